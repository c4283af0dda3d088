// Building a scene from a JSON file and from all files that it includes.
#include "sim/load/json/scene.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/core/config.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/folded.hpp"
#include "model/scene/hit.hpp"
#include "sim/files/input.hpp"
#include "sim/files/text.hpp"
#include "sim/load/json/motion.hpp"
#include "sim/load/json/parts.hpp"
#include "sim/load/json/shapes.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/part_builder.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

using Part = std::shared_ptr<PlacedScene>;

/// All files of one load. Reads each file once, and throws UserError if a file contains itself.
class Library {
public:
    explicit Library(Loading& loading) : loading_(loading) {}
    JsonLoad json(const std::filesystem::path& path, std::string_view text);
    Part file(const std::filesystem::path& path, const JsonValue& from);
    Part builtin(const std::string& spec, Primitives primitives, const JsonValue& from);
    Loading& loading() const { return loading_; }

private:
    Loading& loading_;
    std::map<std::string, Part> known_;
    std::vector<std::filesystem::path> open_;
};

/// Builds the scene of one JSON file.
class JsonScene {
public:
    JsonScene(const JsonValue& in, const std::filesystem::path& path, Library& library)
        : in_(in), path_(path), library_(library) {}

    JsonLoad build() {
        in_.only_keys(
            {"camera", "background", "lights", "materials", "meshes", "objects", "spheres", "planes"});
        scene_.name = printable(path_.filename().string(), 80);
        if (const auto camera = in_.find("camera")) read_camera(*camera);
        if (const auto background = in_.find("background")) scene_.background = colour_of(*background);
        const auto lights = in_.find("lights");
        if (lights) read_lights(lights->array());
        if (const auto materials = in_.find("materials"))
            for (const auto& [name, ignored] : materials->object().raw().items()) {
                make_room(*materials, sizeof(Material));
                material_numbers_[name] = static_cast<std::uint32_t>(scene_.materials.size());
                scene_.materials.push_back(material(name, materials->at(name)));
            }
        // A scene with spheres or planes needs no mesh.
        const bool has_others = in_.find("spheres") || in_.find("planes");
        if (!has_others || in_.find("meshes")) read_meshes(in_.at("meshes").object());
        if (!has_others || in_.find("objects")) objects(in_.at("objects").array());
        if (const auto spheres = in_.find("spheres")) read_each(spheres->array(), sphere_of, scene_.spheres);
        if (const auto planes = in_.find("planes")) read_each(planes->array(), plane_of, scene_.planes);
        pose(placed_, 0);
        return {std::move(placed_), lights.has_value()};
    }

private:
    /// Charges bytes to the memory allowance of the files. Throws UserError if it is used up.
    void make_room(const JsonValue& from, std::uint64_t bytes) {
        if (!library_.loading().may_make(bytes)) from.refuse(library_.loading().too_much());
    }

    Material material(const std::string& name, const JsonValue& in) {
        Material made = material_of_keys(in, {.name = name});
        if (const auto texture = in.find("texture")) {
            const JsonTexture given = texture_of(*texture);
            if (given.pattern)
                give_pattern(made, given, *texture);
            else
                give_picture(made, given, texture->raw().is_object() ? texture->at("file") : *texture);
        } else if (const auto cutoff = in.find("cutoff")) {
            cutoff->refuse(
                "makes holes where the alpha of a texture is low, and this material has no texture");
        }
        return made;
    }

    /// Paints a pattern. The material gets it as its texture, or its average colour if the load draws none.
    void give_pattern(Material& material, const JsonTexture& given, const JsonValue& from) {
        const Pattern& pattern = *given.pattern;
        make_room(from, painting_bytes(pattern));
        Texture painted = rayclock::texture_of(pattern);
        if (!library_.loading().draws_textures()) {
            material.colour *= average_of(painted);
            return;
        }
        material.texture = static_cast<std::uint32_t>(scene_.textures.size());
        scene_.textures.push_back(given.texture);
        scene_.textures.back().name = painted.name, scene_.textures.back().pyramid = painted.pyramid;
    }

