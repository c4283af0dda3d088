#pragma once
// The descriptor of structure=bih.
#include "model/engine/bih/bih.hpp"
#include "model/engine/bih/build.hpp"
#include "model/engine/parts.hpp"
#include "model/engine/space_cells/exits.hpp"

namespace rayclock::bih {

/// Members: model/engine/engines.hpp.
struct Engine : engine::OfBoxRay<BihNode>, engine::OfCells<BihNode, WideBih> {
    static constexpr Structure structure = Structure::bih;
    static constexpr const char* node_name = "bih_node";

    static int latency(const Config& config) {
        const Stages stages(config);
        return stages.cut + stages.plane + stages.exits + stages.rank;
    }
    static std::uint32_t decide(const RayForm& form, const Wide& node, const Config& config,
                                std::uint32_t* t_near) {
        return bih_exits(form, node, config, t_near);
    }
    static NodeAnswer answer(const Request& request, const Config& config) {
        return bih_answer(request, config);
    }
    static void put(const space_cells::Cell& cell, std::size_t plane, BihNode& node) {
        node.axis[plane] = cell.axis;
        if (cell.axis == no_axis) return;
        node.lower_to[plane] = cell.lower->bounds.hi[cell.axis];
        node.upper_from[plane] = cell.upper->bounds.lo[cell.axis];
    }
    static void put_none(std::size_t plane, BihNode& node) { node.axis[plane] = no_axis; }
    static space_cells::CellPtr build(const space_cells::Pieces& pieces, const std::vector<PrimData>&,
                                      const Config& config) {
        return bih::build(pieces, config);
    }
};

}   // namespace rayclock::bih
