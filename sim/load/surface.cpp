#include "sim/load/surface.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <assimp/GltfMaterial.h>
#include <assimp/ObjMaterial.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace rayclock {
namespace {

double number(const aiMaterial& m, const char* key, double otherwise) {
    ai_real value = 0;
    return m.Get(key, 0, 0, value) == aiReturn_SUCCESS && std::isfinite(value) ? value : otherwise;
}

double fraction(double x) { return std::clamp(x, 0.0, 1.0); }

glm::dvec3 colour(const aiMaterial& m, const char* key, glm::dvec3 otherwise) {
    aiColor4D c;
    if (m.Get(key, 0, 0, c) != aiReturn_SUCCESS) return otherwise;
    return {fraction(c.r), fraction(c.g), fraction(c.b)};
}

/// What is reflected or let through is not scattered as well.
void share(Material& out) {
    out.transmit = fraction(out.transmit);
    out.mirror = std::min(fraction(out.mirror), 1 - out.transmit);
    const double rest = 1 - out.mirror - out.transmit;
    out.diffuse *= rest;
    out.ambient *= rest;
}

void from_mtl(const aiMaterial& in, Material& out) {
    const glm::dvec3 specular = colour(in, "$clr.specular", glm::dvec3(0));
    int illumination = 2;
    in.Get(AI_MATKEY_OBJ_ILLUM, illumination);
    const double strength = std::max({specular.x, specular.y, specular.z});
    // Models 0 and 1 have no highlight; from 3 on the specular colour also says how much is mirrored.
    if (illumination >= 2) out.highlight = strength;
    if (illumination >= 3 && illumination <= 9) out.mirror = strength;
    out.shine = std::max(1.0, number(in, "$mat.shininess", 1));
    out.transmit = 1 - fraction(number(in, "$mat.opacity", 1));
    out.index = number(in, "$mat.refracti", 1);
}

void from_gltf(const aiMaterial& in, Material& out, double refraction) {
    const double metallic = fraction(number(in, "$mat.metallicFactor", 1));
    const double rough = fraction(number(in, "$mat.roughnessFactor", 1));
    const double polish = (1 - rough) * (1 - rough);
    out.mirror = metallic * polish;
    out.highlight = 0.5 * polish;
    // The Phong exponent whose lobe is as wide as that of the roughness squared.
    out.shine = std::clamp(2 / std::max(1e-6, std::pow(rough, 4)) - 2, 1.0, 1000.0);
    out.transmit = std::max(1 - fraction(number(in, "$mat.opacity", 1)), fraction(number(in, "$mat.transmission.factor", 0)));
    out.index = refraction;
}

} // namespace

Material material_of(const aiMaterial& in, const Prepared& prepared) {
    Material out;
    out.name = "default";
    aiString name;
    in.Get(AI_MATKEY_NAME, name);
    const std::string_view alias(name.C_Str());
    std::size_t number = prepared.materials.size();
    if (alias.starts_with('m')) std::from_chars(alias.data() + 1, alias.data() + alias.size(), number);
    if (number >= prepared.materials.size()) return out;  // the importer's own stand-in
    out.name = prepared.materials[number];
    if (prepared.refraction.empty()) {
        out.colour = colour(in, "$clr.diffuse", out.colour);
        from_mtl(in, out);
    } else {
        out.colour = colour(in, "$clr.base", out.colour);
        from_gltf(in, out, prepared.refraction[number]);
    }
    if (!(out.index > 0)) out.index = 1;
    share(out);
    return out;
}

// glTF, the only format with cameras and lights here, puts both at the origin of their node and lets them look along
// -z. The importer's own positions are not used: for cameras it has the node's translation in there a second time.
Camera camera_of(const aiCamera& in, const glm::dmat4& place) {
    Camera out;
    out.eye = glm::dvec3(place[3]);
    out.at = out.eye - glm::dvec3(place[2]);
    out.up = glm::dvec3(place[1]);
    out.fov_degrees = glm::degrees(static_cast<double>(in.mHorizontalFOV));
    return out;
}

std::vector<Light> lights_of(const std::vector<PlacedLight>& placed, const Bounds& bounds) {
    const glm::dvec3 middle = 0.5 * (bounds.lo + bounds.hi);
    const double size = glm::length(bounds.hi - bounds.lo);
    std::vector<Light> lights;
    double brightest = 0;
    for (const auto& [in, place] : placed) {
        Light light;
        light.colour = {in->mColorDiffuse.r, in->mColorDiffuse.g, in->mColorDiffuse.b};
        light.position = glm::dvec3(place[3]);
        if (in->mType == aiLightSource_DIRECTIONAL) {
            light.position = middle + 20 * size * glm::normalize(glm::dvec3(place[2]));
        } else {
            const glm::dvec3 to = light.position - middle;
            light.colour /= std::max(glm::dot(to, to), 1e-6 * size * size);
        }
        const double strength = std::max({light.colour.x, light.colour.y, light.colour.z});
        if (!(strength > 0) || !std::isfinite(strength) || !std::isfinite(glm::dot(light.position, light.position))) continue;
        brightest = std::max(brightest, strength);
        lights.push_back(light);
    }
    for (Light& light : lights) light.colour *= 1 / (brightest * std::sqrt(static_cast<double>(lights.size())));
    return lights;
}

} // namespace rayclock
