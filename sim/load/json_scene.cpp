#include "sim/load/json_scene.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/scene/builtin.hpp"
#include "sim/files/input.hpp"
#include "sim/load/json_parts.hpp"
#include "sim/load/mesh_file.hpp"
#include "sim/load/place.hpp"
#include "sim/files/text.hpp"

namespace rayclock {
namespace {

using Part = std::shared_ptr<Scene>;

/// All files of one load: each is read once, and none may contain itself.
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

/// Gathers one JSON file.
class JsonScene {
public:
    JsonScene(const JsonValue& in, const std::filesystem::path& path, Library& library)
        : in_(in), path_(path), library_(library) {}

    JsonLoad build() {
        in_.only_keys(
            {"camera", "background", "lights", "materials", "meshes", "objects", "spheres", "planes"});
        scene_.name = printable(path_.filename().string(), 80);
        if (const auto camera = in_.find("camera")) scene_.camera = camera_of(*camera);
        if (const auto background = in_.find("background")) scene_.background = colour_of(*background);
        const auto lights = in_.find("lights");
        if (lights) read_lights(lights->array());
        if (const auto materials = in_.find("materials"))
            for (const auto& [name, ignored] : materials->object().raw().items()) {
                make_room(*materials, sizeof(Material));
                material_numbers_[name] = static_cast<std::uint32_t>(scene_.materials.size());
                scene_.materials.push_back(material_of(materials->at(name), name));
            }
        // Whoever has spheres or planes needs no mesh.
        const bool has_others = in_.find("spheres") || in_.find("planes");
        if (!has_others || in_.find("meshes")) read_meshes(in_.at("meshes").object());
        if (!has_others || in_.find("objects")) objects(in_.at("objects").array());
        if (const auto spheres = in_.find("spheres")) read_each(spheres->array(), sphere_of, scene_.spheres);
        if (const auto planes = in_.find("planes")) read_each(planes->array(), plane_of, scene_.planes);
        return {std::move(scene_), lights.has_value()};
    }

private:
    /// Refuses what would make more than the files allow.
    void make_room(const JsonValue& from, std::uint64_t bytes) {
        if (!library_.loading().may_make(bytes)) from.refuse(library_.loading().too_much());
    }

    struct Mesh {
        Part part;
        std::optional<std::uint32_t> material_base;   ///< set once its own materials are in the scene
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
        if (list.size() > most_lights)
            list.refuse(fmt::format("has {} lights; the most is {}", list.size(), most_lights));
        for (std::size_t i = 0; i < list.size(); ++i) scene_.lights.push_back(light_of(list[i]));
    }

    template <class Primitive>
    void read_each(const JsonValue& list, Primitive (*read)(const JsonValue&), std::vector<Primitive>& into) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            into.push_back(read(list[i]));
            into.back().material = material(list[i]);
        }
    }

    /// The named one, or a grey one that all without a name share.
    std::uint32_t material(const JsonValue& in) {
        if (const auto name = in.find("material")) return known(material_numbers_, *name, "material");
        if (!grey_) {
            grey_ = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.push_back({.name = "default"});
        }
        return *grey_;
    }

    void read_meshes(const JsonValue& list) {
        for (const auto& [name, ignored] : list.raw().items()) meshes_[name] = {mesh(list.at(name)), {}};
    }

    Part mesh(const JsonValue& in) {
        in.only_keys({"file", "builtin", "native", "vertices", "triangles"});
        const bool is_inline = in.find("vertices") || in.find("triangles");
        if (is_inline + in.find("file").has_value() + in.find("builtin").has_value() != 1)
            in.refuse("needs one of 'file', 'builtin', or 'vertices' with 'triangles'");
        if (const auto native = in.find("native"); native && !in.find("builtin"))
            native->refuse("belongs to a 'builtin' only");
        if (const auto file = in.find("file"))
            return library_.file(path_.parent_path() / file->string(), *file);
        if (const auto builtin = in.find("builtin"))
            return library_.builtin(builtin->string(),
                                    flag_or(in, "native", false) ? Primitives::native : Primitives::triangles,
                                    *builtin);
        const auto part = std::make_shared<Scene>(inline_mesh(in));
        make_room(in, bytes_of(*part));
        return part;
    }

