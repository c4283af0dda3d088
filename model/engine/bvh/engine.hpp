#pragma once
// The engine of structure=bvh, as the machine sees it.
#include "model/core/stages.hpp"
#include "model/engine/bvh/box.hpp"

namespace rayclock::engine {

/// Members: model/engine/engines.hpp.
struct Bvh {
    static constexpr Structure structure = Structure::bvh;
    using Node = rayclock::Node;
    using Request = BoxReq;
    using RayForm = BoxRay;
    using Wide = WideNode;
    using Reader = NodeReader;
    static constexpr bool has_cells = false;
    static constexpr const char* node_name = "node";

    static int latency(const Config& config) {
        const Stages stages(config);
        return stages.cut + stages.slab + stages.meet + stages.rank;
    }
    static RayForm form(const Ray&, const BoxRay& ray, const Config&) { return ray; }
    static Request request(std::uint32_t ray, const RayForm& form, const Node& node) {
        return {ray, form.o, form.neg, form.recip, form.len, node};
    }
    static std::uint32_t decide(const RayForm& form, const Wide& node, const Config& config,
                                std::uint32_t* t_near) {
        return box_children(form, node, config, t_near);
    }
    static const WideNode& children(const Wide& node) { return node; }
};

}   // namespace rayclock::engine
