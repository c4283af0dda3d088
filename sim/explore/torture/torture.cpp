// The chips of the torture set, and lockstep runs of their cases.
#include "sim/explore/torture/torture.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/base/error.hpp"
#include "model/engine/check.hpp"
#include "model/engine/engines.hpp"
#include "sim/explore/torture/cases.hpp"

namespace rayclock {

namespace {

Config shading_chip() {
    Config c;
    c.coord_bits = 14, c.dir_bits = 16, c.t_frac_bits = 3, c.recip_bits = 12, c.box_bits = 5,
    c.bary_bits = 12, c.origin_bits = far_drop;   // the minimum for a bounce beyond the lattice
    c.node_width = 4, c.leaf_size = 2, c.contexts = 8, c.stack_depth = 16, c.pipelines = 2, c.tile_bits = 1;
    c.raygen_queue = 2, c.box_queue = 2, c.tri_queue = 4, c.shade_queue = 4, c.cache_queue = 2;
    c.node_sets = 2, c.node_ways = 2, c.node_line = 128, c.node_mshrs = 2;
    c.prim_sets = 2, c.prim_ways = 4, c.prim_line = 64, c.prim_mshrs = 4;
    c.surf_sets = 2, c.surf_ways = 2, c.surf_line = 256, c.surf_mshrs = 2;
    c.l2_sets = 4, c.l2_ways = 4, c.l2_line = 128, c.l2_mshrs = 4;
    c.shading = c.spheres = c.planes = c.smooth = c.refraction = c.horizon = c.supersampling = 1;
    c.panes = 2;
    c.lights = 5, c.bounces = 5, c.addr_bits = 9, c.prim_bits = 10, c.pixel_bits = 7;
    return c;
}

Config wide_chip() {
    Config c;
    c.coord_bits = 18, c.dir_bits = 24, c.t_frac_bits = 6, c.recip_bits = 23, c.box_bits = 8,
    c.bary_bits = 24, c.origin_bits = 11;
    c.node_width = 8, c.leaf_size = 6, c.contexts = 16, c.stack_depth = 2, c.tile_bits = 5;
    c.timing = Timing::fast, c.box_lanes = 2, c.shade_interval = 2;
    c.tri_queue = 32, c.node_sets = 4, c.node_ways = 4, c.node_mshrs = 8, c.prim_sets = 8, c.prim_ways = 2,
    c.prim_line = 128, c.prim_mshrs = 4;
    c.shading = 1, c.surf_sets = 8, c.surf_ways = 1, c.surf_mshrs = 4, c.lights = 3, c.bounces = 1;
    return c;
}

Config sheared_chip() {
    Config c;
    c.primitive_test = PrimitiveTest::sheared;
    // Short reciprocals of long directions give the largest shifts in the slabs.
    c.coord_bits = 16, c.dir_bits = 24, c.recip_bits = 8, c.box_bits = 4, c.bary_bits = 8, c.t_frac_bits = 6;
    c.node_width = 2, c.leaf_size = 3, c.contexts = 4, c.stack_depth = 32, c.tile_bits = 0;
    // One set: the shortest reset.
    c.node_sets = 1, c.node_ways = 8, c.node_line = 256, c.node_mshrs = 4, c.prim_sets = 1, c.prim_ways = 4,
    c.prim_mshrs = 2;
    c.box_lanes = 1, c.tri_interval = 2, c.raygen_interval = 4;
    c.addr_bits = 8;
    return c;
}

/// Two levels that shade: rays start in an instance. All intervals are long.
Config homes_chip() {
    Config c = shading_chip();
    c.structure = Structure::kd, c.levels = 2, c.mesh_structure = MeshStructure::bvh;
    c.coord_bits = 16, c.dir_bits = 18, c.bary_bits = 14, c.origin_bits = 10, c.t_frac_bits = 2;
    c.xform_interval = 4, c.shade_interval = 4, c.tri_interval = 4, c.raygen_interval = 8, c.box_lanes = 2;
    c.stack_depth = 32, c.tile_bits = 2, c.addr_bits = 10, c.lights = 3, c.bounces = 3;
    c.surf_ways = 4;
    c.textures = 1, c.texels = TexelFormat::rgb888;
    c.tex_sets = 2, c.tex_ways = 1, c.tex_line = 128, c.tex_mshrs = 2;
    return c;
}

/// Two levels without shading: planes in any direction above globes, all intervals 1.
Config slants_chip() {
    Config c;
    c.timing = Timing::fast;
    c.structure = Structure::bsp, c.levels = 2, c.mesh_structure = MeshStructure::spheres;
    c.coord_bits = 15, c.dir_bits = 17, c.recip_bits = 14, c.t_frac_bits = 5, c.bary_bits = 10;
    c.node_width = 4, c.leaf_size = 2, c.contexts = 16, c.stack_depth = 32, c.xform_interval = 1;
    c.raygen_queue = 32, c.box_queue = 32, c.tri_queue = 64;
    c.node_sets = 4, c.node_ways = 2, c.node_line = 128, c.node_mshrs = 2, c.prim_sets = 2, c.prim_ways = 2;
    c.prim_mshrs = 2, c.addr_bits = 10;
    return c;
}

/// No tree, every unit that shades, the longest stages, the shortest addresses.
Config listed_chip() {
    Config c = shading_chip();
    c.structure = Structure::none, c.timing = Timing::fast, c.shade_interval = 8;
    c.raygen_interval = 2, c.tri_interval = 1, c.node_width = 2, c.pipelines = 1, c.tile_bits = 3;
    c.tri_queue = c.shade_queue = 64;   // its pipelines are long
    c.contexts = 32, c.l2_sets = 0, c.surf_line = 64, c.prim_line = 128, c.prim_sets = 8, c.addr_bits = 8,
    c.lights = 4, c.bounces = 4;
    c.textures = 1, c.texels = TexelFormat::rgb565;
    c.tex_sets = 4, c.tex_ways = 1, c.tex_line = 64, c.tex_mshrs = 1;
    return c;
}

/// Rays from memory, and primitives of every kind: two pipelines, groups of four rays, and bursts of two
/// lines.
Config rays_chip() {
    Config c = shading_chip();
    c.smooth = c.refraction = c.horizon = c.supersampling = 0, c.panes = 0;
    c.source = RaySource::stream;
    c.timing = Timing::fast, c.raygen_interval = 4;
    c.stream_sets = 2, c.stream_ways = 1, c.stream_line = 128, c.stream_mshrs = 2;
    return c;
}

struct Chip {
    const char* name;
    Config (*make)();
};
constexpr Chip chips[] = {{"shading", shading_chip}, {"wide", wide_chip},     {"sheared", sheared_chip},
                          {"homes", homes_chip},     {"slants", slants_chip}, {"listed", listed_chip},
                          {"rays", rays_chip}};

/// Returns the last engine that the chips other than `shading` do not walk, or bvh if they walk all. If two
/// engines are left, one needs a chip of its own; a test finds it.
Structure engine_left() {
    Structure left = Structure::bvh;
    for_each_engine([&]<class E>(E) {
        bool walked = false;
        for (const Chip& chip : chips)
            if (chip.make != shading_chip) walked = walked || chip.make().is_walked(E::structure);
        if (!walked) left = E::structure;
    });
    return left;
}

}   // namespace

const std::vector<std::string>& torture_chips() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Chip& chip : chips) all.emplace_back(chip.name);
        return all;
    }();
    return names;
}

Config torture_chip(const std::string& name) {
    const auto it =
        std::find_if(std::begin(chips), std::end(chips), [&](const Chip& c) { return c.name == name; });
    if (it == std::end(chips)) throw std::logic_error("there is no tortured chip " + name);
    Config config = it->make();
    if (it->make == shading_chip) config.structure = engine_left();
    config.name = name;
    check_config(config, name);
    return config;
}

std::vector<TortureCase> torture_cases(const std::string& chip) {
    return torture::cases_of(torture_chip(chip));
}

std::vector<RecordedFrame> record_torture(const TortureCase& torture) {
    Job job = torture.job;
    std::vector<RecordedFrame> frames;
    for (std::size_t f = 0; f < torture.frames.size(); ++f) {
        Upload upload = f < torture.uploads.size() ? torture.uploads[f] : Upload{};
        apply(upload, job.image);
        frames.push_back(record_frame(job, torture.frames[f], 1));
        frames.back().upload = std::move(upload);
    }
    return frames;
}

LockstepResult run_torture(const TortureCase& torture, const Progress& progress) {
    return run_lockstep(torture.job, record_torture(torture), torture.disturbance, progress, torture.seed);
}

}   // namespace rayclock
