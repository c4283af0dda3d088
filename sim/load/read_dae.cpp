// DAE (COLLADA 1.4 and 1.5): the tree of nodes, meshes, normals and colours of materials are taken. Up
// becomes y. Textures, cameras, lights, animations and skins are left out, and that is said.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "sim/files/text.hpp"
#include "sim/load/dae_material.hpp"
#include "sim/load/mesh_file.hpp"
#include "sim/load/xml.hpp"

namespace rayclock {
namespace {

constexpr int most_deep = 500;   // the tree is walked by recursion

/// Triangles of a mesh with one material, by the name that the mesh has for it.
struct Primitive {
    std::size_t part;
    std::string symbol;
};
using Bindings = std::map<std::string, std::string>;   ///< a mesh's name of a material: its id

class DaeReader {
public:
    DaeReader(const XmlElement& document, const Place& at, Loading& loading)
        : document_(document), at_(at), loading_(loading), assembly_(at.file, loading) {
        collect(document);
    }

    Scene read() {
        if (document_.name != "COLLADA")
            at_.refuse("this is not COLLADA: its element is " + shown(document_.name));
        const glm::dmat4 up = up_axis();
        const XmlElement* const scene = document_.at("scene/instance_visual_scene");
        if (scene)
            for (const XmlElement* node : target(*scene, "url").all("node")) visit(*node, up, 0);
        else if (const XmlElement* const library = document_.find("library_geometries"))
            for (const XmlElement* geometry : library->all("geometry")) copies_.push_back({geometry, up, {}});
        for (const Copy& copy : copies_) build(*copy.geometry);
        if (triangles_ == 0) at_.refuse("the file has no triangles");
        assembly_.make_alike();
        for (const Copy& copy : copies_) place(copy);
        say_left_out();
        return assembly_.take();
    }

private:
    struct Copy {
        const XmlElement* geometry;
        glm::dmat4 place;
        Bindings bindings;
    };

    void collect(const XmlElement& element) {
        if (const std::string id = element.attribute("id"); !id.empty()) by_id_.try_emplace(id, &element);
        for (const XmlElement& child : element.children) collect(child);
    }
    [[noreturn]] void refuse(const XmlElement& where, const std::string& sentence) const {
        Place{at_.file, where.line}.refuse(sentence);
    }
    /// What "#id" in an attribute means.
    const XmlElement& target(const XmlElement& in, const char* key) const {
        const std::string url = in.attribute(key);
        const auto found = url.starts_with('#') ? by_id_.find(url.substr(1)) : by_id_.end();
        if (found == by_id_.end())
            refuse(in, fmt::format("{} names {}, which is not in the file", in.name, shown(url)));
        return *found->second;
    }

    glm::dmat4 up_axis() const {
        const XmlElement* const in = document_.at("asset/up_axis");
        const std::string axis = in ? joined_words(in->text) : "Y_UP";
        glm::dmat4 turn(1);
        if (axis == "Z_UP") turn[1] = {0, 0, -1, 0}, turn[2] = {0, 1, 0, 0};
        if (axis == "X_UP") turn[0] = {0, 1, 0, 0}, turn[1] = {-1, 0, 0, 0};
        return turn;
    }

    // The tree.

    void visit(const XmlElement& node, glm::dmat4 place, int depth) {
        if (depth > most_deep) refuse(node, fmt::format("nodes are nested deeper than {}", most_deep));
        // A node that is met again and again is read, and its geometries are listed, again and again.
        std::uint64_t cost = sizeof(Copy) * (1 + node.children.size());
        for (const XmlElement& child : node.children) cost += child.text.size();
        if (!loading_.may_make(cost)) at_.refuse(loading_.too_much());
        for (const XmlElement& child : node.children) {
            place = place * transform(child);
            const bool is_skin = child.name == "instance_controller";
            if (child.name == "instance_geometry" || is_skin) {
                const XmlElement* geometry = &target(child, "url");
                if (is_skin) {
                    ++skins_;
                    const XmlElement* const skin = geometry->find("skin");
                    if (!skin) continue;
                    geometry = &target(*skin, "source");
                }
                copies_.push_back({geometry, place, bindings(child)});
            }
            left_out_ += child.name == "instance_camera" || child.name == "instance_light";
        }
        for (const XmlElement& child : node.children) {
            if (child.name == "node") visit(child, place, depth + 1);
            if (child.name == "instance_node") visit(target(child, "url"), place, depth + 1);
        }
    }

