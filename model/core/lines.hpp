#pragma once
// What lies in the lines of memory: nodes, primitives, surfaces. Each describes itself, as payloads do
// (payloads.hpp), and through that the structs in rc_pkg.sv and the tables in the documents.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/frame.hpp"
#include "model/core/layout.hpp"

namespace rayclock {

constexpr int max_width = 8;

/// What memory gives in one answer: 64 bytes.
using Line = std::array<std::uint32_t, 16>;

/// A node as it lies in a memory line of 64 bytes (right-aligned): child boxes quantised relative to `org`,
/// plane k is org + (k << exp). kind: 0 empty, 1 inner node, 1 + n a leaf of n triangles. Inner children come
/// first. Block of children at line `base`: one line per inner child in slot order, then the leaves'
/// triangles, 32 bytes each.
struct Node {
    Vec3i org{};
    std::array<std::uint32_t, 3> exp{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    std::array<std::uint32_t, 3 * max_width> lo{}, hi{};   ///< [3 * child + axis]
    template <class V> void fields(V& v, const Config& c) {
        v("org", org, c.coord_bits, 3);
        v("exp", exp, exp_bits, 3);
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
        v("lo", lo, c.box_bits, 3 * c.node_width);
        v("hi", hi, c.box_bits, 3 * c.node_width);
    }
};

/// A node of a kd-tree as it lies in a memory line of 64 bytes (right-aligned): a treelet of log2 W levels of
/// planes, and the closed box `lo`..`hi` of all that its cell holds; if it is open, the box is not looked at.
/// Planes are in the order of a heap: plane 0 cuts the treelet's cell, planes 1 and 2 its lower and upper
/// half, and so on. Plane i lies at `at`[i] on axis `axis`[i]; axis 3 is no plane, and both its sides are the
/// whole cell. Exit 0 is on the lower side of all planes on its way, exit W - 1 on the upper one. kind: 0
/// empty, 1 a treelet, 1 + n a leaf of n primitives. Block at line `base`: one line for each exit to a
/// treelet, in their order, then the leaves' primitives, 32 bytes each.
struct Treelet {
    std::uint32_t open = 0;
    Vec3i lo{}, hi{};
    std::array<std::uint32_t, max_width - 1> axis{};
    std::array<std::int32_t, max_width - 1> at{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    template <class V> void fields(V& v, const Config& c) {
        v("open", open, 1);
        v("lo", lo, c.coord_bits, 3);
        v("hi", hi, c.coord_bits, 3);
        v("axis", axis, 2, c.planes_of_node());
        v("at", at, c.coord_bits, c.planes_of_node());
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
    }
};
constexpr std::uint32_t no_axis = 3;   ///< of a treelet's plane

/// A node of a tree of planes in any direction as it lies in a memory line of 64 bytes (right-aligned): a
/// treelet whose plane i is the points x of the lattice with `normal`[3 i ..] . x = `at`[i]; its lower side
/// has smaller products. A normal of zeros is no plane. All else is as of Treelet.
struct Slant {
    std::uint32_t open = 0;
    Vec3i lo{}, hi{};
    std::array<std::int32_t, 3 * (max_width - 1)> normal{};   ///< [3 * plane + axis]
    std::array<std::int32_t, max_width - 1> at{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    template <class V> void fields(V& v, const Config& c) {
        v("open", open, 1);
        v("lo", lo, c.coord_bits, 3);
        v("hi", hi, c.coord_bits, 3);
        v("normal", normal, normal_step_bits, 3 * c.planes_of_node());
        v("at", at, c.offset_of_plane_bits(), c.planes_of_node());
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
    }
};

/// A node of a hierarchy of globes (bounding spheres) as it lies in a memory line of 64 bytes
/// (right-aligned). Globe i has its centre at org + (centre << exp) and the radius radius << exp, in lattice
/// steps. Kinds, and the block at line `base`, as of Node.
struct GlobeNode {
    Vec3i org{};
    std::uint32_t exp = 0;
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    std::array<std::uint32_t, 3 * max_width> centre{};   ///< [3 * child + axis]
    std::array<std::uint32_t, max_width> radius{};
    template <class V> void fields(V& v, const Config& c) {
        v("org", org, c.coord_bits, 3);
        v("exp", exp, exp_bits);
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
        v("centre", centre, globe_bits, 3 * c.node_width);
        v("radius", radius, globe_bits, c.node_width);
    }
};

/// Calls `work` with an empty node of the kind that a structure is made of.
template <class Work> decltype(auto) with_node(Structure engine, Work&& work) {
    switch (engine) {
        case Structure::kd: return work(Treelet{});
        case Structure::spheres: return work(GlobeNode{});
        case Structure::bsp: return work(Slant{});
        default: return work(Node{});
    }
}
inline int node_bits(const Config& c, Structure engine) {
    return with_node(engine, [&]<class N>(const N&) { return bits_of<N>(c); });
}

/// An instance as it lies in a memory line of 64 bytes (right-aligned): x' = A x + b takes a point of the
/// scene's lattice to the mesh's. Rows of A sum to 1 at most, in size, so that no operand grows.
struct Placement {
    std::uint32_t first = 0;           ///< number of its first primitive
    std::uint32_t root = 0;            ///< line of the root of its lower structure
    std::uint32_t here = 0;            ///< its own line: what it is called, if the chip shades
    std::uint32_t surfaces = 0;        ///< line of the surface that primitive 0 would have; it may wrap
    std::uint32_t material = 0;        ///< line of a surface whose material all its primitives have; 0: none
    std::uint32_t same = 0;            ///< A = 1 and b = 0: a ray is in it what it is in the scene
    std::array<std::int32_t, 9> a{};   ///< [3 * row + column], map_frac() fraction bits; 1 is possible
    Vec3l b{};                         ///< likewise
    template <class V> void fields(V& v, const Config& c) {
        v("first", first, c.prim_bits);
        v("root", root, c.addr_bits);
        if (c.shading) v("here", here, c.addr_bits);
        if (c.shading) v("surfaces", surfaces, c.addr_bits);
        if (c.shading) v("material", material, c.addr_bits);
        if (c.shading) v("is_same", same, 1);
        v("a", a, c.map_bits(), 9);
        v("b", b, c.coord_bits + c.map_frac(), 3);
    }
    /// Where a ray that leaves it is at home; 0, no instance's line, if it is the same there.
    std::uint32_t home() const { return same ? 0 : here; }
    friend bool operator==(const Placement&, const Placement&) = default;
};

/// What a line of a structure of two levels holds, by its two highest bits, which nodes leave alone.
enum class LineKind : std::uint32_t { scene_node, mesh_node, placement };
constexpr int line_kind_bits = 2;
constexpr int line_kind_shift = 32 - line_kind_bits;   // in the last word
inline LineKind line_kind(const std::uint32_t* line) { return LineKind(line[15] >> line_kind_shift); }
inline void set_line_kind(std::uint32_t* line, LineKind kind) {
    line[15] |= std::uint32_t(kind) << line_kind_shift;
}

enum class PrimKind : std::uint32_t { triangle, plane, sphere };

/// A primitive as it lies in 32 bytes of memory (right-aligned), and its number. Triangle: its corners a, b,
/// c on the lattice. Plane: the same without edges; b - a and c - a are sides of its checkers' squares,
/// halved or doubled: model/compile/plane.hpp. Sphere: a is its centre, b[0] and b[1] the lower and the upper
/// N bits of the square of its radius in lattice steps (radius_squared()).
struct PrimData {
    Vec3i a{}, b{}, c{};
    std::uint32_t prim = 0;
    std::uint32_t kind = 0;   ///< PrimKind
    template <class V> void fields(V& v, const Config& c_) {
        if (c_.has_kinds()) v("prim_kind", kind, 2);
        v("a", a, c_.coord_bits, 3);
        v("b", b, c_.coord_bits, 3);
        v("c", c, c_.coord_bits, 3);
        v("prim", prim, c_.prim_bits);
    }
};

inline std::uint64_t radius_squared(const PrimData& sphere, int coord_bits) {
    const std::uint64_t mask = (std::uint64_t(1) << coord_bits) - 1;
    return (std::uint64_t(sphere.b[0]) & mask) | (std::uint64_t(sphere.b[1]) & mask) << coord_bits;
}

/// What shade must know about a primitive: a line of memory (right-aligned), line Frame::surfaces + number.
struct Surface {
    std::uint32_t kind = 0, smooth = 0, checkered = 0, schlick = 0;
    /// Of a triangle: all components of its edges are multiples of 2^fine, so that points of B fraction bits
    /// lie 2^-(B + fine) of an edge apart on it.
    std::uint32_t fine = 0;
    Vec3i a{}, b{}, c{};                    ///< as in PrimData
    std::array<std::int32_t, 9> normal{};   ///< [3 * corner + axis], at most 2^(corner_bits - 1) - 1 long; if
                                            ///< smooth.
    /// Of a plane normal[0] and [1] are phases, [2] and [3] bits: bit [2] of u + [0] 2^bary_bits tells
    /// whether a square is the second of a pair along u, [3] of v + [1] 2^bary_bits along v; bit -1 is 0. Of
    /// a pane [4] is its bit in ShadeState::cell.
    std::array<std::uint32_t, 3> colour{}, other{};          ///< share_bits of fraction
    std::uint32_t ambient = 0, diffuse = 0, highlight = 0;   ///< share_bits of fraction
    std::uint32_t mirror = 0, transmit = 0;   ///< unit_bits of fraction; 0 only if the material's is 0
    std::uint32_t r0 = 0;      ///< Schlick's reflectance at normal incidence, unit_bits of fraction
    std::uint32_t shine = 0;   ///< Phong's exponent, shine_frac of fraction
    std::uint32_t enter = 0,
                  leave = 0;   ///< ratio of refractive indices outside / inside, inside / outside; index_frac
    template <class V> void fields(V& v, const Config& c_) {
        v("kind", kind, 2);
        v("smooth", smooth, 1);
        v("checkered", checkered, 1);
        v("schlick", schlick, 1);
        v("fine", fine, 3);
        v("a", a, c_.coord_bits, 3);
        v("b", b, c_.coord_bits, 3);
        v("c", c, c_.coord_bits, 3);
        v("normal", normal, corner_bits, 9);
        v("colour", colour, share_bits + 1, 3);
        v("other", other, share_bits + 1, 3);
        v("ambient", ambient, share_bits + 1);
        v("diffuse", diffuse, share_bits + 1);
        v("highlight", highlight, share_bits + 1);
        v("mirror", mirror, unit_bits + 1);
        v("transmit", transmit, unit_bits + 1);
        v("r0", r0, unit_bits + 1);
        v("shine", shine, shine_bits);
        v("enter", enter, ratio_bits);
        v("leave", leave, ratio_bits);
    }
    /// With the material of another; what only planes have stays.
    Surface with_material(const Surface& o) const {
        Surface s = *this;
        s.schlick = o.schlick, s.colour = o.colour, s.other = o.other;
        s.ambient = o.ambient, s.diffuse = o.diffuse, s.highlight = o.highlight;
        s.mirror = o.mirror, s.transmit = o.transmit, s.r0 = o.r0, s.shine = o.shine;
        s.enter = o.enter, s.leave = o.leave;
        return s;
    }
    friend bool operator==(const Surface&, const Surface&) = default;
};

}   // namespace rayclock
