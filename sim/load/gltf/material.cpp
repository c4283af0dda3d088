// Conversion of glTF materials with their extensions, and of transforms, cameras and lights.
#include "sim/load/gltf/material.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace rayclock {
namespace {

float single(double x) { return static_cast<float>(x); }

/// Returns the up direction of a camera with these axes to the right and up. A camera has no roll if its axis
/// to the right is level in single precision. It then gets the vertical, which does not change the view.
/// --eye, --at and --orbit keep this direction, so they do not tilt the horizon. A camera that looks straight
/// up or down, or is upside down, keeps its own axis.
glm::dvec3 up_of(const glm::dvec3& right, const glm::dvec3& up) {
    constexpr double level = 0x1p-20, least_height = 0x1p-10;
    const bool is_level = std::abs(right.y) <= level * glm::length(right),
               is_upright = up.y >= least_height * glm::length(up);
    return is_level && is_upright ? glm::dvec3(0, 1, 0) : up;
}

/// Returns true if the object names a texture other than that of the base colour.
bool names_texture(const JsonValue& in) {
    for (const auto& [key, ignored] : in.object().raw().items())
        if (key.ends_with("Texture") && key != "baseColorTexture" && key != "diffuseTexture") return true;
    return false;
}

/// Reads `count` finite numbers under `key`. Returns false if the key is missing.
template <std::size_t count>
bool numbers(const JsonValue& in, const char* key, std::array<float, count>& out) {
    const auto list = in.find(key);
    if (!list) return false;
    if (!list->raw().is_array() || list->size() != count) list->expected(fmt::format("{} numbers", count));
    for (std::size_t i = 0; i < count; ++i) out[i] = single((*list)[i].number());
    return true;
}

float brightness(const glm::vec3& c) {
    return std::sqrt(0.299f * c.r * c.r + 0.587f * c.g * c.g + 0.114f * c.b * c.b);
}

/// Returns the metalness whose mixture with a dielectric of 4 % reflectance reflects as much as given. Solves
/// the quadratic equation in the appendix of KHR_materials_pbrSpecularGlossiness.
float metal_of(float diffuse, float specular, float rest) {
    constexpr float least = 0.04f;
    if (specular < least) return 0;
    const float b = diffuse * rest / (1 - least) + specular - 2 * least, c = least - specular;
    return std::clamp((-b + std::sqrt(std::max(b * b - 4 * least * c, 0.0f))) / (2 * least), 0.0f, 1.0f);
}

/// Converts KHR_materials_pbrSpecularGlossiness to colour, metalness and roughness.
void specular_glossiness(const JsonValue& in, GltfMaterial& out) {
    std::array<float, 4> diffuse{1, 1, 1, 1};
    std::array<float, 3> specular{1, 1, 1};
    numbers(in, "diffuseFactor", diffuse);
    numbers(in, "specularFactor", specular);
    const glm::vec3 scattered(diffuse[0], diffuse[1], diffuse[2]),
        mirrored(specular[0], specular[1], specular[2]);
    const float rest = 1 - std::max({mirrored.r, mirrored.g, mirrored.b});
    const float metal = metal_of(brightness(scattered), brightness(mirrored), rest);
    constexpr float least = 0.04f, tiny = 1e-6f;
    const glm::vec3 of_dielectric = scattered * (rest / (1 - least) / std::max(1 - metal, tiny)),
                    of_metal = (mirrored - least * (1 - metal)) / std::max(metal, tiny);
    const glm::vec3 colour = glm::clamp(glm::mix(of_dielectric, of_metal, metal * metal), 0.0f, 1.0f);
    out.surface.colour = {colour, diffuse[3]};
    out.surface.metal = metal;
    out.surface.rough = 1 - single(in.number_or("glossinessFactor", 1));
    out.base_texture = in.find("diffuseTexture");
}

void extensions(const JsonValue& in, GltfMaterial& out) {
    GltfSurface& surface = out.surface;
    for (const auto& [key, value] : in.object().raw().items()) {
        if (!value.is_object()) continue;
        const JsonValue own = in.at(key);
        out.has_textures = out.has_textures || names_texture(own);
        if (key == "KHR_materials_transmission")
            surface.transmission = single(own.number_or("transmissionFactor", 0));
        else if (key == "KHR_materials_ior")
            surface.index = own.number_or("ior", surface.index);
        else if (key == "KHR_materials_emissive_strength")
            surface.emission *= single(own.number_or("emissiveStrength", 1));
        else if (key == "KHR_materials_unlit")
            surface.is_unlit = true;
        else if (key == "KHR_materials_pbrSpecularGlossiness")
            specular_glossiness(own, out);
        else
            out.has_extensions = true;
    }
}

void set_column(glm::dmat4& m, int column, float x, float y, float z) {
    m[column] = glm::dvec4(x, y, z, m[column].w);
}

}   // namespace

