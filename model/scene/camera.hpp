#pragma once
// The picture's size, and the map from pixels to rays.
#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

/// The picture's pixel grid: at most 16384 x 16384 (14 bits per side in the hardware).
struct FrameSize {
    int width = 512;
    int height = 384;
    friend bool operator==(const FrameSize&, const FrameSize&) = default;
};
constexpr int max_frame_side = 16384;

/// Returns the size of the whole picture if there is a window, otherwise `size`.
inline FrameSize whole_size(const std::optional<PictureWindow>& window, FrameSize size) {
    return window ? FrameSize{window->whole_width, window->whole_height} : size;
}

/// Throws UserError unless both sides lie in 1..max_frame_side.
void check_frame_size(FrameSize size);

/// The linear map from pixel to ray direction, the one definition for all engines: direction(x, y) = corner +
/// x * right + y * down for the centre of pixel (x, y), with (0, 0) at the top left. Directions are not
/// normalised; the component along the view axis is 1 before scaling.
struct PixelRays {
    glm::dvec3 eye{0};
    glm::dvec3 corner{0}, right{0}, down{0};
    glm::dvec3 direction(double x, double y) const { return corner + x * right + y * down; }
};

/// Returns the map of a camera: w = unit(at - eye), r = unit(w x up), v = r x w; half height tan(fov / 2),
/// square pixels (as in Haines' SPD, with the angle measured to the picture's edges). The camera may have
/// a window: a part of a larger picture. Then the rays are those of the larger picture, and pixel (0, 0) is
/// the first pixel of the part. Throws UserError if the camera or the size is not valid.
PixelRays pixel_rays(const Camera& camera, FrameSize size);

/// Returns the angle between the rays of neighbouring samples: 2 tan(fov / 2) / height of the whole picture /
/// samples per side.
double sample_spread(const Camera& camera, FrameSize size, int samples_per_side);

}   // namespace rayclock
