#pragma once
#include <string>
#include <vector>

namespace rayclock {

/// Format and shape of one machine: everything that the hardware fixes when it is synthesised.
/// One C++ binary serves all of them; for the RTL they become the constants of rc_pkg.sv.
struct Config {
    std::string name = "default";

    // Format: widths in bits.
    int coord_bits = 18;     ///< N: signed lattice coordinate
    int dir_bits = 20;       ///< M: signed direction component; 2N + M <= 62
    int t_frac_bits = 4;     ///< F: fraction bits of a distance t (see t_bits())
    int recip_bits = 16;     ///< R: precision of a reciprocal direction component
    int box_bits = 8;        ///< bits of a child box plane relative to its node
    int bary_bits = 16;      ///< fraction bits of the barycentric u and v of a hit

    // Shape: counts, depths, latencies.
    int node_width = 8;      ///< W: children of a node, 2, 4 or 8
    int leaf_size = 1;       ///< most triangles in a leaf, 1..6
    int contexts = 64;       ///< T: rays in flight
    int stack_depth = 16;    ///< groups of siblings a ray can leave for later
    int raygen_queue = 16;   ///< answers raygen may hold, a power of two
    int box_queue = 16;      ///< answers box may hold, a power of two
    int tri_queue = 32;      ///< answers tri may hold, a power of two
    int mem_latency = 8;     ///< cycles from a memory request to its answer
    int mem_interval = 1;    ///< cycles between two requests on one memory port

    // Derived.
    int t_bits() const { return coord_bits + 2 + t_frac_bits; }      ///< distance, saturating, all ones: beyond
    int edge_bits() const { return 2 * coord_bits + dir_bits + 2; }  ///< signed edge function and determinant
    int num_bits() const { return 3 * coord_bits + 2; }              ///< signed numerator of t
    int guard_dir_bits() const;                                      ///< camera vectors: direction and guard bits
    int ray_bits() const;                                            ///< index of a context
    int group_bits() const;                                          ///< count 0..W
    int slot_bits() const;                                           ///< index 0..W-1
    int stack_bits() const;                                          ///< count 0..stack_depth
    int raygen_latency() const;
    int box_latency() const;
    int tri_latency() const;
};

constexpr int guard_bits = 14;      ///< fraction bits of the camera's pixel steps, dropped by one rounding
constexpr int addr_bits = 24;       ///< memory address in lines of 64 bytes
constexpr int pixel_bits = 14;      ///< pixel coordinate
constexpr int exp_bits = 5;         ///< box exponent, and bit length of a direction component
constexpr int prim_bits = 32;       ///< primitive number
constexpr int offset_bits = 6;      ///< child within its block, in steps of 32 bytes
constexpr int count_bits = 3;       ///< triangles of a leaf, 1..6; 0 for an inner node
constexpr int line_bits = 512;      ///< a memory line, one node
constexpr int half_line_bits = 256; ///< one triangle

/// One parameter as files, `--set` and reports know it.
struct Parameter {
    const char* key;
    int Config::*member;
    int lo, hi;
    bool power_of_two;
    const char* meaning;
};
const std::vector<Parameter>& parameters();

/// The named configurations that ship with the program.
const std::vector<std::string>& config_names();
Config named_config(const std::string& name);

/// Applies one `key=value`; throws UserError naming an unknown key (with the nearest) or a bad value.
void set_parameter(Config& config, const std::string& key, const std::string& value, const std::string& where);

/// Throws UserError unless every parameter and every combination is legal.
void check_config(const Config& config, const std::string& where);

/// Smallest number of bits that hold the values 0..n-1.
constexpr int index_bits(int n) {
    int bits = 0;
    while ((1 << bits) < n) ++bits;
    return bits > 0 ? bits : 1;
}

} // namespace rayclock