GltfMaterial gltf_material(const JsonValue& in, std::size_t number) {
    GltfMaterial out;
    const auto name = in.object().find("name");
    out.name = name ? name->string() : fmt::format("material {}", number);
    out.has_textures = names_texture(in);
    GltfSurface& surface = out.surface;
    if (const auto pbr = in.find("pbrMetallicRoughness")) {
        std::array<float, 4> colour{};
        if (numbers(*pbr, "baseColorFactor", colour))
            surface.colour = {colour[0], colour[1], colour[2], colour[3]};
        surface.metal = single(pbr->number_or("metallicFactor", 1));
        surface.rough = single(pbr->number_or("roughnessFactor", 1));
        out.has_textures = out.has_textures || names_texture(*pbr);
        out.base_texture = pbr->find("baseColorTexture");
    }
    std::array<float, 3> emission{};
    if (numbers(in, "emissiveFactor", emission)) surface.emission = {emission[0], emission[1], emission[2]};
    if (const auto given = in.find("extensions")) extensions(*given, out);
    // The opacity lets light through only in the mode BLEND.
    const auto mode = in.find("alphaMode");
    out.blends = mode && mode->string() == "BLEND";
    out.is_masked = mode && mode->string() == "MASK";
    if (out.is_masked) out.cutoff = in.number_or("alphaCutoff", 0.5);
    out.is_invisible = out.is_masked && double(surface.colour.a) < out.cutoff;
    // The opacity of the texture is compared with the cut-off over the constant opacity.
    if (out.is_masked && surface.colour.a > 0) out.cutoff /= double(surface.colour.a);
    if (!out.blends) surface.colour.a = 1;
    return out;
}

glm::dmat4 gltf_transform(const JsonValue& node) {
    glm::dmat4 out(1);
    std::array<float, 16> matrix{};
    std::array<float, 3> move{0, 0, 0}, scale{1, 1, 1};
    std::array<float, 4> turn{0, 0, 0, 1};
    // Read all three even if a matrix overrides them, so that all are checked.
    const bool is_moved = numbers(node, "translation", move), is_turned = numbers(node, "rotation", turn),
               is_scaled = numbers(node, "scale", scale);
    if (numbers(node, "matrix", matrix)) {
        for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = matrix[static_cast<std::size_t>(i)];
        return out;
    }
    if (!is_moved && !is_turned && !is_scaled) return out;
    const auto [x, y, z, w] = turn;
    set_column(out, 0, (1 - 2 * (y * y + z * z)) * scale[0], 2 * (x * y + z * w) * scale[0],
               2 * (x * z - y * w) * scale[0]);
    set_column(out, 1, 2 * (x * y - z * w) * scale[1], (1 - 2 * (x * x + z * z)) * scale[1],
               2 * (y * z + x * w) * scale[1]);
    set_column(out, 2, 2 * (x * z + y * w) * scale[2], 2 * (y * z - x * w) * scale[2],
               (1 - 2 * (x * x + y * y)) * scale[2]);
    set_column(out, 3, move[0], move[1], move[2]);
    return out;
}

// Cameras and lights sit at the origin of their node and look along -z.
std::optional<Camera> gltf_camera(const JsonValue& in, const glm::dmat4& place) {
    const auto lens = in.find("perspective");
    if (!lens) return std::nullopt;
    Camera out;
    out.eye = glm::dvec3(place[3]);
    out.at = out.eye - glm::dvec3(place[2]);
    out.up = up_of(glm::dvec3(place[0]), glm::dvec3(place[1]));
    out.fov_degrees = glm::degrees(static_cast<double>(single(lens->at("yfov").number())));
    return out;
}

PlacedLight gltf_light(const JsonValue& in, const glm::dmat4& place) {
    const std::string type = in.at("type").string();
    if (type != "point" && type != "spot" && type != "directional")
        in.at("type").expected("\"point\", \"spot\" or \"directional\"");
    const glm::dvec3 colour = in.find("color") ? in.at("color").triple() : glm::dvec3(1);
    const double intensity = in.number_or("intensity", 1);
    if (!(intensity >= 0 && colour.x >= 0 && colour.y >= 0 && colour.z >= 0))
        in.refuse("must not be negative");
    // Ignore the cone of a spot light: rayclock has no spot lights.
    return {type == "directional", glm::vec3(colour) * single(intensity), glm::dvec3(place[3]),
            glm::dvec3(place[2])};
}

}   // namespace rayclock
