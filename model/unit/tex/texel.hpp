#pragma once
// The layout of textures in memory, and the work of the unit tex on one hit. tex.hpp has its timing.
//
// A level's texels lie in tiles, row by row, a tile in each line of memory. A tile has 4 x 2 texels for
// rgb888 and 4 x 4 for rgb565. A line also holds the texels to the right of its tile and below it, according
// to the texture's wrap modes. So the four texels of a bilinear filter always lie in one line.
#include "model/core/payloads.hpp"

namespace rayclock {

/// The tiles of a texel format.
struct TileShape {
    int log_width, log_height;   ///< logarithms of the tile's sides, in texels
    int bits;                    ///< of a texel: red, green, blue, alpha; red highest
    constexpr int width() const { return (1 << log_width) + 1; }   ///< texels in a row of a line
    constexpr int texels() const { return width() * ((1 << log_height) + 1); }
};
constexpr TileShape tile_shape(TexelFormat format) {
    return format == TexelFormat::rgb888 ? TileShape{2, 1, 32} : TileShape{2, 2, 17};
}
static_assert(tile_shape(TexelFormat::rgb888).texels() * 32 <= line_bits);
static_assert(tile_shape(TexelFormat::rgb565).texels() * 17 <= line_bits);

/// Returns the logarithm of the number of a level's lines. The sides are logarithms of texels.
constexpr int lines_log(int log_width, int log_height, TexelFormat format) {
    const TileShape tile = tile_shape(format);
    return std::max(log_width - tile.log_width, 0) + std::max(log_height - tile.log_height, 0);
}
/// Returns the first line of a level, counted from the first line of level 0. A level of 2^e lines, e > 0,
/// begins 2^e + 2 lines after the end of level 0. At most three levels have one line; they precede the
/// others, the smallest first.
std::uint32_t level_offset(const TexRecord& record, std::uint32_t level, TexelFormat format);
/// Returns the lines from the first line of level 0 to the end of the last one.
std::uint32_t texture_lines(const TexRecord& record, TexelFormat format);

/// Returns log2(x) with level_frac fraction bits, for x from 0 to 2^32 - 1. The five bits below the highest
/// set bit index a table of fractions. Each entry is the logarithm at the middle of its range, rounded to
/// nearest. The error is below 0.031. log2(0) counts as 0.
std::uint32_t log_of(std::uint32_t x);
constexpr int log_index_bits = 5;
/// Returns the fraction for each value of these bits.
const std::array<std::uint32_t, 1 << log_index_bits>& log_fractions();

/// The place of a hit in a texture.
struct TexelPlace {
    std::uint32_t line = 0;
    std::uint32_t level = 0;
    std::uint32_t x = 0, y = 0;                 ///< within the tile
    std::uint32_t weight_x = 0, weight_y = 0;   ///< of the texels to the right and below, texel_frac bits
    std::uint32_t cutoff = 0;                   ///< as in TexRecord
    /// The fields that the unit stores until the texels arrive.
    template <class V> void fields(V& v, const Config&) {
        v("x", x, 2);
        v("y", y, 2);
        v("weight_x", weight_x, texel_frac);
        v("weight_y", weight_y, texel_frac);
        v("cutoff", cutoff, 8);
    }
};
/// Returns the level of a hit, 0 to TexRecord::last_level. It is 0 for a path of 0, otherwise log2 of the
/// number of texels across a sample, rounded to nearest. The sample's width is spread * path / sqrt(cosine).
/// This is a ray cone (Akenine-Moeller et al. 2021) whose width grows only with the length of the path.
std::uint32_t level_of(const TexReq& hit, const TexRecord& record, std::int32_t spread);
/// Returns the place of a hit. The corners' coordinates are interpolated by u and v and rounded down once, to
/// coordinate_frac bits. Where a plane's u or v is saturated, the level is the last one. Mirror of
/// rtl/unit/tex/rc_texel_address.sv.
TexelPlace texel_place(const TexReq& hit, const TexRecord& record, std::int32_t spread, const Config& config);

/// Returns a channel's intensity, share_bits fraction bits, for an sRGB code (IEC 61966-2-1), rounded to
/// nearest.
const std::array<std::uint32_t, 256>& srgb_table();
/// Returns the colour of a bilinear filter, rounded once, to nearest. Weights of 0 give the nearest texel.
/// Alpha is filtered in the same way and compared with the cut-off, without rounding. Mirror of
/// rtl/unit/tex/rc_texel_filter.sv.
TexRsp filter_texels(const Line& line, const TexelPlace& place, TexelFormat format);

/// A texel of a line: codes of 8 bits. A shorter code is extended by repeating its upper bits.
struct TexelCode {
    std::array<std::uint32_t, 3> code{};
    std::uint32_t alpha = 0;
};
TexelCode texel_of(const Line& line, std::uint32_t x, std::uint32_t y, TexelFormat format);
/// Writes a texel. Rounds codes to the nearest code of the format.
void put_texel(Line& line, std::uint32_t x, std::uint32_t y, const std::array<std::uint8_t, 4>& texel,
               TexelFormat format);

}   // namespace rayclock
