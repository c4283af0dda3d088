#pragma once
// Proves the range of every signal of the units, for one scene and one frame. Interval arithmetic starts from
// the vertices, the nodes, the eye and the directions of all pixels. Nothing is sampled.
#include <array>
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "sim/explore/fit/interval.hpp"

namespace rayclock::fit {

/// The treatment of a value that its signal cannot hold.
enum class Excess {
    never,       ///< it must fit: the proof fails otherwise
    wraps,       ///< taken modulo 2^bits on purpose: it is a term of a sum that fits
    saturates,   ///< all ones, by name
};

/// One signal, all axes and all children of a node together.
struct Signal {
    std::string unit, name;   ///< as in the RTL, with the stage
    Interval range;           ///< before it wraps or saturates
    bool is_signed = false;
    int there = 0;   ///< bits
    Excess excess = Excess::never;

    int needed() const { return is_signed ? signed_bits(range) : unsigned_bits(range); }
    bool fits() const { return needed() <= there; }
};

/// The inputs of the proof: extremes of the values in memory and in the frame's registers.
struct Extremes {
    using Axes = std::array<Interval, 3>;
    Axes vertex, eye, direction;
    Axes corner, right, down, sum;      ///< camera registers and raygen's sum
    Interval right_x, down_y;           ///< terms of that sum, all axes
    std::int64_t least_direction = 0;   ///< least value of a direction's largest component
    Interval reach;                     ///< largest component of vertex - eye, of any vertex
    Axes p1, p2, edge, to_eye;          ///< of all triangles: d x e1, d x e2; e1 and e2; s
    Axes normal;
    Interval det, u, v, w, num;     ///< over all triangles, before the signs are changed
    Interval edge_term, num_term;   ///< terms of the sums of three products
    /// Nodes of one exponent along one axis.
    struct Group {
        Interval origin, lo, hi;
    };
    std::array<std::array<Group, 1 << exp_bits>, 3> groups;
    Interval base, node, half_line, kind, inner, leaves, offset, slot, prim;
};
Extremes extremes(const MemoryImage& image, const Frame& frame, const Config& config);

struct Ranges {
    std::vector<Signal> signals;
    /// True if every signal that must fit does. The terms of a sum may wrap if the sum fits.
    bool proven() const;
};
Ranges prove_ranges(const MemoryImage& image, const Frame& frame, const Config& config);

/// Append the signals of the units, in the order in which a ray meets them.
void raygen_ranges(const Extremes& e, const Frame& frame, const Config& config, std::vector<Signal>& out);
void box_ranges(const Extremes& e, const Config& config, std::vector<Signal>& out);
void tri_ranges(const Extremes& e, const Config& config, std::vector<Signal>& out);
void walk_ranges(const Extremes& e, const CompileReport& report, const Config& config,
                 std::vector<Signal>& out);

/// Directions of one sign and bit length along one axis, and their reciprocals.
struct RecipClass {
    bool negative = false;
    int len = 0;
    Interval size, aligned, recip;   ///< |d|; |d| << (M - len); r. A zero component has len 0, r 1
};
std::vector<RecipClass> recip_classes(const Interval& direction, const Config& config);

}   // namespace rayclock::fit
