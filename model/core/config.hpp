#pragma once
// Format and shape of a machine, with the limits that all machines share. Every width of the model and the
// RTL derives from it.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace rayclock {

struct DramPart;

/// The length of the RTL's paths, by the value of Config::timing; see model/core/stages.hpp.
enum class Timing { relaxed, fast };

/// The data structure that holds the scene, by the value of Config::structure:
/// - bvh: boxes in boxes (model/engine/bvh);
/// - kd: space cut by planes (model/engine/kd);
/// - none: a list of all primitives (model/engine/none);
/// - octree: planes through the middle of each cell, walked by the engine of kd;
/// - spheres: bounding spheres (model/engine/globe);
/// - bsp: planes in any direction (model/engine/bsp).
enum class Structure { bvh, kd, none, octree, spheres, bsp };

/// The treatment of a primitive on both sides of a cut in an octree or bsp, by the value of
/// Config::straddlers: every leaf that it reaches holds it (leaves), the inner node holds it (inner, octree
/// only), or the compiler makes no such cut (stop, bsp only).
enum class Straddlers { leaves, inner, stop };

/// Ray-triangle tests, by the value of Config::primitive_test; see model/unit/isect/primitive.hpp.
enum class PrimitiveTest { exact, sheared, unit24, moller, woop, truncated };

constexpr int guard_bits = 14;        ///< fraction bits of the camera's pixel steps; one rounding drops them
constexpr int most_shift = 15;        ///< most bits by which a short camera direction is shifted up
constexpr int max_addr_bits = 24;     ///< maximum of Config::addr_bits
constexpr int max_pixel_bits = 14;    ///< maximum of Config::pixel_bits
constexpr int exp_bits = 5;           ///< box exponent, and bit length of a direction component
constexpr int max_prim_bits = 32;     ///< maximum of Config::prim_bits
constexpr int globe_bits = 12;        ///< each coordinate of a globe's centre, and its radius
constexpr int toward_bits = 18;       ///< each direction component in the test of globes
constexpr int normal_step_bits = 7;   ///< component of a slant plane's normal, signed
constexpr int crossing_bits = 18;   ///< quotient that gives the time when a ray crosses such a plane, and its
                                    ///< operands
constexpr int offset_bits = 6;      ///< child within its block, in steps of 32 bytes
constexpr int count_bits = 3;       ///< triangles of a leaf, 1..6; 0 for an inner node
constexpr int line_bits = 512;      ///< a memory line, one node
constexpr int half_line_bits = 256;   ///< one triangle
constexpr int line_bytes = 64;        ///< one answer of the memory
constexpr int unit_bits = 16;         ///< fraction bits of colours, weights and components of unit vectors
constexpr int share_bits = 12;    ///< fraction bits of a material's colours and of the weights of its local
                                  ///< light
constexpr int corner_bits = 11;   ///< component of a corner's normal, signed
constexpr int shine_frac = 4;     ///< fraction bits of Phong's exponent, out of shine_bits
constexpr int shine_bits = 14;
constexpr int index_frac = 12;   ///< fraction bits of a ratio of refractive indices, out of ratio_bits
constexpr int ratio_bits = 16;
constexpr int root_bits = 28;        ///< a square root in the sphere test
constexpr int strength_bits = 17;    ///< a light's colour, share_bits of them fraction
constexpr int light_reach = 8;       ///< a light, or a point of a plane, may lie 2^8 times as far away as the
                                     ///< lattice reaches
constexpr int plane_bits = 12;       ///< whole bits of a plane's u and v
constexpr int approach_steps = 12;   ///< steps in which a distant ray finds the lattice:
                                     ///< model/unit/shade/approach.hpp
constexpr int max_lights = 64;       ///< maximum of Config::lights
constexpr int most_fine = 4;         ///< maximum of Surface::fine
constexpr int sample_bits = 6;       ///< a pixel's sample, 0..63
constexpr int depth_bits = 4;        ///< bounces of a camera ray, 0..15
constexpr int unit_stages = 8;       ///< latency of rtl/fixed/rc_unit.sv
constexpr int power_stages = 7;      ///< latency of rc_power.sv

