#pragma once
// Shared by the sweep's tests: an empty folder, and sweeps of small scenes.
#include <catch2/catch.hpp>

#include <filesystem>

#include "sim/load/load.hpp"
#include "sim/explore/sweep/front.hpp"

namespace rayclock::test {

/// A temporary folder, removed at the end.
class CacheFolder {
public:
    CacheFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "rayclock-sweep-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~CacheFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    CacheFolder(const CacheFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

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
inline sweep::Outcome run_sweep(const Scene& scene, const std::vector<std::string>& axes,
                                const std::filesystem::path& folder, bool fresh = false,
                                FrameSize size = {48, 36}) {
    results::Cache cache(folder, fresh);
    sweep::Outcome outcome = sweep::run({scene, size, points_of(axes), 2, false}, cache, {});
    CHECK(cache.trouble().empty());
    return outcome;
}

}   // namespace rayclock::test
