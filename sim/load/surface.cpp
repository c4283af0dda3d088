// The formulas of the conversions.
#include "sim/load/surface.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rayclock {
namespace {

/// Clamps to 0..1. NaN, which a binary file may hold, becomes 0.
double fraction(double x) { return x > 0 ? std::min(x, 1.0) : 0; }
glm::dvec3 fractions(const glm::vec3& c) { return {fraction(c.r), fraction(c.g), fraction(c.b)}; }

/// Replaces infinity, to which a file's double beyond the range of float converts, by the default.
double finite_or(float x, double otherwise) { return std::isfinite(x) ? x : otherwise; }

bool is_fraction(double x) { return x >= 0 && x <= 1; }
bool are_fractions(const glm::vec3& c) { return is_fraction(c.r) && is_fraction(c.g) && is_fraction(c.b); }

/// Distributes the light: reflected and transmitted light is not scattered as well.
void share(Material& out) {
    out.transmit = fraction(out.transmit);
    out.mirror = std::min(fraction(out.mirror), 1 - out.transmit);
    const double rest = 1 - out.mirror - out.transmit;
    out.diffuse *= rest;
    out.ambient *= rest;
}

}   // namespace

Material material_of(const MtlSurface& in, const std::string& name) {
    Material out;
    out.name = name;
    out.colour = fractions(in.diffuse);
    const glm::dvec3 specular = fractions(in.specular);
    const double strength = std::max({specular.x, specular.y, specular.z});
    // Illumination models 0 and 1 have no highlight. In models 3 to 9 the specular colour is also the mirror
    // weight.
    if (in.illumination >= 2) out.highlight = strength;
    if (in.illumination >= 3 && in.illumination <= 9) out.mirror = strength;
    out.shine = std::max(1.0, finite_or(in.shine, 1));
    out.transmit = 1 - fraction(finite_or(in.opacity, 1));
    out.index = finite_or(in.index, 1);
    if (!(out.index > 0)) out.index = 1;
    share(out);
    return out;
}

bool is_out_of_range(const MtlSurface& s) {
    return !are_fractions(s.diffuse) || !are_fractions(s.specular) || !are_fractions(s.emission) ||
           !(s.shine >= 0) || !is_fraction(s.opacity) || !(s.index > 0) || s.illumination < 0 ||
           s.illumination > 10;
}

Material material_of(const GltfSurface& in, const std::string& name) {
    Material out;
    out.name = name;
    out.colour = fractions(glm::vec3(in.colour));
    const double metallic = fraction(finite_or(in.metal, 1));
    const double rough = fraction(finite_or(in.rough, 1));
    const double polish = (1 - rough) * (1 - rough);
    out.mirror = metallic * polish;
    out.highlight = 0.5 * polish;
    // The Phong exponent whose lobe is as wide as that of the squared roughness.
    out.shine = std::clamp(2 / std::max(1e-6, std::pow(rough, 4)) - 2, 1.0, 1000.0);
    out.transmit = std::max(1 - fraction(finite_or(in.colour.a, 1)), fraction(finite_or(in.transmission, 0)));
    // Alpha blending does not refract.
    out.index = in.transmission > 0 && in.index > 0 ? in.index : 1;
    share(out);
    if (in.is_unlit) make_unlit(out);
    return out;
}

bool is_out_of_range(const GltfSurface& s) {
    const bool is_index = s.index >= 1 || s.index == 0;   // 0 has a special meaning in KHR_materials_ior
    return !are_fractions(glm::vec3(s.colour)) || !is_fraction(s.colour.a) || !is_fraction(s.metal) ||
           !is_fraction(s.rough) || !is_fraction(s.transmission) || !are_fractions(s.emission) || !is_index;
}

void make_unlit(Material& material) {
    material.ambient = 1 - material.transmit;
    material.diffuse = material.highlight = material.mirror = 0;
}

bool add_emission(Material& material, const glm::dvec3& emission) {
    const glm::dvec3 light = glm::clamp(emission, 0.0, 1.0);
    const double most = std::max({light.x, light.y, light.z});
    if (most == 0) return true;
    glm::dvec3& colour = material.colour;
    const double strongest = std::max({colour.x, colour.y, colour.z});
    if (strongest == 0 || material.diffuse + material.ambient == 0) {
        colour = light;
        material.ambient = 1, material.diffuse = 0;
        return true;
    }
    const double ratio = most / strongest;
    const glm::dvec3 off = glm::abs(light - ratio * colour);
    if (std::max({off.x, off.y, off.z}) > 1e-6 * most) return false;   // files hold 32-bit floats
    // An ambient weight above 1 moves into the colour.
    const double ambient = material.ambient + ratio, scale = std::max(ambient, 1.0);
    colour = glm::min(colour * scale, 1.0);
    material.ambient = ambient / scale;
    material.diffuse /= scale;
    return true;
}

std::vector<Light> lights_of(const std::vector<PlacedLight>& placed, const Bounds& bounds) {
    const glm::dvec3 middle = 0.5 * (bounds.lo + bounds.hi);
    const double size = glm::length(bounds.hi - bounds.lo);
    std::vector<Light> lights;
    double brightest = 0;
    for (const PlacedLight& in : placed) {
        Light light;
        light.colour = glm::dvec3(in.colour);
        light.position = in.position;
        if (in.is_directional) {
            light.position = middle + 20 * size * glm::normalize(in.towards);
        } else {
            const glm::dvec3 to = light.position - middle;
            light.colour /= std::max(glm::dot(to, to), 1e-6 * size * size);
        }
        const double strength = std::max({light.colour.x, light.colour.y, light.colour.z});
        if (!(strength > 0) || !std::isfinite(strength) ||
            !std::isfinite(glm::dot(light.position, light.position)))
            continue;
        brightest = std::max(brightest, strength);
        lights.push_back(light);
    }
    for (Light& light : lights)
        light.colour *= 1 / (brightest * std::sqrt(static_cast<double>(lights.size())));
    return lights;
}

}   // namespace rayclock
