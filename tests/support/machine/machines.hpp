#pragma once
// Small frames for machines of many shapes.
#include <string>
#include <utility>
#include <vector>

#include "model/scene/builtin.hpp"
#include "model/engine/check.hpp"
#include "model/core/parameters.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock::test {

using Values = std::vector<std::pair<std::string, int>>;

inline Config shaped(Config config, const Values& values) {
    for (const auto& [key, value] : values) {
        for (const Parameter& p : parameters())
            if (key == p.key)
                set_parameter(config, key, p.names ? (*p.names)[std::size_t(value)] : std::to_string(value),
                              "test");
        config.name += " " + key + "=" + std::to_string(value);
    }
    check_config(config, config.name);
    return config;
}

inline Job small_job(const char* scene, FrameSize size, const Config& config) {
    const Scene made = make_builtin(scene);
    return make_job(made, made.camera ? *made.camera : fit_camera(made, double(size.width) / size.height),
                    size, config);
}

/// Returns shapes that change only timing, not results: memories, contexts, pipelines, caches. They fit the
/// format of `small`.
inline const std::vector<Values>& shapes() {
    static const std::vector<Values> all{
        {},
        {{"contexts", 1}, {"dram", 0}},
        {{"contexts", 256}, {"dram", 2}},
        {{"dram", 1}, {"contexts", 4}, {"tile_bits", 0}},
        {{"dram", 3}, {"pipelines", 2}},
        {{"dram", 0}, {"mem_latency", 100}, {"mem_interval", 5}, {"pipelines", 4}, {"contexts", 8}},
        {{"dram", 2}, {"pipelines", 2}, {"l2_sets", 64}, {"node_sets", 4}, {"prim_sets", 4}},
        {{"dram", 0},
         {"l2_sets", 16},
         {"l2_line", 256},
         {"l2_ways", 1},
         {"l2_mshrs", 1},
         {"mem_latency", 40}},
        {{"dram", 0},
         {"node_sets", 1},
         {"node_ways", 1},
         {"node_mshrs", 1},
         {"prim_sets", 1},
         {"prim_ways", 1},
         {"prim_mshrs", 1},
         {"cache_queue", 2}},
        {{"node_sets", 1},
         {"node_ways", 1},
         {"prim_sets", 1},
         {"prim_ways", 1},
         {"contexts", 1},
         {"dram", 2}},
        {{"node_line", 256},
         {"prim_line", 128},
         {"node_sets", 8},
         {"dram", 1},
         {"tri_interval", 4},
         {"shade_interval", 4},
         {"raygen_interval", 8},
         {"box_lanes", 2}},
        {{"dram", 0}, {"raygen_queue", 2}, {"box_queue", 2}, {"tri_queue", 2}, {"mem_latency", 1}},
    };
    return all;
}

}   // namespace rayclock::test
