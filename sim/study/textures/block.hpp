#pragma once
// Block compression (BC1), which this machine does not have: its effect on texels, and its lines of memory.
// The encoder is that of the library stb.
#include <cstdint>
#include <functional>

#include "model/core/lines.hpp"
#include "model/scene/texture.hpp"
#include "model/unit/tex/texel.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock::texture_study {

/// A block has 4 x 4 texels in 64 bits: two colours of 5, 6 and 5 bits, and 2 bits for each texel, which
/// select one of these colours or of the two colours at thirds between them.
constexpr int block_side = 4, block_bits = 64;

/// Returns a level after compression to blocks and decoding. Alpha is rounded to 0 or 255, as for rgb565:
/// a line of block_tile has one bit of alpha for each texel. Sides below 4 are extended by their last texel.
TexelLevel through_blocks(const TexelLevel& level);

/// Returns a level after rounding to rgb565, as the chip reads it.
TexelLevel through_rgb565(const TexelLevel& level);

/// Returns the colours of one level with the alpha of another.
TexelLevel with_alpha(TexelLevel colours, const TexelLevel& alpha);

/// The texels in a line of memory, if a line has four blocks for 8 x 8 texels, two blocks for the border of
/// 17 texels to the right and below, and a bit of alpha for each of these 81 texels.
constexpr int block_tile_log = 3, blocks_of_line = 6;
constexpr int block_line_bits =
    blocks_of_line * block_bits + ((1 << block_tile_log) + 1) * ((1 << block_tile_log) + 1);
static_assert(block_line_bits <= line_bits);

/// Returns the lines of all levels of a texture, one level after the other without gaps.
std::uint32_t block_lines(const TexRecord& record);

/// Returns the line of block_tile that holds the texels of a line of rgb565. Both begin at the record's base.
std::uint32_t block_line(const TexRecord& record, std::uint32_t rgb565_line);

/// Replaces the lines of texels in a recorded frame of a machine with one level. `moved` gets the texture
/// record and the line, and returns the new line.
void move_texels(RecordedFrame& frame, const Job& job,
                 const std::function<std::uint32_t(const TexRecord&, std::uint32_t)>& moved);

}   // namespace rayclock::texture_study
