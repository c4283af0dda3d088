// Random legal chips.
#include "sim/explore/torture/random_chip.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "model/base/error.hpp"
#include "model/base/rng.hpp"
#include "model/core/parameters.hpp"
#include "model/engine/check.hpp"

namespace rayclock {

namespace {

/// Returns the largest value to draw among the legal ones: larger ones make no difference in a small frame,
/// or are slow in Verilator.
int max_of(const Parameter& p) {
    const std::string key = p.key;
    const std::pair<const char*, int> most[] = {{"contexts", 128},
                                                {"mem_latency", 60},
                                                {"mem_interval", 4},
                                                {"raygen_queue", 64},
                                                {"box_queue", 64},
                                                {"tri_queue", 64},
                                                {"cache_queue", 64},
                                                {"node_sets", 64},
                                                {"prim_sets", 64},
                                                {"l2_sets", 128},
                                                {"node_mshrs", 16},
                                                {"prim_mshrs", 16},
                                                {"l2_mshrs", 32},
                                                {"primitive_test", 1},
                                                {"shade_queue", 64},
                                                {"surf_sets", 64},
                                                {"surf_mshrs", 16},
                                                {"lights", 16},
                                                // The board's memory comes last, and few other parameters are
                                                // legal with it.
                                                {"dram", int(DramName::board) - 1}};
    for (const auto& [name, value] : most)
        if (key == name) return std::min(value, p.hi);
    return p.hi;
}

}   // namespace

Config random_chip(std::uint64_t seed, bool single) {
    Rng rng(seed);
    const auto draw = [&](const Parameter& p, int hi) {
        const int pick = rng.below(4);
        if (!p.power_of_two()) return pick == 0 ? p.lo : pick == 1 ? hi : p.lo + rng.below(hi - p.lo + 1);
        const int lo = std::max(p.lo, 1);
        int steps = 0;
        while (lo << (steps + 1) <= hi) ++steps;
        return pick == 0 ? lo : pick == 1 ? lo << steps : lo << rng.below(steps + 1);
    };
    for (;;) {
        Config config;
        config.name = "random " + std::to_string(seed);
        for (const Parameter& p : parameters())
            if (!p.is("levels") && !p.is("mesh_structure") && !p.is("xform_interval") &&
                !p.is("shade_interval") && !p.is("raygen_interval") && !p.is("panes") && !p.is("horizon"))
                p.set(config, draw(p, max_of(p)));
        // Not below what the scenes need; from a source of their own.
        Rng widths(seed * 31 + 7);
        config.addr_bits = std::max(config.least_addr_bits(), 15 + widths.below(max_addr_bits - 14));
        config.prim_bits = 16 + widths.below(max_prim_bits - 15);
        config.pixel_bits = 7 + widths.below(max_pixel_bits - 6);
        config.xform_interval = 1 << widths.below(3);
        config.levels = 1 + widths.below(2);
        config.shade_interval = 1 << widths.below(4);
        config.raygen_interval = 1 << widths.below(4);
        config.pipelines = rng.below(4) == 0 && !single ? 2 : 1;
        if (rng.below(3) != 0) config.l2_sets = 0;
        // Two of three do not shade. The others have at least what the scenes need; spheres, planes and
        // samples are as drawn.
        config.shading = !single && seed % 3 == 0;
        if (config.shading)
            config.smooth = config.refraction = 1, config.lights = std::max(config.lights, 5),
            config.bounces = std::max(config.bounces, 5);
        else
            config.spheres = config.planes = config.smooth = config.refraction = config.supersampling = 0;
        if (config.planes && config.refraction) config.panes = widths.below(max_panes + 1);
        if (config.planes && config.origin_bits >= far_drop) config.horizon = widths.below(2);
        if (config.is_list() || config.is_sheared() || config.shading) config.levels = 1;
        config.mesh_structure =
            MeshStructure(config.has_instances() ? widths.below(int(names_of<MeshStructure>().size())) : 0);
        try {
            check_config(config, config.name);
            return config;
        } catch (const UserError&) {
            continue;   // widths that are not a legal combination
        }
    }
}

}   // namespace rayclock
