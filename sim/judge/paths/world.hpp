#pragma once
// What the machine must have been given, from the scene as it is: primitives on the lattice, surfaces,
// lights, registers.
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "sim/judge/oracle/solids.hpp"

namespace rayclock {

/// How a frame was asked for.
struct Asked {
    const Scene& scene;
    const Camera& camera;
    const Frame& frame;
    const Lattice& lattice;
    const Config& config;
};

/// The scene's primitives as the lattice has them, by number. Of a chip that shades the corners of large
/// triangles lie on coarser points (aligned()): `scene` is the scene with those moved.
std::vector<oracle::Solid> solids_of(const Scene& scene, const Lattice& lattice, int coord_bits);

/// Of a step: what doubles may add on the way to the lattice.
constexpr double lattice_slack = 1e-6;

/// Steps by which each corner of a scene may lie off on each axis, the bound of aligned(): half a step, and
/// of a chip that shades 2^-13 of the shortest edge of its triangles. Any, if no triangle has it.
std::vector<double> corner_bounds(const Scene& scene, const Lattice& lattice, const Config& config);

/// Steps by which a point of the lattice lies off one of the scene, on the axis where it is most, without
/// what doubles lose far from the scene's origin.
double corner_error(const Lattice& lattice, const Vec3i& steps, const glm::dvec3& given);

/// Spheres and planes of a scene as the lattice has them, in its steps.
void snap_round(const Lattice& lattice, Scene& scene);

const Material& material_of(const Scene& scene, std::size_t primitive);

/// A plane's bit in the cell of a path: the first that transmit have one, as many as the chip has panes, and
/// what lies in one of them after it has the same. 0 for all other primitives.
std::uint32_t pane_bit(const Asked& asked, std::size_t primitive);

/// Primitive i's surface: corners and material, each number the nearest that its format has. Corner normals
/// are left out: holds_normals().
Surface expected_surface(const Scene& scene, const std::vector<oracle::Solid>& solids, const Config& config,
                         std::size_t i);
/// The same of another material.
Surface expected_surface(const Scene& scene, const std::vector<oracle::Solid>& solids, const Config& config,
                         std::size_t i, const Material& material);

/// Whether a smooth triangle's surface has the scene's corner normals: the longest of the three fills its
/// bits, each number is the nearest, and all are turned if their sum points away from the triangle's own
/// side.
bool holds_normals(const Scene& scene, std::size_t triangle, const Surface& seen);

/// What is wrong with the frame's registers, a sentence each: eye, depth, samples, background, lights.
std::vector<std::string> judge_registers(const Asked& asked, const Whitted& settings);

}   // namespace rayclock
