// Encodes and decodes blocks, and computes their lines of memory.
#include "sim/study/textures/block.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <stb_dxt.h>

#include "model/layout/words.hpp"

namespace rayclock::texture_study {

namespace {

using Code = std::array<std::uint8_t, 4>;

/// Returns the 8-bit codes of a colour of 5, 6 and 5 bits.
std::array<int, 3> expanded(int packed) {
    const int red = packed >> 11, green = packed >> 5 & 63, blue = packed & 31;
    return {red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2};
}

/// Returns the four colours of a block. If the first number is not the larger one, the third colour is the
/// mean of both, and the fourth is black.
std::array<Code, 4> palette_of(const std::array<std::uint8_t, 8>& block) {
    const int first = block[0] | block[1] << 8, second = block[2] | block[3] << 8;
    const std::array<int, 3> a = expanded(first), b = expanded(second);
    std::array<Code, 4> palette{};
    for (std::size_t k = 0; k < 3; ++k) {
        palette[0][k] = std::uint8_t(a[k]), palette[1][k] = std::uint8_t(b[k]);
        palette[2][k] = std::uint8_t(first > second ? (2 * a[k] + b[k] + 1) / 3 : (a[k] + b[k] + 1) / 2);
        palette[3][k] = std::uint8_t(first > second ? (a[k] + 2 * b[k] + 1) / 3 : 0);
    }
    return palette;
}

std::uint8_t alpha_bit(std::uint8_t alpha) { return alpha >= 128 ? 255 : 0; }

/// For tiles of 2^tile x 2^tile texels, return the logarithm of the number of lines of a level, and of the
/// lines in a row of tiles.
int level_lines_log(const TexRecord& record, std::uint32_t level, int tile) {
    return std::max(int(record.log_width) - int(level) - tile, 0) +
           std::max(int(record.log_height) - int(level) - tile, 0);
}
int columns_log(const TexRecord& record, std::uint32_t level, int tile) {
    return std::max(int(record.log_width) - int(level) - tile, 0);
}

}   // namespace

TexelLevel through_blocks(const TexelLevel& level) {
    TexelLevel out = level;
    const auto texel = [&](int x, int y) -> std::size_t {
        return std::size_t(std::min(y, level.height - 1)) * std::size_t(level.width) +
               std::size_t(std::min(x, level.width - 1));
    };
    for (int top = 0; top < level.height; top += block_side)
        for (int left = 0; left < level.width; left += block_side) {
            std::array<std::uint8_t, 4 * block_side * block_side> source{};
            for (int i = 0; i < block_side * block_side; ++i) {
                Code code = level.texels[texel(left + i % block_side, top + i / block_side)];
                code[3] = 255;
                std::ranges::copy(code, source.begin() + 4 * i);
            }
            std::array<std::uint8_t, 8> block{};
            stb_compress_dxt_block(block.data(), source.data(), 0, STB_DXT_HIGHQUAL);
            const std::array<Code, 4> palette = palette_of(block);
            for (int y = 0; y < block_side && top + y < level.height; ++y)
                for (int x = 0; x < block_side && left + x < level.width; ++x) {
                    Code code = palette[block[std::size_t(4 + y)] >> 2 * x & 3];
                    code[3] = alpha_bit(level.texels[texel(left + x, top + y)][3]);
                    out.texels[texel(left + x, top + y)] = code;
                }
        }
    return out;
}

TexelLevel through_rgb565(const TexelLevel& level) {
    TexelLevel out = level;
    for (Code& code : out.texels) {
        Line line{};
        put_texel(line, 0, 0, code, TexelFormat::rgb565);
        const TexelCode read = texel_of(line, 0, 0, TexelFormat::rgb565);
        for (std::size_t k = 0; k < 3; ++k) code[k] = std::uint8_t(read.code[k]);
        code[3] = std::uint8_t(read.alpha);
    }
    return out;
}

TexelLevel with_alpha(TexelLevel colours, const TexelLevel& alpha) {
    for (std::size_t i = 0; i < colours.texels.size(); ++i) colours.texels[i][3] = alpha.texels[i][3];
    return colours;
}

std::uint32_t block_lines(const TexRecord& record) {
    std::uint32_t lines = 0;
    for (std::uint32_t level = 0; level <= record.last_level; ++level)
        lines += 1u << level_lines_log(record, level, block_tile_log);
    return lines;
}

std::uint32_t block_line(const TexRecord& record, std::uint32_t rgb565_line) {
    constexpr TexelFormat format = TexelFormat::rgb565;
    constexpr int tile = tile_shape(format).log_width;
    static_assert(tile == tile_shape(format).log_height && block_tile_log == tile + 1);
    std::uint32_t first = record.base;
    for (std::uint32_t level = 0; level <= record.last_level; ++level) {
        const std::uint32_t begin = record.base + level_offset(record, level, format),
                            lines = 1u << level_lines_log(record, level, tile);
        if (rgb565_line >= begin && rgb565_line < begin + lines) {
            const std::uint32_t at = rgb565_line - begin;
            const int columns = columns_log(record, level, tile);
            const std::uint32_t column = at & ((1u << columns) - 1), row = at >> columns;
            return first + (row / 2 << columns_log(record, level, block_tile_log)) + column / 2;
        }
        first += 1u << level_lines_log(record, level, block_tile_log);
    }
    throw std::logic_error("a texel line lies outside its texture");
}

void move_texels(RecordedFrame& frame, const Job& job,
                 const std::function<std::uint32_t(const TexRecord&, std::uint32_t)>& moved) {
    if (job.config.has_instances()) throw std::logic_error("move_texels: the machine has two levels");
    for (const std::uint32_t* at : frame.trace.rays)
        for (bool finished = false; !finished;) {
            for (VisitWord visit; !visit.ends_ray();) {
                visit = {*at++};
                if (visit.has_tests())
                    while (!TestWord{*at++}.is_last()) {}
            }
            if (EndWord{*at}.is_record()) {
                const TexRecord record = unpack<TexRecord>(job.image.line(EndWord{*at}.line()), job.config);
                // The trace owns its words, and nothing replays it now.
                auto& line = const_cast<std::uint32_t&>(at[1]);
                line = moved(record, line);
                at += 2;
            }
            finished = EndWord{*at}.ends_pixel();
            at += 2;
        }
}

}   // namespace rayclock::texture_study
