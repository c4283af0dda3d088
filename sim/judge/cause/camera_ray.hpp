#pragma once
// Whether a machine's camera ray goes through its pixel: the reference's ray against the stated rounding.
#include "model/scene/camera.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

/// `rays`: those of the picture; `given`: along the reference's ray, of any length, in the scene's units;
/// `d`: the machine's.
///
/// Let v be the reference's direction in lattice steps, scaled as the pixel map has it, and m the largest
/// component that the map gives. The registers hold scale v, scale >= (2^(M-1+G) - 2^G - off) / m, and what
/// raygen sums of them is off by (w + h) / 2 at most (model/compile/frame.cpp: off, the proof). Raygen
/// doubles the sum s times, while it has M - 1 + G bits, and rounds once to nearest. So a component of d is
/// off by
///     E = 1/2 + 2^(s-G) (w + h) / 2,      2^(s-G) < 2^(M-1) / (scale max |v_k| - (w + h) / 2)
/// and by 1 in place of 1/2 where d ends at its largest number. Then d and v enclose an angle whose sine is
/// at most sqrt(3) E / |d|.
bool goes_through(const Asked& asked, const PixelRays& rays, const glm::dvec3& given, const Vec3i& d);

}   // namespace rayclock
