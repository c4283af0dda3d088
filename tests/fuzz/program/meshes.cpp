// Fuzzes OBJ with MTL, PLY, STL, glTF and the other mesh formats.
#include "sim/load/gunzip.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "tests/fuzz/program/scenes.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {
namespace {

using Read = Scene (*)(const std::filesystem::path&, std::string, Loading&);

/// Reads a mesh as load_mesh_file() does.
void check_mesh(Read read, const std::string& name, std::string_view bytes, Finite finite) {
    check_reader(
        bytes, [&](Loading& loading) { return read(file(name), std::string(bytes), loading); }, finite);
}

}   // namespace

void obj(std::string_view bytes) { check_mesh(read_obj, "fuzzed.obj", bytes, Finite::always); }
void ply(std::string_view bytes) { check_mesh(read_ply, "fuzzed.ply", bytes, Finite::always); }
void stl(std::string_view bytes) { check_mesh(read_stl, "fuzzed.stl", bytes, Finite::always); }
void off(std::string_view bytes) { check_mesh(read_off, "fuzzed.off", bytes, Finite::always); }
void tds(std::string_view bytes) { check_mesh(read_3ds, "fuzzed.3ds", bytes, Finite::always); }
void dae(std::string_view bytes) { check_mesh(read_dae, "fuzzed.dae", bytes, Finite::checked); }
void gz(std::string_view bytes) {
    const auto read = [](const std::filesystem::path& path, std::string packed, Loading& loading) {
        return read_off(path, gunzip(path, packed, loading), loading);
    };
    check_mesh(read, "fuzzed.off.gz", bytes, Finite::always);
}
void gltf(std::string_view bytes) { check_mesh(read_gltf, "fuzzed.gltf", bytes, Finite::checked); }

/// Assigns every material to a triangle, so that its values are checked.
void mtl(std::string_view bytes) {
    check_reader(
        bytes,
        [&](Loading& loading) {
            Scene scene;
            scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
            scene.materials.emplace_back();
            scene.triangles.push_back({{0, 1, 2}, 0});
            for (const MtlBlock& block : read_mtl(file("fuzzed.mtl"), bytes, loading)) {
                scene.materials.push_back(material_of(block.surface, block.name));
                const Material& m = scene.materials.back();
                demand(m.mirror + m.transmit <= 1 + 1e-9, "no more light leaves a surface than has come");
            }
            return scene;
        },
        Finite::always);
}

}   // namespace rayclock::fuzz
