// Divides a node's answer between trav and list.
#include "model/unit/trav/children.hpp"

namespace rayclock {

Children children_of(const NodeAnswer& answer) {
    Children children{answer.base, answer.inner, answer.t_near, {}};
    for (std::size_t i = 0; i < max_width; ++i) children.slot[i] = answer.offset[i] >> 1;
    return children;
}

Leaves leaves_of(const NodeAnswer& answer) {
    Leaves leaves{answer.ray, answer.base, answer.leaves, {}, {}, {}};
    for (std::size_t i = 0; i < answer.leaves; ++i) {
        leaves.t_near[i] = answer.t_near[answer.inner + i];
        leaves.offset[i] = answer.offset[answer.inner + i];
        leaves.count[i] = answer.count[answer.inner + i];
    }
    return leaves;
}

}   // namespace rayclock
