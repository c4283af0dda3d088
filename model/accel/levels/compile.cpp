// compile_levels: lattices and maps, a lower structure for each class, the scene's tree above them.
#include <bit>
#include <map>

#include <glm/matrix.hpp>

#include "model/accel/collapse.hpp"
#include "model/accel/emit.hpp"
#include "model/accel/encode.hpp"
#include "model/accel/levels/levels.hpp"
#include "model/accel/surfaces.hpp"
#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"

namespace rayclock {
namespace {

constexpr int most_groups = 62;   // a Trace tells an instance from so many dropped groups

void check_levels(const PlacedScene& scene, const Config& config, const std::string& name) {
    if (!scene.own.spheres.empty() || !scene.own.planes.empty())
        throw UserError(name + ": two levels hold triangles only, no true spheres and no planes");
    const std::uint64_t count = primitive_count(scene);
    if (count == 0) throw UserError(name + ": there is nothing to see: no triangle");
    const auto need = int(std::bit_width(count - 1));
    if (need > config.prim_bits)
        throw UserError(name + ": " + std::to_string(count) + " triangles need numbers of " +
                        std::to_string(need) + " bits, and prim_bits is " + std::to_string(config.prim_bits));
}

/// The triangles of a mesh that count on a class's lattice, numbered within the mesh.
std::vector<PrimData> snapped(const SharedMesh& mesh, const MeshClass& made, const Config& config) {
    std::vector<PrimData> all;
    const bool mirrored = glm::determinant(glm::dmat3(made.before)) < 0;   // turned inside out again
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto corner = [&](std::size_t k) {
            return snapped_corner(made, mesh, mesh.triangles[i].vertex[k]);
        };
        const PrimData prim{corner(0), corner(mirrored ? 2 : 1), corner(mirrored ? 1 : 2), std::uint32_t(i),
                            0};
        if (counts(prim, config)) all.push_back(prim);
    }
    return all;
}

class LevelsCompiler {
public:
    LevelsCompiler(const LevelParts& parts, const std::vector<Material>& materials, const Config& config,
                   const std::string& name, LevelsImage& out)
        : parts_(parts), materials_(materials), config_(config), name_(name), out_(out), image_(out.image) {}

    void run() {
        std::vector<std::uint32_t> firsts;
        std::vector<std::uint32_t> kept;   // instances of which something is left
        std::uint64_t number = 0;
        lowers_.resize(out_.maps.classes.size());
        for (std::size_t c = 0; c < lowers_.size(); ++c) compile_class(c);
        for (std::uint32_t i = 0; i < parts_.instances.size(); ++i) {
            firsts.push_back(std::uint32_t(number));
            number += parts_.meshes[parts_.instances[i].mesh]->triangles.size();
            if (!lowers_[class_of(i)].words.empty()) kept.push_back(i);
        }
        if (kept.empty())
            throw UserError(name_ + ": all " + std::to_string(number) + " triangles vanish on a lattice of " +
                            std::to_string(config_.coord_bits) +
                            " bits; a larger coord_bits or an eye closer to the scene would help");
        write_scene_tree(kept, firsts);
        append_lowers();
        image_.primitives = std::uint32_t(number);
        image_.report.triangles = number;
        image_.report.bytes = image_.words.size() * sizeof(std::uint32_t);
        check_stack(image_.report.stack_need, config_, name_);
        if (image_.report.stack_need > most_groups)
            throw UserError(name_ + ": two levels keep " + std::to_string(most_groups) +
                            " sibling groups of a ray at most, and this tree needs " +
                            std::to_string(image_.report.stack_need));
    }

private:
    std::uint32_t class_of(std::uint32_t instance) const { return out_.maps.instances[instance].mesh_class; }

    void compile_class(std::size_t c) {
        const MeshClass& made = out_.maps.classes[c];
        const std::vector<PrimData> prims = snapped(*parts_.meshes[made.mesh], made, config_);
        if (!prims.empty()) lowers_[c] = compile_triangles(prims, config_, name_);
    }

