#pragma once
// Registers of frames, set directly: directions at the ends of their width, rays through corners, lights near
// and far.
#include "model/layout/memory_image.hpp"
#include "sim/explore/torture/dice.hpp"

namespace rayclock::torture {

struct Size {
    std::uint32_t width, height;
};

/// Looks from anywhere, from a primitive's corner or from a corner of the lattice at one of the primitives,
/// with any angle. `shorter`: directions 2^shorter times as short as they may be, beyond what raygen moves
/// them up by, so that t reaches its end.
Frame view(const std::vector<PrimData>& prims, const Config& config, Size size, int shorter, Dice& dice);

/// Looks along -z from above the mesh's middle, so that pixel (x, y) hits corner (x, y) of it exactly.
Frame corner_view(const Config& config, Size size, std::int32_t step);

/// 9 x 9 directions of at most 4 `unit`s a component, so that many components are equal.
Frame diagonal_view(const Vec3i& eye, std::int64_t unit);

/// Directions whose components all but reach a power of two, so that they round up to it.
Frame brim_view(const Vec3i& eye, const Config& config);

/// Where the mirror number `at` stands, -1, 0 or 1, and a view from where it sends rays along z.
Vec3i mirror_place(const Config& config, std::int32_t at);
Frame mirror_view(const Config& config, Size size, const Vec3i& normal, std::int32_t at);

/// From outside straight at the panes, all of them behind each other; `spread` is the tangent of the
/// picture's angle.
Frame pane_view(const Config& config, Size size, double spread);

/// What a chip that shades is told: everything drawn at random, for `samples` x `samples` of a pixel.
ShadeFrame settings(const MemoryImage& image, const Config& config, int samples, Dice& dice);

}   // namespace rayclock::torture
