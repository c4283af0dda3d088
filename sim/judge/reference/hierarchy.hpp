#pragma once
#include <cstdint>
#include <vector>

namespace rayclock {

// The reference tracer's bounding-volume hierarchy: binary binned-SAH build (Wald 2007, "On fast construction
// of SAH-based bounding volume hierarchies"), collapsed to four children a node so that one ray is tested
// against four boxes at once (Wald, Benthin, Boulos 2008, "Getting rid of packets").
//
// Boxes are single precision and always contain what they bound. The result depends only on the boxes given,
// never on the number of threads. Nothing here knows triangles: leaves are ranges of `order`.

/// Four floats handled as one; GCC's portable vector type, SSE on x86-64.
typedef float RefFloat4 __attribute__((vector_size(16)));

/// Axis-aligned box, with the number of the primitive that it bounds.
struct RefBox {
    float lo[3], hi[3];
    std::uint32_t primitive;
};

/// Four children. `plane[2 * axis]` are their lower bounds, `plane[2 * axis + 1]` the upper ones.
/// blocks == 0: `child` is a node. Otherwise a leaf of that many blocks, the first of which is `child`.
/// A child that is not there has an inverted infinite box, which no ray enters, and is a leaf of block 0,
/// harmless should a ray beyond the range of float (all distances NaN) enter it nevertheless.
struct alignas(64) RefNode {
    RefFloat4 plane[6];
    std::uint32_t child[4];
    std::uint32_t blocks[4];
};

constexpr int ref_block_size = 2;   ///< primitives a block; two doubles fill one SSE register
constexpr int ref_max_leaf = 8;     ///< primitives a leaf at most
constexpr int ref_max_depth = 96;   ///< inner nodes on a path at most, kept by the builder
constexpr int ref_stack_size = 3 * ref_max_depth + 4;   ///< each node on the path leaves at most three
                                                        ///< siblings

/// Node 0 is the root. `order` holds ref_block_size primitives a block; a leaf's last block is filled up
/// by repeating its last primitive, which changes no answer.
struct RefHierarchy {
    std::vector<RefNode> nodes;
    std::vector<std::uint32_t> order;
};

/// Builds over all of `boxes`, which it reorders. No boxes: no nodes.
RefHierarchy build_hierarchy(std::vector<RefBox>& boxes);

}   // namespace rayclock
