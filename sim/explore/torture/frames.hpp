#pragma once
// Registers of frames, set directly: directions at the ends of their width, rays through corners, lights near
// and far.
#include "model/layout/memory_image.hpp"
#include "sim/explore/torture/dice.hpp"

namespace rayclock::torture {

struct Size {
    std::uint32_t width, height;
};

/// Looks at one of the primitives, with any angle, from any point, from a primitive's corner or from a corner
/// of the lattice. `shorter` makes directions 2^shorter times shorter than allowed. raygen cannot shift them
/// up that far, so t saturates.
Frame view(const std::vector<PrimData>& prims, const Config& config, Size size, int shorter, Dice& dice);

/// Looks along -z from above the mesh's middle, so that pixel (x, y) hits corner (x, y) of it exactly.
Frame corner_view(const Config& config, Size size, std::int32_t step);

/// 9 x 9 directions with components of at most 4 `unit`s, so many components are equal.
Frame diagonal_view(const Vec3i& eye, std::int64_t unit);

/// Directions just below a power of two, which round up to it.
Frame brim_view(const Vec3i& eye, const Config& config);

/// Return the place of mirror `at` (-1, 0 or 1), and a view whose rays it reflects along z.
Vec3i mirror_place(const Config& config, std::int32_t at);
Frame mirror_view(const Config& config, Size size, const Vec3i& normal, std::int32_t at);

/// Looks from outside straight at the panes, which lie behind each other. `spread` is the tangent of the
/// picture's angle.
Frame pane_view(const Config& config, Size size, double spread);

/// Returns a legal record of a ray of any kind. Two of three lead to a corner of a primitive or near it.
RayRecord random_record(const std::vector<PrimData>& prims, const Config& config, Dice& dice);

/// Random registers of a chip that shades, with `samples` x `samples` samples per pixel.
ShadeFrame settings(const MemoryImage& image, const Config& config, int samples, Dice& dice);

}   // namespace rayclock::torture
