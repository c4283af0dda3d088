// compile_levels: lattices and maps, a lower structure for each class, and the scene's tree above them.
#include "model/compile/levels/levels.hpp"

#include <bit>
#include <map>

#include <glm/matrix.hpp>

#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/emit.hpp"
#include "model/compile/refit/refit.hpp"
#include "model/compile/surfaces.hpp"
#include "model/engine/check.hpp"
#include "model/engine/engines.hpp"
#include "model/layout/words.hpp"

namespace rayclock {
namespace {

constexpr int max_groups = 62;   // a Trace reserves larger counts of dropped groups for instances

class LevelsCompiler {
public:
    LevelsCompiler(const LevelParts& parts, const std::vector<Material>& materials, const Config& config,
                   const std::string& name, LevelsImage& out)
        : parts_(parts), materials_(materials), config_(config), name_(name), out_(out), image_(out.image) {}

    void run(int buffers, const UpperRoom& room) {
        buffers_ = std::max(buffers, 1);
        lowers_.resize(out_.maps.classes.size());
        out_.rooms.assign(lowers_.size(), 0), out_.surfaces.resize(lowers_.size());
        for (std::size_t c = 0; c < lowers_.size(); ++c) compile_class(c);
        gather_entries();
        if (buffers > 0) {   // each buffer has room for any tree of the film
            out_.upper_lines = aligned(room(out_.entries));
            image_.words.resize(std::size_t(out_.upper_lines) * std::size_t(buffers) * words_per_line, 0);
        }
        std::vector<PlacedEntry> placed;
        const UpperReport report =
            write_upper(out_.entries, 0, true, config_.upper(), name_, image_.words, placed);
        image_.first_mesh_line = image_.lines();
        append_lowers();
        image_.first_surface_line = image_.lines();
        for (std::size_t e = 0; e < out_.entries.size(); ++e) complete(out_.entries[e], out_.of_entry[e]);
        write_entries(out_.entries, placed, config_, image_.words);
        image_.report.nodes += report.nodes;
        image_.report.leaves = report.leaves;
        image_.report.depth = report.depth;
        image_.report.stack_need = report.stack_need;
        image_.primitives = std::uint32_t(triangles_);
        image_.report.triangles = triangles_;
        image_.report.bytes = image_.words.size() * sizeof(std::uint32_t);
        check_need(report.stack_need, config_, name_);
    }

private:
    std::uint32_t class_of(std::uint32_t instance) const { return out_.maps.instances[instance].mesh_class; }

    /// Collects the instances that have primitives left on the lattice.
    void gather_entries() {
        std::uint64_t& number = triangles_;
        for (std::size_t i = 0; i < parts_.instances.size(); ++i) {
            const InstanceMap& map = out_.maps.instances[i];
            const MemoryImage& lower = lowers_[map.mesh_class];
            if (out_.maps.classes[map.mesh_class].before != glm::dmat4(1))
                image_.written_out.push_back(std::uint32_t(number));
            if (!lower.words.empty()) {
                out_.entries.push_back(
                    {&map, std::uint32_t(number), 0, 0, 0, lower.report.stack_need, lower.report.depth});
                out_.of_entry.push_back(std::uint32_t(i));
            }
            number += parts_.count(parts_.instances[i].mesh);
        }
        if (out_.entries.empty())
            throw UserError(name_ + ": all " + std::to_string(number) +
                            (parts_.round ? " primitives" : " triangles") + " vanish on a lattice of " +
                            std::to_string(config_.coord_bits) +
                            " bits; a larger coord_bits or an eye closer to the scene would help");
    }

    /// Rounds up to whole lines of every cache, so that no cache line holds lines of two trees.
    std::uint32_t aligned(std::uint32_t lines) const {
        const auto step = std::uint32_t(std::max({config_.node_line, config_.prim_line, config_.surf_line,
                                                  config_.tex_line, config_.l2_line}) /
                                        line_bytes);
        return (lines + step - 1) / step * step;
    }

