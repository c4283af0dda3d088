#pragma once
// The correct inputs of the machine, computed from the scene: primitives on the lattice, surfaces, lights,
// registers.
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/scene/whitted.hpp"
#include "sim/judge/oracle/solids.hpp"

namespace rayclock {

/// The inputs of a frame.
struct FrameInputs {
    const Scene& scene;
    const Camera& camera;
    const Frame& frame;
    const Lattice& lattice;
    const Config& config;
};

/// Returns the scene's primitives on the lattice, by number. In a chip that shades, corners of large
/// triangles lie on coarser points (align_large_triangles()); `scene` must contain the moved corners.
std::vector<oracle::Solid> solids_of(const Scene& scene, const Lattice& lattice, int coord_bits);

/// Largest error of doubles, in lattice steps.
constexpr double lattice_slack = 1e-6;

/// Returns the largest allowed error of each corner on each axis, in lattice steps (the bound of
/// align_large_triangles()). It is half a step. In a chip that shades it is at least 2^-13 of the shortest
/// edge of the corner's triangles. A corner of no triangle may lie anywhere.
std::vector<double> corner_bounds(const Scene& scene, const Lattice& lattice, const Config& config);

/// Returns the distance of a lattice point from a scene point, in steps, on the worst axis. Errors of doubles
/// far from the scene's origin are subtracted.
double corner_error(const Lattice& lattice, const Vec3i& steps, const glm::dvec3& given);

/// Converts the spheres and planes of a scene to lattice steps, rounded as on the lattice.
void snap_round(const Lattice& lattice, Scene& scene);

const Material& material_of(const Scene& scene, std::size_t primitive);

/// Returns a plane's bit in the cell of a path. The first transmitting planes have one each, as many as the
/// chip has panes. A later plane that coincides with one of them has the same bit. All other primitives have
/// 0.
std::uint32_t pane_bit(const FrameInputs& inputs, std::size_t primitive);

/// Returns primitive i's surface: corners and material, each number rounded to its format. It has no corner
/// normals; holds_normals() judges them.
Surface expected_surface(const Scene& scene, const std::vector<oracle::Solid>& solids, const Config& config,
                         std::size_t i);
/// The same with another material.
Surface expected_surface(const Scene& scene, const std::vector<oracle::Solid>& solids, const Config& config,
                         std::size_t i, const Material& material);

/// Returns true if a smooth triangle's surface has the scene's corner normals. The longest of the three must
/// fill its bits, and each number must be rounded to nearest. All three are negated if their sum points away
/// from the triangle's front.
bool holds_normals(const Scene& scene, std::size_t triangle, const Surface& seen);

/// Returns the faults of the frame's registers, a sentence each: eye, depth, samples, background, lights.
std::vector<std::string> judge_registers(const FrameInputs& inputs, const Whitted& settings);

}   // namespace rayclock
