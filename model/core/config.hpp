#pragma once
// Format and shape of a machine, with the limits that all machines share. Every width of the model and the
// RTL derives from it.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "model/core/choices.hpp"

namespace rayclock {

struct DramPart;

constexpr int guard_bits = 14;        ///< fraction bits of the camera's pixel steps; one rounding drops them
constexpr int max_shift = 15;         ///< most bits by which a short camera direction is shifted up
constexpr int max_addr_bits = 24;     ///< maximum of Config::addr_bits
constexpr int max_pixel_bits = 14;    ///< maximum of Config::pixel_bits
constexpr int exp_bits = 5;           ///< box exponent, and bit length of a direction component
constexpr int max_prim_bits = 32;     ///< maximum of Config::prim_bits
constexpr int globe_bits = 12;        ///< each coordinate of a globe's centre, and its radius
constexpr int toward_bits = 18;       ///< each direction component in the test of globes
constexpr int normal_step_bits = 7;   ///< component of a slant plane's normal, signed
/// Bits of the quotient that gives the time when a ray crosses such a plane, and of its operands.
constexpr int crossing_bits = 18;
constexpr int offset_bits = 6;        ///< child within its block, in steps of 32 bytes
constexpr int count_bits = 3;         ///< triangles of a leaf, 1..6; 0 for an inner node
constexpr int line_bits = 512;        ///< a memory line, one node
constexpr int half_line_bits = 256;   ///< one triangle
constexpr int line_bytes = 64;        ///< one answer of the memory
constexpr int unit_bits = 16;         ///< fraction bits of colours, weights and components of unit vectors
/// Fraction bits of a material's colours and of the weights of its local light.
constexpr int share_bits = 12;
constexpr int corner_bits = 11;   ///< component of a corner's normal, signed
constexpr int shine_frac = 4;     ///< fraction bits of Phong's exponent, out of shine_bits
constexpr int shine_bits = 14;
constexpr int index_frac = 12;   ///< fraction bits of a ratio of refractive indices, out of ratio_bits
constexpr int ratio_bits = 16;
constexpr int root_bits = 28;       ///< a square root in the sphere test
constexpr int strength_bits = 17;   ///< a light's colour, share_bits of them fraction
/// A light, or a point of a plane, may lie 2^8 times as far away as the lattice reaches.
constexpr int light_reach = 8;
constexpr int plane_bits = 12;   ///< whole bits of a plane's u and v
/// Additional bits of a path's length in a chip with planes (rtl/unit/shade/surface/rc_far_path.sv). A point
/// lies at most 2^(N-1+light_reach) steps away on each axis, so its distance is below 2^(N+8). t only reaches
/// 2^(N+2).
constexpr int far_path_bits = light_reach - 2;
/// Steps in which a distant ray finds the lattice: model/unit/shade/light/approach.hpp.
constexpr int approach_steps = 12;
constexpr int max_lights = 64;         ///< maximum of Config::lights, and of a scene's lights
constexpr int light_number_bits = 7;   ///< of 0 ... max_lights
constexpr int max_fine = 4;            ///< maximum of Surface::fine
constexpr int sample_bits = 6;         ///< a pixel's sample, 0..63
constexpr int sub_pixel_bits = 8;      ///< fraction bits of a sample's place
constexpr int depth_bits = 4;          ///< bounces of a camera ray, 0..15
constexpr int coordinate_frac = 20;    ///< fraction bits of a texture coordinate, out of coordinate_bits
constexpr int coordinate_bits = 28;
constexpr int texel_frac = 8;   ///< fraction bits of a texture coordinate in texels
constexpr int side_bits = 4;    ///< logarithm of a texture's side, 0..12
constexpr int max_side_log = 12;
constexpr int level_frac = 6;     ///< fraction bits of a texture's level and of logarithms of lengths
constexpr int level_bits = 14;    ///< such a logarithm, signed
constexpr int hole_bits = 6;      ///< counter of the holes that a ray has passed since its last bounce
constexpr int length_bits = 7;    ///< fraction bits of a direction's length in a path's length
constexpr int unit_stages = 8;    ///< latency of rtl/fixed/rc_unit_vector.sv
constexpr int power_stages = 7;   ///< latency of rc_power.sv

/// Bits that a point of a plane beyond the lattice loses as a ray's origin: O' in docs/proofs/origins.md.
constexpr int far_drop = light_reach + 1;
constexpr int max_dram_channels = 4;   ///< maximum of Config::dram_channels
constexpr int max_panes = 4;           ///< maximum of Config::panes

/// Format and shape of one machine: everything that synthesis fixes. One C++ binary serves all machines; the
/// RTL gets the same values as constants of rc_pkg.sv.
struct Config {
    std::string name = "default";

