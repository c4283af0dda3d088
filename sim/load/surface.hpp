// From the materials and lights of other formats to ours.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

/// What MTL says of a material, as 32-bit floats, and what holds where it says nothing.
struct MtlSurface {
    glm::vec3 diffuse{0.6f}, specular{0}, emission{0};
    float shine = 0, opacity = 1, index = 1;
    int illumination = 1;
};
Material material_of(const MtlSurface& surface, const std::string& name);
/// True if a value lies where it means nothing, so that material_of() takes the nearest that does.
bool is_out_of_range(const MtlSurface& surface);

/// What glTF says of one. `colour` ends with the opacity.
struct GltfSurface {
    glm::vec4 colour{1};
    float metal = 1, rough = 1, transmission = 0;
    double index = 1.5;   ///< counts if light is transmitted
    glm::vec3 emission{0};
    bool is_unlit = false;
};
Material material_of(const GltfSurface& surface, const std::string& name);
bool is_out_of_range(const GltfSurface& surface);

/// What becomes of a "material" of which add_emission() makes nothing.
constexpr const char* mixed_emission =
    "giving off light of a colour other than that of the surface, which is not drawn";
/// A surface with a colour of its own, whatever falls on it.
void make_unlit(Material& material);
/// Adds light that a surface gives off. Ours gives off ambient light, which has the surface's colour. So
/// false, and nothing is added, if the emission has another colour than a surface that also scatters light.
bool add_emission(Material& material, const glm::dvec3& emission);

/// A light of glTF and the place of its node.
struct PlacedLight {
    bool is_directional;
    glm::vec3 colour;
    glm::dvec3 position, towards;   ///< of the node: its origin and its z axis
};

/// Our lights have no attenuation and no unit: the brightest as seen from the middle of `bounds` gets 1 /
/// sqrt(n), the others in proportion. A directional light is put far away.
std::vector<Light> lights_of(const std::vector<PlacedLight>& lights, const Bounds& bounds);

}   // namespace rayclock
