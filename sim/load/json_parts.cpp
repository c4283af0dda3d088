#include "sim/load/json_parts.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace rayclock {
namespace {

glm::dvec3 weights(const JsonValue& in) {
    const glm::dvec3 v = in.triple();
    if (!(v.x >= 0 && v.y >= 0 && v.z >= 0)) in.expected("3 numbers, none negative");
    return v;
}

void read(const JsonValue& in, std::string_view key, double& out, double least) {
    const auto value = in.find(key);
    if (!value) return;
    out = value->number();
    if (out < least) value->expected(fmt::format("at least {}", least));
}

/// The volume that the three directions of unit length span is 1 for a rotation and 0 when flat. Lengths beyond any
/// use are refused with it: their products would leave the range of a double.
bool is_singular(const glm::dmat4& m) {
    glm::dmat3 directions(m);
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(directions[i]);
        if (!(length > 1e-100 && length < 1e100)) return true;
        directions[i] /= length;
    }
    return !(std::abs(glm::determinant(directions)) > 1e-9);
}

glm::dmat4 matrix(const JsonValue& in) {
    if (!in.raw().is_array() || in.size() != 16) in.expected("16 numbers, row by row");
    glm::dmat4 m;
    for (std::size_t i = 0; i < 16; ++i) m[static_cast<int>(i % 4)][static_cast<int>(i / 4)] = in[i].number();
    for (std::size_t i = 12; i < 16; ++i)
        if (in[i].number() != (i == 15 ? 1 : 0)) in[i].expected(i == 15 ? "1: the last row is 0 0 0 1" : "0: the last row is 0 0 0 1");
    if (is_singular(m)) in.expected("a matrix that keeps solids solid");
    return m;
}

glm::dmat4 rotation(const JsonValue& in) {
    in.only_keys({"axis", "degrees"});
    const JsonValue axis = in.at("axis");
    const double length = glm::length(axis.triple());
    if (!(length > 0) || !std::isfinite(length)) axis.expected("a direction");
    return glm::rotate(glm::dmat4(1), glm::radians(in.at("degrees").number()), axis.triple() / length);
}

glm::dmat4 scaling(const JsonValue& in) {
    const glm::dvec3 factors = in.raw().is_number() ? glm::dvec3(in.number()) : in.raw().is_array() ? in.triple() : glm::dvec3(0);
    if (!in.raw().is_number() && !in.raw().is_array()) in.expected("a number or 3 numbers");
    const glm::dmat4 m = glm::scale(glm::dmat4(1), factors);
    if (is_singular(m)) in.expected("different from 0 (and within 1e-100 to 1e100) in all directions");
    return m;
}

} // namespace

Camera camera_of(const JsonValue& in) {
    in.only_keys({"eye", "at", "up", "fov_degrees"});
    Camera camera;
    camera.eye = in.at("eye").triple();
    camera.at = in.at("at").triple();
    if (const auto up = in.find("up")) camera.up = up->triple();
    camera.fov_degrees = in.number_or("fov_degrees", camera.fov_degrees);
    if (!(camera.fov_degrees > 0 && camera.fov_degrees < 180)) in.at("fov_degrees").expected("an angle between 0 and 180");
    return camera;
}

Light light_of(const JsonValue& in) {
    in.only_keys({"position", "colour"});
    Light light;
    light.position = in.at("position").triple();
    if (const auto colour = in.find("colour")) light.colour = weights(*colour);
    return light;
}

Material material_of(const JsonValue& in, const std::string& name) {
    in.only_keys({"colour", "ambient", "diffuse", "highlight", "shine", "mirror", "transmit", "index"});
    Material material;
    material.name = name;
    if (const auto colour = in.find("colour")) material.colour = weights(*colour);
    read(in, "ambient", material.ambient, 0);
    read(in, "diffuse", material.diffuse, 0);
    read(in, "highlight", material.highlight, 0);
    read(in, "shine", material.shine, 0);
    read(in, "mirror", material.mirror, 0);
    read(in, "transmit", material.transmit, 0);
    read(in, "index", material.index, 0.01);
    return material;
}

Scene inline_mesh(const JsonValue& in) {
    Scene mesh;
    const JsonValue vertices = in.at("vertices").array(), triangles = in.at("triangles").array();
    for (std::size_t i = 0; i < vertices.size(); ++i) mesh.vertices.push_back(vertices[i].triple());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const JsonValue corners = triangles[i];
        if (!corners.raw().is_array() || corners.size() != 3) corners.expected("3 vertex numbers");
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) triangle.vertex[k] = static_cast<std::uint32_t>(corners[k].whole(mesh.vertices.size()));
        mesh.triangles.push_back(triangle);
    }
    if (mesh.triangles.empty()) triangles.refuse("has no triangles");
    mesh.materials.push_back({.name = "default"});
    return mesh;
}

glm::dmat4 transform_of(const JsonValue& object) {
    if (const auto given = object.find("matrix")) {
        for (const char* key : {"translate", "rotate", "scale"})
            if (object.find(key)) object.refuse(fmt::format("has both 'matrix' and '{}'", key));
        return matrix(*given);
    }
    glm::dmat4 m(1);
    if (const auto translate = object.find("translate")) m = glm::translate(m, translate->triple());
    if (const auto rotate = object.find("rotate")) m = m * rotation(*rotate);
    if (const auto scale = object.find("scale")) m = m * scaling(*scale);
    return m;
}

} // namespace rayclock
