// The video path: TMDS by the rules of DVI, the clocks, and whole pictures from the chip's pixels to a
// screen.
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>

#include "tests/board/video/video_dut.hpp"
#include <catch2/catch.hpp>

namespace screen_test {

using namespace rayclock;
using namespace rayclock::test;

/// One channel's encoder.
class Encoder {
public:
    Encoder() : rtl_(video_config(), "rc_tmds") {}
    /// Sends a byte, or a control symbol, and returns what was sent two clocks before.
    std::uint16_t clock(std::optional<std::uint8_t> byte, std::uint8_t control = 0) {
        de_ = byte.has_value();
        data_ = byte.value_or(0x5a);
        control_ = control;
        rtl_.settle();
        const std::uint16_t symbol = std::uint16_t(symbol_);
        rtl_.clock();
        return symbol;
    }

private:
    RtlModule rtl_;
    Signal de_{rtl_, "de"}, data_{rtl_, "data"}, control_{rtl_, "control"}, symbol_{rtl_, "symbol"};
};

int disparity_of(std::uint16_t symbol) { return 2 * std::popcount(symbol) - 10; }

/// Returns the byte of a symbol.
std::uint8_t byte_of(std::uint16_t symbol) {
    const unsigned sent = symbol >> 9 ? ~unsigned(symbol) : symbol;
    unsigned byte = sent & 1;
    for (int i = 1; i < 8; ++i) {
        const unsigned changed = (sent >> i ^ sent >> (i - 1)) & 1;
        byte |= (symbol >> 8 & 1 ? changed : changed ^ 1) << i;
    }
    return std::uint8_t(byte);
}

/// Everything from pixels to the screen.
class Board {
public:
    explicit Board(std::uint32_t khz) : khz_(khz), scan_(khz), video_(khz, receiver) {}
    /// Simulates until the screen has shown so many frames, or gives up after three frames more.
    void show(std::uint64_t frames, const ShownPicture& picture, ReadPort& port) {
        const std::uint64_t most = (frames + 3) * 800 * 525 * khz_ / 25000;
        for (std::uint64_t i = 0; screen.frames() < frames && i < most; ++i)
            video_.clock(scan_.clock(picture, port));
        REQUIRE(screen.frames() == frames);
    }
    void require_sound() {
        REQUIRE(screen.errors() == std::vector<std::string>{});
        REQUIRE(receiver.errors() == std::vector<std::string>{});
        REQUIRE(receiver.is_aligned());
        REQUIRE_FALSE(video_.overflow());
        REQUIRE_FALSE(video_.underflow());
        REQUIRE(scan_.model.underruns() == 0);
    }

