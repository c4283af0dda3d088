#pragma once
// Camera registers of a frame.
#include "model/core/frame.hpp"
#include "model/layout/memory_image.hpp"
#include "model/scene/camera.hpp"

namespace rayclock {

/// Returns the camera registers of a frame: the eye on the lattice, and the pixel map scaled so that every
/// sum of raygen fits and every direction's largest component is at least 2^(M-2). Throws UserError if the
/// picture is larger than pixel_bits allows. It also throws if a direction in its middle would be too short:
/// beyond 175 degrees, or 800 times as wide as high.
Frame make_frame(const Camera& camera, FrameSize size, const Lattice& lattice, const Config& config);
/// Returns these registers together with the addresses that the chip needs of its memory.
Frame make_frame(const Camera& camera, FrameSize size, const MemoryImage& image, const Config& config);

}   // namespace rayclock
