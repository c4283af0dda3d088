// Stand-ins for the readers of pictures and for Assimp, which the targets of scenes do not use.
#include "tests/fuzz/program/scenes.hpp"

#include <cmath>
#include <cstdlib>

#include "model/scene/view.hpp"
#include "sim/load/import/assimp.hpp"
#include "sim/load/lights.hpp"
#include "sim/load/textures.hpp"
#include "sim/explore/sweep/key.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock {

/// Pictures are not decoded, because load_scene() is not fuzzed.
glm::vec4 average_colour(const std::string&) { throw std::runtime_error("pictures are not read here"); }

TexelLevel decoded_picture(const std::string&) { throw std::runtime_error("pictures are not read here"); }

/// No other program is started.
bool assimp_reads(const std::string&) { return false; }
std::string assimp_glb(const std::filesystem::path& file, std::uint64_t, const std::optional<std::string>&) {
    throw UserError(file.string() + ": is not read here");
}

}   // namespace rayclock

namespace rayclock::fuzz {
namespace {

/// The result of a call, or the sentence of its refusal.
struct Answer {
    Scene scene;
    std::string refusal;
    bool operator==(const Answer& other) const {
        return refusal == other.refusal && sweep::scene_digest(scene) == sweep::scene_digest(other.scene);
    }
};

Answer answer_of(const std::function<Scene(Loading&)>& read) {
    static const Progress silent;
    static const bool is_large = std::getenv("RC_FUZZ_LARGE") != nullptr;
    // Every file yields the same picture, so that coordinates are checked.
    const auto picture = [](const std::string&) {
        return TexelLevel{2, 1, {{0, 0, 0, 255}, {255, 255, 255, 255}}};
    };
    Loading loading(silent, is_large ? Allowance{} : small_allowance, {}, picture);
    Answer answer;
    try {
        PlacedScene placed;
        placed.own = read(loading);
        settle_textures(placed, "the scene", loading);
        answer.scene = std::move(placed.own);
    } catch (const UserError& error) {
        answer.refusal = error.what();
        check_sentence(answer.refusal);
    }
    for (const std::string& note : loading.notes()) check_sentence(note);
    return answer;
}

void check_indices(const Scene& scene) {
    for (const Triangle& t : scene.triangles) {
        for (const std::uint32_t v : t.vertex)
            demand(v < scene.vertices.size(), "a triangle's vertices are in range");
        demand(t.material < scene.materials.size(), "a triangle's material is in range");
    }
    for (const Sphere& s : scene.spheres)
        demand(s.material < scene.materials.size(), "a sphere's material is in range");
    for (const Plane& p : scene.planes)
        demand(p.material < scene.materials.size(), "a plane's material is in range");
    demand(scene.normals.empty() || scene.normals.size() == scene.vertices.size(),
           "every vertex has a normal, or none has");
}

}   // namespace

void check_reader(std::string_view bytes, const std::function<Scene(Loading&)>& read, Finite finite) {
    Answer answer = answer_of(read);
    if (bytes.size() % 8 == 0) demand(answer == answer_of(read), "the same bytes give the same answer");
    if (!answer.refusal.empty()) return;
    Scene& scene = answer.scene;
    check_indices(scene);
    const bool is_good = passes([&] { check_scene(scene, "the scene"); });
    demand(is_good || finite == Finite::checked, "what a file of floats gives can be traced");
    if (!is_good) return;
    for (const glm::dvec3& n : scene.normals)
        demand(std::abs(n.x * n.x + n.y * n.y + n.z * n.z - 1) < 1e-6, "normals have unit length");
    passes([&] {
        add_missing_lights(scene);
        check_scene(scene, "the scene with lights");
        view_of(scene.camera ? *scene.camera : fit_camera(scene, 4.0 / 3), "the camera");
    });
}

}   // namespace rayclock::fuzz
