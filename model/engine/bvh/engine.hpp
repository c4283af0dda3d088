#pragma once
// The descriptor of structure=bvh.
#include "model/engine/bvh/box.hpp"
#include "model/engine/parts.hpp"

namespace rayclock::bvh {

/// Members: model/engine/engines.hpp.
struct Engine : engine::OfBoxRay<rayclock::Node> {
    static constexpr Structure structure = Structure::bvh;
    using Wide = WideNode;
    using Reader = NodeReader;
    static constexpr bool has_cells = false;
    static constexpr const char* node_name = "node";

    static int latency(const Config& config) {
        const Stages stages(config);
        return stages.cut + stages.slab + stages.meet + stages.rank;
    }
    static std::uint32_t decide(const RayForm& form, const Wide& node, const Config& config,
                                std::uint32_t* t_near) {
        return box_children(form, node, config, t_near);
    }
    static const WideNode& children(const Wide& node) { return node; }
    static NodeAnswer answer(const Request& request, const Config& config) { return box(request, config); }
};

}   // namespace rayclock::bvh
