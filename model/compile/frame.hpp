#pragma once
// Camera registers of a frame.
#include "model/core/frame.hpp"
#include "model/layout/memory_image.hpp"
#include "model/scene/camera.hpp"

namespace rayclock {

/// Returns the camera registers of a frame: the eye on the lattice, and the pixel map scaled so that every
/// sum of raygen fits and every direction's largest component is at least 2^(M-2). Throws UserError if the
/// picture is larger than pixel_bits allows. It also throws if a direction in the picture's middle would be
/// too short, as with a field of view of 175 degrees in a picture 800 times as wide as high.
Frame make_frame(const Camera& camera, FrameSize size, const Lattice& lattice, const Config& config);
/// Returns the same registers, and the addresses in memory that the chip needs.
Frame make_frame(const Camera& camera, FrameSize size, const MemoryImage& image, const Config& config);

}   // namespace rayclock
