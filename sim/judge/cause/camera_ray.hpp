#pragma once
// Decides whether a machine's camera ray goes through its pixel, within the stated rounding of the
// reference's ray.
#include "model/scene/camera.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

/// The bound on the error of a picture's camera rays.
///
/// Let v be the reference's direction in lattice steps, scaled as the pixel map has it, and m the largest
/// component that the map gives. The registers hold scale v, scale >= (2^(M-1+G) - 2^G - off) / m. The error
/// of their sum in raygen is at most (w + h) / 2 (model/compile/frame.cpp has `off` and the proof). raygen
/// doubles the sum s times, until it fills M - 1 + G bits, and rounds once to nearest. So the error of a
/// component of d is at most
///     E = 1/2 + 2^(s-G) (w + h) / 2,      2^(s-G) < 2^(M-1) / (scale max |v_k| - (w + h) / 2)
/// with 1 in place of 1/2 if d saturates. Then the sine of the angle between d and v is at most
/// sqrt(3) E / |d|.
class CameraBound {
public:
    /// `rays`: the picture's camera rays.
    CameraBound(const FrameInputs& inputs, const PixelRays& rays);

    /// `given`: the direction of the reference's ray, of any length, in scene units. `d`: the machine's
    /// direction.
    bool goes_through(const glm::dvec3& given, const Vec3i& d) const;

private:
    int dir_bits_;
    glm::dvec3 pitch_, plane_;   ///< plane_: normal of the plane in which all directions of the map end
    double height_;              ///< plane_ . direction, the same for all of them
    double sides_;               ///< w + h
    double scale_;
};

}   // namespace rayclock