    /// As nodes of boxes in boxes, with a placement where a leaf would be.
    void write_scene_tree(const std::vector<std::uint32_t>& kept, const std::vector<std::uint32_t>& firsts) {
        std::vector<LatticeBox> boxes;
        for (const std::uint32_t i : kept) boxes.push_back(out_.maps.instances[i].box);
        BinaryTree tree = build_tree(boxes);
        optimise_tree(tree);
        Config single = config_;
        single.leaf_size = 1;
        const Collapse collapse(tree, single);
        image_.words.assign(words_per_line, 0);
        const int need = write_node(tree, collapse, tree.root, 0, kept, firsts, 1);
        image_.report.stack_need = need;
    }

    /// Returns how many groups of siblings a ray may have to keep below the node.
    int write_node(const BinaryTree& tree, const Collapse& collapse, std::uint32_t node, std::uint32_t line,
                   const std::vector<std::uint32_t>& kept, const std::vector<std::uint32_t>& firsts,
                   int depth) {
        std::vector<WideChild> found;
        collapse.children(node, found);
        std::vector<NodeChild> children;
        for (const WideChild& child : found) children.push_back({tree.nodes[child.node].box, 0});
        const auto base = std::uint32_t(image_.words.size() / words_per_line);
        check_lines(base + found.size(), config_, name_);
        image_.words.resize(image_.words.size() + found.size() * words_per_line, 0);
        write_payload(encode_node(children, base, config_), config_, at(line), scratch_);
        ++image_.report.nodes;
        int need = 0;
        for (std::uint32_t i = 0; i < found.size(); ++i) {
            if (!found[i].leaf) {
                need = std::max(need,
                                write_node(tree, collapse, found[i].node, base + i, kept, firsts, depth + 1));
                continue;
            }
            std::vector<std::uint32_t> one;
            collapse.boxes(found[i].node, one);
            const std::uint32_t instance = kept[one[0]];
            placements_.push_back({instance, firsts[instance], base + i});
            const CompileReport& below = lowers_[class_of(instance)].report;
            need = std::max(need, below.stack_need);
            image_.report.depth = std::max(image_.report.depth, depth + 1 + below.depth);
            ++image_.report.leaves;
        }
        return need + (found.size() >= 2);
    }

    /// Lower structures behind the scene's tree, and what points at them.
    void append_lowers() {
        for (std::size_t c = 0; c < lowers_.size(); ++c) {
            out_.roots.push_back(lowers_[c].words.empty() ? 0 : image_.lines());
            if (lowers_[c].words.empty()) continue;
            const std::uint32_t root = image_.lines();
            check_lines(std::uint64_t(root) + lowers_[c].lines(), config_, name_);
            image_.words.insert(image_.words.end(), lowers_[c].words.begin(), lowers_[c].words.end());
            image_.report.nodes += lowers_[c].report.nodes;
            move_nodes(root);
        }
        image_.surfaces = image_.lines();
        for (const Placed& placed : placements_) {
            const InstanceMap& map = out_.maps.instances[placed.instance];
            std::uint32_t surfaces = 0, material = 0;
            if (config_.shading) {
                surfaces = surfaces_of(placed.instance) - placed.first;
                if (const auto& own = parts_.instances[placed.instance].material)
                    material = material_of(*own);
            }
            write_payload(Placement{placed.first, out_.roots[map.mesh_class], placed.line,
                                    surfaces & ((1u << config_.addr_bits) - 1), material, map.a, map.b},
                          config_, at(placed.line), scratch_);
            set_line_kind(at(placed.line), LineKind::placement);
        }
    }

    /// Line of the first surface of an instance's mesh; instances of a class share them.
    std::uint32_t surfaces_of(std::uint32_t instance) {
        const auto [found, is_new] = surfaces_.try_emplace(class_of(instance), image_.lines());
        if (is_new) write_surfaces_of(class_of(instance));
        return found->second;
    }

    /// Line of a surface that has a material and no corners.
    std::uint32_t material_of(std::uint32_t material) {
        const auto [found, is_new] = materials_of_.try_emplace(material, image_.lines());
        if (!is_new) return found->second;
        Scene scene;
        scene.vertices.emplace_back();
        scene.triangles = {{{0, 0, 0}, material}};
        write(scene);
        return found->second;
    }

