#pragma once
// The descriptor of structure=bsp.
#include "model/engine/bsp/build.hpp"
#include "model/engine/bsp/slant.hpp"
#include "model/engine/parts.hpp"
#include "model/engine/space_cells/exits.hpp"

namespace rayclock::bsp {

/// Members: model/engine/engines.hpp.
struct Engine : engine::OfCells<Slant, WideSlant> {
    static constexpr Structure structure = Structure::bsp;
    using Node = rayclock::Slant;
    using Request = SlantReq;
    using RayForm = SlantRay;
    static constexpr const char* node_name = "slant";

    static int latency(const Config& config) {
        const Stages stages(config);
        return stages.cut + stages.crossing + stages.exits + stages.rank;
    }
    static RayForm form(const Ray& ray, const BoxRay& box, const Config& config) {
        return {box, slant_direction(ray, config)};
    }
    static Request request(std::uint32_t ray, const RayForm& form, const Node& node) {
        return {ray, form.box.o, form.box.recip, form.box.len, form.along, node};
    }
    static std::uint32_t decide(const RayForm& form, const Wide& node, const Config& config,
                                std::uint32_t* t_near) {
        return slant_exits(form.box, form.along, node, config, t_near);
    }
    static NodeAnswer answer(const Request& request, const Config& config) { return slant(request, config); }
    static void put(const space_cells::Cell& cell, std::size_t plane, Slant& slant) {
        for (std::size_t k = 0; k < 3; ++k) slant.normal[3 * plane + k] = cell.normal[k];
        slant.at[plane] = cell.at;
    }
    static void put_none(std::size_t, Slant&) {}
    static space_cells::CellPtr build(const space_cells::Pieces& pieces, const std::vector<PrimData>& prims,
                                      const Config& config) {
        return bsp::build(pieces, prims, config);
    }
};

}   // namespace rayclock::bsp
