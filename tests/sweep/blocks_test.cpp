// Block compression in the study of textures: decoded texels, and the lines of larger tiles.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

#include "sim/study/textures/block.hpp"

using namespace rayclock;
using namespace rayclock::texture_study;

namespace {

TexelLevel level_of(int width, int height, const auto& texel) {
    TexelLevel level{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) level.texels.push_back(texel(x, y));
    return level;
}

using Code = std::array<std::uint8_t, 4>;

}   // namespace

TEST_CASE("a block of two colours that the format can store keeps both") {
    const Code a{255, 0, 0, 255}, b{0, 255, 255, 255};
    const TexelLevel level = level_of(16, 8, [&](int x, int y) { return (x * 5 + y * 3) % 7 < 3 ? a : b; });
    CHECK(through_blocks(level).texels == level.texels);
    const TexelLevel one = level_of(8, 8, [&](int, int) { return Code{247, 251, 0, 255}; });
    for (const Code& code : through_blocks(one).texels) CHECK(code == Code{247, 251, 0, 255});
}

TEST_CASE("a block has four colours, its own two and two at thirds between them") {
    // Steps of a third of 255 between black and white are exact, and no other grey is one of them.
    const auto grey = [](int code) {
        return Code{std::uint8_t(code), std::uint8_t(code), std::uint8_t(code), 255};
    };
    const TexelLevel thirds = level_of(4, 4, [&](int x, int) { return grey(85 * x); });
    CHECK(through_blocks(thirds).texels == thirds.texels);
    const TexelLevel ramp = level_of(4, 4, [&](int x, int y) { return grey(17 * (4 * y + x)); });
    std::set<Code> colours;
    for (const Code& code : through_blocks(ramp).texels) colours.insert(code);
    CHECK(colours.size() == 4);
}

TEST_CASE("a picture without whole blocks is extended, and alpha is rounded to one bit") {
    const TexelLevel small = level_of(2, 1, [](int x, int) {
        return x == 0 ? Code{255, 0, 0, 127} : Code{0, 0, 255, 128};
    });
    const TexelLevel coded = through_blocks(small);
    REQUIRE(coded.texels.size() == 2);
    CHECK(coded.texels[0] == Code{255, 0, 0, 0});
    CHECK(coded.texels[1] == Code{0, 0, 255, 255});
    CHECK(with_alpha(coded, small).texels == small.texels);
}

TEST_CASE("the texels of four lines of rgb565 share a line of blocks") {
    for (std::uint32_t log_width = 0; log_width <= 7; ++log_width)
        for (std::uint32_t log_height = 0; log_height <= 7; ++log_height) {
            INFO(log_width << " x " << log_height);
            TexRecord record;
            record.base = 1000;
            record.log_width = log_width, record.log_height = log_height;
            record.last_level = std::max(log_width, log_height);
            // The tile of 8 x 8 texels in which each texel lies, by level, column and row.
            std::map<std::array<std::uint32_t, 3>, std::set<std::uint32_t>> lines;
            for (std::uint32_t level = 0; level <= record.last_level; ++level) {
                const std::uint32_t width = std::max(1u << log_width >> level, 1u),
                                    height = std::max(1u << log_height >> level, 1u);
                for (std::uint32_t y = 0; y < height; ++y)
                    for (std::uint32_t x = 0; x < width; ++x) {
                        const std::uint32_t narrow = record.base +
                                                     level_offset(record, level, TexelFormat::rgb565) +
                                                     y / 4 * std::max(width / 4, 1u) + x / 4;
                        lines[{level, x / 8, y / 8}].insert(block_line(record, narrow));
                    }
            }
            std::set<std::uint32_t> all;
            for (const auto& [tile, found] : lines) {
                CHECK(found.size() == 1);
                all.insert(found.begin(), found.end());
            }
            CHECK(all.size() == lines.size());   // no two tiles share a line
            CHECK(all.size() == block_lines(record));
            CHECK(*all.begin() == record.base);
            CHECK(*all.rbegin() == record.base + block_lines(record) - 1);
        }
}
