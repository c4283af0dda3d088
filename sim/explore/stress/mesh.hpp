#pragma once
// Surfaces for hard cases: shapes in the unit cube, and their triangles on a lattice.
#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/base/rng.hpp"
#include "sim/judge/oracle/tree.hpp"

namespace rayclock::stress {

/// Points and faces, counter-clockwise seen from outside. Closed unless stated otherwise.
struct Shape {
    std::vector<glm::dvec3> points;
    std::vector<std::array<std::uint32_t, 3>> faces;
};
/// Returns the icosahedron on the unit sphere, with every face divided in four `level` times.
Shape sphere(int level);
/// Returns two apexes at z = -1 and 1 over a ring of `sides` points of the given radius. It has corners of
/// high valence, and needles if it is thin.
Shape bipyramid(int sides, double radius);
/// Returns the cube from -1 to 1, with n x n squares of two triangles on each face.
Shape cube(int n);
/// Returns a prism over a star of `teeth` points, with concave edges and corners.
Shape cog(int teeth);
/// Returns a rectangle in the plane z = 0 from -1 to 1 with n x n squares, all triangles facing up. Not
/// closed.
Shape plate(int n, bool other_diagonal = false);

/// Returns the shape rotated about a random axis by a random angle.
Shape turned(const Shape& shape, Rng& rng);

/// Triangles on the lattice and their bounds.
struct Mesh : oracle::Extent {
    std::vector<oracle::Corners> triangles;

    /// Adds a scaled and moved shape. Every point moves to the nearest lattice point, so closed shapes stay
    /// closed.
    using Extent::add;
    void add(const Shape& shape, double scale, const glm::dvec3& centre = glm::dvec3{0});
    /// Returns true if every edge has as many opposite edges, so that the surface has no border.
    bool closed() const;
};

/// Cuts triangles in two at the middle of an edge, on one side only. With `slivers`, a triangle without area
/// closes the seam, and the middle lies exactly on the edge. Without, the middle moves by a lattice step.
/// This T-junction leaks.
void cut_edges(Mesh& mesh, int count, bool slivers, Rng& rng);

}   // namespace rayclock::stress