    /// On the class's lattice, whose steps are the unit here: normals of corners are turned as planes are.
    void write_surfaces_of(std::uint32_t number) {
        const MeshClass& made = out_.maps.classes[number];
        const SharedMesh& mesh = *parts_.meshes[made.mesh];
        Scene part, scene;
        part.vertices = mesh.vertices, part.normals = mesh.normals, part.triangles = mesh.triangles;
        append(scene, part, made.before, {}, 0);
        if (!made.corners.empty()) scene.vertices = made.corners;
        for (glm::dvec3& at : scene.vertices) at = (at - made.lattice.centre) / made.lattice.pitch;
        for (glm::dvec3& normal : scene.normals) normal = unit_or_zero(normal * made.lattice.pitch);
        write(scene);
    }

    /// Surfaces of a scene whose unit is a step.
    void write(Scene& scene) {
        scene.materials = materials_;
        MemoryImage surfaces;
        surfaces.lattice.coord_bits = config_.coord_bits;
        check_lines(std::uint64_t(image_.lines()) + scene.triangles.size(), config_, name_);
        write_surfaces(scene, config_, name_, surfaces);
        image_.words.insert(image_.words.end(), surfaces.words.begin(), surfaces.words.end());
    }

    /// Nodes of a lower structure that was compiled from line 0 on and now begins at `root`.
    void move_nodes(std::uint32_t root) {
        std::vector<std::uint32_t> pending{root};
        while (!pending.empty()) {
            const std::uint32_t line = pending.back();
            pending.pop_back();
            Node node = unpack<Node>(at(line), config_);
            node.base += root;
            std::fill_n(at(line), words_per_line, 0u);
            write_payload(node, config_, at(line), scratch_);
            set_line_kind(at(line), LineKind::mesh_node);
            for (std::uint32_t i = 0; i < max_width && node.kind[i] == 1; ++i)
                pending.push_back(node.base + i);
        }
    }

    std::uint32_t* at(std::uint32_t line) { return &image_.words[std::size_t(line) * words_per_line]; }

    struct Placed {
        std::uint32_t instance = 0, first = 0, line = 0;
    };
    const LevelParts& parts_;
    const std::vector<Material>& materials_;
    const Config& config_;
    const std::string& name_;
    LevelsImage& out_;
    MemoryImage& image_;
    std::vector<MemoryImage> lowers_;   // by class
    std::vector<Placed> placements_;
    std::map<std::uint32_t, std::uint32_t> surfaces_, materials_of_;   // lines, by class and by material
    Words scratch_;
};

}   // namespace

Config with_two_levels(Config config, const std::string& where) {
    config.levels = 2;
    check_config(config, where);
    return config;
}

LevelsImage compile_levels(const PlacedScene& scene, const glm::dvec3& eye, const Config& given) {
    const Stopwatch watch;
    const std::string name = scene.own.name.empty() ? "the scene" : scene.own.name;
    const Config config = with_two_levels(given, name);
    check_levels(scene, config, name);
    const SharedMesh own{"", scene.own.vertices, scene.own.normals, scene.own.triangles};
    LevelParts parts;
    if (!own.triangles.empty()) {
        parts.meshes.push_back(&own);
        parts.instances.push_back({"", 0, glm::dmat4(1), {}});
    }
    const auto before = std::uint32_t(parts.meshes.size());
    for (const SharedMesh& mesh : scene.meshes) parts.meshes.push_back(&mesh);
    for (Instance instance : scene.instances) {
        if (scene.meshes[instance.mesh].triangles.empty()) continue;
        instance.mesh += before;
        parts.instances.push_back(std::move(instance));
    }
    LevelsImage out;
    out.maps = map_instances(parts, eye, config);
    out.image.lattice = out.maps.lattice;
    LevelsCompiler(parts, scene.own.materials, config, name, out).run();
    out.image.report.pitch = out.maps.lattice.pitch;
    out.image.report.seconds = watch.seconds();
    return out;
}

}   // namespace rayclock
