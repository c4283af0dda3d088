#pragma once
// Converts materials and lights of other formats to rayclock's.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

/// The values of an MTL material as 32-bit floats. The initial values hold for statements that the file
/// lacks.
struct MtlSurface {
    glm::vec3 diffuse{0.6f}, specular{0}, emission{0};
    float shine = 0, opacity = 1, index = 1;
    int illumination = 1;
};
/// Converts a material. Clamps values that are out of range.
Material material_of(const MtlSurface& surface, const std::string& name);
/// Returns true if a value is out of range, so that material_of() uses the nearest valid one.
bool is_out_of_range(const MtlSurface& surface);

/// The values of a glTF material. The fourth component of `colour` is the opacity.
struct GltfSurface {
    glm::vec4 colour{1};
    float metal = 1, rough = 1, transmission = 0;
    double index = 1.5;   ///< used only if light is transmitted
    glm::vec3 emission{0};
    bool is_unlit = false;
};
Material material_of(const GltfSurface& surface, const std::string& name);
bool is_out_of_range(const GltfSurface& surface);

/// The continuation of a warning about a "material" for which add_emission() returns false.
constexpr const char* mixed_emission =
    "giving off light of a colour other than that of the surface, which is not drawn";
/// Makes the surface show its own colour, independent of the light.
void make_unlit(Material& material);
/// Adds emission to a material. Rayclock expresses emission as ambient light, which has the surface's colour.
/// So it returns false and adds nothing if the surface also scatters light and the colours differ.
bool add_emission(Material& material, const glm::dvec3& emission);

/// A glTF light and the place of its node.
struct PlacedLight {
    bool is_directional;
    glm::vec3 colour;
    glm::dvec3 position, towards;   ///< of the node: its origin and its z axis
};

/// Converts lights. Rayclock's lights have no attenuation and no unit. So the light that is brightest at the
/// middle of `bounds` gets 1 / sqrt(n), n being the number of lights. The others scale in proportion. A
/// directional light is placed far away.
std::vector<Light> lights_of(const std::vector<PlacedLight>& lights, const Bounds& bounds);

}   // namespace rayclock
