#pragma once
// The descriptor of structure=spheres.
#include "model/engine/parts.hpp"
#include "model/engine/spheres/globe.hpp"

namespace rayclock::spheres {

/// Members: model/engine/engines.hpp.
struct Engine {
    static constexpr Structure structure = Structure::spheres;
    using Node = rayclock::GlobeNode;
    using Request = GlobeReq;
    using RayForm = GlobeRay;
    using Wide = WideGlobes;
    using Reader = engine::WidenedReader<Node>;
    static constexpr bool has_cells = false;
    static constexpr const char* node_name = "globe_node";

    static int latency(const Config& config) {
        const Stages stages(config);
        return stages.cut + stages.globe + stages.rank;
    }
    static RayForm form(const Ray& ray, const BoxRay&, const Config& config) {
        return globe_ray(ray, config);
    }
    static Request request(std::uint32_t ray, const RayForm& form, const Node& node) {
        return {ray, form.o, form.toward, form.len, node};
    }
    static std::uint32_t decide(const RayForm& form, const Wide& node, const Config& config,
                                std::uint32_t* t_near) {
        return globe_children(form, node, config, t_near);
    }
    static const WideNode& children(const Wide& node) { return node.children; }
    static NodeAnswer answer(const Request& request, const Config& config) { return globe(request, config); }
};

}   // namespace rayclock::spheres
