#pragma once
// Registers that the host sets before a frame. They describe their fields as payloads do; payloads.hpp
// explains the symbols.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"

namespace rayclock {

using Vec3i = std::array<std::int32_t, 3>;
using Vec3l = std::array<std::int64_t, 3>;

/// The origin of a ray (docs/proofs/origins.md):
/// - camera: from the eye;
/// - bounce: reflected or refracted, from a point of a surface;
/// - shadow: from the light to such a point, which it would reach at t = 2^-B;
/// - away: from such a point towards a light beyond the lattice, without end. It is a bounce for which any
///   hit suffices, as for a shadow ray.
enum class RayKind : std::uint32_t { camera, bounce, shadow, away };
constexpr int ray_kind_bits = 2;
constexpr bool ends_at_any(RayKind kind) { return kind >= RayKind::shadow; }
/// Returns t_max, the end of a ray's interval. It is the distance to beat until the ray has a hit. A shadow
/// ray ends at the surface, and other rays have all ones. Mirror of rtl/fixed/rc_t_best.sv.
constexpr std::uint32_t t_max_of(RayKind kind, const Config& config) {
    return kind == RayKind::shadow ? 1u << (config.coord_bits + config.t_frac_bits)
                                   : (1u << config.t_bits()) - 1;
}

/// Middle of the error range of a path length's logarithm: path_to() in model/unit/shade/surface/surf.hpp.
constexpr double length_bias = 0.057;

/// Registers of a frame for a chip that shades.
struct ShadeFrame {
    std::uint32_t first_surface_line = 0;   ///< line of primitive 0's surface
    std::uint32_t depth = 0;                ///< most bounces
    /// Least weight of a ray, rounded down to unit_bits + 1 fraction bits; see weighs_enough().
    std::uint32_t threshold = 0;
    std::uint32_t side = 1;     ///< a pixel has side * side samples
    std::uint32_t stride = 1;   ///< from sample to sample through the cells
    std::uint32_t jitter = 0;
    std::uint32_t contrast = 0;   ///< unit_bits fraction bits; 0: trace all samples
    /// round(2^unit_bits / samples), for all samples and for the first ones.
    std::uint32_t share = 0, first_share = 0;
    std::uint32_t seed = 0;
    std::array<std::uint32_t, 3> background{};   ///< unit_bits fraction bits
    /// Logarithm of the width of a pixel's sample at a distance of 1, minus length_bias: level_frac fraction
    /// bits.
    std::int32_t spread = 0;
    std::uint32_t lights = 0;
    std::array<std::uint32_t, max_lights> near{};   ///< 1: the light lies within the lattice
    /// 1: no plane except panes separates the light from the eye.
    std::array<std::uint32_t, max_lights> clear{};
    /// The panes that separate the light from the eye, one bit each.
    std::array<std::uint32_t, max_lights> cell{};
    std::array<std::int32_t, 3 * max_lights> place{};     ///< [3 * light + axis], lattice points
    std::array<std::uint32_t, 3 * max_lights> colour{};   ///< share_bits fraction bits
    template <class V> void fields(V& v, const Config& c) {
        v("surfaces", first_surface_line, c.addr_bits);
        v("depth", depth, depth_bits);
        v("threshold", threshold, unit_bits + 2);
        v("side", side, 4);
        v("stride", stride, sample_bits);
        v("jitter", jitter, 1);
        v("contrast", contrast, unit_bits + 1);
        v("share", share, unit_bits + 1);
        v("first_share", first_share, unit_bits + 1);
        v("seed", seed, 32);
        v("background", background, unit_bits + 1, 3);
        if (c.has_textures()) v("spread", spread, level_bits);
        v("lights", lights, light_number_bits);
        v("is_near", near, 1, c.lights);
        v("is_clear", clear, 1, c.lights);
        if (c.panes > 0) v("light_cell", cell, c.panes, c.lights);
        v("place", place, c.light_bits(), 3 * c.lights);
        v("colour", colour, strength_bits, 3 * c.lights);
    }
};

/// Registers of a frame. They give a camera ray its direction d in three steps. Only the last step rounds.
///
/// The ray's point (px, py) is the pixel's number with f fraction bits. Without supersampling f = 0 and
/// px = x, py = y. With it f = 8 and px = 256 x + offset (sample_offset()). With g = guard_bits + f and
/// M = dir_bits:
/// - V_k = 2^f corner_k + px right_k + py down_k on every axis k. The host keeps it to M + g bits, signed.
/// - s is the largest of 0..max_shift with -2^(M-1+g) <= 2^s V_k < 2^(M-1+g) on all three axes.
/// - d_k = min(floor((2^s V_k + 2^(g-1)) / 2^g), 2^(M-1) - 1). This rounds to nearest, halves up; 2^(M-1)
///   does not fit into M bits.
///
/// So d is an integer direction with all the bits that M allows. It is only longer by a power of two than
/// without s. The host also keeps max |V_k| >= 2^(M-2+g-max_shift) at every point, so max |d_k| >= 2^(M-2).
/// So t of a hit inside the lattice never saturates. On the axis of the largest component the ray advances by
/// |d_k| num / den <= 2^N - 1 lattice steps, so t <= ceil(2^(M-1+F) (2^N - 1) / 2^(M-2)) < 2^(N+1+F), half of
/// the range of t.
struct Frame {
    /// With a stream, the width is 2^pixel_bits, and the height is the number of rows that `ray_count` rays
    /// take.
    std::uint32_t width = 0, height = 0;
    std::uint32_t ray_count = 0;        ///< with a stream: the number of its rays
    std::uint32_t first_ray_line = 0;   ///< with a stream: line of the first two rays
    std::uint32_t first_hit_line = 0;   ///< line of the first hits, if the chip writes them
    std::uint32_t root = 0;   ///< line of the root node, or the first line of the list of primitives
    std::uint32_t listed_primitives = 0;   ///< number of primitives in the list, without a tree
    Vec3i eye{};                           ///< lattice point
    Vec3l corner{}, right{}, down{};       ///< M + guard_bits bits, signed
    ShadeFrame shade;
    template <class V> void fields(V& v, const Config& c) {
        if (c.is_stream()) {
            v("ray_count", ray_count, 2 * c.pixel_bits);
            v("rays", first_ray_line, c.addr_bits);
            if (c.writes_hits()) v("hits", first_hit_line, c.addr_bits);
        } else {
            v("width", width, c.pixel_bits + 1);
            v("height", height, c.pixel_bits + 1);
        }
        v("root", root, c.addr_bits);
        if (c.is_list()) v("listed", listed_primitives, c.addr_bits + 1);
        if (c.is_stream()) return;
        v("eye", eye, c.coord_bits, 3);
        v("corner", corner, c.guard_dir_bits(), 3);
        v("right", right, c.guard_dir_bits(), 3);
        v("down", down, c.guard_dir_bits(), 3);
        if (c.has_shade()) shade.fields(v, c);
    }
    /// Pixels of the picture, or rays of the stream.
    std::uint64_t pixels() const { return ray_count > 0 ? ray_count : std::uint64_t(width) * height; }
};

}   // namespace rayclock