    void compile_class(std::size_t c) {
        const MeshClass& made = out_.maps.classes[c];
        std::vector<PrimData> prims = snapped(parts_, made, config_);
        if (!parts_.is_round(made.mesh)) {
            const SharedMesh& mesh = *parts_.meshes[made.mesh];
            mark_cutouts(mesh.triangles, mesh.coordinates, materials_, config_, prims);
        }
        image_.report.coincident += drop_coincident_spheres(prims);
        if (made.deforms)
            out_.rooms[c] = aligned(std::uint32_t(
                std::min<std::uint64_t>(Refit::max_lines(prims.size()), std::uint64_t(1) << max_addr_bits)));
        if (!prims.empty()) lowers_[c] = compile_triangles(prims, config_.lower(), name_);
    }

    /// Appends the lower structures after the scene's tree.
    void append_lowers() {
        for (std::size_t c = 0; c < lowers_.size(); ++c) {
            out_.roots.push_back(lowers_[c].words.empty() ? 0 : image_.lines());
            if (lowers_[c].words.empty()) continue;
            const std::uint32_t root = image_.lines();
            check_lines(std::uint64_t(root) + lowers_[c].lines(), config_, name_);
            image_.words.insert(image_.words.end(), lowers_[c].words.begin(), lowers_[c].words.end());
            image_.report.nodes += lowers_[c].report.nodes;
            with_engine(config_.lower_engine(), [&]<class E>(E) { move_nodes<typename E::Node>(root); });
            make_room(c, root);
        }
    }

    /// Reserves lines for any tree over a mesh that deforms, in each buffer.
    void make_room(std::size_t c, std::uint32_t root) {
        if (out_.rooms[c] == 0) return;
        const std::uint64_t lines = root + std::uint64_t(out_.rooms[c]) * std::uint64_t(buffers_);
        check_lines(lines, config_, name_);
        image_.words.resize(std::size_t(lines) * words_per_line, 0);
    }

    /// Fills an entry's addresses once the lower structures lie in memory.
    void complete(UpperEntry& entry, std::uint32_t instance) {
        entry.root = out_.roots[entry.map->mesh_class];
        if (!config_.shading) return;
        entry.first_surface_line = surfaces_of(class_of(instance)) - entry.first;
        if (parts_.is_round(out_.maps.classes[class_of(instance)].mesh)) {
            image_.first_plane = entry.first + std::uint32_t(parts_.round->spheres.size());
            image_.first_plane_surface_line = entry.first_surface_line + image_.first_plane;
        }
        if (const auto& own = parts_.instances[instance].material) entry.material = material_of(*own);
    }

    /// Returns the line of the first surface of a class, which its instances share.
    std::uint32_t surfaces_of(std::uint32_t number) {
        if (out_.surfaces[number].empty()) write_surfaces_of(number);
        return out_.surfaces[number][0].first;
    }

    /// Returns the line of a surface with a material but without corners.
    std::uint32_t material_of(std::uint32_t material) {
        const auto [found, is_new] = materials_of_.try_emplace(material, image_.lines());
        if (!is_new) return found->second;
        Scene scene;
        scene.vertices.emplace_back();
        scene.triangles = {{{0, 0, 0}, material}};
        scene.materials = materials_;
        write(scene);
        return found->second;
    }

    /// Writes the surfaces of a class, and its textures before them.
    void write_surfaces_of(std::uint32_t number) {
        const MeshClass& made = out_.maps.classes[number];
        std::vector<LevelsImage::Surfaces>& all = out_.surfaces[number];
        all.resize(made.deforms ? std::size_t(buffers_) : 1);
        if (parts_.is_round(made.mesh)) return write_round(made.lattice, all[0]);
        Scene scene = class_surfaces(*parts_.meshes[made.mesh], made, materials_);
        scene.textures = parts_.textures;
        write_texels(scene, config_, name_, out_.textures, image_);
        for (LevelsImage::Surfaces& one : all) {
            if (made.deforms) align();
            one.records = write_records(scene, step_lattice(), config_, name_, out_.textures, image_);
            one.first = image_.lines();
            write(scene, step_lattice(), one.records);
        }
        if (made.deforms) align();
    }

