// rc_sdram and its model in every cycle, with a behavioural SDRAM that checks the rules of the data sheet.
// Bandwidth and latency are compared with formulas of the gates.
#include "tests/board/memory/sdram_world.hpp"
#include "tests/support/machine/build_all.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr int sdram_khz[] = {75'000, 50'000, 100'000, 142'857};

int any_khz() { return GENERATE(75'000, 50'000, 100'000, 142'857); }
const SdramPart& any_sdram() { return sdram_part(GENERATE(as<std::string>{}, "as4c32m16sb", "is42s16160g")); }

/// Random traffic: bursts and pauses, reads and writes.
void random_disturbance(SdramRig& rig, int requests) {
    std::uint32_t last = 0;
    int gap = 0, writes = 0;
    for (int i = 0; i < requests; ++i) {
        if (rig.draw.percent(5)) gap = rig.draw.below(3) == 0 ? rig.draw.below(100) : rig.draw.below(3);
        if (rig.draw.percent(5)) writes = 50 * rig.draw.below(3);
        last = next_address(rig.draw, rig.part, last);
        const Sdram::Request request{rig.draw.percent(writes), last, std::uint32_t(rig.draw.bits(8))};
        const WriteLine line = random_line(rig.draw, rig.draw.coin());
        rig.idle(gap);
        rig.send(request, &line);
    }
    rig.drain();
}

/// Reads lines without a pause. Returns the cycles between the first beats of neighbours.
std::vector<std::uint64_t> spacing(SdramRig& rig, int lines, auto address) {
    rig.first_beats.clear();
    for (int i = 0; i < lines; ++i) rig.send({false, address(std::uint32_t(i)), std::uint32_t(i & 255)});
    rig.drain();
    std::vector<std::uint64_t> gaps;
    for (std::size_t i = 1; i < rig.first_beats.size(); ++i)
        gaps.push_back(rig.first_beats[i] - rig.first_beats[i - 1]);
    return gaps;
}

/// Checks that lines follow each other every `step` cycles, except around refreshes.
void check_spacing(const SdramRig& rig, const std::vector<std::uint64_t>& gaps, std::uint64_t step,
                   std::uint64_t refreshes, const SdramClocks& c) {
    std::uint64_t longer = 0;
    for (const std::uint64_t gap : gaps) {
        CAPTURE(rig.part.name, gap);
        if (gap == step) continue;
        ++longer;
        // The bus waits for the precharge, the refresh and the activation. A row that has just been activated
        // stays open for tRAS.
        REQUIRE(gap >= std::uint64_t(32 + c.rp + c.rfc + c.rcd));
        REQUIRE(gap <= step + std::uint64_t(c.rp + c.rfc + c.rcd + c.ras));
    }
    REQUIRE(longer <= refreshes);
    REQUIRE(longer + 2 >= refreshes);
}

}   // namespace

