// Triangles, polygons, strips and fans of COLLADA meshes.
#include "sim/load/dae/geometry.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "model/base/error.hpp"
#include "model/scene/view.hpp"
#include "sim/load/holes.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

/// Transforms a normal by the cofactor matrix of `move`, which keeps it perpendicular to the surface. A
/// mirroring map negates the result.
glm::dvec3 turned(const glm::dmat4& move, const glm::dvec3& normal) {
    const glm::dmat3 m(move);
    const glm::dvec3 made(glm::dot(glm::cross(m[1], m[2]), normal), glm::dot(glm::cross(m[2], m[0]), normal),
                          glm::dot(glm::cross(m[0], m[1]), normal));
    return glm::determinant(m) < 0 ? -made : made;
}

}   // namespace

std::vector<DaePart> DaeGeometries::parts(const XmlElement& geometry, const DaePose& pose,
                                          const DaeSets& sets) {
    std::vector<DaePart> made;
    const XmlElement* const mesh = geometry.find("mesh");
    shapeless_ += !mesh;
    if (!mesh) return made;
    for (const XmlElement& child : mesh->children) {
        const std::string& kind = child.name;
        if (kind == "triangles" || kind == "polylist" || kind == "polygons" || kind == "tristrips" ||
            kind == "trifans")
            made.push_back(primitive(child, pose, sets));
        lines_ += kind == "lines" || kind == "linestrips";
    }
    return made;
}

const DaeGeometries::Inputs& DaeGeometries::vertices(const XmlElement& in) {
    const auto [found, is_new] = vertices_.try_emplace(&in);
    if (!is_new) return found->second;
    for (const XmlElement& input : in.children) {
        if (input.name != "input") continue;
        const std::string semantic = input.attribute("semantic");
        if (semantic == "POSITION") found->second.positions = document_.points(input);
        if (semantic == "NORMAL") found->second.normals = document_.points(input);
        if (semantic == "TEXCOORD" && !found->second.per_vertex) found->second.per_vertex = &input;
        colours_ += semantic == "COLOR";
    }
    return found->second;
}

DaeGeometries::Inputs DaeGeometries::inputs_of(const XmlElement& primitive, const DaeSets& sets) {
    Inputs made;
    bool has_colours = false;
    for (const XmlElement& input : primitive.children) {
        if (input.name != "input") continue;
        const std::string semantic = input.attribute("semantic");
        const std::uint64_t offset = document_.offset(input);
        made.stride = std::max(made.stride, offset + 1);
        has_colours |= semantic == "COLOR";
        if (semantic == "VERTEX") {
            const Inputs& of_vertex = vertices(document_.target(input, "source"));
            made.positions = of_vertex.positions;
            made.position_at = offset;
            made.per_vertex = of_vertex.per_vertex;
            if (of_vertex.normals && !made.normals) made.normals = of_vertex.normals, made.normal_at = offset;
        } else if (semantic == "NORMAL") {
            made.normals = document_.points(input);
            made.normal_at = offset;
        }
    }
    colours_ += has_colours;
    if (!made.positions) document_.refuse(primitive, primitive.name + " without positions");
    if (const auto set = sets.find(primitive.attribute("material")); set != sets.end())
        choose_coordinates(primitive, set->second, made);
    return made;
}

/// The coordinates of <vertices> are the set 0, unless the primitive has its own set 0. If the primitive
/// lacks the chosen set, its corners have no coordinates.
void DaeGeometries::choose_coordinates(const XmlElement& primitive, std::optional<std::uint64_t> set,
                                       Inputs& inputs) {
    std::map<std::uint64_t, const XmlElement*> sets;
    for (const XmlElement& input : primitive.children)
        if (input.name == "input" && input.attribute("semantic") == "TEXCOORD")
            sets.try_emplace(document_.whole(input, "set", 0), &input);
    if (inputs.per_vertex) sets.try_emplace(0, inputs.per_vertex);
    unchosen_ += !set && sets.size() > 1;
    const auto chosen = set ? sets.find(*set) : sets.begin();
    if (chosen == sets.end()) return;
    const XmlElement& input = *chosen->second;
    inputs.coordinate_at = &input == inputs.per_vertex ? inputs.position_at : document_.offset(input);
    try {
        inputs.coordinates = document_.points(input, 2);
    } catch (const UserError& error) {
        inputs.fault = error.what();
    }
}

/// Returns the coordinates of a corner, with t downwards. In the file t increases upwards.
glm::dvec2 DaeGeometries::on_picture(const XmlElement& list, Inputs& inputs, std::uint64_t index) const {
    const auto fault = [&](const std::string& sentence) {
        if (inputs.fault.empty())
            inputs.fault = fmt::format("{}: line {}: {}", printable(document_.file()), list.line, sentence);
        return no_coordinates;
    };
    if (index >= inputs.coordinates->count)
        return fault(fmt::format("texture coordinate index {} is out of range: there are {} (0 is the first)",
                                 index, inputs.coordinates->count));
    const glm::dvec2 given = inputs.coordinates->on_picture(index);
    for (const double x : {given.x, given.y})
        if (!(std::abs(x) <= max_given_coordinate))
            return fault(fmt::format("texture coordinate {} has the value {}; the most is {}", index, x,
                                     max_given_coordinate));
    return {given.x, 1 - given.y};
}

glm::dvec3 DaeGeometries::entry(const XmlElement& list, const DaePoints& source, std::uint64_t index,
                                const char* what) const {
    if (index >= source.count)
        document_.refuse(list, fmt::format("{} index {} is out of range: there are {} (0 is the first)", what,
                                           index, source.count));
    return source[index];
}

