#pragma once
// The reference tracer's bounding-volume hierarchy. A binary binned-SAH build (Wald 2007, "On fast
// construction of SAH-based bounding volume hierarchies") is collapsed to four children per node. So one ray
// is tested against four boxes at once (Wald, Benthin, Boulos 2008, "Getting rid of packets").
//
// Boxes are single precision and always contain the primitives that they bound. The result depends only on
// the boxes, never on the number of threads. This code does not depend on the kind of primitive: leaves are
// ranges of `order`.
#include <cstdint>
#include <vector>

namespace rayclock {

/// Four floats in one vector: GCC's portable vector type, SSE on x86-64.
typedef float RefFloat4 __attribute__((vector_size(16)));

/// An axis-aligned box, with the number of the primitive that it bounds.
struct RefBox {
    float lo[3], hi[3];
    std::uint32_t primitive;
};

/// A node of four children. `plane[2 * axis]` holds their lower bounds, `plane[2 * axis + 1]` the upper ones.
/// blocks == 0: `child` is a node. Otherwise the child is a leaf of that many blocks, and `child` is the
/// first one. A missing child has an inverted infinite box, which no ray enters. It is a leaf of block 0, so
/// it does no harm if a ray beyond the range of float (all distances NaN) enters it nevertheless.
struct alignas(64) RefNode {
    RefFloat4 plane[6];
    std::uint32_t child[4];
    std::uint32_t blocks[4];
};

constexpr int ref_block_size = 2;   ///< primitives per block; two doubles fill one SSE register
constexpr int ref_max_leaf = 8;     ///< most primitives per leaf
constexpr int ref_max_depth = 96;   ///< most inner nodes on a path; the builder keeps this bound
/// Each node on the path leaves at most three siblings.
constexpr int ref_stack_size = 3 * ref_max_depth + 4;

/// A built hierarchy. Node 0 is the root. `order` holds ref_block_size primitives per block. A leaf's last
/// block is padded by repeating its last primitive, which changes no answer.
struct RefHierarchy {
    std::vector<RefNode> nodes;
    std::vector<std::uint32_t> order;
};

/// Builds a hierarchy over `boxes` and reorders them. Without boxes it has no nodes.
RefHierarchy build_hierarchy(std::vector<RefBox>& boxes);

}   // namespace rayclock