TEST_CASE("the RTL of the SDRAM controller is built", "[.build]") {
    std::vector<RtlJob> jobs;
    for (const SdramPart& part : sdram_parts())
        for (const int khz : sdram_khz)
            jobs.push_back({SdramRig::module(part, khz), part.name, format("default")});
    jobs.push_back({SdramRig::module(sdram_parts()[0], 75'000, 1), "in phase", format("default")});
    build_all(jobs);
}

TEST_CASE("model and RTL of the SDRAM controller agree in every cycle, and the data are right",
          "[sdram][lockstep]") {
    const int khz = any_khz();
    const SdramPart& part = any_sdram();
    const unsigned seed = GENERATE(1u, 2u);
    CAPTURE(khz, part.name, seed);
    SdramRig rig(part, khz, seed);
    rig.align_every = 2000;
    rig.initialise();
    random_disturbance(rig, 10'000);
    REQUIRE(rig.chip.violations().empty());
    REQUIRE(rig.expected.chip_agrees());
    CHECK(rig.chip.refreshes() > 300);
    REQUIRE(rig.model.refreshes() - rig.chip.refreshes() <= 1);   // one may be on its way to the pins
}

TEST_CASE("the SDRAM controller reads right with the clock of the SDRAM in phase", "[sdram][lockstep]") {
    SdramRig rig(sdram_part("as4c32m16sb"), 75'000, 3, 1);
    rig.initialise();
    random_disturbance(rig, 5000);
    REQUIRE(rig.expected.chip_agrees());
}

TEST_CASE("the SDRAM controller starts anew after a reset at any time", "[sdram][lockstep]") {
    SdramRig rig(sdram_part("as4c32m16sb"), 142'857);
    rig.initialise();
    // A row that was open stays so for the initial wait, which is longer than the longest tRAS. So the
    // content of the memory does not outlast a reset, but the controller works.
    rig.allowed = SdramFault::tras_longest;
    for (int i = 0; i < 20; ++i) {
        std::uint32_t last = 0;
        for (int k = 0; k < 5; ++k) {
            last = next_address(rig.draw, rig.part, last);
            const Sdram::Request request{rig.draw.coin(), last, 0};
            const WriteLine line = random_line(rig.draw, false);
            rig.send(request, &line);
        }
        rig.idle(rig.draw.below(80));
        rig.reset();
        rig.expected.forget();
        rig.initialise();
        random_disturbance(rig, 50);
    }
    REQUIRE(rig.expected.chip_agrees());
}

TEST_CASE("an idle SDRAM controller refreshes every row in 64 ms", "[sdram][lockstep]") {
    const SdramPart& part = sdram_part("as4c32m16sb");
    SdramRig rig(part, 50'000);
    rig.initialise();
    const std::uint64_t begin = rig.cycle;
    while (rig.cycle - begin < 3'200'000) rig.step(nullptr);
    REQUIRE(rig.chip.refreshes() >= 8192);
    REQUIRE(rig.chip.refreshes() <= 8210);
}

TEST_CASE("a stream of reads fills the bus of the SDRAM except during refreshes", "[sdram][speed]") {
    const int khz = any_khz();
    const SdramPart& part = any_sdram();
    CAPTURE(khz, part.name);
    const SdramClocks c = sdram_clocks(part, khz);
    const std::uint32_t in_row = 1u << (part.column_bits - 5), rows = 4 * in_row;
    SdramRig rig(part, khz);
    rig.initialise();
    std::uint64_t before = rig.model.refreshes();
    const auto refreshes = [&] {
        const std::uint64_t more = rig.model.refreshes() - before;
        before = rig.model.refreshes();
        return more;
    };
    SECTION("lines in sequence, across banks and rows") {
        const auto gaps = spacing(rig, 600, [](std::uint32_t i) { return i; });
        check_spacing(rig, gaps, 32, refreshes(), c);
    }
    SECTION("another row of another bank each time") {
        const auto gaps = spacing(rig, 600, [&](std::uint32_t i) { return i % 4 * in_row + i * rows; });
        check_spacing(rig, gaps, 32, refreshes(), c);
    }
    SECTION("another row of the same bank each time") {
        const auto gaps = spacing(rig, 200, [&](std::uint32_t i) { return i * rows; });
        check_spacing(rig, gaps, std::uint64_t(32 + c.rp + c.rcd), refreshes(), c);
    }
    SECTION("writes in sequence") {
        const WriteLine line = random_line(rig.draw, false);
        rig.send({true, 0, 0}, &line);
        const std::uint64_t begin = rig.cycle;
        for (std::uint32_t i = 1; i < 400; ++i) rig.send({true, i, 0}, &line);
        const std::uint64_t most =
            399 * 32 + refreshes() * std::uint64_t(c.rp + c.rfc + c.rcd + c.ras + c.wr) + 32;
        REQUIRE(rig.cycle - begin <= most);
        rig.drain();
    }
}

TEST_CASE("a lone read of the SDRAM has the latency of its gates, to the cycle", "[sdram][speed]") {
    const int khz = any_khz();
    const SdramPart& part = any_sdram();
    CAPTURE(khz, part.name);
    const SdramClocks c = sdram_clocks(part, khz);
    const std::uint32_t rows = 4u << (part.column_bits - 5);
    SdramRig rig(part, khz);
    rig.initialise();
    const auto latency = [&](std::uint32_t line) {
        rig.send({false, line, 1});
        const std::uint64_t accepted = rig.cycle - 1;
        rig.drain();
        rig.idle(20);
        return rig.last_beats.back() - accepted;
    };
    const std::uint64_t open = std::uint64_t(1 + 1 + 1 + c.cl + 31);    // row, decision, pins, latency, beats
    REQUIRE(latency(5) == open - 1 + std::uint64_t(c.rcd));             // the bank was closed
    REQUIRE(latency(6) == open);                                        // the row was open
    REQUIRE(latency(5 + rows) == open + std::uint64_t(c.rp + c.rcd));   // another row was open
}

TEST_CASE("a write between reads turns the bus with one idle clock", "[sdram][speed]") {
    const int khz = any_khz();
    const SdramPart& part = any_sdram();
    const SdramClocks c = sdram_clocks(part, khz);
    SdramRig rig(part, khz);
    rig.initialise();
    const WriteLine line = random_line(rig.draw, true);
    rig.send({false, 0, 1});
    rig.drain();
    rig.first_beats.clear();
    rig.send({false, 1, 1});
    rig.send({true, 2, 2}, &line);
    rig.send({false, 2, 3});
    rig.drain();
    REQUIRE(rig.first_beats.size() == 2);
    // From the last read of line 1: the turn, four bursts, and the next read.
    REQUIRE(rig.first_beats[1] - rig.first_beats[0] == std::uint64_t(24 + c.cl + 8 + 1 + 32));
}

TEST_CASE("skipped quiet cycles of the SDRAM controller change nothing", "[sdram][skip]") {
    const SdramClocks clocks = sdram_clocks(sdram_part("as4c32m16sb"), 75'000);
    Sdram stepped(clocks), skipped(clocks);
    Draw draw(7);
    while (!stepped.init_done()) stepped.clock(nullptr), skipped.clock(nullptr);
    std::uint64_t skips = 0, line = 0;
    for (int i = 0; i < 30'000; ++i) {
        if (stepped.ready() && draw.percent(30)) {
            const Sdram::Request request{draw.coin(),
                                         std::uint32_t(line = draw.coin() ? line + 1 : draw.bits(20)), 1};
            stepped.clock(&request);
            skipped.clock(&request);
            continue;
        }
        // Short skips end within the gates after a refresh.
        const std::uint64_t some =
            std::min(skipped.quiet_cycles(), draw.coin() ? draw.bits(2) : draw.bits(10));
        skips += some;
        skipped.skip(some);
        for (std::uint64_t k = 0; k < some; ++k) {
            REQUIRE(stepped.ready());
            REQUIRE_FALSE(stepped.read_beat().valid);
            REQUIRE(stepped.pins().command == SdramCommand::nop);
            stepped.clock(nullptr);
        }
        for (int k = draw.coin() ? draw.below(60) : 0; k > 0; --k) {
            REQUIRE(stepped.ready() == skipped.ready());
            REQUIRE(stepped.refreshing() == skipped.refreshing());
            REQUIRE(stepped.read_beat() == skipped.read_beat());
            REQUIRE(stepped.write_beat() == skipped.write_beat());
            REQUIRE(stepped.pins().command == skipped.pins().command);
            stepped.clock(nullptr);
            skipped.clock(nullptr);
        }
    }
    REQUIRE(skips > 10'000);
    REQUIRE(stepped.refreshes() == skipped.refreshes());
}

TEST_CASE("the figures of the SDRAM parts hold together", "[sdram][parts]") {
    REQUIRE(sdram_part("as4c32m16sb").bytes() == 64u << 20);
    REQUIRE(sdram_part("is42s16160g").bytes() == 32u << 20);
    REQUIRE(sdram_part("as4c32m16sb").line_bits() == 20);
    REQUIRE(sdram_part("is42s16160g").line_bits() == 19);
    REQUIRE_THROWS_WITH(sdram_part("core memory"), Catch::Contains("no SDRAM is called 'core memory'"));
    REQUIRE_THROWS_WITH(sdram_clocks(sdram_part("as4c32m16sb"), 150'500),
                        "the SDRAM as4c32m16sb allows a clock of at most 142.857 MHz, not 150.5");
    const SdramClocks c = sdram_clocks(sdram_part("as4c32m16sb"), 142'857);
    REQUIRE(c.cl == 3);
    REQUIRE(c.rcd == 3);
    REQUIRE(c.rp == 3);
    REQUIRE(c.ras == 6);
    REQUIRE(c.wr == 2);
    REQUIRE(c.rfc == 9);
    REQUIRE(c.refi == 1114);   // 7.8 us / 7.001 ns
    const SdramClocks slower = sdram_clocks(sdram_part("as4c32m16sb"), 100'000);
    REQUIRE(slower.cl == 2);
    REQUIRE(slower.rcd == 3);   // 21 ns in clocks of 10 ns
    REQUIRE(slower.ras == 5);
    REQUIRE(slower.rfc == 7);
    REQUIRE(slower.refi == 780);
    REQUIRE(sdram_clocks(sdram_part("is42s16160g"), 125'000).ras == 5);   // tRC less tRP, 8 - 3
    for (const SdramPart& part : sdram_parts()) REQUIRE_FALSE(part.source.empty());
}

TEST_CASE("figures of the SDRAM controller", "[.figures]") {
    for (const SdramPart& part : sdram_parts())
        for (const int khz : sdram_khz) {
            SdramRig rig(part, khz);
            rig.initialise();
            const auto gaps = spacing(rig, 4000, [](std::uint32_t i) { return i; });
            const std::uint64_t all = rig.last_beats.back() - rig.first_beats.front() + 1;
            std::printf("%s, %d kHz: 4000 lines in sequence take %lu cycles, %.1f MB/s, %.2f %% of the bus\n",
                        part.name.c_str(), khz, static_cast<unsigned long>(all),
                        4000 * 64 / (double(all) / khz) / 1e3, 100.0 * 4000 * 32 / double(all));
        }
}
