#pragma once
// Parts that descriptors share (engines.hpp explains the members).
#include "model/core/layout.hpp"
#include "model/core/stages.hpp"
#include "model/engine/box_ray.hpp"
#include "model/engine/node_answer.hpp"

namespace rayclock::engine {

/// A unit that takes a ray in the form of the slab test.
template <class NodeLine> struct OfBoxRay {
    using Node = NodeLine;
    using Request = BoxRayReq<NodeLine>;
    using RayForm = BoxRay;
    static RayForm form(const Ray&, const BoxRay& ray, const Config&) { return ray; }
    static Request request(std::uint32_t ray, const RayForm& form, const Node& node) {
        return {ray, form.o, form.neg, form.recip, form.len, node};
    }
};

/// Unpacks a node's line and widens it.
template <class NodeLine> class WidenedReader {
public:
    explicit WidenedReader(const Config& config) : config_(config) {}
    auto operator()(const std::uint32_t* line) const {
        return widen(unpack<NodeLine>(line, config_), config_.node_width);
    }

private:
    const Config& config_;
};

/// A node whose exits are cells.
template <class NodeLine, class WideNodeLine> struct OfCells {
    using Wide = WideNodeLine;
    using Reader = WidenedReader<NodeLine>;
    static constexpr bool has_cells = true;
    static const WideNode& children(const Wide& node) { return node.exits; }
};

}   // namespace rayclock::engine