/// Bits that a point of a plane beyond the lattice loses as a ray's origin: O' in docs/origins.md.
constexpr int far_drop = light_reach + 1;
constexpr int max_panes = 4;   ///< maximum of Config::panes

/// Format and shape of one machine: everything that synthesis fixes. One C++ binary serves all machines; the
/// RTL gets the same values as constants of rc_pkg.sv.
struct Config {
    std::string name = "default";

    // Format: widths in bits.
    int coord_bits = 18;      ///< N: signed lattice coordinate
    int dir_bits = 20;        ///< M: signed direction component; 2N + M <= 62
    int t_frac_bits = 4;      ///< F: fraction bits of a distance t, see t_bits()
    int recip_bits = 16;      ///< R: precision of a reciprocal direction component
    int box_bits = 8;         ///< bits of a child box plane relative to its node
    int bary_bits = 16;       ///< fraction bits of the barycentric u and v of a hit
    int primitive_test = 0;   ///< ray-triangle test, see primitive_test_names()
    int origin_bits = 12;     ///< B: fraction bits of a secondary ray's origin, with `shading`; see
                              ///< docs/origins.md

    int structure = 0;    ///< data structure of the scene, see structure_names()
    int straddlers = 0;   ///< with octree or bsp, see straddlers_names()
    int splits = 0;       ///< with bvh, see splits_names()
    int references = 8;   ///< with kd, octree or bsp: most references per primitive on average, 1..64
    int levels = 1;       ///< 2: a tree over instances, and one tree below it for each mesh (docs/motion.md)
    int mesh_structure = 0;   ///< data structure of meshes, see mesh_structure_names(); 0: the same as
                              ///< `structure`

    // Shape: counts, depths, latencies.
    int node_width = 8;        ///< W: children of a node, 2, 4 or 8
    int leaf_size = 1;         ///< most primitives in a leaf, 1..6
    int contexts = 64;         ///< T: rays in flight
    int stack_depth = 16;      ///< groups of siblings that a ray can leave for later
    int raygen_queue = 16;     ///< answers that raygen may hold, a power of two
    int box_queue = 16;        ///< answers that box may hold, a power of two
    int tri_queue = 32;        ///< answers that tri may hold, a power of two
    int box_lanes = 8;         ///< children that box tests at once: 1, 2, 4 or 8; 8 covers any node
    int tri_interval = 1;      ///< cycles between primitives that tri accepts: 1, 2 or 4
    int raygen_interval = 1;   ///< cycles between rays that raygen begins: 1, 2, 4 or 8
    int xform_interval = 2;    ///< cycles between rays that xform accepts, with two levels: 1, 2 or 4
    int shade_interval = 1;    ///< cycles between passes that shade accepts, with shading: 1, 2, 4 or 8
    int pipelines = 1;         ///< P: pipelines of one machine, 1 to 16
    int tile_bits = 4;    ///< tiles are squares of 2^k x 2^k pixels, in Morton order inside; 0: row by row
    int node_sets = 64;   ///< node cache of a pipeline: sets
    int node_ways = 4;    ///< ways
    int node_line = 64;   ///< bytes per line
    int node_mshrs = 8;   ///< most lines in flight
    int prim_sets = 64;   ///< primitive cache of a pipeline, the same fields
    int prim_ways = 4;
    int prim_line = 64;
    int prim_mshrs = 8;
    int l2_sets = 0;   ///< cache that all pipelines share, the same; 0: there is none
    int l2_ways = 4;
    int l2_line = 64;
    int l2_mshrs = 16;
    int cache_queue = 4;   ///< answers that a cache may hold, a power of two
    int timing = 0;        ///< length of the chip's paths, see timing_names()

    // Shape: optional units, present only if a scene needs them. All but the first need `shading`.
    int shading = 0;         ///< 1: the chip computes finished colours, with shadow rays and bounces
    int spheres = 0;         ///< 1: tri can test spheres
    int planes = 0;          ///< 1: tri can test planes, and shade computes checkers
    int smooth = 0;          ///< 1: normals interpolated between a triangle's corners
    int refraction = 0;      ///< 1: refracted rays
    int panes = 0;           ///< most transmitting planes for which a path records its side
    int horizon = 0;         ///< 1: bounces that miss the lattice meet planes beyond it
    int supersampling = 0;   ///< 1: several samples per pixel
    int lights = 8;          ///< most point lights
    int bounces = 5;         ///< most waiting rays of a pixel: the largest depth
    int shade_queue = 64;    ///< answers that shade may hold, a power of two
    int surf_sets = 64;      ///< surface cache of a pipeline, the same fields
    int surf_ways = 4;
    int surf_line = 64;
    int surf_mshrs = 8;

