// Sorts the answer of a node unit.
#include "model/engine/node_answer.hpp"

#include "model/unit/trav/order.hpp"

namespace rayclock {

NodeAnswer node_answer(std::uint32_t ray, std::uint32_t hits, const std::uint32_t* t_near,
                       const WideNode& node) {
    NodeAnswer out;
    std::array<std::uint64_t, 2 * max_width> sorted;
    out.ray = ray;
    out.base = node.base;
    out.inner = sort_children(hits & node.inner_mask, t_near, sorted.data());
    out.leaves = sort_children(hits & ~std::uint32_t(node.inner_mask), t_near, &sorted[out.inner]);
    for (std::size_t i = 0; i < out.inner + out.leaves; ++i) {
        const std::uint32_t child = ByDistance::child(sorted[i]);
        out.t_near[i] = ByDistance::near(sorted[i]);
        out.offset[i] = node.offset[child];
        out.count[i] = node.count[child];
    }
    return out;
}

}   // namespace rayclock
