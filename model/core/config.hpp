#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace rayclock {

struct DramPart;

/// How short the RTL's paths are cut, by the value of Config::timing; see model/core/stages.hpp.
enum class Timing { relaxed, fast };

/// What holds the scene in memory, by the value of Config::structure: boxes in boxes (model/engine/bvh),
/// space cut by planes (model/engine/kd), or nothing but a list of all primitives (model/engine/none). An
/// octree is cut by planes in the middle of its cells, and walked by the engine of kd. Planes of bsp lie in
/// any direction (model/engine/bsp).
enum class Structure { bvh, kd, none, octree, spheres, bsp };

/// What becomes of what lies on both sides of a cut, by the value of Config::straddlers, in an octree and
/// with planes in any direction: it is in every leaf that it reaches into, in the inner node (octree), or
/// there is no such cut (bsp).
enum class Straddlers { leaves, inner, stop };

/// Ray-triangle tests, by the value of Config::primitive_test; see model/unit/isect/primitive.hpp.
enum class PrimitiveTest { exact, sheared, unit24, moller, woop, truncated };

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
constexpr int max_panes = 4;   ///< of Config::panes

/// Format and shape of one machine: everything that the hardware fixes when it is synthesised.
/// One C++ binary serves all of them; for the RTL they become the constants of rc_pkg.sv.
struct Config {
    std::string name = "default";

    // Format: widths in bits.
    int coord_bits = 18;      ///< N: signed lattice coordinate
    int dir_bits = 20;        ///< M: signed direction component; 2N + M <= 62
    int t_frac_bits = 4;      ///< F: fraction bits of a distance t (see t_bits())
    int recip_bits = 16;      ///< R: precision of a reciprocal direction component
    int box_bits = 8;         ///< bits of a child box plane relative to its node
    int bary_bits = 16;       ///< fraction bits of the barycentric u and v of a hit
    int primitive_test = 0;   ///< how a ray meets a triangle, see primitive_test_names()
    int origin_bits = 12;     ///< B: fraction bits of a secondary ray's origin, see docs/origins.md; with
                              ///< `shading` only

    int structure = 0;        ///< what holds the scene in memory, see structure_names()
    int straddlers = 0;       ///< of an octree and of bsp, see straddlers_names()
    int splits = 0;           ///< of bvh, see splits_names()
    int references = 8;       ///< of kd, octree and bsp: the most that a primitive has in the mean, 1..64
    int levels = 1;           ///< 2: a tree over instances, and one below it for each mesh (docs/motion.md)
    int mesh_structure = 0;   ///< of these the lower ones, see mesh_structure_names(): as `structure` (same)

    // Shape: counts, depths, latencies.
    int node_width = 8;        ///< W: children of a node, 2, 4 or 8
    int leaf_size = 1;         ///< most primitives in a leaf, 1..6
    int contexts = 64;         ///< T: rays in flight
    int stack_depth = 16;      ///< groups of siblings a ray can leave for later
    int raygen_queue = 16;     ///< answers raygen may hold, a power of two
    int box_queue = 16;        ///< answers box may hold, a power of two
    int tri_queue = 32;        ///< answers tri may hold, a power of two
    int box_lanes = 8;         ///< children that box tests at once, 1, 2, 4 or 8; 8 is all of any node's
    int tri_interval = 1;      ///< cycles from a primitive that tri takes to the next, 1, 2 or 4
    int raygen_interval = 1;   ///< cycles from a ray that raygen begins to the next, 1, 2, 4 or 8
    int xform_interval = 2;    ///< cycles from a ray that xform takes to the next, 1, 2 or 4; with two levels
    int shade_interval = 1;   ///< cycles from a pass that shade takes to the next, 1, 2, 4 or 8; with shading
    int pipelines = 1;        ///< P: pipelines of one machine, 1 to 16
    int tile_bits = 4;    ///< pixels are given out in squares of 2^k x 2^k, in Morton order inside; 0: row by
                          ///< row
    int node_sets = 64;   ///< node cache of a pipeline: sets,
    int node_ways = 4;    ///< ways,
    int node_line = 64;   ///< bytes a line,
    int node_mshrs = 8;   ///< lines that may be on their way
    int prim_sets = 64;   ///< primitive cache of a pipeline, the same
    int prim_ways = 4;
    int prim_line = 64;
    int prim_mshrs = 8;
    int l2_sets = 0;   ///< cache that all pipelines share, the same; 0: there is none
    int l2_ways = 4;
    int l2_line = 64;
    int l2_mshrs = 16;
    int cache_queue = 4;   ///< answers a cache may hold, a power of two
    int timing = 0;        ///< how short its paths are cut, see timing_names()

