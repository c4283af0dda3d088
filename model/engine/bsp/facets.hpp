#pragma once
// Planes in any direction that may cut a cell.
#include <span>

#include "model/engine/bsp/solid.hpp"
#include "model/engine/kd/split.hpp"

namespace rayclock::bsp {

/// The normal of at most 2^(normal_step_bits - 1) - 1 a component that is nearest to a direction's, or zeros
/// of zeros.
Vec3i nearest_normal(const glm::dvec3& direction);

/// Candidates from polygons (Fuchs, Kedem and Naylor 1980, "On visible surface generation by a priori tree
/// structures"), scored by the surface area heuristic (Ize, Wald and Parker 2008, "Ray tracing with the BSP
/// tree"). A triangle offers planes parallel to itself and planes through its edges at right angles to it,
/// with normals of normal_step_bits, moved so that none of it is on the plane's far side. Of a cell with up
/// to 16 items two offer theirs, and so does every axis: planes that are parallel to
/// axes are found as those of a kd-tree (kd/split.hpp), and are all that larger cells are cut by. So a cell
/// costs O(1) more than in a kd-tree, and the tree O(n log n). A plane across no axis counts as a fifth
/// dearer than it is by area: boxes below it fit worse.
class Facets {
public:
    Facets(const std::vector<PrimData>& prims, const kd::Pieces& pieces, const Config& config);
    /// Keeps what is cheaper than `best`.
    void best_split(const kd::Items& items, const kd::Region& region, kd::Split& best) const;

private:
    using Normals = std::array<Vec3i, 4>;
    static Normals normals_of(const PrimData& prim);
    void consider(const kd::Items& items, const Solid& solid, std::uint32_t prim, const Vec3i& normal,
                  kd::Split& best) const;
    void consider_at(std::span<const kd::Clipper::Reach> reaches, const Solid& solid, const Vec3i& normal,
                     std::int64_t at, kd::Split& best) const;

    const kd::Pieces& pieces_;
    std::vector<Normals> normals_;   ///< that a primitive offers; zeros are none, and boxes have none
    bool stops_;                     // no plane cuts a primitive
};

}   // namespace rayclock::bsp
