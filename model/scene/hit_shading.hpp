#pragma once
// Pictures, and shading outside the chip.
#include <vector>

#include <glm/vec3.hpp>

#include "model/base/progress.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// A picture in linear RGB, row by row from the top.
struct Picture {
    FrameSize size;
    std::vector<glm::vec3> pixels;
};

/// Turns hits into colours, in the same way for reference, model and RTL: ambient, Lambert and Phong terms of
/// every light (no secondary rays), smooth normals where the scene has them, background elsewhere. A hit on a
/// sphere counts by its depth, along the ray of the pixel's middle. The scene must have a camera.
Picture shade(const Scene& scene, const HitFrame& frame, const Progress& progress = {});

}   // namespace rayclock
