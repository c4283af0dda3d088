#pragma once
// Chips with textures, random texture records and hits, and the rules of unit tex in exact integers. The
// rules follow the comments of TexRecord, TexReq and model/unit/tex/texel.hpp, but call no function of that
// file.
#include <cmath>
#include <vector>

#include "model/engine/check.hpp"
#include "tests/support/cases/chip_name.hpp"
#include "tests/support/cases/draw.hpp"

namespace rayclock::test {

__extension__ using Int128 = __int128;

/// Returns a chip with textures. "rgb888" has the widths of default, "rgb565" those of ulx3s-shaded. "narrow"
/// has few contexts, few bits of u and v, and the shortest addresses. "fine" has the most bits of u and v.
/// "levels" has two levels. "planes" has planes, whose u and v are signed. "wide" has planes and the widest u
/// and v.
inline Config tex_config(const std::string& name) {
    check_base(name, {"rgb888", "rgb565", "narrow", "fine", "levels", "planes", "wide"});
    Config c = named_config(name == "rgb565" ? "ulx3s-shaded" : "default");
    c.name = name;
    c.shading = c.textures = 1;
    c.texels = name == "rgb565" || name == "narrow" ? TexelFormat::rgb565 : TexelFormat::rgb888;
    if (name == "narrow") c.contexts = 2, c.bary_bits = 4, c.addr_bits = 16, c.origin_bits = 4;
    if (name == "fine") c.bary_bits = 24;
    if (name == "levels") c.levels = 2;
    if (name == "planes" || name == "wide") c.planes = 1;
    if (name == "wide") c.bary_bits = 19, c.t_frac_bits = 8;
    check_config(c, name);
    return c;
}

// ---- The rules.

inline Int128 floor_by(Int128 x, Int128 by) { return x / by - (x % by < 0); }

/// Returns 64 log2(m), not rounded. m is the middle of part `part` when the octave from 1 to 2 is divided
/// into 32 parts.
inline long double exact_log_in_64ths(int part) { return 64 * std::log2((32 + part + 0.5L) / 32); }

/// Returns 64 log2(m), rounded to nearest; 0 for x = 0. m is the middle of x's part when its octave is
/// divided into 32 parts.
inline int log_in_64ths(std::uint32_t x) {
    static const std::vector<int> parts = [] {
        std::vector<int> values;
        for (int i = 0; i < 32; ++i) values.push_back(int(std::floor(exact_log_in_64ths(i) + 0.5L)));
        return values;
    }();
    if (x == 0) return 0;
    int whole = 0, part = 0;
    while (std::uint64_t(2) << whole <= x) ++whole;
    while (std::uint64_t(33 + part) << whole <= std::uint64_t(32) * x) ++part;
    return 64 * whole + parts[std::size_t(part)];
}

/// Returns 64 times the contribution of a slanted view to the level. The table's logarithm of a cosine of 1
/// is slightly above 0.
inline int slant_in_64ths(std::uint32_t cosine) {
    const int lost = 64 * 16 - log_in_64ths(cosine);
    return lost > 0 ? lost / 2 : 0;
}
/// Returns 64 times the level of a hit before it is rounded and clamped.
inline int level_in_64ths(const TexReq& hit, const TexRecord& record, int spread) {
    return record.density + hit.scale + spread + log_in_64ths(hit.path) + slant_in_64ths(hit.cosine);
}
/// Returns u or v of a hit as a whole number of 2^-bary_bits.
inline Int128 weight_in(std::uint32_t x, const Config& c) {
    const Int128 range = Int128(1) << c.uv_bits();
    return c.planes && 2 * Int128(x) >= range ? Int128(x) - range : Int128(x);
}
/// True if u or v lies at an end of its range, on a plane.
inline bool is_at_end(const TexReq& hit, const Config& c) {
    const Int128 most = (Int128(1) << (c.uv_bits() - 1)) - 1;
    const auto ends = [&](std::uint32_t x) {
        return weight_in(x, c) == most || weight_in(x, c) == -most - 1;
    };
    return c.planes && (ends(hit.u) || ends(hit.v));
}
/// A path of 0 selects level 0.
inline int wanted_level(const TexReq& hit, const TexRecord& record, int spread) {
    if (hit.path == 0) return 0;
    const auto nearest = int(floor_by(level_in_64ths(hit, record, spread) + 32, 64));
    return nearest < 0 ? 0 : nearest > int(record.last_level) ? int(record.last_level) : nearest;
}

/// A place on one axis of a level: the first of two texels, and the weight of the second in 256ths.
struct AxisPlace {
    int texel = 0, weight = 0;
};
/// `side`: the level's texels on this axis. The coordinate is exact until it is rounded down to 2^-20
/// pictures, and once more to 256ths of a texel.
inline AxisPlace wanted_on_axis(const TexReq& hit, const std::array<std::int32_t, 3>& corner, int side,
                                WrapMode wrap, bool nearest, const Config& c) {
    const Int128 one = Int128(1) << c.bary_bits, picture = Int128(1) << 20;
    const Int128 u = weight_in(hit.u, c), v = weight_in(hit.v, c);
    const Int128 sum = Int128(corner[0]) * (one - u - v) + Int128(corner[1]) * u + Int128(corner[2]) * v;
    Int128 at = floor_by(sum, one);
    if (wrap == WrapMode::repeat) {
        at -= picture * floor_by(at, picture);
    } else if (wrap == WrapMode::mirror) {
        at -= 2 * picture * floor_by(at, 2 * picture);
        if (at >= picture) at = 2 * picture - 1 - at;
    } else if (at < 0) {
        at = 0;
    } else if (at >= picture) {
        at = picture - 1;
    }
    auto place = int(floor_by(at * side * 256, picture));
    if (nearest) return {place / 256, 0};
    place -= 128;
    if (place < 0) place = wrap == WrapMode::repeat ? place + 256 * side : 0;
    return {place / 256, place % 256};
}

/// The texels of a tile's sides, and the bits of a texel.
struct WantedTile {
    int width, height, bits;
};
inline WantedTile wanted_tile(TexelFormat format) {
    return format == TexelFormat::rgb888 ? WantedTile{4, 2, 32} : WantedTile{4, 4, 17};
}
inline int tiles_on(int side, int tile) { return side > tile ? side / tile : 1; }

struct WantedPlace {
    std::uint32_t line = 0;
    int level = 0, x = 0, y = 0, weight_x = 0, weight_y = 0;   ///< x, y: within the tile
    int cutoff = 0;
};
inline WantedPlace wanted_place(const TexReq& hit, const TexRecord& record, int spread, const Config& c) {
    const WantedTile tile = wanted_tile(c.texels);
    WantedPlace place;
    place.cutoff = int(record.cutoff);
    place.level =
        hit.path != 0 && is_at_end(hit, c) ? int(record.last_level) : wanted_level(hit, record, spread);
    const auto halved = [](std::uint32_t log, int times) { return std::max((1 << log) >> times, 1); };
    const auto lines = [&](int level) {
        return tiles_on(halved(record.log_width, level), tile.width) *
               tiles_on(halved(record.log_height, level), tile.height);
    };
    const int width = halved(record.log_width, place.level), height = halved(record.log_height, place.level);
    const AxisPlace x = wanted_on_axis(hit, record.s, width, record.wrap_s, record.nearest, c),
                    y = wanted_on_axis(hit, record.t, height, record.wrap_t, record.nearest, c);
    place.x = x.texel % tile.width, place.y = y.texel % tile.height;
    place.weight_x = x.weight, place.weight_y = y.weight;
    Int128 line = record.base;
    if (place.level > 0) {
        line += lines(0);
        if (lines(place.level) > 1)
            line += lines(place.level) + 2;
        else
            line += int(record.last_level) - place.level;
    }
    line += y.texel / tile.height * tiles_on(width, tile.width) + x.texel / tile.width;
    place.line = std::uint32_t(line % (Int128(1) << c.addr_bits));
    return place;
}

/// Returns the bits of a texel, taken from the line one by one.
inline std::uint32_t texel_bits(const Line& line, int x, int y, TexelFormat format) {
    const WantedTile tile = wanted_tile(format);
    const int first = (y * (tile.width + 1) + x) * tile.bits;
    std::uint32_t bits = 0;
    for (int i = 0; i < tile.bits; ++i) {
        const auto at = std::size_t(first + i);
        bits |= (line[at / 32] >> at % 32 & 1) << i;
    }
    return bits;
}
/// Returns the 8-bit code of a channel: red, green, blue.
inline std::uint32_t texel_code(std::uint32_t bits, std::size_t channel, TexelFormat format) {
    if (format == TexelFormat::rgb888) return bits >> (24 - 8 * channel) & 255;
    // A code of 5 or 6 bits, extended by repeating its upper bits.
    const std::uint32_t code = channel == 0 ? bits >> 12 : channel == 1 ? bits >> 6 & 63 : bits >> 1 & 31;
    return channel == 1 ? 4 * code + code / 16 : 8 * code + code / 4;
}
/// Returns the linear light of an sRGB code.
inline long double linear_of(std::uint32_t code) {
    const long double x = (long double)(code) / 255;
    return x <= 0.04045L ? x / 12.92L : std::pow((x + 0.055L) / 1.055L, 2.4L);
}
inline int intensity_of(std::uint32_t code) {
    static const std::vector<int> all = [] {
        std::vector<int> values;
        for (std::uint32_t i = 0; i < 256; ++i)
            values.push_back(int(std::floor(linear_of(i) * (1 << share_bits) + 0.5L)));
        return values;
    }();
    return all[code];
}
/// Returns the alpha of a texel, 0 to 255.
inline int texel_alpha(std::uint32_t bits, TexelFormat format) {
    if (format == TexelFormat::rgb888) return int(bits % 256);
    return bits % 2 != 0 ? 255 : 0;
}
/// Returns 65536 times the weighted mean of a value of four texels.
template <class F>
std::int64_t filtered_sum(const Line& line, const WantedPlace& place, TexelFormat format, const F& value) {
    std::int64_t sum = 0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
            sum += std::int64_t(value(texel_bits(line, place.x + i, place.y + j, format))) *
                   (i == 0 ? 256 - place.weight_x : place.weight_x) *
                   (j == 0 ? 256 - place.weight_y : place.weight_y);
    return sum;
}
/// Returns 65536 times the difference between alpha and the cut-off. There is a hole if it is negative.
inline std::int64_t above_cutoff(const Line& line, const WantedPlace& place, TexelFormat format) {
    const std::int64_t alpha =
        filtered_sum(line, place, format, [&](std::uint32_t bits) { return texel_alpha(bits, format); });
    return alpha - 65536 * std::int64_t(place.cutoff);
}
/// Returns the weighted mean of four texels, rounded half up, and whether there is a hole. Does not set
/// `ray`.
inline TexRsp wanted_answer(const Line& line, const WantedPlace& place, TexelFormat format) {
    TexRsp answer;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t sum = filtered_sum(line, place, format, [&](std::uint32_t bits) {
            return intensity_of(texel_code(bits, k, format));
        });
        answer.colour[k] = std::uint32_t((sum + 32768) / 65536);
    }
    answer.hole = above_cutoff(line, place, format) < 0;
    return answer;
}

