// The pixel writer: model and RTL in every cycle, and every pixel in its place.
#include <algorithm>
#include <map>
#include <random>

#include "tests/board/video/video_dut.hpp"
#include <catch2/catch.hpp>

namespace pixel_writer_test {

using namespace rayclock;
using namespace rayclock::test;

/// The pixels of a picture with random colours, in an order that depends on `scatter`: 0 tile by tile, as the
/// chip starts them; else each pixel comes up to `scatter` places late.
std::vector<PixelWriterPair::Pixel> pixels_of(const ShownPicture& picture, int scatter, Draw& draw) {
    std::vector<std::pair<std::uint64_t, PixelWriterPair::Pixel>> keyed;
    for (std::uint32_t tile_y = 0; tile_y < picture.height; tile_y += 8)
        for (std::uint32_t tile_x = 0; tile_x < picture.width; tile_x += 8)
            for (std::uint32_t y = tile_y; y < std::min(tile_y + 8, picture.height); ++y)
                for (std::uint32_t x = tile_x; x < std::min(tile_x + 8, picture.width); ++x)
                    keyed.push_back({keyed.size() + std::uint64_t(draw.below(scatter + 1)),
                                     {x, y, std::uint32_t(draw.bits(24))}});
    std::ranges::stable_sort(keyed, {}, [](const auto& k) { return k.first; });
    std::vector<PixelWriterPair::Pixel> pixels;
    for (const auto& [key, pixel] : keyed) pixels.push_back(pixel);
    return pixels;
}

/// Writes all pixels, then flushes.
void write_all(PixelWriterPair& writer, const std::vector<PixelWriterPair::Pixel>& pixels,
               const ShownPicture& picture, int offers, int accepts, Draw& draw) {
    std::size_t next = 0;
    for (int waited = 0; next < pixels.size();) {
        const bool offer = draw.percent(offers);
        const bool accepted = writer.clock(offer ? std::optional(pixels[next]) : std::nullopt, picture,
                                           draw.percent(1), accepts);
        waited = accepted ? 0 : waited + 1;
        REQUIRE(waited < 20000);
        next += accepted;
    }
    for (int waited = 0; !writer.model.empty() || waited == 0; ++waited) {
        REQUIRE(waited < 100000);
        writer.clock({}, picture, true, accepts);
    }
}

TEST_CASE("the pixel writer puts every pixel in its place, in the model's cycles", "[board][pixels]") {
    struct Size {
        std::uint32_t width, height;
    };
    const Size size =
        GENERATE(Size{1, 1}, Size{5, 3}, Size{33, 17}, Size{64, 48}, Size{1023, 5}, Size{3, 1023});
    const int scatter = GENERATE(0, 20, 100000), accepts = GENERATE(100, 40);
    CAPTURE(size.width, size.height, scatter, accepts);
    Draw draw{7};
    const ShownPicture picture{1000, size.width, size.height};
    LineMemory memory(1000 + picture.blocks_across() * picture.blocks_down() + 1);
    for (PixelLine& line : memory) line.fill(0xa5a5);
    const LineMemory before = memory;
    PixelWriterPair writer(memory, 3);
    const std::vector<PixelWriterPair::Pixel> pixels = pixels_of(picture, scatter, draw);
    write_all(writer, pixels, picture, accepts == 100 ? 100 : 60, accepts, draw);
    LineMemory expected = before;
    for (const auto& [x, y, colour] : pixels) {
        PixelLine& line = expected.at(line_of(picture, x, y));
        line[2 * (4 * (y % 4) + x % 4)] = std::uint16_t(colour);
        line[2 * (4 * (y % 4) + x % 4) + 1] = std::uint16_t(colour >> 16);
    }
    REQUIRE(memory == expected);
}

TEST_CASE("tiles cost one write per block", "[board][pixels]") {
    Draw draw{7};
    const ShownPicture picture{0, 64, 48};
    LineMemory memory(16 * 12);
    PixelWriterPair writer(memory, 3);
    const std::vector<PixelWriterPair::Pixel> pixels = pixels_of(picture, 0, draw);
    for (std::size_t next = 0; next < pixels.size();) next += writer.clock(pixels[next], picture, false, 100);
    while (!writer.model.empty()) writer.clock({}, picture, true, 100);
    std::ranges::sort(writer.written);
    REQUIRE(writer.written.size() == 16 * 12);
    for (std::uint32_t line = 0; line < 16 * 12; ++line) REQUIRE(writer.written[line] == line);
}

TEST_CASE("the block that was begun first is written first", "[board][pixels]") {
    // Five blocks with a pixel each; only four fit.
    LineMemory memory(100);
    const ShownPicture picture{0, 40, 8};
    PixelWriterPair writer(memory, 3);
    for (const std::uint32_t x : {20u, 4u, 36u, 0u, 12u})
        while (!writer.clock(PixelWriterPair::Pixel{x, 5, x}, picture, false, 100)) {}
    for (int i = 0; i < 200; ++i) writer.clock({}, picture, false, 100);
    REQUIRE(writer.written == std::vector<std::uint32_t>{15});
    REQUIRE_FALSE(writer.model.empty());
    for (int i = 0; i < 400; ++i) writer.clock({}, picture, true, 100);
    REQUIRE(writer.written == std::vector<std::uint32_t>{15, 11, 19, 10, 13});
    REQUIRE(writer.model.empty());
}

TEST_CASE("a full block is written before an older one that is not full", "[board][pixels]") {
    LineMemory memory(100);
    const ShownPicture picture{0, 40, 8};
    PixelWriterPair writer(memory, 3);
    while (!writer.clock(PixelWriterPair::Pixel{39, 0, 1}, picture, false, 100)) {}
    for (std::uint32_t i = 0; i < 16; ++i)
        while (!writer.clock(PixelWriterPair::Pixel{4 + i % 4, i / 4, i}, picture, false, 100)) {}
    for (int i = 0; i < 200; ++i) writer.clock({}, picture, false, 100);
    REQUIRE(writer.written == std::vector<std::uint32_t>{1});
}

}   // namespace pixel_writer_test
