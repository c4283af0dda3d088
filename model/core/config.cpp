// The table of parameters, the named configurations, and the widths derived from them.
#include "model/core/config.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/core/lines.hpp"
#include "model/core/dram_parts.hpp"

namespace rayclock {

namespace {
constexpr std::array mesh_structures{Structure::bvh, Structure::kd, Structure::octree, Structure::spheres,
                                     Structure::bsp};   // order of mesh_structure_names() after its first
                                                        // entry
}   // namespace
Structure Config::lower_structure() const {
    return has_instances() && mesh_structure > 0 ? mesh_structures[std::size_t(mesh_structure - 1)]
                                                 : Structure(structure);
}
Config Config::upper() const {
    Config level = *this;
    level.mesh_structure = 0;
    return level;
}
Config Config::lower() const {
    Config level = upper();
    level.structure = int(lower_structure());
    return level;
}

int Config::guard_dir_bits() const { return dir_bits + guard_bits; }
int Config::edge_bits() const {
    if (is_sheared()) return 2 * coord_bits + 3;
    const int plain = 2 * coord_bits + dir_bits + 2;
    // A bounce is the first of these, a shadow ray the second: docs/origins.md.
    return shading ? std::max(plain + origin_bits, 3 * coord_bits + origin_bits + 3) : plain;
}
int Config::tri_ray_bits() const {
    return 3 * origin_width() + 3 * ray_dir_bits() + (is_sheared() ? 3 : 0) + (shading ? 2 : 0) +
           (planes ? 1 : 0) + (spheres ? prim_bits + 1 : 0);
}
int Config::ray_bits() const { return index_bits(contexts); }
int Config::group_bits() const { return index_bits(node_width + 1); }
int Config::slot_bits() const { return index_bits(node_width); }
int Config::stack_bits() const { return index_bits(stack_depth + 1); }

// A direction has length 2^(M-2), and the lattice reaches 2^(N-1+B). The last step is an eighth of that
// reach, unless directions are too long.
int Config::approach_shift() const { return std::max(0, origin_width() - dir_bits - 2); }

namespace {
int miss_bits(int mshrs, int line) {
    return index_bits(mshrs) + (line > line_bytes ? index_bits(line / line_bytes) : 0);
}
}   // namespace
int Config::node_miss_bits() const { return miss_bits(node_mshrs, node_line); }
int Config::prim_miss_bits() const { return miss_bits(prim_mshrs, prim_line); }
int Config::surf_miss_bits() const { return shading ? miss_bits(surf_mshrs, surf_line) : 1; }
int Config::l2_miss_bits() const { return miss_bits(l2_mshrs, l2_line); }
int Config::least_addr_bits() const {
    const auto beside_tag = [](int sets, int line) {
        return int(std::bit_width(unsigned(sets)) + std::bit_width(unsigned(line / line_bytes))) - 2;
    };
    const int own = std::max({beside_tag(node_sets, node_line), beside_tag(prim_sets, prim_line),
                              shading ? beside_tag(surf_sets, surf_line) : 0});
    return 1 + (l2_sets > 0 ? std::max(own, beside_tag(l2_sets, l2_line)) : own);
}
int Config::clear_cycles() const {
    return 4 + std::max({node_sets, prim_sets, shading ? surf_sets : 0, l2_sets});
}
int Config::client_bits() const { return index_bits(clients() * pipelines); }
int Config::client_id_bits() const {
    return client_bits() + std::max({node_miss_bits(), prim_miss_bits(), shading ? surf_miss_bits() : 0});
}
int Config::tile_coord_bits() const { return pixel_bits - tile_bits; }
int Config::mem_id_bits() const { return l2_sets > 0 ? l2_miss_bits() : client_id_bits(); }

const DramPart* Config::dram_part() const {
    if (own_dram) return own_dram.get();
    return dram == 0 ? nullptr : &rayclock::dram_part(dram_names()[std::size_t(dram)]);
}

const std::vector<std::string>& dram_names() {
    static const std::vector<std::string> names{"ideal",    "sdr",  "ddr3",   "rpu",
                                                "sdr_half", "ddr4", "lpddr4", "hbm2"};
    return names;
}

const std::vector<std::string>& structure_names() {
    static const std::vector<std::string> names{"bvh", "kd", "none", "octree", "spheres", "bsp"};
    return names;
}

const std::vector<std::string>& mesh_structure_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"same"};
        for (const Structure s : mesh_structures) all.push_back(structure_names()[std::size_t(s)]);
        return all;
    }();
    return names;
}

