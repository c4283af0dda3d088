#pragma once
#include <cstdint>

#include "model/scene/builtin.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {

// builtin.cpp lists the scenes; most have a file of their own. Each has the exact number of primitives by
// formula and the scene itself for a size >= 1. Memory and time grow with the result only, and the same size
// always gives the same bits. Curved things come as Haines' package cuts them by default (tessellation factor
// 3) with smooth normals; a scene without curved triangles has no normals. Lights are 1/sqrt(their number)
// strong; three or more still blow out what they all shine on, so such surfaces have half of Haines' Kd
// (shading is free in his description).

PrimitiveCounts balls_counts(int size, Primitives primitives);
Scene make_balls(int size, Primitives primitives);

std::uint64_t gears_triangles(int size);
Scene make_gears(int size);
PlacedScene make_gearbox(int size);   ///< the same, of one gear
std::uint64_t flake_triangles(int size);
PlacedScene make_flake(int size);   ///< the balls, of one ball
std::uint64_t boughs_triangles(int size);
PlacedScene make_boughs(int size);   ///< the tree, of one cone and one ball

// Scenes that move, for some seconds and then again from the beginning; each of instances of few meshes.

std::uint64_t clockwork_triangles(int size);
PlacedScene make_clockwork(int size);   ///< a wall of size * size gears that turn each other, over a ground
std::uint64_t crowd_triangles(int size);
PlacedScene make_crowd(int size);   ///< size * size walkers of five parts each; the camera goes along
std::uint64_t flight_triangles(int size);
PlacedScene make_flight(int size);   ///< so many mirror balls that are thrown over a ground; a light goes
                                     ///< round

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

Scene make_plane(int size);

std::uint64_t square_triangles(int size);
Scene make_square(int size);

}   // namespace rayclock
