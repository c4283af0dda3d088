// DAE (COLLADA 1.4 and 1.5). Reads the tree of nodes, meshes, the file's pose of skins and morphs, normals,
// colours of materials and their pictures. Turns the up axis to y. Leaves out cameras, lights and animations,
// with a note.
#include <deque>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/text.hpp"
#include "sim/load/dae/controller.hpp"
#include "sim/load/dae/geometry.hpp"
#include "sim/load/dae/material.hpp"
#include "sim/load/dae/transform.hpp"
#include "sim/load/mesh/mesh_file.hpp"

namespace rayclock {
namespace {

constexpr int max_nesting = 500;   // visit() is recursive

/// The id of a symbol's material. `sets`: the set of coordinates for each name that its pictures use.
struct Binding {
    std::string material;
    std::map<std::string, std::uint64_t> sets;
};
using Bindings = std::map<std::string, Binding>;   ///< by symbol, a mesh's name of a material

class DaeReader {
public:
    DaeReader(const XmlElement& top, const std::filesystem::path& path, Loading& loading)
        : top_(top),
          document_(top, path.string(), loading),
          assembly_(path.string(), loading),
          materials_(document_, path.parent_path()),
          controllers_(document_, places_),
          geometries_(document_, assembly_) {}

    Scene read() {
        const SourcePosition at{document_.file()};
        const XmlElement* const scene = top_.at("scene/instance_visual_scene");
        if (scene) {
            const XmlElement& root = document_.target(*scene, "url");
            for (const XmlElement* node : root.all("node"))
                visit(*node, document_.up() * document_.into(top_, *node), 0);
        } else if (const XmlElement* const library = top_.find("library_geometries")) {
            for (const XmlElement* geometry : library->all("geometry"))
                copies_.push_back({geometry, nullptr, document_.up() * document_.into(top_, *geometry), {}});
        }
        for (Copy& copy : copies_) build(copy);
        if (geometries_.triangles() == 0) at.refuse("the file has no triangles");
        assembly_.make_alike();
        for (const Copy& copy : copies_) place(copy);
        say_left_out();
        Scene made = assembly_.take();
        made.textures = materials_.textures();
        return made;
    }

private:
    /// A geometry in one place.
    struct Copy {
        const XmlElement* geometry;
        const XmlElement* controlled;   ///< the <instance_controller>, or null
        glm::dmat4 place;
        Bindings bindings;
        const std::vector<DaePart>* parts = nullptr;
    };

    void visit(const XmlElement& node, glm::dmat4 place, int depth) {
        if (depth > max_nesting)
            document_.refuse(node, fmt::format("nodes are nested deeper than {}", max_nesting));
        // A node may be instanced many times. Each visit reads it and lists its geometries, so charge every
        // visit.
        std::uint64_t cost = sizeof(Copy) * (1 + node.children.size());
        for (const XmlElement& child : node.children) cost += child.text.size();
        document_.charge(cost);
        for (const XmlElement& child : node.children) place = place * dae_transform(child, document_);
        places_.try_emplace(&node, place);
        for (const XmlElement& child : node.children) {
            if (child.name == "instance_geometry") {
                const XmlElement& geometry = document_.target(child, "url");
                copies_.push_back(
                    {&geometry, nullptr, place * document_.into(node, geometry), bindings(child)});
            }
            if (child.name == "instance_controller")
                copies_.push_back({nullptr, &child, place, bindings(child)});
            left_out_ += child.name == "instance_camera" || child.name == "instance_light";
        }
        for (const XmlElement& child : node.children) {
            if (child.name != "node" && child.name != "instance_node") continue;
            const XmlElement& inner = child.name == "node" ? child : document_.target(child, "url");
            visit(inner, place * document_.into(node, inner), depth + 1);
        }
    }

    Bindings bindings(const XmlElement& instance) {
        Bindings all;
        std::size_t inputs = 0;
        if (const XmlElement* const bound = instance.at("bind_material/technique_common"))
            for (const XmlElement* m : bound->all("instance_material")) {
                const auto [made, is_new] = all.try_emplace(m->attribute("symbol"));
                if (!is_new) continue;
                made->second.material = m->attribute("target");
                for (const XmlElement* input : m->all("bind_vertex_input"))
                    if (input->attribute("input_semantic") == "TEXCOORD")
                        made->second.sets.try_emplace(input->attribute("semantic"),
                                                      document_.whole(*input, "input_set", 0));
                inputs += made->second.sets.size();
            }
        document_.charge((all.size() + inputs) * sizeof(XmlElement));
        return all;
    }

