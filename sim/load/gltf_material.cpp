#include "sim/load/gltf_material.hpp"

#include <array>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace rayclock {
namespace {

float single(double x) { return static_cast<float>(x); }

/// True if the object itself says how to find a texture.
bool names_texture(const JsonValue& in) {
    for (const auto& [key, ignored] : in.object().raw().items())
        if (key.ends_with("Texture") && key != "baseColorTexture") return true;
    return false;
}

/// `count` finite numbers under `key`, or false.
template <std::size_t count>
bool numbers(const JsonValue& in, const char* key, std::array<float, count>& out) {
    const auto list = in.find(key);
    if (!list) return false;
    if (!list->raw().is_array() || list->size() != count) list->expected(fmt::format("{} numbers", count));
    for (std::size_t i = 0; i < count; ++i) out[i] = single((*list)[i].number());
    return true;
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
    // Only blending makes a surface show what is behind it.
    const auto mode = in.find("alphaMode");
    out.blends = mode && mode->string() == "BLEND";
    if (!out.blends) surface.colour.a = 1;
    if (const auto given = in.find("extensions")) {
        if (const auto transmission = given->find("KHR_materials_transmission"))
            surface.transmission = single(transmission->number_or("transmissionFactor", 0));
        if (const auto refraction = given->find("KHR_materials_ior"))
            surface.index = refraction->number_or("ior", surface.index);
        for (const auto& [key, value] : given->raw().items())
            if (value.is_object()) out.has_textures = out.has_textures || names_texture(given->at(key));
    }
    return out;
}

glm::dmat4 gltf_transform(const JsonValue& node) {
    glm::dmat4 out(1);
    std::array<float, 16> matrix{};
    std::array<float, 3> move{0, 0, 0}, scale{1, 1, 1};
    std::array<float, 4> turn{0, 0, 0, 1};
    // All are read, so that all are checked.
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

// Cameras and lights are at the origin of their node and look along -z.
std::optional<Camera> gltf_camera(const JsonValue& in, const glm::dmat4& place) {
    const auto lens = in.find("perspective");
    if (!lens) return std::nullopt;
    Camera out;
    out.eye = glm::dvec3(place[3]);
    out.at = out.eye - glm::dvec3(place[2]);
    out.up = glm::dvec3(place[1]);
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
    // A spot's cone is not in our lights.
    return {type == "directional", glm::vec3(colour) * single(intensity), glm::dvec3(place[3]),
            glm::dvec3(place[2])};
}

void GltfDropped::say(Loading& loading, const std::string& file) const {
    const auto tell = [&](std::uint64_t count, const char* what, const char* sentence) {
        if (count > 0) loading.note(file, counted(count, what) + sentence);
    };
    tell(odd, "material", " with values out of range, taken as the nearest within");
    tell(averaged, "material", " with a texture of its colour, drawn in the mean of the texture");
    tell(textures, "material", " with other textures, which are not drawn");
    tell(colours, "primitive", " with vertex colours, which are not drawn");
    tell(lines, "primitive", " of points or lines left out");
}

}   // namespace rayclock
