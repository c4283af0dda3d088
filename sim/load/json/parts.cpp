// Reading cameras, lights, materials, primitives and transforms of a JSON scene.
#include "sim/load/json/parts.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace rayclock {
namespace {

glm::dvec3 components(const JsonValue& in, double most) {
    const glm::dvec3 v = in.triple();
    for (int i = 0; i < 3; ++i)
        if (!(v[i] >= 0 && v[i] <= most)) in.expected(fmt::format("3 numbers within 0 and {}", most));
    return v;
}

void at_least(const JsonValue& in, std::string_view key, double& out, double least) {
    const auto value = in.find(key);
    if (!value) return;
    out = value->number();
    if (out < least) value->expected(fmt::format("at least {}", least));
}

void weight(const JsonValue& in, std::string_view key, double& out) {
    const auto value = in.find(key);
    if (!value) return;
    out = value->number();
    if (!(out >= 0 && out <= 1)) value->expected("a number within 0 and 1");
}

Wrap wrap_of(const JsonValue& in) {
    if (in.raw() == "repeat") return Wrap::repeat;
    if (in.raw() == "mirror") return Wrap::mirror;
    if (in.raw() == "clamp") return Wrap::clamp;
    in.expected("\"repeat\", \"mirror\" or \"clamp\", or a list of two of them for s and t");
}

glm::dvec2 point_of(const JsonValue& in) {
    if (!in.raw().is_array() || in.size() != 2) in.expected("2 numbers, s and t");
    return {in[0].number(), in[1].number()};
}

int number_or(const JsonValue& in, std::string_view key, int usual, int least, int most) {
    const auto value = in.find(key);
    if (!value) return usual;
    const double number = value->number();
    if (number != std::floor(number) || number < least || number > most)
        value->expected(fmt::format("a whole number from {} to {}", least, most));
    return int(number);
}

int texels_on_side(const JsonValue& in) {
    const double number = in.number();
    if (!(number >= 1 && number <= max_texture_side) || std::exp2(std::ilogb(number)) != number)
        in.expected(fmt::format("a power of two from 1 to {}", max_texture_side));
    return int(number);
}

Pattern::Kind pattern_kind(const JsonValue& in) {
    if (in.raw() == "checker") return Pattern::Kind::checker;
    if (in.raw() == "bricks") return Pattern::Kind::bricks;
    if (in.raw() == "gradient") return Pattern::Kind::gradient;
    if (in.raw() == "noise") return Pattern::Kind::noise;
    in.expected("\"checker\", \"bricks\", \"gradient\" or \"noise\"");
}

/// Throws UserError for a key of another kind of pattern.
void check_pattern_keys(const JsonValue& in, Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::checker:
            return in.only_keys(
                {"pattern", "size", "colours", "columns", "rows", "wrap", "filter", "mipmaps"});
        case Pattern::Kind::bricks:
            return in.only_keys(
                {"pattern", "size", "colours", "columns", "rows", "joint", "wrap", "filter", "mipmaps"});
        case Pattern::Kind::gradient:
            return in.only_keys({"pattern", "size", "colours", "wrap", "filter", "mipmaps"});
        case Pattern::Kind::noise:
            return in.only_keys({"pattern", "size", "colours", "columns", "rows", "octaves", "seed", "wrap",
                                 "filter", "mipmaps"});
    }
}

Pattern pattern_of(const JsonValue& in) {
    Pattern out;
    out.kind = pattern_kind(in.at("pattern"));
    check_pattern_keys(in, out.kind);
    if (const auto size = in.find("size")) {
        const bool has_two = size->raw().is_array() && size->size() == 2;
        out.width = texels_on_side(has_two ? (*size)[0] : *size);
        out.height = texels_on_side(has_two ? (*size)[1] : *size);
    }
    if (const auto colours = in.find("colours")) {
        const bool is_pair = out.kind == Pattern::Kind::bricks;
        if (colours->array().size() < 2 || (is_pair && colours->size() > 2))
            colours->expected(is_pair ? "a list of 2 colours, of the bricks and of their joints"
                                      : "a list of at least 2 colours");
        out.colours.clear();
        for (std::size_t i = 0; i < colours->size(); ++i) out.colours.push_back(colour_of((*colours)[i]));
    }
    if (out.kind == Pattern::Kind::bricks) out.columns = 4, out.rows = 8;
    if (out.kind == Pattern::Kind::noise) out.columns = out.rows = 4;
    out.octaves = number_or(in, "octaves", out.octaves, 1, max_octaves);
    const int most = out.kind == Pattern::Kind::noise ? max_cells >> (out.octaves - 1) : max_cells;
    out.columns = number_or(in, "columns", out.columns, 1, most);
    out.rows = number_or(in, "rows", out.rows, 1, most);
    weight(in, "joint", out.joint);
    if (const auto seed = in.find("seed")) out.seed = seed->whole(std::uint64_t(1) << 53);
    return out;
}

