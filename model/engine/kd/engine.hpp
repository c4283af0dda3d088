#pragma once
// The engine of structure=kd, and of structure=octree, as the machine sees it.
#include "model/core/stages.hpp"
#include "model/engine/kd/build.hpp"
#include "model/engine/kd/exits.hpp"
#include "model/engine/kd/treelet.hpp"
#include "model/engine/octree/build.hpp"
#include "model/engine/reader.hpp"

namespace rayclock::engine {

/// Members: model/engine/engines.hpp.
struct Kd {
    static constexpr Structure structure = Structure::kd;
    using Node = rayclock::Treelet;
    using Request = TreeletReq;
    using RayForm = BoxRay;
    using Wide = WideTreelet;
    using Reader = WidenedReader<Node>;
    static constexpr bool has_cells = true;
    static constexpr const char* node_name = "treelet";

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
        return treelet_exits(form, node, config, t_near);
    }
    static const WideNode& children(const Wide& node) { return node.exits; }
    static kd::CellPtr build(const kd::Pieces& pieces, const std::vector<PrimData>& prims,
                             const Config& config) {
        return config.is_octree() ? octree::build(pieces, config) : kd::build(pieces, prims, config);
    }
};

}   // namespace rayclock::engine
