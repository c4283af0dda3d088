#pragma once
// The arrays of a walk through a tree.
#include <type_traits>
#include <utility>

#include "model/engine/bvh/box.hpp"
#include "model/unit/list/ray_tests.hpp"
#include "model/unit/trav/stack.hpp"

namespace rayclock {

/// Arrays of a walk.
template <class Order> struct WalkRoom {
    alignas(32) std::array<typename Order::Time, max_width> t_near;   ///< by child
    alignas(32) std::array<typename Order::Key, max_width> leaves;    ///< leaves that the ray meets, in order
};

/// The leaves of a node that a ray meets, in order: the `Met` of LeafCursor.
template <class Order> struct MetLeaves {
    const WideNode* node = nullptr;
    const typename Order::Key* keys = nullptr;
    std::uint32_t leaves = 0;

    std::uint32_t size() const { return leaves; }
    RAYCLOCK_INLINE typename Order::Time near(std::uint32_t i) const { return Order::near(keys[i]); }
    RAYCLOCK_INLINE std::uint32_t first(std::uint32_t i) const {
        return 2 * node->base + node->offset[Order::child(keys[i])];
    }
    RAYCLOCK_INLINE std::uint32_t count(std::uint32_t i) const { return node->count[Order::child(keys[i])]; }
};

#include "model/trace/tree_walk.inl"

}   // namespace rayclock