/// Reads a vector that can span a plane: its length lies within 1e-100 and 1e100.
glm::dvec3 side(const JsonValue& in) {
    const glm::dvec3 v = in.triple();
    const double length = glm::length(v);
    if (!(length > 1e-100 && length < 1e100))
        in.expected("a direction, no shorter than 1e-100 and no longer than 1e100");
    return v;
}

}   // namespace

glm::dmat4 matrix_of(const JsonValue& in) {
    if (!in.raw().is_array() || in.size() != 16) in.expected("16 numbers, row by row");
    glm::dmat4 m;
    for (std::size_t i = 0; i < 16; ++i) m[static_cast<int>(i % 4)][static_cast<int>(i / 4)] = in[i].number();
    for (std::size_t i = 12; i < 16; ++i)
        if (in[i].number() != (i == 15 ? 1 : 0))
            in[i].expected(i == 15 ? "1: the last row is 0 0 0 1" : "0: the last row is 0 0 0 1");
    if (is_singular(m)) in.expected("a matrix that keeps solids solid");
    return m;
}

Turn turn_of(const JsonValue& in) {
    in.only_keys({"axis", "degrees"});
    const JsonValue axis = in.at("axis");
    const double length = glm::length(axis.triple());
    if (!(length > 0) || !std::isfinite(length)) axis.expected("a direction");
    return {axis.triple() / length, in.at("degrees").number()};
}

glm::dquat quaternion(const Turn& turn) { return glm::angleAxis(glm::radians(turn.degrees), turn.axis); }

glm::dvec3 scale_of(const JsonValue& in) {
    const glm::dvec3 factors = in.raw().is_number()  ? glm::dvec3(in.number())
                               : in.raw().is_array() ? in.triple()
                                                     : glm::dvec3(0);
    if (!in.raw().is_number() && !in.raw().is_array()) in.expected("a number or 3 numbers");
    if (is_singular(glm::scale(glm::dmat4(1), factors)))
        in.expected("different from 0 (and within 1e-100 to 1e100) in all directions");
    return factors;
}

Camera camera_of(const JsonValue& in) {
    in.only_keys({"eye", "at", "up", "fov_degrees"});
    return camera_of_keys(in);
}

Camera camera_of_keys(const JsonValue& in) {
    Camera camera;
    camera.eye = in.at("eye").triple();
    camera.at = in.at("at").triple();
    if (const auto up = in.find("up")) camera.up = up->triple();
    camera.fov_degrees = in.number_or("fov_degrees", camera.fov_degrees);
    if (!(camera.fov_degrees > 0 && camera.fov_degrees < 180))
        in.at("fov_degrees").expected("an angle between 0 and 180");
    return camera;
}

Light light_of(const JsonValue& in) {
    in.only_keys({"position", "colour"});
    return light_of_keys(in);
}

Light light_of_keys(const JsonValue& in) {
    Light light;
    light.position = in.at("position").triple();
    if (const auto colour = in.find("colour")) light.colour = components(*colour, max_light);
    return light;
}

JsonTexture texture_of(const JsonValue& in) {
    JsonTexture out;
    if (in.raw().is_string()) {
        out.file = in.string();
        return out;
    }
    if (!in.raw().is_object()) in.expected("the name of a picture, or an object with 'file' or 'pattern'");
    if (in.find("pattern")) {
        if (in.find("file")) in.refuse("has both 'file' and 'pattern'");
        out.pattern = pattern_of(in);
    } else {
        in.only_keys({"file", "pattern", "wrap", "filter", "mipmaps"});
        out.file = in.at("file").string();
    }
    if (const auto wrap = in.find("wrap")) {
        if (wrap->raw().is_array() && wrap->size() == 2)
            out.texture.wrap_s = wrap_of((*wrap)[0]), out.texture.wrap_t = wrap_of((*wrap)[1]);
        else
            out.texture.wrap_s = out.texture.wrap_t = wrap_of(*wrap);
    }
    if (const auto filter = in.find("filter")) {
        out.texture.nearest = filter->raw() == "nearest";
        if (!out.texture.nearest && filter->raw() != "bilinear")
            filter->expected("\"nearest\" or \"bilinear\"");
    }
    out.texture.mipmaps = flag_or(in, "mipmaps", true);
    return out;
}

Material material_of(const JsonValue& in, Material material) {
    in.only_keys({"colour", "ambient", "diffuse", "highlight", "shine", "mirror", "transmit", "index",
                  "checkered", "other", "schlick"});
    return material_of_keys(in, std::move(material));
}

Material material_of_keys(const JsonValue& in, Material material) {
    in.only_keys({"colour", "ambient", "diffuse", "highlight", "shine", "mirror", "transmit", "index",
                  "checkered", "other", "schlick", "texture", "cutoff"});
    if (const auto colour = in.find("colour")) material.colour = colour_of(*colour);
    if (const auto other = in.find("other")) material.other = colour_of(*other);
    weight(in, "ambient", material.ambient);
    weight(in, "diffuse", material.diffuse);
    weight(in, "highlight", material.highlight);
    at_least(in, "shine", material.shine, 0);
    weight(in, "mirror", material.mirror);
    weight(in, "transmit", material.transmit);
    weight(in, "cutoff", material.cutoff);
    at_least(in, "index", material.index, 0.01);
    material.checkered = flag_or(in, "checkered", material.checkered);
    material.schlick = flag_or(in, "schlick", material.schlick);
    return material;
}