    /// Begins a new line of every cache, so that no cache line holds lines of two buffers.
    void align() { image_.words.resize(std::size_t(aligned(image_.lines())) * words_per_line, 0); }

    /// Writes the surfaces of the scene's own spheres and planes, on the scene's lattice, and their textures
    /// before them.
    void write_round(const Lattice& lattice, LevelsImage::Surfaces& surfaces) {
        Scene scene;
        scene.spheres = parts_.round->spheres, scene.planes = parts_.round->planes;
        scene.materials = materials_, scene.textures = parts_.textures;
        write_texels(scene, config_, name_, out_.textures, image_);
        surfaces.records = write_records(scene, lattice, config_, name_, out_.textures, image_);
        surfaces.first = image_.lines();
        write(scene, lattice, surfaces.records);
    }

    /// Writes the surfaces of a scene whose unit is a lattice step.
    Lattice step_lattice() const { return {glm::dvec3(0), glm::dvec3(1), config_.coord_bits}; }
    void write(const Scene& scene) { write(scene, step_lattice()); }
    void write(const Scene& scene, const Lattice& lattice, const std::vector<std::uint32_t>& records = {}) {
        MemoryImage surfaces;
        surfaces.lattice = lattice;
        check_lines(std::uint64_t(image_.lines()) + primitive_count(scene), config_, name_);
        write_surfaces(scene, records, config_, name_, surfaces);
        image_.words.insert(image_.words.end(), surfaces.words.begin(), surfaces.words.end());
    }

    /// Moves the nodes of a lower structure, compiled from line 0 on, to `root`. `Line` is their type.
    template <class Line> void move_nodes(std::uint32_t root) {
        std::vector<std::uint32_t> pending{root};
        while (!pending.empty()) {
            const std::uint32_t line = pending.back();
            pending.pop_back();
            Line node = unpack<Line>(at(line), config_);
            node.base += root;
            std::fill_n(at(line), words_per_line, 0u);
            write_payload(node, config_, at(line), scratch_);
            set_line_kind(at(line), LineKind::mesh_node);
            std::uint32_t next = node.base;
            for (const std::uint32_t kind : node.kind)
                if (kind == 1) pending.push_back(next++);
        }
    }

    std::uint32_t* at(std::uint32_t line) { return &image_.words[std::size_t(line) * words_per_line]; }

    const LevelParts& parts_;
    const std::vector<Material>& materials_;
    const Config& config_;
    const std::string& name_;
    LevelsImage& out_;
    MemoryImage& image_;
    int buffers_ = 1;
    std::vector<MemoryImage> lowers_;                       // by class
    std::uint64_t triangles_ = 0;                           // placed
    std::map<std::uint32_t, std::uint32_t> materials_of_;   // lines, by material
    Words scratch_;
};

}   // namespace

std::vector<PrimData> snapped_triangles(const SharedMesh& mesh, const MeshClass& made, const Config& config) {
    std::vector<PrimData> all;
    // A mirrored mesh is inside out, so two of its corners are swapped.
    const bool mirrored = glm::determinant(glm::dmat3(made.before)) < 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto corner = [&](std::size_t k) {
            return snapped_corner(made, mesh, mesh.triangles[i].vertex[k]);
        };
        const PrimData prim{corner(0), corner(mirrored ? 2 : 1), corner(mirrored ? 1 : 2), std::uint32_t(i),
                            PrimKind::triangle};
        if (made.deforms || counts(prim, config)) all.push_back(prim);
    }
    return all;
}

std::vector<PrimData> snapped(const LevelParts& parts, const MeshClass& made, const Config& config) {
    if (!parts.is_round(made.mesh)) return snapped_triangles(*parts.meshes[made.mesh], made, config);
    std::vector<PrimData> all;
    for (std::size_t i = 0; i < parts.count(made.mesh); ++i) {
        PrimData prim = snap_primitive(*parts.round, made.lattice, parts.round->triangles.size() + i);
        prim.prim = std::uint32_t(i);
        if (counts(prim, config)) all.push_back(prim);
    }
    return all;
}

