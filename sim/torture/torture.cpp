#include "sim/torture/torture.hpp"

#include <stdexcept>

#include "model/base/error.hpp"
#include "sim/torture/cases.hpp"

namespace rayclock {

namespace {

Config shading_chip() {
    Config c;
    c.coord_bits = 14, c.dir_bits = 16, c.t_frac_bits = 3, c.recip_bits = 12, c.box_bits = 5,
    c.bary_bits = 12, c.origin_bits = 8;
    c.node_width = 4, c.leaf_size = 2, c.contexts = 8, c.stack_depth = 16, c.pipelines = 2, c.tile_bits = 1;
    c.raygen_queue = 2, c.box_queue = 2, c.tri_queue = 4, c.shade_queue = 4, c.cache_queue = 2;
    c.node_sets = 2, c.node_ways = 2, c.node_line = 128, c.node_mshrs = 2;
    c.prim_sets = 2, c.prim_ways = 4, c.prim_line = 64, c.prim_mshrs = 4;
    c.surf_sets = 2, c.surf_ways = 2, c.surf_line = 256, c.surf_mshrs = 2;
    c.l2_sets = 4, c.l2_ways = 4, c.l2_line = 128, c.l2_mshrs = 4;
    c.shading = c.spheres = c.planes = c.smooth = c.refraction = c.supersampling = 1;
    c.lights = 5, c.bounces = 5, c.addr_bits = 9, c.prim_bits = 10, c.pixel_bits = 7;
    return c;
}

Config wide_chip() {
    Config c;
    c.coord_bits = 18, c.dir_bits = 24, c.t_frac_bits = 6, c.recip_bits = 23, c.box_bits = 8,
    c.bary_bits = 24, c.origin_bits = 11;
    c.node_width = 8, c.leaf_size = 6, c.contexts = 16, c.stack_depth = 2, c.tile_bits = 5;
    c.tri_queue = 32, c.node_sets = 4, c.node_ways = 4, c.node_mshrs = 8, c.prim_sets = 8, c.prim_ways = 2,
    c.prim_line = 128, c.prim_mshrs = 4;
    c.shading = 1, c.surf_sets = 8, c.surf_ways = 1, c.surf_mshrs = 4, c.lights = 3, c.bounces = 1;
    return c;
}

Config sheared_chip() {
    Config c;
    c.primitive_test = int(PrimitiveTest::sheared);
    // Short reciprocals of long directions: the slabs' shifts go as far as they can.
    c.coord_bits = 16, c.dir_bits = 24, c.recip_bits = 8, c.box_bits = 4, c.bary_bits = 8, c.t_frac_bits = 6;
    c.node_width = 2, c.leaf_size = 3, c.contexts = 4, c.stack_depth = 32, c.tile_bits = 0;
    // One set: reset is as short as it may be.
    c.node_sets = 1, c.node_ways = 8, c.node_line = 256, c.node_mshrs = 4, c.prim_sets = 1, c.prim_ways = 4,
    c.prim_mshrs = 2;
    c.addr_bits = 8;
    return c;
}

}   // namespace

const std::vector<std::string>& torture_chips() {
    static const std::vector<std::string> names{"shading", "wide", "sheared"};
    return names;
}

Config torture_chip(const std::string& name) {
    Config config = name == "shading" ? shading_chip() : name == "wide" ? wide_chip() : sheared_chip();
    config.name = name;
    check_config(config, name);
    return config;
}

std::vector<TortureCase> torture_cases(const std::string& chip) {
    return torture::cases_of(torture_chip(chip));
}

LockstepResult run_torture(const TortureCase& torture, const Progress& progress) {
    std::vector<FrameTrace> frames;
    for (const Frame& frame : torture.frames) frames.push_back(record_frame(torture.job, frame, 1));
    return run_lockstep(torture.job, frames, torture.traffic, progress, torture.seed);
}

}   // namespace rayclock
