// The table of parameters that depend on other parameters.
#include "sim/run/request/idle.hpp"

#include <algorithm>

#include "sim/run/request/material.hpp"

namespace rayclock {

namespace {

bool has_octree(const Config& c) { return c.upper().is_octree() || c.lower().is_octree(); }

/// The parameters of a part that exists only if another parameter selects it.
struct Part {
    const char* decider;
    bool (*is_there)(const Config& config);
    std::vector<std::string> parameters;
};
const std::vector<Part>& parts() {
    static const std::vector<Part> all{
        {"dram", [](const Config& c) { return !c.dram_part(); }, {"mem_latency", "mem_interval"}},
        {"dram", [](const Config& c) { return c.dram_part() != nullptr; }, {"dram_channels"}},
        {"l2_sets", [](const Config& c) { return c.l2_sets > 0; }, {"l2_ways", "l2_line", "l2_mshrs"}},
        {"structure",
         [](const Config& c) { return !c.is_list(); },
         {"node_sets", "node_ways", "node_line", "node_mshrs", "box_queue", "stack_depth"}},
        {"structure", [](const Config& c) { return has_octree(c) || c.has_slants(); }, {"straddlers"}},
        {"structure", [](const Config& c) { return c.has_planes(); }, {"references"}},
        {"structure", [](const Config& c) { return c.has_boxes(); }, {"box_bits", "box_lanes"}},
        {"structure", [](const Config& c) { return c.is_bvh(); }, {"splits"}},
        {"structure",
         [](const Config& c) { return c.has_boxes() || c.has_globes() || has_octree(c); },
         {"leaf_size"}},
        {"levels", [](const Config& c) { return c.has_instances(); }, {"xform_interval", "mesh_structure"}},
        {"shading",
         [](const Config& c) { return c.shading != 0; },
         {"origin_bits", "lights", "bounces", "shade_queue", "shade_interval", "surf_sets", "surf_ways",
          "surf_line", "surf_mshrs"}}};
    return all;
}

std::string value_of(const Config& config, const std::string& key) {
    for (const Parameter& p : parameters())
        if (key == p.key) return value_text(config, p);
    return {};
}

}   // namespace

std::vector<std::string> idle_settings(const Config& config, const std::vector<std::string>& set) {
    std::vector<std::string> sentences;
    for (const std::string& item : set) {
        const std::string key = item.substr(0, item.find('='));
        for (const Part& part : parts()) {
            const auto& own = part.parameters;
            if (part.is_there(config) || std::find(own.begin(), own.end(), key) == own.end()) continue;
            sentences.push_back(key + " has no effect with " + part.decider + "=" +
                                value_of(config, part.decider));
        }
    }
    return sentences;
}

std::vector<std::string> idle_finish(const Finish& f, const Whitted& settings, const Scene& scene) {
    std::vector<std::string> sentences;
    if (f.depth && settings.depth > 0 && !has_bounces(scene))
        sentences.push_back(
            "--depth " + std::to_string(settings.depth) +
            " draws no reflected or refracted ray, since no material reflects or transmits light" +
            (may_give_material(scene) ? "; --material mirror=0.5 lets reflect what has no material of its own"
                                      : ""));
    if (f.threshold && settings.depth == 0) sentences.push_back("--threshold has no effect with --depth 0");
    if (f.contrast && settings.aa * settings.aa <= int(first_samples))
        sentences.push_back("--contrast has no effect with --aa " + std::to_string(settings.aa) +
                            ", since the first " + std::to_string(first_samples) +
                            " samples are always taken");
    return sentences;
}

}   // namespace rayclock
