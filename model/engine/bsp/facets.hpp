#pragma once
// Planes in any direction that may cut a cell.
#include <span>

#include "model/engine/bsp/solid.hpp"
#include "model/engine/space_cells/split.hpp"

namespace rayclock::bsp {

/// Returns the normal nearest to a direction, with components of at most 2^(normal_step_bits - 1) - 1. It is
/// zero for a zero direction.
Vec3i nearest_normal(const glm::dvec3& direction);

/// Candidate planes from polygons (Fuchs, Kedem and Naylor 1980, "On visible surface generation by a priori
/// tree structures"). The surface area heuristic scores them (Ize, Wald and Parker 2008, "Ray tracing with
/// the BSP tree").
///
/// A triangle offers planes parallel to itself, and planes through its edges at right angles to it. Their
/// normals have normal_step_bits, and each plane is moved so that the whole triangle lies on one side. In a
/// cell with up to 16 items two of them offer planes, and so does every axis. Planes parallel to axes are
/// found as in a kd-tree (space_cells/split.hpp); larger cells are cut only by these. So a cell costs O(1)
/// more than in a kd-tree, and the tree O(n log n). A plane that is not parallel to two axes costs 20 % more
/// than its area implies, because boxes below it fit worse.
class Facets {
public:
    Facets(const std::vector<PrimData>& prims, const space_cells::Pieces& pieces, const Config& config);
    /// Replaces `best` by any cheaper cut.
    void best_split(const space_cells::Items& items, const space_cells::Region& region,
                    space_cells::Split& best) const;

private:
    using Normals = std::array<Vec3i, 4>;
    static Normals normals_of(const PrimData& prim);
    void consider(const space_cells::Items& items, const Solid& solid, std::uint32_t prim,
                  const Vec3i& normal, space_cells::Split& best) const;
    void consider_at(std::span<const space_cells::Clipper::Reach> reaches, const Solid& solid,
                     const Vec3i& normal, std::int64_t at, space_cells::Split& best) const;

    const space_cells::Pieces& pieces_;
    std::vector<Normals> normals_;   ///< offered by each primitive; zeros mean none, and boxes have none
    bool stops_;                     // no plane may cut a primitive
};

}   // namespace rayclock::bsp
