#pragma once
// The lines of memory that every engine shares: instances, primitives, surfaces. An engine describes its
// nodes itself (model/engine/*/node.hpp). Each describes its own fields, as payloads do (payloads.hpp). The
// structs in rc_pkg.sv and the tables in the documents come from these descriptions.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/frame.hpp"
#include "model/core/layout.hpp"

namespace rayclock {

constexpr int max_width = 8;

/// One answer of the memory: 64 bytes.
using Line = std::array<std::uint32_t, 16>;

/// An instance in a memory line of 64 bytes (right-aligned). x' = A x + b maps a point of the scene's lattice
/// to the mesh's. The absolute values in a row of A sum to at most 1, so no operand grows.
struct Placement {
    std::uint32_t first = 0;                ///< number of its first primitive
    std::uint32_t root = 0;                 ///< line of the root of its lower structure
    std::uint32_t here = 0;                 ///< its own line, which identifies it if the chip shades
    std::uint32_t first_surface_line = 0;   ///< field `surfaces`: where primitive 0's would be; it may wrap
    std::uint32_t material = 0;   ///< line of a surface whose material all its primitives take; 0: none
    std::uint32_t is_same = 0;    ///< 1: A = 1 and b = 0, so a ray is the same in its mesh and in the scene
    /// With textures: log2 of the number of mesh steps in a scene step, |det A|^(1/3); level_frac fraction
    /// bits.
    std::int32_t texel_scale = 0;
    std::array<std::int32_t, 9> a{};   ///< [3 * row + column], map_frac() fraction bits; 1 is possible
    Vec3l b{};                         ///< map_frac() fraction bits
    template <class V> void fields(V& v, const Config& c) {
        v("first", first, c.prim_bits);
        v("root", root, c.addr_bits);
        if (c.shading) v("here", here, c.addr_bits);
        if (c.shading) v("surfaces", first_surface_line, c.addr_bits);
        if (c.shading) v("material", material, c.addr_bits);
        if (c.shading) v("is_same", is_same, 1);
        if (c.has_textures()) v("texel_scale", texel_scale, level_bits);
        v("a", a, c.map_bits(), 9);
        v("b", b, c.coord_bits + c.map_frac(), 3);
    }
    /// Returns the home of a ray that leaves this instance. It is 0, which is not an instance's line, if the
    /// ray is the same there.
    std::uint32_t home() const { return is_same ? 0 : here; }
    friend bool operator==(const Placement&, const Placement&) = default;
};

/// The content of a line in a structure of two levels, in its two highest bits. Nodes leave these bits free.
enum class LineKind : std::uint32_t { scene_node, mesh_node, placement };
constexpr int line_kind_bits = 2;
constexpr int line_kind_shift = 32 - line_kind_bits;   // in the last word
inline LineKind line_kind(const std::uint32_t* line) { return LineKind(line[15] >> line_kind_shift); }
inline void set_line_kind(std::uint32_t* line, LineKind kind) {
    line[15] |= std::uint32_t(kind) << line_kind_shift;
}

/// A cut-out is a triangle whose texture may have holes (TexRecord::cutoff). In a chip without textures all
/// triangles are of kind `triangle`.
enum class PrimKind : std::uint32_t { triangle, plane, sphere, cutout };
constexpr int prim_kind_bits = 2;

/// A primitive in 32 bytes of memory (right-aligned), and its number.
/// - Triangle or cut-out: its corners a, b, c on the lattice.
/// - Plane: a point a; b - a and c - a are the sides of its checkers' squares, halved or doubled:
///   model/compile/plane.hpp.
/// - Sphere: a is its centre. b[0] and b[1] are the lower and upper N bits of its squared radius in lattice
///   steps (radius_squared()).
struct PrimData {
    Vec3i a{}, b{}, c{};
    std::uint32_t prim = 0;
    PrimKind kind = PrimKind::triangle;
    bool is_triangle() const { return kind == PrimKind::triangle || kind == PrimKind::cutout; }
    template <class V> void fields(V& v, const Config& c_) {
        if (c_.has_kinds()) v("prim_kind", kind, prim_kind_bits);
        v("a", a, c_.coord_bits, 3);
        v("b", b, c_.coord_bits, 3);
        v("c", c, c_.coord_bits, 3);
        v("prim", prim, c_.prim_bits);
    }
};

/// A ray of a stream in 32 bytes of memory (right-aligned). Its kind is bounce for a closest hit, away for
/// any hit, and shadow for any hit up to a point: this ray begins at that point, a lattice point
/// (docs/guide/streams.md).
struct RayRecord {
    RayKind kind = RayKind::camera;
    Vec3i o{}, d{};   ///< as in Ray
    template <class V> void fields(V& v, const Config& c) {
        v("kind", kind, ray_kind_bits);
        v("o", o, c.origin_width(), 3);
        v("d", d, c.ray_dir_bits(), 3);
    }
    friend bool operator==(const RayRecord&, const RayRecord&) = default;
};

inline std::uint64_t radius_squared(const PrimData& sphere, int coord_bits) {
    const std::uint64_t mask = (std::uint64_t(1) << coord_bits) - 1;
    return (std::uint64_t(sphere.b[0]) & mask) | (std::uint64_t(sphere.b[1]) & mask) << coord_bits;
}

/// How a texture continues beyond its edges.
enum class WrapMode : std::uint32_t { repeat, mirror, clamp };
constexpr int wrap_bits = 2;

/// The texture on a surface: a line of memory (right-aligned), which Surface::record names. One unit of s
/// and t is the whole picture; t points down.
struct TexRecord {
    /// The coordinates at the corners a, b and c of Surface, coordinate_frac fraction bits. For a sphere: at
    /// (u, v) = (0, 0), (1, 0) and (0, 1).
    std::array<std::int32_t, 3> s{}, t{};
    std::uint32_t base = 0;   ///< first line of level 0; model/unit/tex/texel.hpp has the others
    std::uint32_t log_width = 0, log_height = 0;   ///< logarithms of the sides of level 0, in texels
    WrapMode wrap_s = WrapMode::repeat, wrap_t = WrapMode::repeat;
    std::uint32_t nearest = 0;      ///< 1: the nearest texel; 0: bilinear
    std::uint32_t last_level = 0;   ///< number of the smallest level
    /// Logarithm of the density of level 0: texels per 2^-F lattice steps. level_frac fraction bits.
    std::int32_t density = 0;
    /// Where alpha is below this, the triangle has a hole; 255 is opaque. 0: the triangle has no holes.
    std::uint32_t cutoff = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("s", s, coordinate_bits, 3);
        v("t", t, coordinate_bits, 3);
        v("base", base, c.addr_bits);
        v("log_width", log_width, side_bits);
        v("log_height", log_height, side_bits);
        v("wrap_s", wrap_s, wrap_bits);
        v("wrap_t", wrap_t, wrap_bits);
        v("nearest", nearest, 1);
        v("last_level", last_level, side_bits);
        v("density", density, level_bits);
        v("cutoff", cutoff, 8);
    }
    friend bool operator==(const TexRecord&, const TexRecord&) = default;
};