// ---- Random operands.

/// Draws a coordinate: any number, or one within 2 of a border of texels, of half texels, or of pictures.
inline std::int32_t random_coordinate(Draw& draw) {
    if (draw.coin()) return std::int32_t(draw.number(coordinate_bits));
    const int step = draw.between(coordinate_frac - max_side_log - 1, coordinate_frac + 1);
    const std::int64_t border = std::int64_t(draw.number(coordinate_bits - step)) << step;
    const std::int64_t most = (1 << (coordinate_bits - 1)) - 1;
    return std::int32_t(std::clamp<std::int64_t>(border + draw.between(-2, 2), -most - 1, most));
}
inline std::array<std::int32_t, 3> random_corners(Draw& draw) {
    std::array<std::int32_t, 3> corners{};
    for (auto& x : corners) x = random_coordinate(draw);
    // Equal corners give exactly this coordinate.
    if (draw.percent(40)) corners[1] = corners[2] = corners[0];
    return corners;
}

/// Draws a record. It has all levels that its sides allow, or level 0 alone.
inline TexRecord random_record(Draw& draw, const Config& c) {
    TexRecord record;
    record.s = random_corners(draw), record.t = random_corners(draw);
    record.base = std::uint32_t(draw.natural(c.addr_bits));
    const auto side = [&] {
        return std::uint32_t(draw.coin()   ? draw.between(0, max_side_log)
                             : draw.coin() ? 0
                             : draw.coin() ? max_side_log
                                           : draw.between(1, 3));
    };
    record.log_width = side(), record.log_height = side();
    record.wrap_s = WrapMode(draw.below(3)), record.wrap_t = WrapMode(draw.below(3));
    record.nearest = draw.percent(25);
    record.last_level = draw.percent(15) ? 0 : std::max(record.log_width, record.log_height);
    record.density = std::int32_t(draw.number(level_bits));
    record.cutoff = std::uint32_t(draw.percent(20) ? 0 : draw.percent(20) ? 255 : draw.natural(8));
    return record;
}