    /// Reads a picture. The load draws it, or its average colour.
    void give_picture(Material& material, const JsonTexture& given, const JsonValue& from) {
        const std::filesystem::path path = path_.parent_path() / given.file;
        Loading& loading = library_.loading();
        std::string why;
        if (!loading.draws_textures()) {
            const auto average = loading.average(loading.read(path, from.where()), why);
            if (!average) from.refuse("names " + shown(given.file) + ", which cannot be drawn: " + why);
            material.colour *= glm::dvec3(*average);
            return;
        }
        auto& pyramid = pictures_[path.lexically_normal().string()];
        if (!pyramid)
            pyramid = read_pyramid(loading.read(path, from.where()), path_.string(),
                                   "the picture " + shown(given.file), loading, why);
        if (!pyramid) from.refuse("names " + shown(given.file) + ", which cannot be drawn: " + why);
        material.texture = static_cast<std::uint32_t>(scene_.textures.size());
        scene_.textures.push_back(given.texture);
        scene_.textures.back().name = printable(given.file, 80), scene_.textures.back().pyramid = pyramid;
    }

    /// A named mesh, and the positions of its parts in the scene from their first use on.
    struct Named {
        Part part;
        std::optional<std::uint32_t> material_base;   ///< of its own materials
        std::optional<std::uint32_t> shared;          ///< its own triangles as a shared mesh
        std::optional<std::uint32_t> mesh_base;       ///< of the meshes that it places itself
    };

    template <class Map> static auto& known(Map& map, const JsonValue& name, std::string_view what) {
        const auto found = map.find(name.string());
        if (found != map.end()) return found->second;
        std::vector<std::string> names;
        for (const auto& [key, ignored] : map) names.push_back(key);
        name.refuse(fmt::format("names no {} of this file: {}{}", what, shown(name.string()),
                                did_you_mean(name.string(), names)));
    }

