// Choosing between built-in scenes and files, and completing the loaded scene.
#include "sim/load/load.hpp"

#include <filesystem>
#include <new>

#include "model/base/error.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/folded.hpp"
#include "sim/files/image/average.hpp"
#include "sim/files/input.hpp"
#include "sim/files/text.hpp"
#include "sim/load/json/scene.hpp"
#include "sim/load/lights.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

/// Returns true if the name has a dot or a slash or exists on the disk. All other names mean built-in scenes.
bool is_file_name(const std::string& spec) {
    std::error_code ignored;
    return spec.find_first_of("./") != spec.npos || std::filesystem::exists(spec, ignored);
}

JsonLoad load_file(const std::string& spec, Loading& loading) {
    const std::filesystem::path path(spec);
    if (extension(path) == "json") return load_json_scene(path, loading);
    if (is_mesh_file(path)) return {load_mesh_file(path, loading), false};
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        SourcePosition{spec}.refuse(
            "there is no such file, and no built-in scene has a dot or slash in its name");
    read_file(path);   // reports a directory or an unreadable file
    SourcePosition{spec}.refuse(
        "is not a kind of file that can be loaded (.obj .ply .stl .off .3ds .dae .glb .gltf, by Assimp .fbx "
        ".x3d "
        ".blend .lwo and others, these also with .gz behind, .json), nor a built-in scene");
}

/// Loads a scene, and reports whether its lights are complete.
JsonLoad load_anything(const std::string& spec, Primitives primitives, Loading& loading) {
    if (spec.empty()) throw UserError("the name of the scene is empty");
    if (spec.find('\0') != spec.npos) throw UserError("the name of the scene has a zero byte in it");
    const bool is_made = is_builtin(spec) || !is_file_name(spec);
    return is_made ? JsonLoad{make_placed(spec, primitives), true} : load_file(spec, loading);
}

/// Returns a scene with too many placed triangles to expand its instances.
Scene folded_scene(JsonLoad load, const std::string& where) {
    if (!load.has_lights)
        throw UserError(
            where + ": " + std::to_string(primitive_count(load.scene)) +
            " placed triangles are too many to find lights for them; the scene must have a list of them");
    Scene scene = keep_instances(std::move(load.scene));
    check_folded(scene, where);
    return scene;
}

}   // namespace

Scene load_scene(const std::string& spec, const Progress& progress, Primitives primitives,
                 std::vector<std::string>* notes, Textures textures) {
    Loading loading(progress, {}, average_colour,
                    textures == Textures::drawn ? decoded_picture : DecodePicture{});
    try {
        JsonLoad load = load_anything(spec, primitives, loading);
        settle_textures(load.scene, printable(spec), loading);
        if (notes) *notes = loading.notes();
        if (primitive_count(load.scene) > max_unfolded) return folded_scene(std::move(load), printable(spec));
        Scene scene = flattened(std::move(load.scene));
        check_scene(scene, printable(spec));
        if (!load.has_lights) add_missing_lights(scene);
        return scene;
    } catch (const std::bad_alloc&) {
        SourcePosition{spec}.refuse("the scene does not fit in memory");
    } catch (const std::filesystem::filesystem_error& error) {
        SourcePosition{spec}.refuse("cannot be read (" + error.code().message() + ")");
    }
}

}   // namespace rayclock
