// Divides a node's answer between trav and list.
#include "model/unit/trav/children.hpp"

namespace rayclock {

Children children_of(const BoxRsp& boxes) {
    Children children{boxes.base, boxes.inner, boxes.t_near, {}};
    for (std::size_t i = 0; i < max_width; ++i) children.slot[i] = boxes.offset[i] >> 1;
    return children;
}

Leaves leaves_of(const BoxRsp& boxes) {
    Leaves leaves{boxes.ray, boxes.base, boxes.leaves, {}, {}, {}};
    for (std::size_t i = 0; i < boxes.leaves; ++i) {
        leaves.t_near[i] = boxes.t_near[boxes.inner + i];
        leaves.offset[i] = boxes.offset[boxes.inner + i];
        leaves.count[i] = boxes.count[boxes.inner + i];
    }
    return leaves;
}

}   // namespace rayclock