    // Shape: units that are there only if a scene needs them; all but the first need `shading`.
    int shading = 0;         ///< 1: the chip makes finished colours, with shadow rays and bounces
    int spheres = 0;         ///< 1: tri can test spheres
    int planes = 0;          ///< 1: tri can test planes, and shade knows checkers
    int smooth = 0;          ///< 1: normals between those of a triangle's corners
    int refraction = 0;      ///< 1: refracted rays
    int panes = 0;           ///< planes that transmit of which a path knows its side
    int horizon = 0;         ///< 1: bounces that pass by the lattice meet planes beyond it
    int supersampling = 0;   ///< 1: several samples in a pixel
    int lights = 8;          ///< most point lights
    int bounces = 5;         ///< most rays of a pixel that wait for their turn: the largest depth
    int shade_queue = 64;    ///< answers shade may hold, a power of two
    int surf_sets = 64;      ///< surface cache of a pipeline, as the others
    int surf_ways = 4;
    int surf_line = 64;
    int surf_mshrs = 8;

    // Beside the chip.
    int dram = 2;                               ///< memory, see dram_names()
    std::shared_ptr<const DramPart> own_dram;   ///< a memory that somebody described; if it is there, `dram`
                                                ///< says nothing
    int dram_channels = 1;                      ///< such memories side by side; the ideal one has no channels
    int mem_latency = 8;    ///< cycles from a request to its answer, if the memory is `ideal`
    int mem_interval = 1;   ///< cycles between two requests, if the memory is `ideal`
    int scan_out = 0;       ///< 1: a screen reads its picture from the memory, see FrameBuffer
    int pixel_writes = 0;   ///< 1: finished pixels are written to the memory

    // What the widest scene and picture need; checked when a scene is compiled and a frame made.
    int addr_bits = 24;    ///< memory address in lines of 64 bytes
    int prim_bits = 32;    ///< primitive number
    int pixel_bits = 14;   ///< pixel coordinate

    // Derived.
    int t_bits() const { return coord_bits + 2 + t_frac_bits; }   ///< distance, saturating, all ones: beyond
    PrimitiveTest test() const { return PrimitiveTest(primitive_test); }
    bool has_splits() const { return is_bvh() && splits != 0; }
    bool is_bvh() const { return Structure(structure) == Structure::bvh; }
    bool is_list() const { return Structure(structure) == Structure::none; }
    bool is_octree() const { return Structure(structure) == Structure::octree; }
    bool has_instances() const { return levels == 2; }
    bool has_homes() const { return has_instances() && shading; }   ///< rays start from instances
    /// Of meshes; that of the scene if there is one level.
    Structure lower_structure() const;
    /// The structure for which the RTL is built: an octree's nodes are those of a kd-tree.
    static Structure engine_of(Structure s) { return s == Structure::octree ? Structure::kd : s; }
    Structure engine() const { return engine_of(Structure(structure)); }
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

/// One parameter as files, `--set` and reports know it.
struct Parameter {
    const char* key;
    int Config::*member;
    int lo, hi;
    bool power_of_two;
    const char* meaning;
    const std::vector<std::string>* names = nullptr;   ///< of the values 0, 1 ..., if they are named
};
const std::vector<Parameter>& parameters();

/// Memories that can lie beside the chip, by the value of Config::dram.
const std::vector<std::string>& dram_names();

/// What holds the scene in memory, by the value of Config::structure.
const std::vector<std::string>& structure_names();
/// What holds each mesh, by the value of Config::mesh_structure.
const std::vector<std::string>& mesh_structure_names();

/// What becomes of what a plane cuts, by the value of Config::straddlers.
const std::vector<std::string>& straddlers_names();
/// Whether the compiler of boxes may cut primitives, by the value of Config::splits.
const std::vector<std::string>& splits_names();

/// How short paths are cut, by the value of Config::timing.
const std::vector<std::string>& timing_names();

/// Ray-triangle tests, by the value of Config::primitive_test.
const std::vector<std::string>& primitive_test_names();

/// Throws UserError if the configuration asks for a test that is not built in RTL.
void check_rtl(const Config& config);

/// A parameter's value as files and reports give it: a number or a name.
std::string value_text(const Config& config, const Parameter& parameter);

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