DaeGeometries::Corners DaeGeometries::corners_of(const XmlElement& list, Inputs& inputs,
                                                 const DaePose& pose) {
    document_.charge(list.text.size());   // a geometry may be cut again for many skins
    std::vector<std::uint64_t> indices;
    const SourcePosition at{document_.file(), list.line};
    std::string_view rest = list.text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
        const std::int64_t index = whole_number(word, at);
        if (index < 0) at.refuse(fmt::format("index {}", index));
        indices.push_back(static_cast<std::uint64_t>(index));
    }
    if (indices.size() % inputs.stride != 0)
        at.refuse(fmt::format("{} indices, and a corner has {}", indices.size(), inputs.stride));
    Corners corners;
    for (std::size_t i = 0; i < indices.size(); i += inputs.stride) {
        const std::uint64_t vertex = indices[i + inputs.position_at];
        Corner corner{entry(list, *inputs.positions, vertex, "vertex")};
        if (vertex < pose.positions.size()) corner.position = pose.positions[vertex];
        if (inputs.normals)
            corner.normal = entry(list, *inputs.normals, indices[i + inputs.normal_at], "normal");
        if (inputs.coordinates) corner.st = on_picture(list, inputs, indices[i + inputs.coordinate_at]);
        if (vertex < pose.moves.size()) {
            corner.normal = turned(pose.moves[vertex], corner.normal);
            corner.position = glm::dvec3(pose.moves[vertex] * glm::dvec4(corner.position, 1));
        }
        if (!is_finite(corner.position)) at.refuse(fmt::format("vertex {} is not finite", vertex));
        if (!is_finite(corner.normal)) ++lost_normals_, corner.normal = glm::dvec3(0);
        corners.push_back(corner);
    }
    return corners;
}

DaePart DaeGeometries::primitive(const XmlElement& in, const DaePose& pose, const DaeSets& sets) {
    Inputs inputs = inputs_of(in, sets);
    std::vector<Corners> faces;
    if (in.name == "polylist" && in.all("p").size() > 1)
        document_.refuse(in, fmt::format("a polylist with {} <p>", in.all("p").size()));
    for (const XmlElement& child : in.children) {
        if (child.name == "ph") {   // a polygon with holes
            const XmlElement* const outline = child.find("p");
            if (!outline) document_.refuse(child, "a polygon without an outline");
            std::vector<Corners> holes;
            for (const XmlElement* hole : child.all("h")) holes.push_back(corners_of(*hole, inputs, pose));
            std::erase_if(holes, [](const Corners& hole) { return hole.size() < 3; });
            Corners corners = corners_of(*outline, inputs, pose);
            std::size_t count = corners.size();
            for (const Corners& hole : holes) count += hole.size() + 2;
            if (count > max_corners)
                document_.refuse(child, fmt::format("a polygon with {} corners and bridges; the most is {}",
                                                    count, max_corners));
            faces.push_back(corners.size() < 3 ? corners : joined_ring(corners, std::move(holes)));
        }
        if (child.name != "p") continue;
        Corners corners = corners_of(child, inputs, pose);
        if (in.name == "polygons")
            faces.push_back(std::move(corners));
        else if (in.name == "polylist")
            cut_list(in, corners, faces);
        else if (in.name == "triangles")
            for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
                faces.push_back({corners[k], corners[k + 1], corners[k + 2]});
        else   // a strip reverses every second triangle; a fan begins each at its first corner
            for (std::size_t k = 0; k + 2 < corners.size(); ++k)
                faces.push_back(in.name == "trifans"
                                    ? Corners{corners[0], corners[k + 1], corners[k + 2]}
                                    : Corners{corners[k + k % 2], corners[k + 1 - k % 2], corners[k + 2]});
    }
    PartBuilder builder(faces.size(), inputs.normals.has_value());
    for (const Corners& corners : faces) face(in, builder, corners);
    return {assembly_.add(std::move(builder)), in.attribute("material"), inputs.fault};
}

void DaeGeometries::face(const XmlElement& in, PartBuilder& builder, const Corners& corners) {
    if (corners.size() > max_corners)
        document_.refuse(in,
                         fmt::format("a face with {} corners; the most is {}", corners.size(), max_corners));
    if (corners.size() < 3) return;   // a point or a line
    if ((triangles_ += corners.size() - 2) > max_triangles)
        SourcePosition{document_.file()}.refuse(fmt::format("more than {} triangles", max_triangles));
    assembly_.face(builder, corners);
}

void DaeGeometries::cut_list(const XmlElement& in, const Corners& corners,
                             std::vector<Corners>& faces) const {
    const XmlElement* const counts = in.find("vcount");
    if (!counts) document_.refuse(in, "a polylist without vcount");
    std::size_t next = 0;
    std::string_view rest = counts->text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
        const std::int64_t count = whole_number(word, {document_.file(), counts->line});
        if (count < 0 || static_cast<std::uint64_t>(count) > corners.size() - next)
            document_.refuse(
                *counts, fmt::format("a face of {} corners, and {} are left", count, corners.size() - next));
        const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(next);
        if (count >= 3) faces.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count));
        next += static_cast<std::size_t>(count);
    }
}

void DaeGeometries::say_left_out() const {
    const auto say = [&](std::uint64_t count, const char* what, const char* sentence) {
        if (count > 0) document_.loading().note(document_.file(), counted(count, what) + sentence);
    };
    say(shapeless_, "shape", " that is not a mesh, left out");
    say(lines_, "primitive", " of lines left out");
    say(colours_, "primitive", " with vertex colours, which are not drawn");
    say(unchosen_, "primitive",
        " with several sets of texture coordinates, of which its material chooses none, drawn with the "
        "first");
    say(lost_normals_, "corner", " with a normal that is not finite, taken as flat");
}

}   // namespace rayclock