const std::vector<std::string>& straddlers_names() {
    static const std::vector<std::string> names{"leaves", "inner", "stop"};
    return names;
}

const std::vector<std::string>& splits_names() {
    static const std::vector<std::string> names{"off", "on"};
    return names;
}

const std::vector<std::string>& timing_names() {
    static const std::vector<std::string> names{"relaxed", "fast"};
    return names;
}

const std::vector<std::string>& primitive_test_names() {
    static const std::vector<std::string> names{"exact", "sheared", "unit24", "moller", "woop", "truncated"};
    return names;
}

std::string value_text(const Config& config, const Parameter& p) {
    if (p.member == &Config::dram && config.own_dram) return config.own_dram->name;
    return p.names ? (*p.names)[std::size_t(config.*p.member)] : std::to_string(config.*p.member);
}

const std::vector<Parameter>& parameters() {
    static const std::vector<Parameter> all{
        {"coord_bits", &Config::coord_bits, 12, 20, false, "N: bits of a lattice coordinate"},
        {"dir_bits", &Config::dir_bits, 12, 24, false, "M: bits of a direction component"},
        {"t_frac_bits", &Config::t_frac_bits, 0, 8, false, "F: fraction bits of a distance"},
        {"recip_bits", &Config::recip_bits, 8, 24, false, "R: precision of a reciprocal direction"},
        {"box_bits", &Config::box_bits, 4, 8, false, "bits of a child box plane"},
        {"bary_bits", &Config::bary_bits, 4, 24, false, "fraction bits of u and v"},
        {"primitive_test", &Config::primitive_test, 0, int(primitive_test_names().size()) - 1, false,
         "ray-triangle test: exact, sheared; in software only: unit24, moller, woop, truncated",
         &primitive_test_names()},
        {"origin_bits", &Config::origin_bits, 2, 16, false, "B: fraction bits of a secondary ray's origin"},
        {"structure", &Config::structure, 0, int(structure_names().size()) - 1, false,
         "what holds the scene: bvh, spheres, kd, octree, bsp, or none (a list of all primitives)",
         &structure_names()},
        {"straddlers", &Config::straddlers, 0, int(straddlers_names().size()) - 1, false,
         "what a plane cuts is in both leaves, of an octree in the inner node (inner), or of bsp not cut "
         "(stop)",
         &straddlers_names()},
        {"splits", &Config::splits, 0, int(splits_names().size()) - 1, false,
         "on: boxes of bvh that would overlap may be cut, and a primitive be in several leaves",
         &splits_names()},
        {"references", &Config::references, 1, 64, false,
         "most references a primitive, in the mean, of kd, octree and bsp; fewer make a smaller image"},
        {"levels", &Config::levels, 1, 2, false,
         "2: instances are walked as such, by a tree over them and one for each mesh; 1: written out"},
        {"mesh_structure", &Config::mesh_structure, 0, int(mesh_structure_names().size()) - 1, false,
         "what holds each mesh, with levels=2: same (as structure), bvh, kd, octree, spheres, bsp",
         &mesh_structure_names()},
        {"node_width", &Config::node_width, 2, 8, true, "W: children of a node"},
        {"leaf_size", &Config::leaf_size, 1, 6, false, "most primitives in a leaf"},
        {"contexts", &Config::contexts, 1, 1024, true, "T: rays in flight"},
        {"stack_depth", &Config::stack_depth, 1, 64, true, "sibling groups on a ray's stack"},
        {"raygen_queue", &Config::raygen_queue, 2, 256, true, "answers raygen may hold"},
        {"box_queue", &Config::box_queue, 2, 256, true, "answers box may hold"},
        {"tri_queue", &Config::tri_queue, 2, 256, true, "answers tri may hold"},
        {"box_lanes", &Config::box_lanes, 1, 8, true,
         "children of a node that box tests at once; a node with more takes several cycles"},
        {"tri_interval", &Config::tri_interval, 1, 4, true,
         "cycles from a primitive that tri takes to the next; more share multipliers"},
        {"raygen_interval", &Config::raygen_interval, 1, 8, true,
         "cycles from a ray that raygen begins to the next; more share dividers"},
        {"xform_interval", &Config::xform_interval, 1, 4, true,
         "cycles from a ray that xform takes to the next, with levels=2; more share multipliers"},
        {"shade_interval", &Config::shade_interval, 1, 8, true,
         "cycles from a pass that shade takes to the next, with shading; more share multipliers"},
        {"pipelines", &Config::pipelines, 1, 16, true, "P: pipelines"},
        {"tile_bits", &Config::tile_bits, 0, 6, false, "pixels go out in squares of 2^k; 0: row by row"},
        {"node_sets", &Config::node_sets, 1, 4096, true, "node cache of a pipeline: sets"},
        {"node_ways", &Config::node_ways, 1, 8, true, "ways"},
        {"node_line", &Config::node_line, 64, 256, true, "bytes a line, at least one node"},
        {"node_mshrs", &Config::node_mshrs, 1, 64, true, "lines on their way"},
        {"prim_sets", &Config::prim_sets, 1, 4096, true, "primitive cache of a pipeline: sets"},
        {"prim_ways", &Config::prim_ways, 1, 8, true, "ways"},
        {"prim_line", &Config::prim_line, 64, 256, true, "bytes a line"},
        {"prim_mshrs", &Config::prim_mshrs, 1, 64, true, "lines on their way"},
        {"l2_sets", &Config::l2_sets, 0, 16384, true, "shared cache: sets, 0 for none"},
        {"l2_ways", &Config::l2_ways, 1, 8, true, "ways"},
        {"l2_line", &Config::l2_line, 64, 256, true, "bytes a line"},
        {"l2_mshrs", &Config::l2_mshrs, 1, 64, true, "lines on their way"},
        {"cache_queue", &Config::cache_queue, 2, 256, true, "answers a cache may hold"},
        {"timing", &Config::timing, 0, int(timing_names().size()) - 1, false,
         "how short paths are cut: relaxed (few stages) or fast (many)", &timing_names()},
        {"shading", &Config::shading, 0, 1, false,
         "1: the chip makes finished colours, with shadow rays and bounces"},
        {"spheres", &Config::spheres, 0, 1, false, "1: tri can test spheres"},
        {"planes", &Config::planes, 0, 1, false, "1: tri can test infinite planes, and shade knows checkers"},
        {"smooth", &Config::smooth, 0, 1, false, "1: normals between those of a triangle's corners"},
        {"refraction", &Config::refraction, 0, 1, false, "1: refracted rays"},
        {"panes", &Config::panes, 0, max_panes, false,
         "number of transmitting planes for which a path records its side, for lights beyond the lattice"},
        {"horizon", &Config::horizon, 0, 1, false,
         "1: bounces that pass by the lattice meet planes beyond it"},
        {"supersampling", &Config::supersampling, 0, 1, false, "1: several samples in a pixel"},
        {"lights", &Config::lights, 1, max_lights, false, "most point lights"},
        {"bounces", &Config::bounces, 1, 15, false, "most rays of a pixel that wait: the largest depth"},
        {"shade_queue", &Config::shade_queue, 2, 256, true, "answers shade may hold"},
        {"surf_sets", &Config::surf_sets, 1, 4096, true, "surface cache of a pipeline: sets"},
        {"surf_ways", &Config::surf_ways, 1, 8, true, "ways"},
        {"surf_line", &Config::surf_line, 64, 256, true, "bytes a line"},
        {"surf_mshrs", &Config::surf_mshrs, 1, 64, true, "lines on their way"},
        {"dram", &Config::dram, 0, int(dram_names().size()) - 1, false,
         "memory: ideal, sdr, ddr3, rpu, sdr_half, ddr4, lpddr4, hbm2, or a JSON file that describes one",
         &dram_names()},
        {"dram_channels", &Config::dram_channels, 1, most_dram_channels, false,
         "such memories side by side, which take neighbouring addresses in turn"},
        {"mem_latency", &Config::mem_latency, 1, 10000, false, "ideal memory: cycles from request to answer"},
        {"mem_interval", &Config::mem_interval, 1, 1000, false, "ideal memory: cycles between requests"},
        {"scan_out", &Config::scan_out, 0, 1, false,
         "1: a screen of 640x480 pixels is read 60 times a second"},
        {"pixel_writes", &Config::pixel_writes, 0, 1, false, "1: finished pixels are written to the memory"},
        {"addr_bits", &Config::addr_bits, 8, max_addr_bits, false,
         "bits of a memory address, in lines of 64 bytes"},
        {"prim_bits", &Config::prim_bits, 1, max_prim_bits, false, "bits of a primitive number"},
        {"pixel_bits", &Config::pixel_bits, 7, max_pixel_bits, false, "bits of a pixel coordinate"},
    };
    return all;
}

