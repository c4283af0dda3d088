// The named configurations, the setting of a parameter, and derived widths.
#include "model/core/config.hpp"

#include <algorithm>
#include <bit>
#include <charconv>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/core/dram_parts.hpp"
#include "model/core/parameters.hpp"

namespace rayclock {

Structure Config::lower_structure() const {
    if (!has_instances() || mesh_structure == MeshStructure::same) return structure;
    static_assert(int(MeshStructure::bvh) == int(Structure::bvh) + 1);   // both follow RAYCLOCK_TREES
    return Structure(int(mesh_structure) - 1);
}
Config Config::upper() const {
    Config level = *this;
    level.mesh_structure = MeshStructure::same;
    return level;
}
Config Config::lower() const {
    Config level = upper();
    level.structure = lower_structure();
    return level;
}

int Config::guard_dir_bits() const { return dir_bits + guard_bits; }
int Config::edge_bits() const {
    if (is_sheared()) return 2 * coord_bits + 3;
    const int plain = 2 * coord_bits + dir_bits + 2;
    // A bounce is the first of these, a shadow ray the second: docs/proofs/origins.md.
    return shading ? std::max(plain + origin_bits, 3 * coord_bits + origin_bits + 3) : plain;
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
int Config::surf_miss_bits() const { return has_shade() ? miss_bits(surf_mshrs, surf_line) : 1; }
int Config::stream_miss_bits() const { return is_stream() ? miss_bits(stream_mshrs, stream_line) : 1; }
int Config::tex_miss_bits() const { return has_textures() ? miss_bits(tex_mshrs, tex_line) : 1; }
int Config::l2_miss_bits() const { return miss_bits(l2_mshrs, l2_line); }
int Config::longest_line() const {
    return std::max({node_line, prim_line, has_shade() ? surf_line : 0, is_stream() ? stream_line : 0,
                     has_textures() ? tex_line : 0, l2_sets > 0 ? l2_line : 0});
}
int Config::least_addr_bits() const {
    const auto untagged_bits = [](int sets, int line) {
        return int(std::bit_width(unsigned(sets)) + std::bit_width(unsigned(line / line_bytes))) - 2;
    };
    const int own = std::max({untagged_bits(node_sets, node_line), untagged_bits(prim_sets, prim_line),
                              has_shade() ? untagged_bits(surf_sets, surf_line) : 0,
                              is_stream() ? untagged_bits(stream_sets, stream_line) : 0,
                              has_textures() ? untagged_bits(tex_sets, tex_line) : 0});
    return 1 + (l2_sets > 0 ? std::max(own, untagged_bits(l2_sets, l2_line)) : own);
}
int Config::clear_cycles() const {
    return 4 + std::max({node_sets, prim_sets, has_shade() ? surf_sets : 0, is_stream() ? stream_sets : 0,
                         has_textures() ? tex_sets : 0, l2_sets});
}
int Config::client_bits() const { return index_bits(clients() * pipelines); }
int Config::client_id_bits() const {
    return client_bits() + std::max({node_miss_bits(), prim_miss_bits(), surf_miss_bits(), stream_miss_bits(),
                                     tex_miss_bits()});
}
int Config::tile_coord_bits() const { return pixel_bits - tile_bits; }
int Config::mem_id_bits() const { return l2_sets > 0 ? l2_miss_bits() : client_id_bits(); }

const DramPart* Config::dram_part() const {
    if (own_dram) return own_dram.get();
    return dram == DramName::ideal ? nullptr : &rayclock::dram_part(name_of(dram));
}

namespace {

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
    c.shading = c.planes = c.spheres = c.refraction = true;
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
    static const std::vector<std::string> names{"default", "small", "wide",         "saarcor",
                                                "rpu",     "ulx3s", "ulx3s-shaded", "ulx3s-board"};
    return names;
}

// docs/guide/configurations.md gives the sources of the figures.
Config named_config(const std::string& name) {
    Config c;
    c.name = name;
    if (name == "default") return c;
    if (name == "small") {
        make_small(c);
        c.contexts = 16;
        set_cache(c.node_sets, c.node_ways, c.node_mshrs, 32, 2, 4);
        set_cache(c.prim_sets, c.prim_ways, c.prim_mshrs, 32, 2, 4);
        c.dram = DramName::sdr;
        return c;
    }
    if (name == "ulx3s" || name == "ulx3s-shaded" || name == "ulx3s-board") {
        make_small(c);
        c.timing = Timing::fast;
        c.tri_interval = 2;
        c.raygen_queue = c.box_queue = 32;
        c.tri_queue = 64;
        set_cache(c.node_sets, c.node_ways, c.node_mshrs, 256, 2, 8);
        set_cache(c.prim_sets, c.prim_ways, c.prim_mshrs, 256, 2, 8);
        if (name != "ulx3s") make_shaded(c);
        c.dram = DramName::sdr_half;
        if (name == "ulx3s-board") {
            c.dram = DramName::board;
            c.scan_out = c.pixel_writes = true;
        }
        return c;
    }
    if (name == "wide") {
        c.pipelines = 4;
        c.l2_sets = 512;
        return c;
    }
    if (name == "saarcor") {
        make_binary(c);
        c.dram = DramName::rpu;
        return c;
    }
    if (name == "rpu") {
        make_binary(c);
        c.contexts = 128;
        set_cache(c.node_sets, c.node_ways, c.node_mshrs, 128, 1, 8);
        set_cache(c.prim_sets, c.prim_ways, c.prim_mshrs, 128, 1, 8);
        c.dram = DramName::rpu;
        return c;
    }
    throw UserError("no configuration is called " + shown(name) + did_you_mean(name, config_names()));
}

void set_parameter(Config& config, const std::string& key, const std::string& value,
                   const std::string& where) {
    const auto p = std::find_if(parameters().begin(), parameters().end(),
                                [&](const Parameter& row) { return row.is(key); });
    if (p == parameters().end()) {
        std::vector<std::string> keys;
        for (const Parameter& row : parameters()) keys.push_back(row.key);
        throw UserError(where + ": no parameter is called " + shown(key) + did_you_mean(key, keys));
    }
    if (p->names) {
        const auto at = std::find(p->names->begin(), p->names->end(), value);
        if (at == p->names->end())
            throw UserError(where + ": no " + key + " is called " + shown(value) +
                            did_you_mean(value, *p->names));
        p->set(config, int(at - p->names->begin()));
        if (p->is("dram")) config.own_dram = nullptr;
        return;
    }
    int number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc{} || end != value.data() + value.size())
        throw UserError(where + ": " + key + " must be a whole number, not " + shown(value));
    if (p->type == Parameter::Type::flag) check_range(*p, number, where);   // a bool holds no other value
    p->set(config, number);
}

}   // namespace rayclock