// Corner normals transform as planes do: by the transpose of the map from steps to the class's space. In the
// scene each has unit length again. The map's transpose takes all three there together, so their lengths are
// set here.
Scene class_surfaces(const SharedMesh& mesh, const MeshClass& made, const std::vector<Material>& materials) {
    Scene part, scene;
    part.vertices = mesh.vertices, part.normals = mesh.normals, part.triangles = mesh.triangles;
    part.coordinates = mesh.coordinates;
    append(scene, part, made.before, {}, 0);
    if (!made.corners.empty()) scene.vertices = made.corners;
    for (glm::dvec3& at : scene.vertices) at = (at - made.lattice.centre) / made.lattice.pitch;
    for (glm::dvec3& normal : scene.normals)
        if (const double length = glm::length(made.normal_map * normal); length > 0)
            normal *= made.lattice.pitch / length;
    scene.materials = materials;
    return scene;
}

void check_need(int need, const Config& config, const std::string& name) {
    check_stack(need, config, name);
    if (need > max_groups)
        throw UserError(name + ": two levels keep " + std::to_string(max_groups) +
                        " sibling groups of a ray at most, and this tree needs " + std::to_string(need));
}

namespace {
bool has_round(const PlacedScene& scene) { return !scene.own.spheres.empty() || !scene.own.planes.empty(); }
}   // namespace

LevelParts parts_of(const PlacedScene& scene, const SharedMesh& own) {
    LevelParts parts;
    parts.textures = scene.own.textures;
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
    if (!has_round(scene)) return parts;
    static const SharedMesh none;
    parts.round = &scene.own;
    parts.instances.push_back({"", std::uint32_t(parts.meshes.size()), glm::dmat4(1), {}});
    parts.meshes.push_back(&none);
    return parts;
}

InstancePlaces places_of(const PlacedScene& scene) {
    InstancePlaces places;
    if (!scene.own.triangles.empty()) places.emplace_back(1);
    for (const Instance& instance : scene.instances)
        if (!scene.meshes[instance.mesh].triangles.empty()) places.push_back(instance.place);
    if (has_round(scene)) places.emplace_back(1);
    return places;
}

SharedMesh own_mesh(const PlacedScene& scene) {
    return {"", scene.own.vertices, scene.own.normals, scene.own.triangles, scene.own.coordinates};
}

void check_levels(const PlacedScene& scene, const Config& config, const std::string& name) {
    check_units(scene.own, config, name);
    const std::uint64_t count = primitive_count(scene);
    if (count == 0) throw UserError(name + ": there is nothing to see: no primitive");
    const auto need = int(std::bit_width(count - 1));
    if (need > config.prim_bits)
        throw UserError(name + ": " + std::to_string(count) +
                        (has_round(scene) ? " primitives" : " triangles") + " need numbers of " +
                        std::to_string(need) + " bits, and prim_bits is " + std::to_string(config.prim_bits));
}

void compile_parts(const LevelParts& parts, const std::vector<Material>& materials, const Config& config,
                   const std::string& name, int buffers, const UpperRoom& room, LevelsImage& out) {
    out.image.lattice = out.maps.lattice;
    auto lattices = std::make_shared<LevelLattices>();
    for (const MeshClass& made : out.maps.classes) lattices->classes.push_back({made.lattice, made.before});
    for (const InstanceMap& map : out.maps.instances) lattices->of_instance.push_back(map.mesh_class);
    out.image.levels = std::move(lattices);
    LevelsCompiler(parts, materials, config, name, out).run(buffers, room);
    out.image.report.pitch = out.maps.lattice.pitch;
}

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
    const SharedMesh own = own_mesh(scene);
    const LevelParts parts = parts_of(scene, own);
    LevelsImage out;
    out.maps = map_instances(parts, eye, config);
    compile_parts(parts, scene.own.materials, config, name, 0, {}, out);
    out.image.report.seconds = watch.seconds();
    return out;
}

}   // namespace rayclock