    glm::dmat4 transform(const XmlElement& in) const {
        glm::dmat4 made(1);
        const auto numbers = [&](std::size_t count) {
            const std::vector<float> list = dae_numbers(in, at_.file);
            if (list.size() != count)
                refuse(in, fmt::format("{} of {} numbers instead of {}", in.name, list.size(), count));
            return list;
        };
        if (in.name == "matrix") {
            const std::vector<float> m = numbers(16);
            for (int i = 0; i < 16; ++i) made[i % 4][i / 4] = m[static_cast<std::size_t>(i)];
        } else if (in.name == "translate") {
            const std::vector<float> v = numbers(3);
            made[3] = {v[0], v[1], v[2], 1};
        } else if (in.name == "scale") {
            const std::vector<float> v = numbers(3);
            for (int i = 0; i < 3; ++i) made[i][i] = v[static_cast<std::size_t>(i)];
        } else if (in.name == "rotate") {
            const std::vector<float> v = numbers(4);
            glm::dvec3 axis(v[0], v[1], v[2]);
            if (!(glm::length(axis) > 0)) return made;
            axis = glm::normalize(axis);
            const double angle = v[3] * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
            for (int i = 0; i < 3; ++i) {   // Rodrigues' rotation
                glm::dvec3 e(0);
                e[i] = 1;
                made[i] = glm::dvec4(e * c + glm::cross(axis, e) * s + axis * glm::dot(axis, e) * (1 - c), 0);
            }
        } else if (in.name == "lookat" || in.name == "skew") {
            refuse(in, "a node with " + in.name + " cannot be read");
        }
        return made;
    }

    Bindings bindings(const XmlElement& instance) {
        Bindings all;
        if (const XmlElement* const bound = instance.at("bind_material/technique_common"))
            for (const XmlElement* m : bound->all("instance_material"))
                all.try_emplace(m->attribute("symbol"), m->attribute("target"));
        if (!loading_.may_make(all.size() * sizeof(XmlElement))) at_.refuse(loading_.too_much());
        return all;
    }

    // Meshes.

    /// Triples of an input's source.
    const std::vector<glm::vec3>& source(const XmlElement& input) {
        const XmlElement& in = target(input, "source");
        const auto [found, is_new] = sources_.try_emplace(&in);
        if (!is_new) return found->second;
        const XmlElement* const accessor = in.at("technique_common/accessor");
        if (!accessor) refuse(in, "a source without an accessor");
        const std::vector<float> numbers = dae_numbers(target(*accessor, "source"), at_.file);
        const auto attribute = [&](const char* key, std::uint64_t otherwise) {
            const std::string text = accessor->attribute(key);
            if (text.empty()) return otherwise;
            const std::int64_t value = whole_number(text, {at_.file, accessor->line});
            if (value < 0 || value > std::int64_t{1} << 32)
                refuse(*accessor, fmt::format("{} is {}", key, value));
            return static_cast<std::uint64_t>(value);
        };
        const std::uint64_t count = attribute("count", 0), offset = attribute("offset", 0),
                            stride = attribute("stride", 1);
        if (stride < 3) refuse(*accessor, fmt::format("a stride of {}, and a point has 3 numbers", stride));
        if (count > 0 && (offset > numbers.size() || (numbers.size() - offset) / stride + 1 < count ||
                          offset + (count - 1) * stride + 3 > numbers.size()))
            refuse(*accessor,
                   fmt::format("{} points go beyond the {} numbers of their array", count, numbers.size()));
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::size_t k = offset + i * stride;
            found->second.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
        }
        return found->second;
    }