    Screen screen;
    TmdsReceiver receiver{screen};

private:
    std::uint32_t khz_;
    ScanOutPair scan_;
    Video video_;
};

TEST_CASE("every byte at every disparity is balanced and comes back", "[board][tmds]") {
    // A breadth-first search of the encoder's states: the disparities that it can reach, with bytes to each.
    std::map<int, std::vector<std::uint8_t>> paths{{0, {}}};
    std::vector<int> open{0};
    Encoder encoder;
    const auto send = [&](std::optional<std::uint8_t> byte) { return encoder.clock(byte); };
    while (!open.empty()) {
        const int from = open.back();
        open.pop_back();
        for (int byte = 0; byte < 256; ++byte) {
            std::vector<std::uint8_t> path = paths[from];
            path.push_back(std::uint8_t(byte));
            for (int i = 0; i < 3; ++i) send({});
            std::vector<std::uint16_t> symbols;
            for (const std::uint8_t b : path) symbols.push_back(send(b));
            symbols.push_back(send({}));
            symbols.push_back(send({}));
            symbols.erase(symbols.begin(), symbols.begin() + 2);
            int sum = 0;
            Screen screen(ScreenMode{.width = 1, .height = 1});   // judges each symbol by the rules
            screen.symbols({0b1101010100, 0b1101010100, 0b1101010100});
            for (std::size_t i = 0; i < path.size(); ++i) {
                REQUIRE(byte_of(symbols[i]) == path[i]);
                screen.symbols({symbols[i], symbols[i], symbols[i]});
                sum += disparity_of(symbols[i]);
                REQUIRE(std::abs(sum) <= 8);
            }
            for (const std::string& error : screen.errors()) FAIL(error);
            if (paths.emplace(sum, path).second) open.push_back(sum);
        }
    }
    std::vector<int> reached;
    for (const auto& [sum, path] : paths) reached.push_back(sum);
    REQUIRE(reached == std::vector<int>{-8, -6, -4, -2, 0, 2, 4, 6, 8});
}

TEST_CASE("each control symbol is the one that DVI prescribes", "[board][tmds]") {
    Encoder encoder;
    const std::array<std::uint16_t, 4> expected{0x354, 0x0ab, 0x154, 0x2ab};
    for (std::uint8_t control = 0; control < 4; ++control) {
        for (int i = 0; i < 2; ++i) encoder.clock({}, control);
        REQUIRE(encoder.clock({}, control) == expected[control]);
    }
}

TEST_CASE("a million bytes of any content leave the channel balanced", "[board][tmds]") {
    Encoder encoder;
    Draw draw{5};
    int sum = 0, least = 0, most = 0;
    for (int i = 0; i < 3; ++i) encoder.clock({});
    for (int i = 0; i < 1'000'000; ++i) {
        const std::uint8_t byte = i < 300'000   ? 0
                                  : i < 500'000 ? 0xff
                                  : i < 600'000 ? 0x10
                                                : std::uint8_t(draw.bits(8));
        const std::uint16_t symbol = encoder.clock(byte);
        if (i < 2) continue;
        sum += disparity_of(symbol);
        least = std::min(least, sum);
        most = std::max(most, sum);
    }
    REQUIRE(least >= -8);
    REQUIRE(most <= 8);
}

TEST_CASE("a picture passes from pixels to the screen bit by bit", "[board][screen][long]") {
    struct Case {
        ShownPicture picture;
        std::uint32_t khz;
    };
    const Case c =
        GENERATE(Case{{0, 1, 1}, 75000}, Case{{5, 320, 240, true}, 75000}, Case{{0, 640, 480}, 62500},
                 Case{{900, 130, 97}, 50000}, Case{{1, 131, 77, true}, 100000}, Case{{1, 639, 479}, 75000});
    const auto& [picture, khz] = c;
    CAPTURE(picture.width, picture.height, khz);
    Draw draw{9};
    LineMemory memory(picture.base + picture.blocks_across() * picture.blocks_down());
    PixelWriterPair writer(memory, 4);
    std::vector<PixelWriterPair::Pixel> pixels;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> colours;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x)
            pixels.push_back({x, y, colours[{x, y}] = std::uint32_t(draw.bits(24))});
    for (std::size_t next = 0; next < pixels.size();) next += writer.clock(pixels[next], picture, false, 90);
    while (!writer.model.empty()) writer.clock({}, picture, true, 90);

    Board board(khz);
    ReadPort port(memory, {khz * 40 / 75000, 60, true, 0});
    board.show(1, picture, port);
    board.require_sound();
    const std::uint32_t scale = picture.doubled ? 2 : 1, left = (640 - scale * picture.width) / 2,
                        top = (480 - scale * picture.height) / 2;
    std::size_t wrong = 0;
    for (std::uint32_t y = 0; y < 480; ++y)
        for (std::uint32_t x = 0; x < 640; ++x) {
            const bool in =
                x >= left && x < left + scale * picture.width && y >= top && y < top + scale * picture.height;
            const std::uint32_t colour = in ? colours.at({(x - left) / scale, (y - top) / scale}) : 0;
            wrong += board.screen.picture().at(x, y) != ScreenPicture::Pixel{std::uint8_t(colour),
                                                                             std::uint8_t(colour >> 8),
                                                                             std::uint8_t(colour >> 16)};
        }
    REQUIRE(wrong == 0);
    REQUIRE(board.screen.largest_disparity() <= 8);
}

TEST_CASE("two frames pass between the clocks without a gap", "[board][screen][long]") {
    const std::uint32_t khz = GENERATE(50000U, 62500U, 75000U, 100000U);
    CAPTURE(khz);
    const LineMemory memory(80 * 60);
    Board board(khz);
    ReadPort port(memory, {40, 60, false, 0});
    board.show(2, {0, 320, 240, true}, port);
    board.require_sound();
}

}   // namespace screen_test