    void read_lights(const JsonValue& list) {
        if (list.size() > std::size_t(max_lights))
            list.refuse(fmt::format("has {} lights; the most is {}", list.size(), max_lights));
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto keys = list[i].find("keyframes");
            if (!keys) {
                scene_.lights.push_back(light_of(list[i]));
                continue;
            }
            list[i].only_keys({"keyframes"});
            Light& light = scene_.lights.emplace_back();
            placed_.motion.lights.push_back(light_motion_of(*keys, std::uint32_t(i), light));
        }
    }

    void read_camera(const JsonValue& in) {
        const auto keys = in.find("keyframes");
        if (!keys) return void(scene_.camera = camera_of(in));
        in.only_keys({"keyframes"});
        placed_.motion.camera = camera_motion_of(*keys, scene_.camera.emplace());
    }

    template <class Primitive>
    void read_each(const JsonValue& list, Primitive (*read)(const JsonValue&), std::vector<Primitive>& into) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            into.push_back(read(list[i]));
            into.back().material = material(list[i]);
        }
    }

    /// Returns the named material. All objects without a name share one grey material.
    std::uint32_t material(const JsonValue& in) {
        if (const auto name = in.find("material")) return known(material_numbers_, *name, "material");
        if (!grey_) {
            grey_ = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.push_back({.name = "default"});
        }
        return *grey_;
    }

    void read_meshes(const JsonValue& list) {
        for (const auto& [name, ignored] : list.raw().items())
            meshes_[name] = {mesh(list.at(name)), {}, {}, {}};
    }

    Part mesh(const JsonValue& in) {
        in.only_keys({"file", "builtin", "native", "shapes", "vertices", "triangles", "coordinates"});
        const bool is_inline = in.find("vertices") || in.find("triangles");
        const auto shapes = in.find("shapes");
        if (is_inline + in.find("file").has_value() + in.find("builtin").has_value() + shapes.has_value() !=
            1)
            in.refuse("needs one of 'file', 'builtin', 'shapes', or 'vertices' with 'triangles'");
        if (const auto coordinates = in.find("coordinates"); coordinates && !is_inline)
            coordinates->refuse("belongs to 'triangles' only");
        if (const auto native = in.find("native"); native && !in.find("builtin"))
            native->refuse("belongs to a 'builtin' only");
        if (const auto file = in.find("file"))
            return library_.file(path_.parent_path() / file->string(), *file);
        if (const auto builtin = in.find("builtin"))
            return library_.builtin(builtin->string(),
                                    flag_or(in, "native", false) ? Primitives::native : Primitives::triangles,
                                    *builtin);
        const auto part =
            std::make_shared<PlacedScene>(shapes ? shapes_of(*shapes, path_.parent_path(), library_.loading())
                                                 : PlacedScene{inline_mesh(in), {}, {}});
        make_room(in, bytes_of(*part));
        return part;
    }

    void objects(const JsonValue& list) {
        if (list.size() == 0) list.refuse("is empty: there is nothing to see");
        // Count before anything is copied, because copies of copies could fill the memory. Find out as well
        // whether the scene needs normals: all of its meshes have some, or none has.
        bool any_smooth = false;
        std::uint64_t copied = 0;   // triangles; instances may have more, which then stay shared
        for (std::size_t i = 0; i < list.size(); ++i) {
            const PlacedScene& part = *named(list[i]).part;
            any_smooth = any_smooth || has_normals(part);
            const std::uint64_t one = primitive_count(part), copies = copies_of(list[i]);
            const bool is_placed = list[i].find("instances") || list[i].find("keyframes");
            if (!is_placed && one > max_triangles - std::min(copied, max_triangles))
                list[i].refuse(fmt::format(
                    "brings the scene above {} copied triangles; 'instances' are not copied", max_triangles));
            if (one > 0 && copies > (no_primitive - 1 - placed_triangles_) / one)
                list[i].refuse(fmt::format("brings the scene above {} placed triangles", no_primitive - 1));
            if (!is_placed) copied += one;
            placed_triangles_ += one * copies;
        }
        for (std::size_t i = 0; i < list.size(); ++i) {
            library_.loading().report_progress("placing", i, list.size());
            object(list[i], any_smooth);
        }
    }

    Named& named(const JsonValue& object) {
        object.only_keys(
            {"mesh", "material", "translate", "rotate", "scale", "matrix", "instances", "keyframes"});
        return known(meshes_, object.at("mesh"), "mesh");
    }

    std::size_t copies_of(const JsonValue& object) {
        const auto instances = object.find("instances");
        if (instances && instances->array().size() == 0)
            instances->refuse("is empty: there is nothing to place");
        return instances ? instances->size() : 1;
    }

    std::optional<std::uint32_t> material_named(const JsonValue& in) {
        if (const auto name = in.find("material")) return known(material_numbers_, *name, "material");
        return {};
    }

    void object(const JsonValue& in, bool is_smooth) {
        Named& mesh = named(in);
        if (is_smooth && !has_normals(*mesh.part)) {
            make_room(in, bytes_of(*mesh.part));
            mesh.part = std::make_shared<PlacedScene>(*mesh.part);   // other objects may share the part
            make_smooth(*mesh.part);
            make_room(in, bytes_of(*mesh.part));
        }
        const std::optional<std::uint32_t> material = material_named(in);
        if (in.find("keyframes")) make_room(in, sizeof(MotionNode));
        const NodePlace where = where_of(in, {}, placed_.motion, library_.loading());
        const auto instances = in.find("instances");
        if (!instances)
            return where.node ? share(in, mesh, where, material) : copy(in, mesh, where.place, material);
        for (std::size_t i = 0; i < instances->size(); ++i) {
            const JsonValue instance = (*instances)[i];
            instance.only_keys({"material", "translate", "rotate", "scale", "matrix", "keyframes"});
            const std::optional<std::uint32_t> own = material_named(instance);
            share(instance, mesh, where_of(instance, where, placed_.motion, library_.loading()),
                  own ? own : material);
        }
    }

    std::uint32_t material_base(const JsonValue& from, Named& mesh) {
        if (!mesh.material_base) {
            const std::vector<Material>& materials = mesh.part->own.materials;
            make_room(from, materials.size() * sizeof(Material));
            mesh.material_base = static_cast<std::uint32_t>(scene_.materials.size());
            const auto texture_base = static_cast<std::uint32_t>(scene_.textures.size());
            for (Material material : materials) {
                if (material.texture) *material.texture += texture_base;
                scene_.materials.push_back(std::move(material));
            }
            const std::vector<Texture>& textures = mesh.part->own.textures;
            scene_.textures.insert(scene_.textures.end(), textures.begin(), textures.end());
        }
        return *mesh.material_base;
    }

    void check_spheres(const JsonValue& from, const PlacedScene& part, const glm::dmat4& transform) {
        if (!part.own.spheres.empty() && !keeps_spheres(transform))
            from.refuse("stretches spheres, which need the same scale in all directions");
    }

    /// Copies the part's own primitives, and places the meshes that the part places.
    void copy(const JsonValue& from, Named& mesh, const glm::dmat4& transform,
              std::optional<std::uint32_t> material) {
        const PlacedScene& part = *mesh.part;
        const std::uint32_t base = material ? 0 : material_base(from, mesh);
        check_spheres(from, part, transform);
        make_room(from, bytes_of(part.own) - part.own.materials.size() * sizeof(Material));
        append_part(scene_, part.own, transform, material, base);
        compose(from, mesh, {transform, {}}, material);
    }

    /// Places the part's triangles as an instance that shares them. Copies true spheres and planes.
    void share(const JsonValue& from, Named& mesh, const NodePlace& where,
               std::optional<std::uint32_t> material) {
        const PlacedScene& part = *mesh.part;
        check_spheres(from, part, where.place);
        if (where.node && !(part.own.spheres.empty() && part.own.planes.empty()))
            from.refuse("moves true spheres or planes; only triangles can move");
        if (!part.own.triangles.empty()) {
            if (!mesh.shared)
                mesh.shared = add_mesh(
                    from, {"", part.own.vertices, part.own.normals, part.own.triangles, part.own.coordinates},
                    material_base(from, mesh));
            instance(from, *mesh.shared, where, material);
        }
        Scene round;
        round.spheres = part.own.spheres, round.planes = part.own.planes;
        const std::uint32_t base = material ? 0 : material_base(from, mesh);
        make_room(from, bytes_of(round));
        append(scene_, round, where.place, material, base);
        compose(from, mesh, where, material);
    }

    /// Places the instances of the part itself, so that a graph of any depth becomes one level. The nodes of
    /// the part move in the space where the part is placed.
    void compose(const JsonValue& from, Named& mesh, const NodePlace& where,
                 std::optional<std::uint32_t> material) {
        const PlacedScene& part = *mesh.part;
        if (part.instances.empty()) return;
        const std::uint32_t materials = material_base(from, mesh);
        if (!mesh.mesh_base) {
            mesh.mesh_base = static_cast<std::uint32_t>(placed_.meshes.size());
            for (const SharedMesh& shared : part.meshes) add_mesh(from, shared, materials);
            make_room(from, bytes_of(part.motion));
            add_deforming(part.motion, *mesh.mesh_base, placed_.motion);
        }
        const std::vector<const AttachedInstance*> attached = attached_of(part);
        make_room(from, part.motion.nodes.size() * sizeof(MotionNode));
        const std::uint32_t nodes = add_nodes(part.motion, where, placed_.motion);
        for (std::size_t i = 0; i < part.instances.size(); ++i) {
            const Instance& inner = part.instances[i];
            const auto own = inner.material ? std::optional(*inner.material + materials) : std::nullopt;
            const NodePlace at = attached[i] ? NodePlace{attached[i]->place, nodes + attached[i]->node}
                                             : NodePlace{where.place * inner.place, where.node};
            instance(from, *mesh.mesh_base + inner.mesh, at, material ? material : own);
        }
    }

    std::uint32_t add_mesh(const JsonValue& from, SharedMesh mesh, std::uint32_t material_base) {
        make_room(from, bytes_of(mesh));
        for (Triangle& triangle : mesh.triangles) triangle.material += material_base;
        placed_.meshes.push_back(std::move(mesh));
        return static_cast<std::uint32_t>(placed_.meshes.size() - 1);
    }

    void instance(const JsonValue& from, std::uint32_t mesh, const NodePlace& where,
                  std::optional<std::uint32_t> material) {
        if (is_singular(where.place))
            from.refuse("flattens its mesh, or scales it too far, together with the places around it");
        // A scene with too many triangles stays folded: its instances are not expanded.
        const bool is_folded = placed_triangles_ > max_unfolded;
        make_room(from, sizeof(Instance) + (is_folded ? 0 : bytes_of(placed_.meshes[mesh])));
        if (where.node)
            placed_.motion.attached.push_back(
                {static_cast<std::uint32_t>(placed_.instances.size()), *where.node, where.place});
        placed_.instances.push_back({from.path(), mesh, where.place, material});
    }

    JsonValue in_;
    std::filesystem::path path_;
    Library& library_;
    PlacedScene placed_;
    Scene& scene_ = placed_.own;
    std::map<std::string, std::uint32_t> material_numbers_;
    std::map<std::string, std::shared_ptr<const Pyramid>> pictures_;   // by path
    std::optional<std::uint32_t> grey_;
    std::uint64_t placed_triangles_ = 0;
    std::map<std::string, Named> meshes_;
};

