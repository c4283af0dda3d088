// Scan-out: model and RTL in every cycle, pictures that change in the blank only, and underruns.
#include <vector>

#include "tests/board/video/video_dut.hpp"
#include <catch2/catch.hpp>

namespace scan_out_test {

using namespace rayclock;
using namespace rayclock::test;

constexpr std::uint64_t frame_clocks = 800 * 525;   // pixel clocks

LineMemory random_memory(std::size_t lines, unsigned seed) {
    Draw draw{seed};
    LineMemory memory(lines);
    for (PixelLine& line : memory)
        for (std::uint16_t& beat : line) beat = std::uint16_t(draw.bits(16));
    return memory;
}

/// Gathers the pixels of scan-out into frames, without a cable. A frame begins with the first pixel after a
/// vertical sync.
class Frames {
public:
    void take(const SentPixel& pixel) {
        if (++cycles_ > 10 * 3 * frame_clocks) FAIL("the screen gets no whole frames");
        if (!pixel.valid) return;
        if (!pixel.vsync) now_.clear();
        if (!pixel.de) return;
        now_.push_back(
            {std::uint8_t(pixel.colour), std::uint8_t(pixel.colour >> 8), std::uint8_t(pixel.colour >> 16)});
        if (now_.size() == 640 * 480) all.push_back({640, 480, now_});
    }
    std::vector<ScreenPicture> all;

private:
    std::vector<ScreenPicture::Pixel> now_;
    std::uint64_t cycles_ = 0;
};

/// Runs the model alone for some frames, and returns its underruns.
std::uint32_t underruns(const ShownPicture& picture, const ScanOut::Shape& shape,
                        const ReadPort::Speed& speed, int frames) {
    ScanOut scan(shape);
    static const LineMemory memory(160 * 120);
    ReadPort port(memory, speed);
    const std::uint64_t cycles = frames * frame_clocks * shape.chip_khz / shape.pixel_khz;
    for (std::uint64_t i = 0; i < cycles; ++i) {
        port.begin(scan.is_urgent());
        ScanOutPair::model_clock(scan, picture, port);
    }
    REQUIRE(port.requests >= std::uint64_t(frames - 1) * picture.blocks_across() * picture.blocks_down());
    return scan.underruns();
}

const ShownPicture full{0, 640, 480}, doubled{0, 320, 240, true};

TEST_CASE("scan-out has the model's cycles under a random memory", "[board][scan][long]") {
    struct Case {
        ShownPicture picture;
        ReadPort::Speed speed;
    };
    const Case c =
        GENERATE(Case{full, {32, 5, false, 50}}, Case{full, {45, 40, true, 20}},
                 Case{full, {90, 30, false, 10}},   // with underruns
                 Case{doubled, {33, 60, true, 80}}, Case{{7, 130, 97}, {40, 0, false, 90}},
                 Case{{7, 131, 98, true}, {40, 0, true, 95}}, Case{{3, 1, 1}, {32, 0, false, 0}},
                 Case{{3, 641, 100}, {32, 0, false, 0}}, Case{{3, 640, 0}, {32, 0, false, 0}},
                 Case{{3, 321, 240, true}, {32, 0, false, 0}}, Case{{3, 65535, 65535}, {32, 0, false, 0}});
    CAPTURE(c.picture.width, c.picture.height, c.speed.line_cycles, c.speed.latency, c.speed.refuses);
    const LineMemory memory = random_memory(160 * 120 + 7, 3);
    ReadPort port(memory, c.speed, 5);
    ScanOutPair scan;
    Frames frames;
    for (std::uint64_t i = 0; i < 2 * 3 * frame_clocks; ++i) frames.take(scan.clock(c.picture, port));
    REQUIRE(frames.all.size() == 2);
    if (c.speed.line_cycles > 80) {
        REQUIRE(scan.model.underruns() > 1000);
    } else {
        REQUIRE(scan.model.underruns() == 0);
        const std::uint32_t blocks = c.picture.blocks_across() * c.picture.blocks_down();
        REQUIRE(port.requests == (c.picture.is_shown() ? 2 * blocks : 0));
        for (const ScreenPicture& frame : frames.all) REQUIRE((frame == expected_screen(memory, c.picture)));
    }
}

TEST_CASE("a picture is taken over in the vertical blank only", "[board][scan]") {
    const LineMemory memory = random_memory(2000, 4);
    Draw draw{11};
    ReadPort port(memory, {40, 100, false, 0}, 5);
    ScanOutPair scan;
    Frames frames;
    ShownPicture given{0, 33, 9};
    std::vector<ShownPicture> taken;
    while (frames.all.size() < 5) {
        if (draw.below(50'000) == 0)
            given = {std::uint32_t(draw.below(500)), std::uint32_t(draw.below(200)),
                     std::uint32_t(draw.below(100)), draw.coin()};
        if (scan.model.takes()) taken.push_back(given);
        frames.take(scan.clock(given, port));
        // The memory stops now and then, so that old lines arrive in a new picture.
        if (draw.below(100'000) == 0) port.change({draw.coin() ? 40U : 200'000U, 100, false, 0});
    }
    REQUIRE(taken.size() >= 5);
    // A frame is the picture that was taken over before it; a slow memory makes pixels black.
    for (std::size_t i = 0; i < 5; ++i) {
        const ScreenPicture expected = expected_screen(memory, taken[i]);
        std::size_t wrong = 0, shown = 0;
        for (std::size_t k = 0; k < expected.pixels.size(); ++k) {
            wrong += frames.all[i].pixels[k] != expected.pixels[k] &&
                     frames.all[i].pixels[k] != ScreenPicture::Pixel{};
            shown += frames.all[i].pixels[k] != ScreenPicture::Pixel{};
        }
        CAPTURE(i, shown);
        REQUIRE(wrong == 0);
    }
}

TEST_CASE("lines of the last picture that come late are discarded", "[board][scan]") {
    const LineMemory memory = random_memory(160 * 120 + 100, 6);
    ReadPort port(memory, {40, 100, false, 0}, 5);
    ScanOutPair scan;
    Frames frames;
    const ShownPicture second{160 * 120, 36, 30};
    // The memory is too slow for the first picture, so that requests are pending when the second begins. An
    // answer takes longer than the blank's first lines.
    port.change({3000, 20'000, false, 0});
    while (!scan.model.takes()) scan.clock(full, port);
    scan.clock(full, port);
    while (!scan.model.takes()) scan.clock(full, port);
    REQUIRE(scan.model.underruns() > 0);
    port.change({40, 100, false, 0});
    frames.take(scan.clock(second, port));
    const std::uint32_t before = scan.model.underruns();
    while (frames.all.empty()) frames.take(scan.clock(second, port));
    REQUIRE((frames.all[0] == expected_screen(memory, second)));
    REQUIRE(scan.model.underruns() == before);
}

TEST_CASE("a line that ends while the next picture is taken over is of the last one", "[board][scan]") {
    const LineMemory memory = random_memory(160 * 120 + 100, 6);
    const ShownPicture second{160 * 120, 36, 30};
    // The cycle of the first request, and of the second time that a picture is taken over.
    std::uint64_t requested = 0, taken = 0;
    ScanOut scan({});
    ReadPort silent(memory, {40, 1'000'000'000, false, 0});
    for (std::uint64_t now = 0, times = 0; times < 2; ++now) {
        silent.begin(false);
        times += scan.takes();
        taken = now;
        const bool first = silent.requests == 0;
        ScanOutPair::model_clock(scan, full, silent);
        if (first && silent.requests == 1) requested = now;
    }
    for (const std::uint64_t earlier : {0, 1, 2}) {
        CAPTURE(earlier);
        // The first line takes so long that its last beat comes in that cycle, or just before or after it.
        ReadPort port(memory, {40, std::uint32_t(taken + 1 - earlier - 31 - requested), false, 0});
        ScanOutPair pair;
        Frames frames;
        for (std::uint64_t now = 0; now < taken; ++now) pair.clock(full, port);
        REQUIRE(pair.model.takes());
        port.change({40, 100, false, 0});
        while (frames.all.empty()) frames.take(pair.clock(second, port));
        REQUIRE((frames.all[0] == expected_screen(memory, second)));
    }
}

TEST_CASE("skipping quiet cycles of scan-out has the effect of stepping", "[board][scan]") {
    const std::uint32_t khz = GENERATE(50000U, 62500U, 75000U, 73000U);
    Draw draw{khz};
    for (int i = 0; i < 8; ++i) {
        const ShownPicture picture{5, std::uint32_t(draw.between(1, 660)),
                                   std::uint32_t(draw.between(1, 490)), draw.percent(30)};
        CAPTURE(khz, picture.width, picture.height, picture.doubled);
        const LineMemory memory(160 * 123 + 5);
        const ReadPort::Speed speed{std::uint32_t(draw.between(32, 50)), 50, false, 0};
        ScanOut stepping({.chip_khz = khz}), skipping({.chip_khz = khz});
        ReadPort stepped(memory, speed), skipped(memory, speed);
        std::uint64_t quiet = 0, all = 0;
        for (const std::uint64_t last = 2 * frame_clocks * khz / 25000; all < last;) {
            const std::uint64_t most = skipping.quiet(),
                                cycles = draw.coin() ? most : most * draw.bits(8) / 256;
            skipping.skip(cycles);
            quiet += cycles;
            for (std::uint64_t k = 0; k <= cycles; ++k, ++all) {
                stepped.begin(false);
                skipped.begin(false);
                const bool sleeps = k < cycles;
                if (sleeps && (stepping.requests() || stepping.takes() || stepping.nears()))
                    FAIL("cycle " << all << " is not quiet");
                ScanOutPair::model_clock(stepping, picture, stepped);
                if (sleeps)
                    skipped.end({});
                else
                    ScanOutPair::model_clock(skipping, picture, skipped);
            }
            if (stepping.requests() != skipping.requests() || stepping.takes() != skipping.takes() ||
                stepping.is_urgent() != skipping.is_urgent() || stepping.quiet() != skipping.quiet() ||
                stepping.underruns() != skipping.underruns())
                FAIL("cycle " << all << " differs after " << cycles << " of " << most << " quiet cycles");
        }
        REQUIRE(stepped.requests == skipped.requests);
        REQUIRE(quiet > all / 10);
    }
}

TEST_CASE("a line every 40 cycles at 75 MHz is enough, also if only urgent requests are served",
          "[board][scan]") {
    const bool only_if_urgent = GENERATE(false, true);
    const ShownPicture picture = GENERATE(full, doubled);
    REQUIRE(underruns(picture, {}, {40, 60, only_if_urgent, 0}, 3) == 0);
}

TEST_CASE("the slowest memory without underruns is the formula's", "[board][scan]") {
    const std::uint32_t khz = GENERATE(50000U, 62500U, 75000U, 100000U);
    const ScanOut::Shape shape{.chip_khz = khz};
    const std::uint32_t worst = worst_line_cycles(full, khz, 25000);
    CAPTURE(khz, worst);
    REQUIRE(worst == khz / 1250);   // 60 cycles at 75 MHz
    for (const bool only_if_urgent : {false, true}) {
        REQUIRE(underruns(full, shape, {worst, 60, only_if_urgent, 0}, 3) == 0);
        REQUIRE(underruns(full, shape, {worst + 1, 60, only_if_urgent, 0}, 3) > 0);
    }
    REQUIRE(worst_line_cycles(doubled, khz, 25000) == 4 * worst);
    REQUIRE(underruns(doubled, shape, {4 * worst, 60, true, 0}, 3) == 0);
    REQUIRE(underruns(doubled, shape, {4 * worst + 4, 60, true, 0}, 3) > 0);
}

TEST_CASE("an answer may take as long as the requests in flight allow", "[board][scan]") {
    const std::uint32_t worst = worst_line_cycles(full, 75000, 25000);
    // A place is in use from the offer to the last of the 32 beats.
    for (const std::uint32_t in_flight : {1U, 2U, 4U, 8U}) {
        CAPTURE(in_flight);
        const ScanOut::Shape shape{.in_flight = in_flight};
        const std::uint32_t latency = in_flight * worst - 32;
        REQUIRE(underruns(full, shape, {32, latency - 2, false, 0}, 3) == 0);
        REQUIRE(underruns(full, shape, {32, latency + in_flight, false, 0}, 3) > 0);
    }
}

TEST_CASE("a due block may take as long as the blank and the screen before it", "[board][scan]") {
    const ShownPicture picture = GENERATE(full, doubled, ShownPicture{0, 64, 480}, ShownPicture{0, 637, 8});
    const ScanOut::Shape shape{.in_flight = 128};
    const std::uint32_t delay = worst_delay_cycles(picture, 75000, 25000);
    CAPTURE(picture.width, delay);
    REQUIRE(underruns(picture, shape, {32, delay - 32, true, 0}, 3) == 0);
    if (picture.blocks_down() > 2) REQUIRE(underruns(picture, shape, {32, delay + 32, true, 0}, 3) > 0);
}

TEST_CASE("any picture is safe within the three bounds of the memory", "[board][scan]") {
    Draw draw{23};
    for (int i = 0; i < 25; ++i) {
        const bool doubles = draw.coin();
        const ShownPicture picture{0, std::uint32_t(draw.between(1, doubles ? 320 : 640)),
                                   std::uint32_t(draw.between(1, doubles ? 240 : 480)), doubles};
        const std::uint32_t khz = std::uint32_t(draw.between(40'000, 110'000));
        const ScanOut::Shape shape{.chip_khz = khz};
        const std::uint32_t delay = worst_delay_cycles(picture, khz, 25000),
                            latency = std::uint32_t(draw.between(0, 100)),
                            cycles = std::min(worst_line_cycles(picture, khz, 25000), delay - latency - 32);
        CAPTURE(picture.width, picture.height, doubles, khz, cycles, latency);
        if (cycles < 32 || latency + 34 > shape.in_flight * cycles) continue;
        REQUIRE(underruns(picture, shape, {cycles, latency, true, 0}, 2) == 0);
    }
}

TEST_CASE("the count of underruns is exact and ends at its largest value", "[board][scan]") {
    // Without an answer every pixel of the picture is missing.
    ScanOutPair scan;
    const LineMemory memory = random_memory(100, 3);
    ReadPort port(memory, {40, 1'000'000'000, false, 0});
    const ShownPicture picture{0, 10, 7, true};
    for (std::uint64_t i = 0; i < 3 * 3 * frame_clocks; ++i) scan.clock(picture, port);
    REQUIRE(scan.model.underruns() == 3 * 20 * 14);
    for (std::uint64_t i = 0; i < 3 * 3 * frame_clocks; ++i) scan.clock({0, 640, 60}, port);
    REQUIRE(scan.model.underruns() == 65535);
}

}   // namespace scan_out_test
