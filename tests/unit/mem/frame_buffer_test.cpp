// The picture's load on the memory: the reads of a screen and the writes of finished pixels, together with
// the chip's reads.
#include <catch2/catch.hpp>

#include "model/base/rng.hpp"
#include "model/mem/memory.hpp"
#include "tests/support/skipping.hpp"

using namespace rayclock;

namespace {

constexpr int khz = 66000;

Config with_picture(const char* dram, int scan_out, int pixel_writes) {
    Config config = named_config("default");
    set_parameter(config, "dram", dram, "test");
    config.scan_out = scan_out;
    config.pixel_writes = pixel_writes;
    return config;
}

}   // namespace

TEST_CASE("a screen of 640x480 is read 60 times a second at any clock", "[memport][picture]") {
    const int clock = GENERATE(20000, 66000, 143000, 1000000);
    for (const char* dram : {"ideal", "sdr_half", "ddr3", "rpu"}) {
        INFO(dram << " at " << clock << " kHz");
        Memory memory{with_picture(dram, 1, 0), clock, {}};
        for (int i = 0; i < 10 * clock; ++i) memory.clock(nullptr);   // ten milliseconds
        const MemoryStats stats = memory.stats();
        CHECK(stats.scanned <= 640 * 480 * 4 * 60 / 64 / 100);
        CHECK(stats.scanned + 1 >= 640 * 480 * 4 * 60 / 64 / 100);
        CHECK(stats.reads == stats.scanned);
        CHECK(stats.writes == 0);
        CHECK(stats.backlog >= 1);
        CHECK(stats.backlog <= 3);   // a refresh delays it
    }
}

TEST_CASE(
    "the screen's words come in time next to a chip that always requests, and do not count as the chip's",
    "[memport][picture]") {
    for (const char* dram : {"ideal", "sdr_half", "ddr3"}) {
        for (const Disturbance& disturbance : {Disturbance{}, Disturbance{40, 30, 5}}) {
            INFO(dram);
            const Config config = with_picture(dram, 1, 0);
            Memory memory{config, khz, disturbance};
            const auto ids = std::uint32_t(1 << config.mem_id_bits());
            std::vector<bool> under_way(ids);
            std::uint64_t requested = 0, answered = 0;
            Rng rng{3};
            for (int cycle = 0; cycle < 20 * khz; ++cycle) {
                if (memory.valid()) {
                    REQUIRE(memory.answer().id < ids);
                    REQUIRE(under_way[memory.answer().id]);
                    under_way[memory.answer().id] = false;
                    ++answered;
                }
                std::uint32_t id = 0;
                while (id < ids && under_way[id]) ++id;
                const bool requests = memory.ready() && id < ids;
                const Memory::Answer request{id, std::uint32_t(rng.below(4096))};
                if (requests) under_way[id] = true, ++requested;
                memory.clock(requests ? &request : nullptr);
            }
            const MemoryStats stats = memory.stats();
            CHECK(requested - answered <= ids);
            CHECK(stats.scanned + 40 >= 23040);   // 20 ms
            CHECK(stats.scanned <= 23040);
            CHECK(stats.backlog <= 16);
            CHECK(stats.reads == requested + stats.scanned);
        }
    }
}

TEST_CASE("a memory too slow for the screen continues to serve the chip", "[memport][picture]") {
    Config config = with_picture("ideal", 1, 0);
    config.mem_interval = 100;   // 660,000 words per second; the screen needs 1,152,000
    Memory memory{config, khz, {}};
    std::uint64_t requested = 0;
    for (int cycle = 0; cycle < 10 * khz; ++cycle) {
        const Memory::Answer request{0, 1};
        const bool requests = memory.ready();
        requested += requests;
        memory.clock(requests ? &request : nullptr);
    }
    CHECK(requested > 3000);
    CHECK(memory.stats().scanned > 3000);
    CHECK(memory.stats().backlog > 1000);
}