/// The shading data of a primitive: a line of memory (right-aligned), number ShadeFrame::first_surface_line +
/// primitive.
struct Surface {
    PrimKind kind = PrimKind::triangle;
    std::uint32_t smooth = 0, checkered = 0, schlick = 0;
    /// For a triangle: all components of its edges are multiples of 2^fine. So points of B fraction bits lie
    /// 2^-(B + fine) of an edge apart on it.
    std::uint32_t fine = 0;
    std::uint32_t record = 0;   ///< line of the surface's TexRecord; 0: no texture
    Vec3i a{}, b{}, c{};        ///< as in PrimData
    /// For a smooth triangle: [3 * corner + axis], each normal at most 2^(corner_bits - 1) - 1 long. For a
    /// plane: normal[0] and [1] are phases, normal[2] and [3] bit numbers. Bit normal[2] of u + normal[0]
    /// 2^bary_bits selects the second square of a pair along u; bit normal[3] of v + normal[1] 2^bary_bits
    /// does so along v. Bit -1 is 0. For a pane: normal[4] is its bit in ShadeState::in_cell.
    std::array<std::int32_t, 9> normal{};
    std::array<std::uint32_t, 3> colour{}, other{};          ///< share_bits fraction bits
    std::uint32_t ambient = 0, diffuse = 0, highlight = 0;   ///< share_bits fraction bits
    std::uint32_t mirror = 0, transmit = 0;   ///< unit_bits fraction bits; 0 only if the material's is 0
    std::uint32_t r0 = 0;      ///< Schlick's reflectance at normal incidence, unit_bits fraction bits
    std::uint32_t shine = 0;   ///< Phong's exponent, shine_frac fraction bits
    /// Ratio of refractive indices outside / inside, and inside / outside; index_frac fraction bits.
    std::uint32_t enter = 0, leave = 0;
    template <class V> void fields(V& v, const Config& c_) {
        v("kind", kind, prim_kind_bits);
        v("smooth", smooth, 1);
        v("checkered", checkered, 1);
        v("schlick", schlick, 1);
        v("fine", fine, 3);
        if (c_.has_textures()) v("record", record, c_.addr_bits);
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
    /// Returns this surface with the material of another, which has no texture. Fields that only planes have
    /// do not change.
    Surface with_material(const Surface& o) const {
        Surface s = *this;
        s.record = 0;
        s.schlick = o.schlick, s.colour = o.colour, s.other = o.other;
        s.ambient = o.ambient, s.diffuse = o.diffuse, s.highlight = o.highlight;
        s.mirror = o.mirror, s.transmit = o.transmit, s.r0 = o.r0, s.shine = o.shine;
        s.enter = o.enter, s.leave = o.leave;
        return s;
    }
    friend bool operator==(const Surface&, const Surface&) = default;
};

}   // namespace rayclock