    /// Makes the parts of a geometry, when it is met first.
    void build(const XmlElement& geometry) {
        const auto [found, is_new] = parts_.try_emplace(&geometry);
        if (!is_new) return;
        const XmlElement* const mesh = geometry.find("mesh");
        if (!mesh) return void(++shapeless_);
        for (const XmlElement& child : mesh->children) {
            const std::string& kind = child.name;
            if (kind == "triangles" || kind == "polylist" || kind == "polygons" || kind == "tristrips" ||
                kind == "trifans")
                found->second.push_back({primitive(child), child.attribute("material")});
            lines_ += kind == "lines" || kind == "linestrips";
        }
    }

    /// What the inputs of a primitive say of each corner.
    struct Inputs {
        const std::vector<glm::vec3>*positions = nullptr, *normals = nullptr;
        std::uint64_t position_at = 0, normal_at = 0, stride = 1;
    };

    Inputs inputs_of(const XmlElement& primitive) {
        Inputs made;
        constexpr std::int64_t most_inputs = 64;
        for (const XmlElement* input : primitive.all("input")) {
            const std::string semantic = input->attribute("semantic"), text = input->attribute("offset");
            const std::int64_t offset = text.empty() ? 0 : whole_number(text, {at_.file, input->line});
            if (offset < 0 || offset >= most_inputs) refuse(*input, fmt::format("an offset of {}", offset));
            made.stride = std::max(made.stride, static_cast<std::uint64_t>(offset) + 1);
            if (semantic == "VERTEX") {
                for (const XmlElement* of_vertex : target(*input, "source").all("input")) {
                    if (of_vertex->attribute("semantic") == "POSITION") made.positions = &source(*of_vertex);
                    if (of_vertex->attribute("semantic") == "NORMAL" && !made.normals) {
                        made.normals = &source(*of_vertex);
                        made.normal_at = static_cast<std::uint64_t>(offset);
                    }
                }
                made.position_at = static_cast<std::uint64_t>(offset);
            } else if (semantic == "NORMAL") {
                made.normals = &source(*input);
                made.normal_at = static_cast<std::uint64_t>(offset);
            }
        }
        if (!made.positions) refuse(primitive, primitive.name + " without positions");
        return made;
    }

