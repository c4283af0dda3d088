#pragma once
// Frames that are watched, on machines of all kinds.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "model/core/settled.hpp"
#include "model/scene/builtin.hpp"
#include "model/engine/check.hpp"
#include "sim/run/stream/stream.hpp"
#include "sim/view/observe/story.hpp"
#include "tests/support/check/streams.hpp"

namespace rayclock::test {

struct Watched {
    const char* scene;
    std::vector<std::pair<const char*, const char*>> values;
    bool finished = false;
    Disturbance disturbance{};
    int frames = 1;
    std::size_t rays = 0;   ///< random rays in place of a camera; 0: a picture
};

struct Watching {
    Job job;
    std::vector<RecordedFrame> traces;
};

inline Watching watching_stream(const Watched& w, std::size_t rays) {
    const Scene scene = make_builtin(w.scene, Primitives::triangles);
    const ListedRays stream("random rays", random_rays(scene, rays, 1));
    Config config = streaming(named_config("default"), scene);
    for (const auto& [key, value] : w.values) set_parameter(config, key, value, "test");
    config = settled(config);
    check_config(config, "test");
    Watching made{make_stream_job(scene, stream, config, Outside::clip).job, {}};
    made.traces.push_back(record_frame(made.job, made.job.frame));
    return made;
}

inline Watching watching(const Watched& w, FrameSize size = {37, 29}) {
    if (w.rays > 0) return watching_stream(w, std::size_t(size.width) * std::size_t(size.height));
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
        {"gears:2", {}, false, {}, 1, 37 * 29},
        {"gears:2",
         {{"pipelines", "2"},
          {"tile_bits", "0"},
          {"l2_sets", "8"},
          {"stream_line", "64"},
          {"stream_sets", "1"},
          {"stream_ways", "1"},
          {"stream_mshrs", "1"},
          {"raygen_interval", "4"},
          {"pixel_bits", "7"}},
         false,
         {20, 30, 5},
         1,
         37 * 29},
        {"gears:1", {{"structure", "kd"}, {"timing", "fast"}, {"stream_line", "256"}}, false, {}, 1, 37 * 29},
    };
    return all;
}

}   // namespace rayclock::test