namespace {

enum Memory { ideal, sdr, ddr3, rpu, sdr_half };   // order of dram_names()

void set_cache(int& sets, int& ways, int& mshrs, int new_sets, int new_ways, int new_mshrs) {
    sets = new_sets;
    ways = new_ways;
    mshrs = new_mshrs;
}

/// Sets narrow formats and nodes of four children.
void make_small(Config& c) {
    c.coord_bits = 16;
    c.dir_bits = 18;
    c.recip_bits = 14;
    c.node_width = 4;
    c.stack_depth = 32;
}

/// Sets up finished pictures with planes, spheres and refraction. The chip is full, so no unit is wider than
/// the number of passes requires.
void make_shaded(Config& c) {
    c.shading = c.planes = c.spheres = c.refraction = 1;
    c.shade_interval = c.raygen_interval = 8;
    c.tri_interval = 4;
    c.box_lanes = 2;
    c.raygen_queue = 8;
    c.box_queue = 16;
    set_cache(c.surf_sets, c.surf_ways, c.surf_mshrs, 128, 1, 4);
    set_cache(c.node_sets, c.node_ways, c.node_mshrs, 512, 1, 4);
    set_cache(c.prim_sets, c.prim_ways, c.prim_mshrs, 512, 1, 4);
    c.t_frac_bits = 1;
    c.recip_bits = 12;
    c.origin_bits = 10;
    c.addr_bits = 19;   // the board has 32 MB
    c.prim_bits = 20;
    c.pixel_bits = 10;
}

/// Sets a binary tree, as the kd-trees of both chips: one split per step. Their 24-bit floats have no
/// counterpart here, so the 18 bits of lattice stay.
void make_binary(Config& c) {
    c.node_width = 2;
    c.stack_depth = 64;
}

}   // namespace

