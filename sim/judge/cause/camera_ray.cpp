// Bounds the error of a camera ray's direction.
#include "sim/judge/cause/camera_ray.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "model/base/largest.hpp"
#include "model/scene/placed.hpp"
#include "sim/judge/paths/arithmetic.hpp"

namespace rayclock {

CameraBound::CameraBound(const FrameInputs& inputs, const PixelRays& rays)
    : dir_bits_(inputs.config.dir_bits), pitch_(inputs.lattice.pitch) {
    // The machine's scale and rounding are those of the whole picture, whose pixel (0, 0) may lie before the
    // window's.
    double left = 0, top = 0, width = inputs.frame.width, height = inputs.frame.height;
    if (const std::optional<PictureWindow>& window = inputs.camera.window) {
        left = -window->x, top = -window->y;
        width = window->whole_width, height = window->whole_height;
    }
    sides_ = width + height;
    const PixelRays steps{rays.eye, rays.corner / pitch_, rays.right / pitch_, rays.down / pitch_};
    double most = std::max(largest(steps.right), largest(steps.down));
    for (const double x : {left - 0.5, left + width - 0.5})
        for (const double y : {top - 0.5, top + height - 0.5})
            most = std::max(most, largest(steps.direction(x, y)));
    plane_ = glm::cross(steps.right, steps.down);
    height_ = glm::dot(plane_, steps.corner);
    scale_ = (std::ldexp(std::exp2(dir_bits_ - 1) - 1, guard_bits) - 0.5 * sides_ - 1.5) / most;
}

bool CameraBound::goes_through(const glm::dvec3& given, const Vec3i& d) const {
    glm::dvec3 v = given / pitch_;
    v *= height_ / glm::dot(plane_, v);
    const double end = std::exp2(dir_bits_ - 1), sum = scale_ * largest(v) - 0.5 * sides_;
    const glm::dvec3 machine = vector_of(d);
    if (!(sum > 0) || largest(machine) < std::exp2(dir_bits_ - 2) - 1) return false;
    const double once = largest(machine) >= end - 1 ? 1 : 0.5,
                 error = once + 0.5 * sides_ * std::min(end / sum, std::exp2(max_shift - guard_bits));
    const double sine = glm::length(glm::cross(unit_or_zero(machine), unit_or_zero(v)));
    return glm::dot(machine, v) > 0 &&
           sine <= std::sqrt(3.0) * error / glm::length(machine) * (1 + Range::slack) + Range::slack;
}

}   // namespace rayclock
