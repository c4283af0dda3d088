#pragma once
#include <vector>

#include <glm/vec3.hpp>

#include "model/base/progress.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Linear RGB, row by row from the top.
struct Picture {
    FrameSize size;
    std::vector<glm::vec3> pixels;
};

/// Turns hits into colours, the same way for reference, model and RTL: ambient, Lambert and Phong terms of
/// every light (no secondary rays), smooth normals where the scene has them, background elsewhere. Of hits on
/// spheres the depth counts, along the ray of the pixel's middle.
Picture shade(const Scene& scene, const HitFrame& frame, const Progress& progress = {});

}   // namespace rayclock