    /// Returns the material of a symbol, or null if it is not in the file.
    const XmlElement* material(const Bindings& bindings, const std::string& symbol) const {
        const auto bound = bindings.find(symbol);
        return bound == bindings.end() ? nullptr : document_.find(bound->second.material);
    }

    /// Returns the sets of coordinates for the pictures of a copy's materials.
    DaeSets sets(const Bindings& bindings) {
        DaeSets all;
        for (const auto& [symbol, binding] : bindings) {
            const XmlElement* const found = material(bindings, symbol);
            const auto name = found ? materials_.coordinates(*found) : std::nullopt;
            if (!name) continue;
            const auto set = binding.sets.find(*name);
            all.emplace(symbol, set == binding.sets.end() ? std::nullopt : std::optional(set->second));
        }
        return all;
    }

    /// Builds the parts of a copy. Copies of a geometry with the same sets of coordinates share the parts.
    /// Each skin and morph has its own parts.
    void build(Copy& copy) {
        DaeSets sets = this->sets(copy.bindings);
        if (!copy.controlled) {
            const auto [found, is_new] = parts_.try_emplace({copy.geometry, std::move(sets)});
            if (is_new) found->second = geometries_.parts(*copy.geometry, {}, found->first.second);
            copy.parts = &found->second;
            return;
        }
        const DaePose pose = controllers_.pose(*copy.controlled);
        if (!pose.geometry) return void(++empty_controllers_);
        if (pose.moves.empty())
            ++morphs_;
        else
            ++skins_, copy.place = glm::dmat4(1);   // the joints place it instead of its node
        posed_.push_back(geometries_.parts(*pose.geometry, pose, sets));
        copy.parts = &posed_.back();
    }

    void place(const Copy& copy) {
        if (!copy.parts) return;
        document_.charge(copy.parts->size() * sizeof(DaePart));   // many copies may have empty parts
        for (const DaePart& part : *copy.parts) {
            const XmlElement* const found = material(copy.bindings, part.symbol);
            lost_materials_ += !found && !part.symbol.empty();
            if (!part.fault.empty() && found && materials_.material(*found).texture)
                throw UserError(part.fault);
            const auto [number, ignored] = numbers_.try_emplace(found, numbers_.size());
            assembly_.place(part.number, copy.place, number->second, [&] {
                return found ? materials_.material(*found) : Material{.name = "default"};
            });
        }
    }

    void say_left_out() {
        const auto say = [&](std::uint64_t count, const char* what, const char* sentence) {
            if (count > 0) document_.loading().note(document_.file(), counted(count, what) + sentence);
        };
        materials_.say_left_out();
        geometries_.say_left_out();
        say(lost_materials_, "primitive", " whose material is not in the file, drawn grey");
        say(skins_, "skin", ", drawn as the nodes of its joints stand");
        say(morphs_, "morph", ", drawn with the weights of the file");
        say(empty_controllers_, "controller", " without a mesh left out");
        const DaePoseFaults& faults = controllers_.faults();
        say(faults.morph_normals, "morph", " of weights above 0, whose normals are those of its base mesh");
        say(faults.other_targets, "target", " of a morph left out: it has other vertices");
        say(faults.lost_joints, "joint", " without a node, drawn as it was bound");
        say(faults.odd_weights, "point", " whose weights do not sum to 1, drawn as if they did");
        say(left_out_, "camera or light", " left out");
        if (top_.find("library_animations"))
            document_.loading().note(document_.file(), "its animations are left out");
    }

    const XmlElement& top_;
    DaeDocument document_;
    Assembly assembly_;
    DaeMaterials materials_;
    DaeControllers::NodePlaces places_;
    DaeControllers controllers_;
    DaeGeometries geometries_;
    std::map<std::pair<const XmlElement*, DaeSets>, std::vector<DaePart>> parts_;   // by geometry and sets
    std::deque<std::vector<DaePart>> posed_;               // one per copy with a controller
    std::map<const XmlElement*, std::uint64_t> numbers_;   // by material
    std::vector<Copy> copies_;
    std::uint64_t skins_ = 0, morphs_ = 0, empty_controllers_ = 0, lost_materials_ = 0, left_out_ = 0;
};

}   // namespace

Scene read_dae(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    const SourcePosition at{path.string()};
    const XmlElement document = parse_xml(at.file, without_mark(bytes), loading);
    if (document.name != "COLLADA") at.refuse("this is not COLLADA: its element is " + shown(document.name));
    return DaeReader(document, path, loading).read();
}

}   // namespace rayclock
