#pragma once
// An octree over the scene by published rules, and the work of rays in it. The machine does not use it: it
// serves to show that rayclock's scenes, rays and terms agree with the literature.
#include <array>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

/// The size of a tree.
struct OctreeSize {
    std::uint64_t inner = 0, leaves = 0, empty = 0;   ///< empty: those of the leaves that hold no object
    std::uint64_t references = 0;                     ///< to objects, in leaves
};

/// The work of rays in the tree.
struct OctreeWork {
    std::uint64_t rays = 0, hits = 0;                 ///< rays, and those that hit something
    std::uint64_t tests = 0, leaves = 0, empty = 0;   ///< visited leaves, and the empty ones among them
    OctreeWork& operator+=(const OctreeWork& o) {
        rays += o.rays, hits += o.hits, tests += o.tests, leaves += o.leaves, empty += o.empty;
        return *this;
    }
};

/// An octree by the rules of "Octree84" in V. Havran, "Comparison of Octree Traversal Algorithms", 1999 (Ray
/// Tracing News 12(2)), after Glassner 1984, "Space subdivision for fast ray tracing". The root is the
/// scene's bounding box. A node is cut in the middle of all three axes, unless it holds at most one object or
/// has the greatest depth. An object is in every leaf that its *bounding box* meets, boundaries included.
///
/// Two rules are missing from his text and follow from his counts. The box of a polygon is widened by 0.02 on
/// both sides of an axis on which it is thinner than 0.02. The root is enlarged by 0.001 on all sides. Both
/// are in the scene's units. With them, most of his trees are matched exactly (docs/measured/ray-counts.md).
///
/// An object is a sphere, or a polygon as the scene's generator cut it into triangles. In scenes without
/// vertex normals, consecutive triangles of one material form a polygon if they lie in one plane and are
/// connected by edges. In other scenes, neighbours of a curved mesh may lie in one plane. There, two
/// consecutive triangles form a polygon if they are halves of a parallelogram.
///
/// A ray visits the leaves on its path from its origin, or from its entry into the root, to its end. It tests
/// all objects of each leaf in the scene's order, so it tests an object in several leaves several times. A
/// shadow ray ends at its first test of a blocker.
class RefOctree {
public:
    RefOctree(const Scene& scene, int depth);
    const OctreeSize& size() const { return size_; }
    std::size_t objects() const { return boxes_.size(); }
    /// Traces one ray from `from` to from + `reach` * `direction`, or to the first test of one of `blockers`,
    /// which are primitives of the scene. Adds its work to `work`.
    void walk(const glm::dvec3& from, const glm::dvec3& direction, double reach, OctreeWork& work,
              const std::vector<std::uint32_t>& blockers = {}) const;

private:
    struct Box {
        glm::dvec3 lo, hi;
        void add(const std::array<glm::dvec3, 3>& corners) {
            for (const glm::dvec3& p : corners) lo = glm::min(lo, p), hi = glm::max(hi, p);
        }
    };
    struct Node {
        std::uint32_t first = 0;     ///< first of its eight children; 0: a leaf
        std::uint32_t objects = 0;   ///< of a leaf
        std::size_t list = 0;        ///< start of its objects in lists_
    };
    struct Way {
        const glm::dvec3 from, direction;
        const std::vector<std::uint32_t> blockers;   ///< objects
        OctreeWork& work;
    };
    void add_objects(const Scene& scene);
    void add_flat_objects(const Scene& scene);
    void add_smooth_objects(const Scene& scene);
    void build(std::uint32_t node, const Box& box, const std::vector<std::uint32_t>& objects, int depth);
    bool visit(const Way& way, std::uint32_t node, const Box& box, double begin, double end) const;
    bool halve(const Way& way, std::uint32_t octant, const Box& box, int axis, double begin,
               double end) const;

    std::vector<Box> boxes_;                 ///< of all objects
    std::vector<std::uint32_t> object_of_;   ///< of each primitive
    std::vector<std::uint32_t> lists_;       ///< objects of all leaves, in ascending order within each
    std::vector<Node> nodes_;
    Box root_;
    OctreeSize size_;
};

}   // namespace rayclock