const std::vector<std::string>& config_names() {
    static const std::vector<std::string> names{"default", "small", "wide",        "saarcor",
                                                "rpu",     "ulx3s", "ulx3s-shaded"};
    return names;
}

// docs/configurations.md gives the sources of the figures.
Config named_config(const std::string& name) {
    Config c;
    c.name = name;
    if (name == "default") return c;
    if (name == "small") {
        make_small(c);
        c.contexts = 16;
        set_cache(c.node_sets, c.node_ways, c.node_mshrs, 32, 2, 4);
        set_cache(c.prim_sets, c.prim_ways, c.prim_mshrs, 32, 2, 4);
        c.dram = sdr;
        return c;
    }
    if (name == "ulx3s" || name == "ulx3s-shaded") {
        make_small(c);
        c.timing = int(Timing::fast);
        c.tri_interval = 2;
        c.raygen_queue = c.box_queue = 32;
        c.tri_queue = 64;
        set_cache(c.node_sets, c.node_ways, c.node_mshrs, 256, 2, 8);
        set_cache(c.prim_sets, c.prim_ways, c.prim_mshrs, 256, 2, 8);
        if (name == "ulx3s-shaded") make_shaded(c);
        c.dram = sdr_half;
        return c;
    }
    if (name == "wide") {
        c.pipelines = 4;
        c.l2_sets = 512;
        return c;
    }
    if (name == "saarcor") {
        make_binary(c);
        c.dram = rpu;
        return c;
    }
    if (name == "rpu") {
        make_binary(c);
        c.contexts = 128;
        set_cache(c.node_sets, c.node_ways, c.node_mshrs, 128, 1, 8);
        set_cache(c.prim_sets, c.prim_ways, c.prim_mshrs, 128, 1, 8);
        c.dram = rpu;
        return c;
    }
    throw UserError("no configuration is called " + shown(name) + did_you_mean(name, config_names()));
}

void set_parameter(Config& config, const std::string& key, const std::string& value,
                   const std::string& where) {
    for (const Parameter& p : parameters()) {
        if (key != p.key) continue;
        if (p.names) {
            const auto at = std::find(p.names->begin(), p.names->end(), value);
            if (at == p.names->end())
                throw UserError(where + ": no " + key + " is called " + shown(value) +
                                did_you_mean(value, *p.names));
            config.*p.member = int(at - p.names->begin());
            if (p.member == &Config::dram) config.own_dram = nullptr;
            return;
        }
        int number = 0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
        if (error != std::errc{} || end != value.data() + value.size())
            throw UserError(where + ": " + key + " must be a whole number, not " + shown(value));
        config.*p.member = number;
        return;
    }
    std::vector<std::string> keys;
    for (const Parameter& p : parameters()) keys.push_back(p.key);
    throw UserError(where + ": no parameter is called " + shown(key) + did_you_mean(key, keys));
}

}   // namespace rayclock
