#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "model/core/choices.hpp"

namespace rayclock {

struct DramPart;

constexpr int guard_bits = 14;        ///< fraction bits of the camera's pixel steps, dropped by one rounding
constexpr int most_shift = 15;        ///< bits by which a short camera direction is moved up at most
constexpr int max_addr_bits = 24;     ///< of Config::addr_bits
constexpr int max_pixel_bits = 14;    ///< of Config::pixel_bits
constexpr int exp_bits = 5;           ///< box exponent, and bit length of a direction component
constexpr int max_prim_bits = 32;     ///< of Config::prim_bits
constexpr int globe_bits = 12;        ///< of a globe's centre on each axis, and of its radius
constexpr int toward_bits = 18;       ///< of a component of a ray's direction, as globes are tested with it
constexpr int normal_step_bits = 7;   ///< of a component of the normal of a plane in any direction, signed
constexpr int crossing_bits = 18;     ///< of the quotient that says when a ray crosses such a plane, and of
                                      ///< what is divided
constexpr int offset_bits = 6;        ///< child within its block, in steps of 32 bytes
constexpr int count_bits = 3;         ///< triangles of a leaf, 1..6; 0 for an inner node
constexpr int line_bits = 512;        ///< a memory line, one node
constexpr int half_line_bits = 256;   ///< one triangle
constexpr int line_bytes = 64;        ///< what memory gives in one answer
constexpr int unit_bits = 16;     ///< fraction bits of colours, of weights and of unit vectors' components
constexpr int share_bits = 12;    ///< fraction bits of a material's colours and of the weights of its local
                                  ///< light
constexpr int corner_bits = 11;   ///< signed components of a corner's normal
constexpr int shine_frac = 4;     ///< fraction bits of Phong's exponent, which has shine_bits
constexpr int shine_bits = 14;
constexpr int index_frac = 12;   ///< fraction bits of a ratio of refractive indices, which has ratio_bits
constexpr int ratio_bits = 16;
constexpr int root_bits = 28;        ///< of a square root in the sphere test
constexpr int strength_bits = 17;    ///< a light's colour, share_bits of them fraction
constexpr int light_reach = 8;       ///< a light, or a point of a plane, may lie 2^8 times as far away as the
                                     ///< lattice reaches
constexpr int plane_bits = 12;       ///< whole bits of a plane's u and v
constexpr int approach_steps = 12;   ///< in which a ray from far away finds the lattice:
                                     ///< model/unit/shade/approach.hpp
constexpr int max_lights = 64;       ///< of Config::lights
constexpr int most_fine = 4;         ///< of Surface::fine
constexpr int sample_bits = 6;       ///< a pixel's sample, 0..63
constexpr int depth_bits = 4;        ///< bounces of a camera ray, 0..15
constexpr int unit_stages = 8;       ///< latency of rtl/fixed/rc_unit.sv,
constexpr int power_stages = 7;      ///< and of rc_power.sv

/// Bits that a point of a plane beyond the lattice loses as a ray's origin: O' of docs/origins.md.
constexpr int far_drop = light_reach + 1;
constexpr int most_dram_channels = 4;   ///< of Config::dram_channels
constexpr int max_panes = 4;            ///< of Config::panes

/// Format and shape of one machine: everything that the hardware fixes when it is synthesised.
/// One C++ binary serves all of them; for the RTL they become the constants of rc_pkg.sv.
struct Config {
    std::string name = "default";

    std::shared_ptr<const DramPart> own_dram;   ///< a memory from a file; `dram` is ignored then

    // The parameters, with their defaults.
#define GROUP(name, text)
#define NUMBER(key, place, usual, least, most, unit, effect, text) int key = usual;
#define POWER(key, place, usual, least, most, unit, effect, text) int key = usual;
#define FLAG(key, place, effect, text) bool key = false;
#define CHOICE(key, place, Type, usual, effect, text) Type key = Type::usual;
#include "model/core/parameters.inl"
#undef GROUP
#undef NUMBER
#undef POWER
#undef FLAG
#undef CHOICE