    void objects(const JsonValue& list) {
        if (list.size() == 0) list.refuse("is empty: there is nothing to see");
        // Counted first, before copies of copies fill the memory; and a scene has normals everywhere or
        // nowhere.
        bool any_smooth = false;
        std::uint64_t primitives = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Scene& part = *named(list[i]).part;
            any_smooth = any_smooth || !part.normals.empty();
            if ((primitives += primitive_count(part)) > max_triangles)
                list[i].refuse(fmt::format("brings the scene above {} triangles", max_triangles));
        }
        for (std::size_t i = 0; i < list.size(); ++i) {
            library_.loading().tell("placing", i, list.size());
            place(list[i], any_smooth);
        }
    }

    Mesh& named(const JsonValue& object) {
        object.only_keys({"mesh", "material", "translate", "rotate", "scale", "matrix"});
        return known(meshes_, object.at("mesh"), "mesh");
    }

    void place(const JsonValue& object, bool is_smooth) {
        Mesh& mesh = named(object);
        if (is_smooth && mesh.part->normals.empty()) {
            make_room(object, bytes_of(*mesh.part));
            mesh.part = std::make_shared<Scene>(*mesh.part);   // others may share it
            make_smooth(*mesh.part);
            make_room(object, bytes_of(*mesh.part));
        }
        std::optional<std::uint32_t> material;
        if (const auto name = object.find("material")) material = known(material_numbers_, *name, "material");
        if (!material && !mesh.material_base) {
            make_room(object, mesh.part->materials.size() * sizeof(Material));
            mesh.material_base = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.insert(scene_.materials.end(), mesh.part->materials.begin(),
                                    mesh.part->materials.end());
        }
        const glm::dmat4 transform = transform_of(object);
        if (!mesh.part->spheres.empty() && !keeps_spheres(transform))
            object.refuse("stretches spheres, which can only be scaled alike in all directions");
        make_room(object, bytes_of(*mesh.part) - mesh.part->materials.size() * sizeof(Material));
        append(scene_, *mesh.part, transform, material, mesh.material_base.value_or(0));
    }

    JsonValue in_;
    std::filesystem::path path_;
    Library& library_;
    Scene scene_;
    std::map<std::string, std::uint32_t> material_numbers_;
    std::optional<std::uint32_t> grey_;
    std::map<std::string, Mesh> meshes_;
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
    if (open_.size() > 50) from.refuse("lies deeper than 50 files");
    Part& part = known_[real.string()];
    if (part) return part;
    if (extension(path) == "json")
        return known_[real.string()] =
                   std::make_shared<Scene>(json(path, loading_.read(path, from.where())).scene);
    if (!is_mesh_file(path))
        from.expected(
            "a file of the kind .obj, .ply, .stl, .off, .3ds, .dae, .glb, .gltf (with .gz or without) or "
            ".json");
    return part = std::make_shared<Scene>(load_mesh_file(path, loading_, from.where()));
}

Part Library::builtin(const std::string& spec, Primitives primitives, const JsonValue& from) {
    Part& part = known_[(primitives == Primitives::native ? "native:" : "builtin:") + spec];
    if (part) return part;
    try {
        // About what it takes, before it is made.
        const PrimitiveCounts count = builtin_counts(spec, primitives);
        if (!loading_.may_make(count.triangles * (sizeof(Triangle) + sizeof(glm::dvec3)) +
                               count.spheres * sizeof(Sphere)))
            throw UserError(loading_.too_much());
        return part = std::make_shared<Scene>(make_builtin(spec, primitives));
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
