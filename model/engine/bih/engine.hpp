#pragma once
// The engine of structure=bih, as the machine sees it.
#include "model/core/stages.hpp"
#include "model/engine/bih/bih.hpp"
#include "model/engine/bih/build.hpp"
#include "model/engine/kd/exits.hpp"
#include "model/engine/reader.hpp"

namespace rayclock {

inline void put(const kd::Cell& cell, std::size_t plane, BihNode& node) {
    node.axis[plane] = cell.axis;
    if (cell.axis == no_axis) return;
    node.lower_to[plane] = cell.lower->bounds.hi[cell.axis];
    node.upper_from[plane] = cell.upper->bounds.lo[cell.axis];
}
inline void put_none(std::size_t plane, BihNode& node) { node.axis[plane] = no_axis; }

}   // namespace rayclock

namespace rayclock::engine {

/// Members: model/engine/engines.hpp.
struct Bih {
    static constexpr Structure structure = Structure::bih;
    using Node = rayclock::BihNode;
    using Request = BihReq;
    using RayForm = BoxRay;
    using Wide = WideBih;
    using Reader = WidenedReader<Node>;
    static constexpr bool has_cells = true;
    static constexpr const char* node_name = "bih_node";

    static int latency(const Config& config) {
        const Stages stages(config);
        return stages.cut + stages.plane + stages.exits + stages.rank;
    }
    static RayForm form(const Ray&, const BoxRay& ray, const Config&) { return ray; }
    static Request request(std::uint32_t ray, const RayForm& form, const Node& node) {
        return {ray, form.o, form.neg, form.recip, form.len, node};
    }
    static std::uint32_t decide(const RayForm& form, const Wide& node, const Config& config,
                                std::uint32_t* t_near) {
        return bih_exits(form, node, config, t_near);
    }
    static const WideNode& children(const Wide& node) { return node.exits; }
    static kd::CellPtr build(const kd::Pieces& pieces, const std::vector<PrimData>&, const Config& config) {
        return bih::build(pieces, config);
    }
};

}   // namespace rayclock::engine
