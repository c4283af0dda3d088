#pragma once
// The generators of built-in scenes, and the numbers of their primitives.
#include <cstdint>

#include "model/scene/builtin.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {

// The generators of the built-in scenes, which builtin.cpp lists; most have a separate file. Each offers the
// exact number of primitives by formula, and the scene itself for a size >= 1. Memory and time grow only with
// the result, and a size always gives the same bits.
//
// Curved shapes have the default cut of Haines' package (tessellation factor 3) with smooth normals. A scene
// without curved triangles has no normals. Lights have strength 1/sqrt(their number). Three or more still
// overexpose a surface that all of them light, so such surfaces have half of Haines' Kd (his description
// leaves shading free).

PrimitiveCounts balls_counts(int size, Primitives primitives);
Scene make_balls(int size, Primitives primitives);

std::uint64_t gears_triangles(int size);
Scene make_gears(int size);
PlacedScene make_gearbox(int size);   ///< the same scene, of instances of one gear
std::uint64_t flake_triangles(int size);
PlacedScene make_flake(int size);   ///< the balls, of instances of one ball
std::uint64_t boughs_triangles(int size);
PlacedScene make_boughs(int size);   ///< the tree, of instances of one cone and one ball

// Moving scenes, which repeat after some seconds. Each consists of instances of few meshes.

std::uint64_t clockwork_triangles(int size);
PlacedScene make_clockwork(int size);   ///< a wall of size * size gears that turn each other, over a ground
std::uint64_t crowd_triangles(int size);
PlacedScene make_crowd(int size);   ///< size * size walkers of five parts each; the camera moves with them
std::uint64_t flight_triangles(int size);
PlacedScene make_flight(int size);   ///< `size` balls thrown over a ground; a light moves in a circle

PrimitiveCounts mount_counts(int size, Primitives primitives);
Scene make_mount(int size, Primitives primitives);

PrimitiveCounts rings_counts(int size, Primitives primitives, int sectors);
Scene make_rings(int size, Primitives primitives, int sectors);

std::uint64_t teapot_triangles(int size);
Scene make_teapot(int size);

std::uint64_t tetra_triangles(int size);
Scene make_tetra(int size);

PrimitiveCounts tree_counts(int size, Primitives primitives, int sectors);
Scene make_tree(int size, Primitives primitives, int sectors);

std::uint64_t icosphere_triangles(int size);
Scene make_icosphere(int size);

std::uint64_t cornell_triangles(int size);
Scene make_cornell(int size);
std::uint64_t mirrors_triangles(int size);
Scene make_mirrors(int size);

constexpr std::uint64_t spheres_spheres = 5;
Scene make_spheres(int size);

constexpr std::uint64_t wknd_spheres = 487;
Scene make_wknd(int size);

Scene make_plane(int size);

std::uint64_t cube_triangles(int size);
Scene make_cube(int size);

std::uint64_t square_triangles(int size);
Scene make_square(int size);

std::uint64_t room_triangles(int size);
Scene make_room(int size);   ///< with textures

}   // namespace rayclock