JsonLoad Library::json(const std::filesystem::path& path, std::string_view text) {
    const Json document = parse_json(path.string(), text);
    open_.push_back(std::filesystem::weakly_canonical(path));
    JsonLoad load = JsonScene(JsonValue(document, path.string()), path, *this).build();
    open_.pop_back();
    return load;
}

Part Library::file(const std::filesystem::path& path, const JsonValue& from) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
    if (error) from.refuse(shown(path.string()) + " cannot be found: " + error.message());
    if (std::find(open_.begin(), open_.end(), real) != open_.end())
        from.refuse(fmt::format("makes {} contain itself", shown(path.string())));
    if (open_.size() > 50) from.refuse("is nested deeper than 50 files");
    Part& part = known_[real.string()];
    if (part) return part;
    if (extension(path) == "json")
        return known_[real.string()] =
                   std::make_shared<PlacedScene>(json(path, loading_.read(path, from.where())).scene);
    if (!is_mesh_file(path))
        from.expected(
            "a file of the kind .obj, .ply, .stl, .off, .3ds, .dae, .glb, .gltf (with .gz or without) or "
            ".json");
    return part = std::make_shared<PlacedScene>(load_mesh_file(path, loading_, from.where()));
}

Part Library::builtin(const std::string& spec, Primitives primitives, const JsonValue& from) {
    Part& part = known_[(primitives == Primitives::native ? "native:" : "builtin:") + spec];
    if (part) return part;
    try {
        // Charge roughly the size of the scene before it is made.
        const PrimitiveCounts count = builtin_counts(spec, primitives);
        if (!loading_.may_make(count.triangles * (sizeof(Triangle) + sizeof(glm::dvec3)) +
                               count.spheres * sizeof(Sphere)))
            throw UserError(loading_.too_much());
        return part = std::make_shared<PlacedScene>(make_placed(spec, primitives));
    } catch (const UserError& error) {
        from.refuse(std::string("cannot be made: ") + error.what());
    }
}

}   // namespace

JsonLoad load_json_scene(const std::filesystem::path& path, Loading& loading) {
    return read_json_scene(path, loading.read(path), loading);
}

JsonLoad read_json_scene(const std::filesystem::path& path, std::string_view text, Loading& loading) {
    return Library(loading).json(path, text);
}

}   // namespace rayclock
