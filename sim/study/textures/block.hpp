#pragma once
// Block compression (BC1), which this machine does not have: its effect on texels, and its lines of memory.
// The library stb (stb_dxt) encodes the blocks.
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

/// Returns a level after compression to blocks and decoding. Alpha is rounded to 0 or 255 as for rgb565,
/// because a line of blocks has one bit of alpha per texel. Sides below 4 are extended by their last texel.
TexelLevel through_blocks(const TexelLevel& level);

/// Returns a level after rounding to rgb565, as the chip reads it.
TexelLevel through_rgb565(const TexelLevel& level);

/// Returns the colours of one level with the alpha of another.
TexelLevel with_alpha(TexelLevel colours, const TexelLevel& alpha);

/// A line of blocks is a line of memory with four blocks for a tile of 8 x 8 texels. Two more blocks hold its
/// border of 17 texels to the right and below. Each of these 81 texels has a bit of alpha.
constexpr int block_tile_log = 3, blocks_of_line = 6;
constexpr int block_line_bits =
    blocks_of_line * block_bits + ((1 << block_tile_log) + 1) * ((1 << block_tile_log) + 1);
static_assert(block_line_bits <= line_bits);

/// Returns the number of lines of blocks for all levels of a texture, which follow each other without gaps.
std::uint32_t block_lines(const TexRecord& record);

/// Returns the line of blocks with the texels of a line of rgb565. In both formats the texture begins at
/// TexRecord::base.
std::uint32_t block_line(const TexRecord& record, std::uint32_t rgb565_line);

/// Replaces the lines of texels in the trace of a recorded frame. The machine must have one level. `moved`
/// gets the texture record and the line, and returns the new line.
void move_texels(RecordedFrame& frame, const Job& job,
                 const std::function<std::uint32_t(const TexRecord&, std::uint32_t)>& moved);

}   // namespace rayclock::texture_study