/// Draws a hit. Does not set `ray` and `record`.
inline TexReq random_hit(Draw& draw, const Config& c) {
    TexReq hit;
    hit.path = std::uint32_t(draw.natural(draw.coin() ? c.path_bits() : draw.between(1, c.path_bits())));
    if (draw.percent(5)) hit.path = 0;
    const std::uint32_t one = 1u << unit_bits;
    hit.cosine = draw.percent(20) ? one : std::min(std::uint32_t(draw.natural(unit_bits)), one);
    const std::uint32_t side = 1u << c.bary_bits;
    hit.u = std::min(std::uint32_t(draw.percent(10) ? side : draw.natural(c.bary_bits)), side);
    hit.v = std::min(std::uint32_t(draw.percent(30) ? side : draw.natural(c.bary_bits)), side - hit.u);
    // A plane's u and v: anywhere, near a whole side, or at an end or next to it.
    const auto on_plane = [&] {
        const std::int64_t whole = draw.number(plane_bits + 1), half = std::int64_t(1) << (c.uv_bits() - 1);
        const std::int64_t near = (whole << c.bary_bits) + draw.between(-2, 2),
                           end = draw.coin() ? half - 1 - draw.below(2) : -half + draw.below(2),
                           x = draw.percent(20) ? end
                               : draw.coin()    ? near
                                                : draw.number(c.uv_bits());
        return std::uint32_t(std::clamp(x, -half, half - 1)) & std::uint32_t((2 * half) - 1);
    };
    if (c.planes && draw.percent(70)) hit.u = on_plane(), hit.v = draw.percent(20) ? hit.v : on_plane();
    if (c.has_homes()) hit.scale = std::int32_t(draw.number(draw.coin() ? level_bits : 10));
    return hit;
}