    // Derived.
    int t_bits() const { return coord_bits + 2 + t_frac_bits; }   ///< distance, saturating, all ones: beyond
    PrimitiveTest test() const { return primitive_test; }
    bool has_splits() const { return is_bvh() && splits == Splits::on; }
    bool is_bvh() const { return structure == Structure::bvh; }
    bool is_list() const { return structure == Structure::none; }
    bool is_octree() const { return structure == Structure::octree; }
    bool has_instances() const { return levels == 2; }
    bool has_homes() const { return has_instances() && shading; }   ///< rays start from instances
    /// Of meshes; that of the scene if there is one level.
    Structure lower_structure() const;
    /// The structure for which the RTL is built: an octree's nodes are those of a kd-tree.
    static Structure engine_of(Structure s) { return s == Structure::octree ? Structure::kd : s; }
    Structure engine() const { return engine_of(structure); }
    Structure lower_engine() const { return engine_of(lower_structure()); }
    /// Nodes of the scene's tree are decided by one unit, those of meshes by another.
    bool has_two_engines() const { return engine() != lower_engine(); }
    /// What one level is: a configuration with its structure alone. Its has_boxes() and so on, which tell
    /// whether any level has them, tell of that one.
    Config upper() const;
    Config lower() const;
    bool has_boxes() const { return is_walked(Structure::bvh); }
    bool has_treelets() const { return is_walked(Structure::kd); }
    bool has_globes() const { return is_walked(Structure::spheres); }
    bool has_slants() const { return is_walked(Structure::bsp); }
    bool has_planes() const { return has_treelets() || has_slants(); }
    bool is_walked(Structure by) const { return engine() == by || lower_engine() == by; }
    /// What lies beside the chip; null if it is the ideal memory.
    const DramPart* dram_part() const;
    bool is_sheared() const { return test() == PrimitiveTest::sheared; }
    int edge_bits() const;   ///< signed edge function and determinant of a hit
    int num_bits() const {
        return 3 * coord_bits + 2 + is_sheared() + origin_frac();
    }                                                                 ///< signed numerator of t
    int tri_ray_bits() const;                                         ///< a ray in list, see TriReq
    int origin_frac() const { return shading ? origin_bits : 0; }     ///< fraction bits of a ray's origin
    int origin_width() const { return coord_bits + origin_frac(); }   ///< its bits, signed
    int point_width() const {
        return origin_width() + (planes ? light_reach : 0);
    }                             ///< of a point that shade knows
    int approach_shift() const;   ///< the last step is 2^this directions long
    int ray_dir_bits() const {
        return shading ? coord_bits + origin_bits + 1 : dir_bits;
    }                                                      ///< M, or what a shadow ray needs
    bool has_kinds() const { return spheres || planes; }   ///< of primitives
    int light_bits() const {
        return coord_bits + light_reach;
    }   ///< signed coordinate of a light, in lattice steps
    int normal_bits() const {
        return 2 * coord_bits + 3 > ray_dir_bits() || !shading ? 2 * coord_bits + 3 : ray_dir_bits();
    }   ///< of a surface's normal, not unit: a triangle's, a sphere's
    int uv_bits() const {
        return bary_bits + 1 + (planes ? plane_bits : 0);
    }   ///< u and v of a hit; signed if there are planes
    int slope_frac_bits() const {
        return dir_bits - 2;
    }                             ///< S: of a sheared ray's slopes, which have dir_bits bits
    int guard_dir_bits() const;   ///< camera vectors: direction and guard bits
    int ray_bits() const;         ///< index of a context
    int group_bits() const;       ///< count 0..W
    int slot_bits() const;        ///< index 0..W-1
    int stack_bits() const;       ///< count 0..stack_depth
    int raygen_latency() const;
    int box_latency() const;
    int box_interval() const {
        return has_boxes() ? std::max(1, node_width / box_lanes) : 1;
    }   ///< cycles from a node that box takes to the next
    int treelet_latency() const;
    int globe_latency() const;
    int slant_latency() const;
    int node_latency() const {
        return std::max(node_latency(engine()), node_latency(lower_engine()));
    }   ///< of the unit that decides a node; of two the slower one's, for which the other's answers wait
    int node_latency(Structure engine) const;
    int map_frac() const { return coord_bits + 3; }   ///< K: fraction bits of an instance's map
    int map_bits() const { return map_frac() + 2; }   ///< of an entry of it, signed; 1 is possible
    int xform_latency() const;
    int planes_of_node() const { return node_width - 1; }   ///< of a treelet or a slant
    int offset_of_plane_bits() const {
        return coord_bits + normal_step_bits + 1;
    }   ///< n . x of a slant's plane, signed: three components of at most 2^6 - 1
    int tri_latency() const;
    int pass_latency() const;     ///< of a pass alone, rtl/unit/shade/rc_pass.sv
    int shade_latency() const;    ///< and of reading what is kept of its context
    int clear_cycles() const;     ///< of a reset, in which all caches are emptied: docs/chip.md
    int node_miss_bits() const;   ///< what tells the node cache's requests to memory apart: line on its way,
                                  ///< word in it
    int prim_miss_bits() const;
    int surf_miss_bits() const;
    int l2_miss_bits() const;
    int least_addr_bits() const;   ///< a tag of one bit in every cache
    int clients() const {
        return shading ? 4 : 2;
    }   ///< of memory, in a pipeline: nodes, primitives, surfaces; the last is never there
    int client_bits() const;       ///< index of a cache among all of the pipelines', clients() p + 0, 1, 2
    int client_id_bits() const;    ///< a cache's request, told apart from all other caches'
    int tile_coord_bits() const;   ///< a tile's coordinate, in tiles
    int mem_id_bits() const;       ///< a request at the memory port
};

/// Throws UserError if the configuration asks for a test that is not built in RTL.
void check_rtl(const Config& config);

/// The named configurations that ship with the program.
const std::vector<std::string>& config_names();
Config named_config(const std::string& name);

/// Applies one `key=value`; throws UserError naming an unknown key (with the nearest) or a bad value.
void set_parameter(Config& config, const std::string& key, const std::string& value,
                   const std::string& where);

/// Throws UserError unless every parameter and every combination is legal.
void check_config(const Config& config, const std::string& where);

/// Smallest number of bits that hold the values 0..n-1.
constexpr int index_bits(int n) {
    int bits = 0;
    while ((1 << bits) < n) ++bits;
    return bits > 0 ? bits : 1;
}

}   // namespace rayclock
