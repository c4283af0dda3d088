#pragma once
// Surfaces for the hard cases: shapes in the unit cube, and what becomes of them on a lattice.
#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/base/rng.hpp"
#include "sim/judge/oracle/tree.hpp"

namespace rayclock::stress {

/// Points and faces, counter-clockwise as seen from outside, closed unless said otherwise.
struct Shape {
    std::vector<glm::dvec3> points;
    std::vector<std::array<std::uint32_t, 3>> faces;
};
/// The icosahedron, every face cut in four `level` times; on the unit sphere.
Shape sphere(int level);
/// Two apexes at z = -1 and 1 over a ring of `sides` points of the given radius: corners of high valence,
/// needles if thin.
Shape bipyramid(int sides, double radius);
/// The cube from -1 to 1, with n x n squares of two triangles a face.
Shape cube(int n);
/// A prism over a star of `teeth` points: concave edges and corners.
Shape cog(int teeth);
/// A rectangle in the plane z = 0 from -1 to 1, n x n squares, both triangles of each facing up. Not closed.
Shape plate(int n, bool other_diagonal = false);

/// Turned about a random axis by a random angle.
Shape turned(const Shape& shape, Rng& rng);

/// Triangles on the lattice, and their bounds.
struct Mesh : oracle::Extent {
    std::vector<oracle::Corners> triangles;

    /// Adds a shape scaled and moved; every point goes to the nearest lattice point, so what was closed is
    /// closed.
    using Extent::add;
    void add(const Shape& shape, double scale, const glm::dvec3& centre = glm::dvec3{0});
    /// Each edge of a triangle is met by the opposite edge of another, as often: no border anywhere.
    bool closed() const;
};

/// Cuts triangles in two at the middle of an edge, on one side only. With `slivers` a triangle without area
/// closes the seam and the middle lies on the edge exactly; without, the middle is moved off by a lattice
/// step: a T-junction, which leaks.
void cut_edges(Mesh& mesh, int count, bool slivers, Rng& rng);

}   // namespace rayclock::stress