glm::dvec3 colour_of(const JsonValue& in) { return components(in, 1); }

bool flag_or(const JsonValue& in, std::string_view key, bool otherwise) {
    const auto value = in.find(key);
    if (!value) return otherwise;
    if (!value->raw().is_boolean()) value->expected("true or false");
    return value->raw().get<bool>();
}

Sphere sphere_of(const JsonValue& in) {
    in.only_keys({"centre", "radius", "material", "rotate"});
    Sphere sphere;
    sphere.centre = in.at("centre").triple();
    sphere.radius = in.at("radius").number();
    if (!(sphere.radius > 0)) in.at("radius").expected("a number above 0");
    if (const auto rotate = in.find("rotate")) sphere.turn = glm::mat3_cast(quaternion(turn_of(*rotate)));
    return sphere;
}

Plane plane_of(const JsonValue& in) {
    in.only_keys({"point", "u", "v", "material", "coordinates"});
    Plane plane;
    plane.point = in.at("point").triple();
    plane.u = side(in.at("u"));
    plane.v = side(in.at("v"));
    if (!(glm::length(glm::cross(glm::normalize(plane.u), glm::normalize(plane.v))) > 1e-9))
        in.at("v").expected("a direction that is not parallel to u");
    if (const auto corners = in.find("coordinates")) {
        if (!corners->raw().is_array() || corners->size() != 3)
            corners->expected("3 points [s, t], at point, point + u and point + v");
        for (std::size_t i = 0; i < 3; ++i) {
            plane.coordinates[i] = point_of((*corners)[i]);
            for (const double x : {plane.coordinates[i].x, plane.coordinates[i].y})
                if (!(std::abs(x) <= max_given_coordinate))
                    (*corners)[i].expected(fmt::format("within -{0} and {0}", max_given_coordinate));
        }
    }
    return plane;
}

Scene inline_mesh(const JsonValue& in) {
    Scene mesh;
    const JsonValue vertices = in.at("vertices").array(), triangles = in.at("triangles").array();
    for (std::size_t i = 0; i < vertices.size(); ++i) mesh.vertices.push_back(vertices[i].triple());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const JsonValue corners = triangles[i];
        if (!corners.raw().is_array() || corners.size() != 3) corners.expected("3 vertex numbers");
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k)
            triangle.vertex[k] = static_cast<std::uint32_t>(corners[k].whole(mesh.vertices.size()));
        mesh.triangles.push_back(triangle);
    }
    if (mesh.triangles.empty()) triangles.refuse("has no triangles");
    if (const auto coordinates = in.find("coordinates")) {
        if (coordinates->array().size() != mesh.triangles.size())
            coordinates->refuse(
                fmt::format("has {} entries for {} triangles", coordinates->size(), mesh.triangles.size()));
        for (std::size_t i = 0; i < coordinates->size(); ++i) {
            const JsonValue corners = (*coordinates)[i];
            if (!corners.raw().is_array() || corners.size() != 3) corners.expected("3 points [s, t]");
            mesh.coordinates.push_back({point_of(corners[0]), point_of(corners[1]), point_of(corners[2])});
        }
    }
    mesh.materials.push_back({.name = "default"});
    return mesh;
}

glm::dmat4 transform_of(const JsonValue& object) {
    if (const auto given = object.find("matrix")) {
        for (const char* key : {"translate", "rotate", "scale"})
            if (object.find(key)) object.refuse(fmt::format("has both 'matrix' and '{}'", key));
        return matrix_of(*given);
    }
    glm::dmat4 m(1);
    if (const auto translate = object.find("translate")) m = glm::translate(m, translate->triple());
    if (const auto rotate = object.find("rotate")) {
        const Turn turn = turn_of(*rotate);
        m = m * glm::rotate(glm::dmat4(1), glm::radians(turn.degrees), turn.axis);
    }
    if (const auto scale = object.find("scale")) m = m * glm::scale(glm::dmat4(1), scale_of(*scale));
    return m;
}

bool keeps_spheres(const glm::dmat4& place) {
    const glm::dmat3 m(place);
    const double length = glm::length(m[0]);
    const glm::dvec3 x = m[0] / length, y = m[1] / length, z = m[2] / length;
    constexpr double rounding = 1e-9;
    const auto is = [](double a, double b) { return std::abs(a - b) < rounding; };
    return is(glm::length(y), 1) && is(glm::length(z), 1) && is(glm::dot(x, y), 0) && is(glm::dot(y, z), 0) &&
           is(glm::dot(z, x), 0);
}

}   // namespace rayclock