    std::shared_ptr<const DramPart> own_dram;   ///< a memory from a file; `dram` is ignored then
    std::string board_sdram = "as4c32m16sb";    ///< chip of dram=board: model/board/sdram_parts.hpp

    // The parameters, with their defaults.
#define GROUP(name, text)
#define NUMBER(key, user, usual, least, most, unit, effect, text) int key = usual;
#define POWER(key, user, usual, least, most, unit, effect, text) int key = usual;
#define FLAG(key, user, effect, text) bool key = false;
#define CHOICE(key, user, Type, usual, effect, text) Type key = Type::usual;
#include "model/core/parameters.inl"
#undef GROUP
#undef NUMBER
#undef POWER
#undef FLAG
#undef CHOICE

    // Derived.
    /// Bits of a distance. A distance saturates; all ones means beyond.
    int t_bits() const { return coord_bits + 2 + t_frac_bits; }
    /// With textures: bits of the length of a path. The length saturates. Points on planes can be
    /// 2^far_path_bits times as far away as the largest t.
    int path_bits() const { return planes ? std::min(t_bits() + far_path_bits, 32) : t_bits(); }
    PrimitiveTest test() const { return primitive_test; }
    bool has_splits() const { return is_bvh() && splits == Splits::on; }
    bool is_bvh() const { return structure == Structure::bvh; }
    bool is_list() const { return structure == Structure::none; }
    bool is_octree() const { return structure == Structure::octree; }
    /// True if any level is an octree.
    bool has_octree() const {
        return structure == Structure::octree || lower_structure() == Structure::octree;
    }
    bool has_instances() const { return levels == 2; }
    /// True if rays come from records in memory. They may begin anywhere, so shading is set as well.
    bool is_stream() const { return shading && source == RaySource::stream; }
    bool has_shade() const { return shading && !is_stream(); }
    /// True if the chip writes the answers to its rays into memory, as records (HitRecord).
    bool writes_hits() const { return is_stream() && pixel_writes; }
    bool has_textures() const { return has_shade() && textures; }
    bool has_homes() const { return has_instances() && shading; }   ///< rays start from instances
    /// Secondary rays name the sphere that they leave, or at which a shadow ray ends. Rays of a stream do
    /// not.
    bool has_self() const { return spheres && has_shade(); }
    /// Rays that meet only some primitives exist. A ray of a stream meets all.
    bool has_partial() const { return planes && has_shade(); }
    /// Returns the structure of meshes; with one level, that of the scene.
    Structure lower_structure() const;
    /// Returns the structure for which the RTL is built. An octree has the nodes of a kd-tree.
    static Structure engine_of(Structure s) { return s == Structure::octree ? Structure::kd : s; }
    Structure engine() const { return engine_of(structure); }
    Structure lower_engine() const { return engine_of(lower_structure()); }
    /// True if the scene's tree and the meshes have different node units.
    bool has_two_engines() const { return engine() != lower_engine(); }
    /// Returns a configuration with only one level's structure. Functions such as has_boxes(), which are true
    /// if any level has such nodes, then describe this level alone.
    Config upper() const;
    Config lower() const;
    bool has_boxes() const { return is_walked(Structure::bvh); }
    /// True if a level is a kd-tree, octree or bsp. Its planes may put a primitive on both sides.
    bool cuts_space() const { return is_walked(Structure::kd) || is_walked(Structure::bsp); }
    bool is_walked(Structure by) const { return engine() == by || lower_engine() == by; }
    /// Returns the memory outside the chip, or null if it is the ideal memory.
    const DramPart* dram_part() const;
    /// True if the memory is the board's (rtl/board): its controller, screen and pixels in the RTL's cycles.
    bool is_board() const { return dram == DramName::board && !own_dram; }
    bool is_sheared() const { return test() == PrimitiveTest::sheared; }
    int edge_bits() const;   ///< signed edge function, and determinant of a hit
    /// Bits of the numerator of t, signed.
    int num_bits() const { return 3 * coord_bits + 2 + is_sheared() + origin_frac(); }
    int origin_frac() const { return shading ? origin_bits : 0; }     ///< fraction bits of a ray's origin
    int origin_width() const { return coord_bits + origin_frac(); }   ///< bits of a ray's origin, signed
    /// Bits of a point in shade, signed.
    int point_width() const { return origin_width() + (planes ? light_reach : 0); }
    int approach_shift() const;   ///< the last step of an approach is 2^this directions long
    /// Bits of a direction component: M, or the bits that a shadow ray needs.
    int ray_dir_bits() const { return shading ? coord_bits + origin_bits + 1 : dir_bits; }
    /// The chip has several kinds of primitives.
    bool has_kinds() const { return spheres || planes || has_textures(); }
    /// Bits of a light's coordinate, signed, in lattice steps.
    int light_bits() const { return coord_bits + light_reach; }
    /// Bits of the normal of a triangle or sphere, not of unit length.
    int normal_bits() const {
        return 2 * coord_bits + 3 > ray_dir_bits() || !shading ? 2 * coord_bits + 3 : ray_dir_bits();
    }
    /// Bits of u and v of a hit; signed if there are planes.
    int uv_bits() const { return bary_bits + 1 + (planes ? plane_bits : 0); }
    /// S: fraction bits of a sheared ray's slopes, which have dir_bits bits.
    int slope_frac_bits() const { return dir_bits - 2; }
    int guard_dir_bits() const;   ///< camera vectors: direction and guard bits
    int ray_bits() const;         ///< index of a context
    int group_bits() const;       ///< count 0..W
    int slot_bits() const;        ///< index 0..W-1
    int stack_bits() const;       ///< count 0..stack_depth
    int raygen_latency() const;
    /// Cycles between nodes that box accepts.
    int box_interval() const { return has_boxes() ? std::max(1, node_width / box_lanes) : 1; }
    int map_frac() const { return coord_bits + 3; }   ///< K: fraction bits of an instance's map
    int map_bits() const { return map_frac() + 2; }   ///< entry of that map, signed; 1 is possible
    int xform_latency() const;
    int planes_of_node() const { return node_width - 1; }   ///< planes, or pairs of planes, in a node
    /// Bits of n . x of a slant's plane, signed. The normal has three components of at most 2^6 - 1.
    int offset_of_plane_bits() const { return coord_bits + normal_step_bits + 1; }
    int tri_latency() const;
    int pass_latency() const;     ///< of a pass alone, rtl/unit/shade/pass/rc_pass.sv
    int shade_latency() const;    ///< of a pass, and of reading its context's state
    int clear_cycles() const;     ///< of a reset, which empties all caches: docs/machine/chip.md
    int node_miss_bits() const;   ///< id of the node cache's request to memory: MSHR, and word of the line
    int prim_miss_bits() const;
    int surf_miss_bits() const;
    int stream_miss_bits() const;
    int tex_miss_bits() const;
    int tex_address_latency() const;   ///< of unit tex, from a texture record to the address of texels
    int tex_filter_latency() const;    ///< of unit tex, from texels to a colour
    int l2_miss_bits() const;
    int longest_line() const;      ///< bytes of the longest line of the chip's caches
    int least_addr_bits() const;   ///< fewest address bits that leave a tag of one bit in every cache
    /// Memory clients of a pipeline: nodes, primitives, and in a chip with shading=1 surfaces or ray records,
    /// and textures. A chip without textures leaves the number of its fourth client unused.
    int clients() const { return shading ? 4 : 2; }
    /// Bits of a cache's number among the caches of all pipelines: clients() * pipeline + 0..3.
    int client_bits() const;
    int client_id_bits() const;    ///< id of a cache's request, unique in the machine
    int tile_coord_bits() const;   ///< coordinate of a tile, in tiles
    int mem_id_bits() const;       ///< id of a request at the memory port
};

/// Throws UserError if the configuration needs something that the RTL does not have: a primitive test in
/// software only, or too many pipelines.
void check_rtl(const Config& config);

/// Returns the names of the configurations that ship with the program.
const std::vector<std::string>& config_names();
/// Returns the configuration with this name. Throws UserError if there is none.
Config named_config(const std::string& name);

/// Applies one `key=value`. Throws UserError that names an unknown key (with the nearest one) or a bad value.
void set_parameter(Config& config, const std::string& key, const std::string& value,
                   const std::string& where);

/// Throws UserError unless every parameter and every combination is legal. check_config()
/// (model/engine/check.hpp) also checks what depends on nodes.
void check_parameters(const Config& config, const std::string& where);

/// Returns the smallest number of bits, at least 1, that hold the values 0..n-1.
constexpr int index_bits(int n) {
    int bits = 0;
    while ((1 << bits) < n) ++bits;
    return bits > 0 ? bits : 1;
}

}   // namespace rayclock
