#pragma once
// The descriptor of structure=kd and structure=octree.
#include "model/engine/kd/build.hpp"
#include "model/engine/kd/treelet.hpp"
#include "model/engine/octree/build.hpp"
#include "model/engine/parts.hpp"
#include "model/engine/space_cells/exits.hpp"

namespace rayclock::kd {

/// Members: model/engine/engines.hpp.
struct Engine : engine::OfBoxRay<Treelet>, engine::OfCells<Treelet, WideTreelet> {
    static constexpr Structure structure = Structure::kd;
    static constexpr const char* node_name = "treelet";

    static int latency(const Config& config) {
        const Stages stages(config);
        return stages.cut + stages.plane + stages.exits + stages.rank;
    }
    static std::uint32_t decide(const RayForm& form, const Wide& node, const Config& config,
                                std::uint32_t* t_near) {
        return treelet_exits(form, node, config, t_near);
    }
    static NodeAnswer answer(const Request& request, const Config& config) {
        return treelet(request, config);
    }
    static void put(const space_cells::Cell& cell, std::size_t plane, Treelet& treelet) {
        treelet.axis[plane] = cell.axis;
        if (cell.axis != no_axis) treelet.at[plane] = cell.at;
    }
    static void put_none(std::size_t plane, Treelet& treelet) { treelet.axis[plane] = no_axis; }
    static space_cells::CellPtr build(const space_cells::Pieces& pieces, const std::vector<PrimData>&,
                                      const Config& config) {
        return config.is_octree() ? octree::build(pieces, config) : kd::build(pieces, config);
    }
};

}   // namespace rayclock::kd
