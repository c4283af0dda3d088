#pragma once
// Frames that are watched, on machines of all kinds.
#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"
#include "model/engine/check.hpp"
#include "sim/view/observe/story.hpp"

namespace rayclock::test {

struct Watched {
    const char* scene;
    std::vector<std::pair<const char*, const char*>> values;
    bool finished = false;
    Traffic traffic{};
    int frames = 1;
};

struct Watching {
    Job job;
    std::vector<RecordedFrame> traces;
};

inline Watching watching(const Watched& w, FrameSize size = {37, 29}) {
    const Scene scene = make_builtin(w.scene, w.finished ? Primitives::native : Primitives::triangles);
    const Whitted settings{.depth = 4};
    Config config = named_config("default");
    if (w.finished) config = fitted_config(scene, settings, config);
    for (const auto& [key, value] : w.values) set_parameter(config, key, value, "test");
    check_config(config, "test");
    Watching made{make_job(scene, *scene.camera, size, config, {}, settings), {}};
    for (int f = 0; f < w.frames; ++f) made.traces.push_back(record_frame(made.job, made.job.frame));
    return made;
}

inline const std::vector<Watched>& watched_machines() {
    static const std::vector<Watched> all{
        {"gears:2", {}},
        {"gears:2", {{"pipelines", "4"}, {"l2_sets", "16"}, {"node_sets", "4"}}, false, {}, 2},
        {"gears:2", {{"timing", "fast"}, {"prim_line", "128"}, {"dram", "ideal"}}},
        {"mount:4", {{"node_sets", "1"}, {"node_ways", "2"}, {"node_mshrs", "1"}}, false, {20, 30, 5}},
        {"spheres", {}, true},
        {"balls:2", {{"contexts", "8"}, {"surf_sets", "1"}, {"surf_line", "128"}, {"pipelines", "2"}}, true},
        {"spheres", {{"timing", "fast"}, {"l2_sets", "4"}, {"l2_line", "128"}}, true, {9, 20, 3}},
        {"spheres", {{"shade_interval", "4"}}, true},
        {"gears:1", {{"structure", "kd"}}},
        {"gears:1", {{"structure", "spheres"}}},
        {"gears:1", {{"structure", "bsp"}}},
        {"tetra:2", {{"structure", "none"}}},
        {"gears:2", {{"tri_interval", "4"}, {"box_lanes", "2"}, {"raygen_interval", "4"}}},
        {"gearbox:2", {{"levels", "2"}}},
        {"gearbox:2", {{"levels", "2"}, {"timing", "fast"}, {"xform_interval", "1"}, {"node_sets", "2"}}},
    };
    return all;
}

}   // namespace rayclock::test