    // Outside the chip.
    int dram = 2;                               ///< memory, see dram_names()
    std::shared_ptr<const DramPart> own_dram;   ///< a memory described in a file; if set, `dram` is ignored
    int dram_channels = 1;   ///< number of such memories side by side; the ideal one has no channels
    int mem_latency = 8;     ///< ideal memory: cycles from a request to its answer
    int mem_interval = 1;    ///< ideal memory: cycles between two requests
    int scan_out = 0;        ///< 1: a screen reads its picture from the memory, see FrameBuffer
    int pixel_writes = 0;    ///< 1: finished pixels are written to the memory

    // Limits of the widest scene and picture, checked when a scene is compiled and a frame is made.
    int addr_bits = 24;    ///< memory address in lines of 64 bytes
    int prim_bits = 32;    ///< primitive number
    int pixel_bits = 14;   ///< pixel coordinate

    // Derived.
    /// Bits of a distance. A distance saturates; all ones means beyond.
    int t_bits() const { return coord_bits + 2 + t_frac_bits; }
    PrimitiveTest test() const { return PrimitiveTest(primitive_test); }
    bool has_splits() const { return is_bvh() && splits != 0; }
    bool is_bvh() const { return Structure(structure) == Structure::bvh; }
    bool is_list() const { return Structure(structure) == Structure::none; }
    bool is_octree() const { return Structure(structure) == Structure::octree; }
    bool has_instances() const { return levels == 2; }
    bool has_homes() const { return has_instances() && shading; }   ///< rays start from instances
    /// Returns the structure of meshes; with one level, that of the scene.
    Structure lower_structure() const;
    /// Returns the structure for which the RTL is built. An octree has the nodes of a kd-tree.
    static Structure engine_of(Structure s) { return s == Structure::octree ? Structure::kd : s; }
    Structure engine() const { return engine_of(Structure(structure)); }
    Structure lower_engine() const { return engine_of(lower_structure()); }
    /// True if one unit decides the nodes of the scene's tree and another those of meshes.
    bool has_two_engines() const { return engine() != lower_engine(); }
    /// Returns one level as a configuration with only that level's structure. has_boxes() and its kind, true
    /// if any level has such nodes, then describe this level alone.
    Config upper() const;
    Config lower() const;
    bool has_boxes() const { return is_walked(Structure::bvh); }
    bool has_treelets() const { return is_walked(Structure::kd); }
    bool has_globes() const { return is_walked(Structure::spheres); }
    bool has_slants() const { return is_walked(Structure::bsp); }
    bool has_planes() const { return has_treelets() || has_slants(); }
    bool is_walked(Structure by) const { return engine() == by || lower_engine() == by; }
    /// Returns the memory outside the chip, or null if it is the ideal memory.
    const DramPart* dram_part() const;
    bool is_sheared() const { return test() == PrimitiveTest::sheared; }
    int edge_bits() const;   ///< signed edge function, and determinant of a hit
    /// Bits of the numerator of t, signed.
    int num_bits() const { return 3 * coord_bits + 2 + is_sheared() + origin_frac(); }
    int tri_ray_bits() const;                                         ///< a ray in list, see TriReq
    int origin_frac() const { return shading ? origin_bits : 0; }     ///< fraction bits of a ray's origin
    int origin_width() const { return coord_bits + origin_frac(); }   ///< bits of a ray's origin, signed
    /// Bits of a point in shade, signed.
    int point_width() const { return origin_width() + (planes ? light_reach : 0); }
    int approach_shift() const;   ///< the last step of an approach is 2^this directions long
    /// Bits of a direction component: M, or the bits that a shadow ray needs.
    int ray_dir_bits() const { return shading ? coord_bits + origin_bits + 1 : dir_bits; }
    bool has_kinds() const { return spheres || planes; }   ///< the chip has several kinds of primitives
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
    int box_latency() const;
    /// Cycles between nodes that box accepts.
    int box_interval() const { return has_boxes() ? std::max(1, node_width / box_lanes) : 1; }
    int treelet_latency() const;
    int globe_latency() const;
    int slant_latency() const;
    /// Latency of a node's decision. With two engines it is that of the slower one, and the answers of the
    /// faster one wait.
    int node_latency() const { return std::max(node_latency(engine()), node_latency(lower_engine())); }
    int node_latency(Structure engine) const;
    int map_frac() const { return coord_bits + 3; }   ///< K: fraction bits of an instance's map
    int map_bits() const { return map_frac() + 2; }   ///< entry of that map, signed; 1 is possible
    int xform_latency() const;
    int planes_of_node() const { return node_width - 1; }   ///< planes of a treelet or a slant
    /// Bits of n . x of a slant's plane, signed. The normal has three components of at most 2^6 - 1.
    int offset_of_plane_bits() const { return coord_bits + normal_step_bits + 1; }
    int tri_latency() const;
    int pass_latency() const;     ///< of a pass alone, rtl/unit/shade/rc_pass.sv
    int shade_latency() const;    ///< of a pass, and of reading its context's state
    int clear_cycles() const;     ///< of a reset, which empties all caches: docs/chip.md
    int node_miss_bits() const;   ///< id of the node cache's request to memory: MSHR, and word of the line
    int prim_miss_bits() const;
    int surf_miss_bits() const;
    int l2_miss_bits() const;
    int least_addr_bits() const;   ///< fewest address bits that leave a tag of one bit in every cache
    /// Memory clients in a pipeline: nodes, primitives, surfaces. A fourth number, with shading, is never
    /// used.
    int clients() const { return shading ? 4 : 2; }
    int client_bits() const;   ///< number of a cache among those of all pipelines: clients() * pipeline + 0,
                               ///< 1, 2
    int client_id_bits() const;    ///< id of a cache's request, unique in the machine
    int tile_coord_bits() const;   ///< coordinate of a tile, in tiles
    int mem_id_bits() const;       ///< id of a request at the memory port
};