TEST_CASE("sixteen finished pixels are a word, written when the chip sends no request, or when four wait",
          "[memport][picture]") {
    Config config = with_picture("ideal", 0, 1);
    config.mem_latency = 4;
    Memory memory{config, khz, {}};
    for (int i = 0; i < 15; ++i) memory.clock(nullptr, 1);
    CHECK(memory.stats().pixel_writes == 0);
    memory.clock(nullptr, 3);   // 18
    CHECK(memory.stats().pixel_writes == 0);
    memory.clock(nullptr);
    CHECK(memory.stats().pixel_writes == 1);
    CHECK(memory.stats().writes == 1);
    int refused = 0;
    for (std::uint32_t i = 0; i < 200; ++i) {   // two pixels per cycle, and the chip requests in every cycle
        const Memory::Answer request{i % 8, i};
        const bool requests = memory.ready();
        refused += !requests;
        memory.clock(requests ? &request : nullptr, 2);
    }
    const MemoryStats stats = memory.stats();
    CHECK(stats.pixel_writes == std::uint64_t(refused) + 1);
    CHECK(stats.pixel_writes >= 402 / 16 - 4);
    CHECK(stats.pixel_writes <= 402 / 16);
    CHECK(stats.reads == 200 - std::uint64_t(refused));
}

TEST_CASE("the picture that is shown and the one that is drawn lie at the memory's end",
          "[memport][picture]") {
    FrameBuffer pictures{with_picture("sdr", 1, 1), khz};
    const auto end = std::uint32_t(capacity_bytes(dram_part("sdr")) / 64);
    std::uint32_t shown = end - 38400, drawn = end - 19200;
    for (int i = 0; i < 19200; ++i) {
        while (!pictures.wants_read() || !pictures.wants_write()) pictures.clock(1, false, true);
        const FrameBuffer::Read read = pictures.read();
        pictures.answered(read.id);
        REQUIRE(read.addr == shown++);
        REQUIRE(pictures.write() == drawn++);
    }
    CHECK(drawn == end);
    while (!pictures.wants_read() || !pictures.wants_write()) pictures.clock(1, false, true);
    CHECK(pictures.read().addr == end - 38400);
    CHECK(pictures.write() == end - 19200);
}

TEST_CASE("pixels are no load unless they are written", "[memport][picture]") {
    Memory memory{with_picture("ddr3", 0, 0), khz, {}};
    for (int i = 0; i < 1000; ++i) memory.clock(nullptr, 1);
    CHECK(memory.stats() == MemoryStats{});
}

TEST_CASE("a memory with a picture that is skipped is the same as one that is stepped",
          "[memport][picture]") {
    const char* dram = GENERATE("ideal", "ddr3", "sdr_half");
    INFO(dram);
    const Config config = with_picture(dram, 1, 1);
    Memory stepped{config, khz, {}}, skipped{config, khz, {}};
    Rng rng{11};
    int skips = 0;
    std::vector<std::uint64_t> free_at(8);   // by id
    for (std::uint64_t now = 0; now < 300'000;) {
        const Memory::Answer request{std::uint32_t(rng.below(8)), std::uint32_t(rng.below(9000))};
        const bool requests = stepped.ready() && free_at[request.id] <= now && rng.below(6) == 0;
        if (requests) free_at[request.id] = now + 4000;
        const auto pixels = std::uint32_t(rng.below(8) == 0);
        stepped.clock(requests ? &request : nullptr, pixels);
        skipped.clock(requests ? &request : nullptr, pixels);
        ++now;
        const std::uint64_t before = now;
        if (!test::pass_quiet(stepped, skipped, now)) continue;
        REQUIRE(now < before + 100);   // a word of the screen is due every 57 cycles
        ++skips;
        REQUIRE(stepped.ready() == skipped.ready());
        REQUIRE(stepped.valid() == skipped.valid());
        REQUIRE(stepped.stats() == skipped.stats());
        REQUIRE(stepped.outcomes() == skipped.outcomes());
    }
    CHECK(skips > 1000);
    CHECK(stepped.stats().scanned > 5000);
}