    std::vector<Corner> corners_of(const XmlElement& p, const Inputs& inputs) const {
        std::vector<std::uint64_t> indices;
        const Place at{at_.file, p.line};
        std::string_view rest = p.text;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const std::int64_t index = whole_number(word, at);
            if (index < 0) at.refuse(fmt::format("index {}", index));
            indices.push_back(static_cast<std::uint64_t>(index));
        }
        if (indices.size() % inputs.stride != 0)
            at.refuse(fmt::format("{} indices, and a corner has {}", indices.size(), inputs.stride));
        const auto entry = [&](const std::vector<glm::vec3>& list, std::uint64_t index, const char* what) {
            if (index >= list.size())
                at.refuse(fmt::format("{} index {} is out of range: there are {} (0 is the first)", what,
                                      index, list.size()));
            return glm::dvec3(list[index]);
        };
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < indices.size(); i += inputs.stride) {
            Corner corner{entry(*inputs.positions, indices[i + inputs.position_at], "vertex")};
            if (inputs.normals)
                corner.normal = entry(*inputs.normals, indices[i + inputs.normal_at], "normal");
            corners.push_back(corner);
        }
        return corners;
    }

    std::size_t primitive(const XmlElement& in) {
        const Inputs inputs = inputs_of(in);
        std::vector<std::vector<Corner>> faces;
        for (const XmlElement* p : in.all("p")) {
            std::vector<Corner> corners = corners_of(*p, inputs);
            if (in.name == "polygons")
                faces.push_back(std::move(corners));
            else if (in.name == "polylist")
                cut_list(in, corners, faces);
            else if (in.name == "triangles")
                for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
                    faces.push_back({corners[k], corners[k + 1], corners[k + 2]});
            else   // a strip turns every second triangle over, a fan begins each at its first corner
                for (std::size_t k = 0; k + 2 < corners.size(); ++k)
                    faces.push_back(
                        in.name == "trifans"
                            ? std::vector{corners[0], corners[k + 1], corners[k + 2]}
                            : std::vector{corners[k + k % 2], corners[k + 1 - k % 2], corners[k + 2]});
        }
        lines_ += in.all("ph").size();
        PartBuilder builder(faces.size(), inputs.normals != nullptr);
        for (const std::vector<Corner>& face : faces) {
            if (face.size() > max_corners)
                refuse(in, fmt::format("a face with {} corners; the most is {}", face.size(), max_corners));
            if (face.size() < 3) continue;   // a point or a line
            triangles_ += face.size() - 2;
            assembly_.face(builder, face);
        }
        if (triangles_ > max_triangles) at_.refuse(fmt::format("more than {} triangles", max_triangles));
        return assembly_.add(std::move(builder));
    }

    void cut_list(const XmlElement& in, const std::vector<Corner>& corners,
                  std::vector<std::vector<Corner>>& faces) const {
        const XmlElement* const counts = in.find("vcount");
        if (!counts) refuse(in, "a polylist without vcount");
        std::size_t next = 0;
        std::string_view rest = counts->text;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const std::int64_t count = whole_number(word, {at_.file, counts->line});
            if (count < 0 || static_cast<std::uint64_t>(count) > corners.size() - next)
                refuse(*counts,
                       fmt::format("a face of {} corners, and {} are left", count, corners.size() - next));
            const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(next);
            faces.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count));
            next += static_cast<std::size_t>(count);
        }
    }

    // Materials.

    void place(const Copy& copy) {
        for (const Primitive& p : parts_[copy.geometry]) {
            const auto bound = copy.bindings.find(p.symbol);
            const std::string url = bound == copy.bindings.end() ? "" : bound->second;
            const auto [number, ignored] = materials_.try_emplace(url, materials_.size());
            assembly_.place(p.part, copy.place, number->second, [&] { return material(url); });
        }
    }

    Material material(const std::string& url) {
        const auto found = url.starts_with('#') ? by_id_.find(url.substr(1)) : by_id_.end();
        if (found == by_id_.end()) return Material{.name = "default"};
        const XmlElement& in = *found->second;
        const XmlElement* const effect = in.find("instance_effect");
        const DaeMaterial made = effect ? dae_material(target(*effect, "url"), at_.file) : DaeMaterial{};
        textured_ += made.has_textures;
        odd_ += is_out_of_range(made.surface);
        const std::string name = in.attribute("name");
        return material_of(made.surface, name.empty() ? in.attribute("id") : name);
    }

    void say_left_out() {
        const auto say = [&](std::uint64_t count, const char* what, const char* sentence) {
            if (count > 0) loading_.note(at_.file, counted(count, what) + sentence);
        };
        say(odd_, "material", " with values out of range, taken as the nearest within");
        say(textured_, "material", " with textures, which are not drawn");
        say(skins_, "node", " with a skin, drawn in the pose without it");
        say(shapeless_, "geometry", " that is no mesh, left out");
        say(lines_, "primitive", " of lines or with holes left out");
        say(left_out_, "camera or light", " left out");
        if (document_.find("library_animations")) loading_.note(at_.file, "its animations are left out");
    }

    const XmlElement& document_;
    Place at_;
    Loading& loading_;
    Assembly assembly_;
    std::map<std::string, const XmlElement*> by_id_;
    std::map<const XmlElement*, std::vector<glm::vec3>> sources_;
    std::map<const XmlElement*, std::vector<Primitive>> parts_;   // of a geometry
    std::map<std::string, std::uint64_t> materials_;              // by url
    std::vector<Copy> copies_;
    std::uint64_t triangles_ = 0, skins_ = 0, lines_ = 0, left_out_ = 0, textured_ = 0, odd_ = 0,
                  shapeless_ = 0;
};

}   // namespace

Scene read_dae(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    const Place at{path.string()};
    const XmlElement document = parse_xml(at.file, without_mark(bytes), loading);
    return DaeReader(document, at, loading).read();
}

}   // namespace rayclock
