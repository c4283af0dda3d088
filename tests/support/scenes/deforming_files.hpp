#pragma once
// Deforming meshes as files: a waving sheet, a crumpled one, and moving objects next to them.
#include <cmath>
#include <functional>
#include <sstream>

#include <catch2/catch.hpp>

#include "sim/load/json/scene.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test {

/// Returns n by n squares as OBJ. `at` maps the point (x, 0, z), -1 <= x, z <= 1, to its corner.
inline std::string sheet_obj(int n, const std::function<glm::dvec3(double x, double z)>& at) {
    std::ostringstream out;
    out.precision(9);
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k) {
            const glm::dvec3 p = at(2.0 * k / n - 1, 2.0 * i / n - 1);
            out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
        }
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const int v = i * (n + 1) + k + 1;
            out << "f " << v << ' ' << v + n + 1 << ' ' << v + n + 2 << ' ' << v + 1 << '\n';
        }
    return out.str();
}

inline std::string waving(int n, double phase) {
    return sheet_obj(n, [&](double x, double z) {
        return glm::dvec3(x, 0.3 * std::sin(4 * x + phase) * std::cos(2 * z - phase), z);
    });
}

/// Returns a sheet rolled up so that corners from both halves come close to each other, and its tree
/// degrades.
inline std::string crumpled(int n) {
    return sheet_obj(n, [&](double x, double z) {
        return glm::dvec3(std::sin(29 * x + 3 * z), std::sin(37 * z + x), std::cos(31 * x - 23 * z));
    });
}

/// Writes a scene with the sheet in three shapes, twice, one of them turned, small and moving, and a resting
/// ball. Returns the name of the scene's file.
inline std::string sheet_film(const SceneFolder& folder, int n, bool crumples = false) {
    folder.write("a.obj", waving(n, 0));
    folder.write("b.obj", waving(n, 2));
    folder.write("c.obj", crumples ? crumpled(n) : waving(n, 4));
    return folder.write("sheet.json", R"({
      "camera": {"eye": [0.5, 2, 4], "at": [0, 0, 0]}, "lights": [{"position": [3, 5, 4]}],
      "meshes": {"sheet": {"shapes": [{"time": 0, "file": "a.obj"}, {"time": 1, "file": "b.obj"},
                                      {"time": 2.5, "file": "c.obj"}]},
                 "ball": {"builtin": "icosphere:1"}},
      "objects": [{"mesh": "sheet"},
                  {"mesh": "sheet", "keyframes": [
                     {"time": 0, "translate": [1, 0.8, 0], "rotate": {"axis": [0, 1, 0], "degrees": 0}, "scale": 0.4},
                     {"time": 2, "translate": [1, 1.2, 0], "rotate": {"axis": [0, 1, 0], "degrees": 120}, "scale": 0.4}]},
                  {"mesh": "ball", "translate": [-1, 0.8, 0], "scale": 0.3}]})");
}

inline PlacedScene scene_in(const std::string& path) {
    const Progress silent;
    Loading loading(silent);
    return load_json_scene(path, loading).scene;
}

/// Requires that a sentence has all these parts.
inline void check_says(const std::string& said, const std::vector<std::string>& parts) {
    INFO("said: " << said);
    for (const std::string& part : parts) CHECK_THAT(said, Catch::Contains(part));
}

}   // namespace rayclock::test
