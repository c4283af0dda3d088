// From the importer's materials, cameras and lights to ours.
#pragma once
#include <vector>

#include <assimp/scene.h>
#include <glm/mat4x4.hpp>

#include "model/scene/scene.hpp"
#include "sim/load/prepare.hpp"

namespace rayclock {

Material material_of(const aiMaterial& material, const Prepared& prepared);

/// A camera or light and the transform of the node that it hangs on.
Camera camera_of(const aiCamera& camera, const glm::dmat4& place);

/// Our lights have no attenuation and no unit: the brightest as seen from the middle of `bounds` gets 1 / sqrt(n),
/// the others in proportion. A directional light is put far away.
struct PlacedLight {
    const aiLight* light;
    glm::dmat4 place;
};
std::vector<Light> lights_of(const std::vector<PlacedLight>& lights, const Bounds& bounds);

} // namespace rayclock