/// Changes the density so that the level lies within the texture's levels, or next to them, often exactly
/// halfway between two levels.
inline void aim_level(Draw& draw, const TexReq& hit, TexRecord& record, int spread) {
    const int target = 64 * draw.between(-1, int(record.last_level) + 1) +
                       (draw.coin() ? 32 : draw.below(64)) + draw.between(-1, 1);
    const int most = (1 << (level_bits - 1)) - 1;
    record.density =
        std::clamp(record.density + target - level_in_64ths(hit, record, spread), -most - 1, most);
}

inline Line random_texels(Draw& draw) {
    Line line{};
    for (auto& word : line) word = std::uint32_t(draw.bits(32));
    return line;
}
/// Replaces the alpha of a texel: 8 bits, or 1 bit.
inline void set_alpha(Line& line, int x, int y, std::uint32_t alpha, TexelFormat format) {
    const WantedTile tile = wanted_tile(format);
    const auto first = std::size_t((y * (tile.width + 1) + x) * tile.bits);
    for (std::size_t i = 0; i < (format == TexelFormat::rgb888 ? 8 : 1); ++i) {
        std::uint32_t& word = line[(first + i) / 32];
        const std::uint32_t bit = 1u << (first + i) % 32;
        word = alpha >> i & 1 ? word | bit : word & ~bit;
    }
}
/// Draws texels whose alpha is often the cut-off, or differs from it by 1. An alpha of one bit is often 1 in
/// all texels, or in none.
inline Line random_texels(Draw& draw, std::uint32_t cutoff, TexelFormat format) {
    Line line = random_texels(draw);
    const int how = draw.below(4);   // 0: at random; 1: all one below, at or above; 2: each its own; 3: few
    if (how == 0) return line;
    const WantedTile tile = wanted_tile(format);
    const int all = draw.between(-1, 1);
    for (int y = 0; y <= tile.height; ++y)
        for (int x = 0; x <= tile.width; ++x) {
            const int beside = how == 1 ? all : how == 2 ? draw.between(-1, 1) : draw.percent(10) ? all : 0;
            set_alpha(line, x, y,
                      format == TexelFormat::rgb888 ? std::uint32_t(std::clamp(int(cutoff) + beside, 0, 255))
                                                    : std::uint32_t(beside >= 0),
                      format);
        }
    return line;
}

}   // namespace rayclock::test
