#pragma once
#include <cstdint>

#include "model/scene/scene.hpp"

namespace rayclock {

// One file per built-in scene; builtin.cpp lists them. Each has the exact number of triangles by formula and the
// scene itself for a size >= 1. Memory and time grow with the result only, and the same size always gives the
// same bits. Curved things come as Haines' package cuts them by default (tessellation factor 3) with smooth normals;
// a scene without anything curved has no normals. Lights are 1/sqrt(their number) strong; three or more still blow out
// what they all shine on, so such surfaces have half of Haines' Kd (shading is free in his description).

std::uint64_t balls_triangles(int size);
Scene make_balls(int size);

std::uint64_t gears_triangles(int size);
Scene make_gears(int size);

std::uint64_t mount_triangles(int size);
Scene make_mount(int size);

std::uint64_t rings_triangles(int size);
Scene make_rings(int size);

std::uint64_t teapot_triangles(int size);
Scene make_teapot(int size);

std::uint64_t tetra_triangles(int size);
Scene make_tetra(int size);

std::uint64_t tree_triangles(int size);
Scene make_tree(int size);

std::uint64_t icosphere_triangles(int size);
Scene make_icosphere(int size);

std::uint64_t cornell_triangles(int size);
Scene make_cornell(int size);

} // namespace rayclock