/// One parameter, as files, `--set` and reports show it.
struct Parameter {
    const char* key;
    int Config::*member;
    int lo, hi;
    bool power_of_two;
    const char* meaning;
    const std::vector<std::string>* names = nullptr;   ///< of the values 0, 1, ..., if they have names
};
const std::vector<Parameter>& parameters();

/// Memories outside the chip, by the value of Config::dram.
const std::vector<std::string>& dram_names();

/// Data structures of the scene, by the value of Config::structure.
const std::vector<std::string>& structure_names();
/// Data structures of meshes, by the value of Config::mesh_structure.
const std::vector<std::string>& mesh_structure_names();

/// Treatments of a primitive that a plane cuts, by the value of Config::straddlers.
const std::vector<std::string>& straddlers_names();
/// Permission for the compiler of boxes to cut primitives, by the value of Config::splits.
const std::vector<std::string>& splits_names();

/// Lengths of the chip's paths, by the value of Config::timing.
const std::vector<std::string>& timing_names();

/// Ray-triangle tests, by the value of Config::primitive_test.
const std::vector<std::string>& primitive_test_names();

/// Throws UserError if the configuration needs something that the RTL does not have: a primitive test in
/// software only, or too many pipelines.
void check_rtl(const Config& config);

/// Returns a parameter's value as files and reports show it: a number or a name.
std::string value_text(const Config& config, const Parameter& parameter);

/// Returns the names of the configurations that ship with the program.
const std::vector<std::string>& config_names();
/// Returns the configuration with this name. Throws UserError if there is none.
Config named_config(const std::string& name);

/// Applies one `key=value`. Throws UserError that names an unknown key (with the nearest one) or a bad value.
void set_parameter(Config& config, const std::string& key, const std::string& value,
                   const std::string& where);

/// Throws UserError unless every parameter and every combination is legal.
void check_config(const Config& config, const std::string& where);

/// Returns the smallest number of bits, at least 1, that hold the values 0..n-1.
constexpr int index_bits(int n) {
    int bits = 0;
    while ((1 << bits) < n) ++bits;
    return bits > 0 ? bits : 1;
}

}   // namespace rayclock
