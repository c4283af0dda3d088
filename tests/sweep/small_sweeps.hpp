#pragma once
// Sweeps of small scenes.
#include <catch2/catch.hpp>

#include <filesystem>

#include "sim/load/load.hpp"
#include "sim/explore/sweep/front.hpp"
#include "tests/support/files/test_folder.hpp"

namespace rayclock::test {

inline Scene scene_with_camera(const std::string& name) {
    Scene scene = load_scene(name);
    if (!scene.camera) scene.camera = fit_camera(scene, 4.0 / 3);
    return scene;
}

inline int megahertz(const std::string& text) { return std::stoi(text) * 1000; }

inline std::vector<sweep::Axis> axes_of(const std::vector<std::string>& texts) {
    std::vector<sweep::Axis> axes;
    for (const std::string& text : texts) axes.push_back(sweep::parse_axis(text));
    return axes;
}
inline std::vector<sweep::Point> points_of(const std::vector<std::string>& texts,
                                           const Config& base = named_config("default")) {
    return sweep::make_points(axes_of(texts), base, 66000, megahertz);
}

/// Runs a sweep without netlists.
inline sweep::Evaluation run_sweep(const Scene& scene, const std::vector<std::string>& axes,
                                   const std::filesystem::path& folder, bool fresh = false,
                                   FrameSize size = {48, 36}) {
    results::Cache cache(folder, fresh);
    sweep::Evaluation outcome = sweep::run({scene, size, points_of(axes), 2, false}, cache, {});
    CHECK(cache.trouble().empty());
    return outcome;
}

}   // namespace rayclock::test
