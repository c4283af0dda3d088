// The host's writes through the DRAM: every gate of a write is kept, every line is written once, reads keep
// their answers, and the time follows from the data sheet.
#include <catch2/catch.hpp>

#include <map>

#include "model/mem/dram.hpp"
#include "model/mem/memory.hpp"
#include "model/machine/machine.hpp"

using namespace rayclock;

namespace {

constexpr int khz = 66'000;

const std::vector<std::string> part_names{"sdr", "sdr_half", "ddr3", "rpu", "ddr4", "lpddr4", "hbm2"};

/// Checks the gates of reads and writes on the data bus and of the rows that they open, by the data sheet,
/// pair by pair.
void check_writes(const DramPart& part, const std::vector<Dram::Issued>& all) {
    const auto clocks = [&](int ps) { return (ps + part.tck - 1) / part.tck; };
    std::map<int, std::uint32_t> open;
    const std::int64_t burst = part.burst_clocks();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Dram::Issued& c = all[i];
        const bool is_column = c.command == DramCommand::read || c.command == DramCommand::write;
        if (is_column) REQUIRE((open.count(c.bank) && open[c.bank] == c.row));
        if (c.command == DramCommand::activate) open[c.bank] = c.row;
        if (c.command == DramCommand::precharge) open.erase(c.bank);
        if (c.command == DramCommand::precharge_all) open.clear();
        for (std::size_t k = i; k-- > 0 && i - k < 100;) {
            const Dram::Issued& b = all[k];
            const std::int64_t between = c.clock - b.clock;
            const bool closes = c.command == DramCommand::precharge_all ||
                                (c.command == DramCommand::precharge && c.bank == b.bank);
            if (b.command == DramCommand::write) {
                const std::int64_t end = part.cwl + burst;   // the end of its data
                if (c.command == DramCommand::read) CHECK(between >= end + clocks(part.twtr));
                if (c.command == DramCommand::write) CHECK(between >= burst);
                if (closes) CHECK(between >= end + clocks(part.twr));
            }
            if (b.command == DramCommand::read && c.command == DramCommand::write)
                CHECK(between + part.cwl >= part.cl + burst + (part.transfers == 1 ? 1 : 2));
            if (b.command == DramCommand::activate && b.bank == c.bank && is_column)
                CHECK(between >= clocks(part.trcd));
        }
    }
}

}   // namespace

TEST_CASE("writes keep the gates of every memory, and so do the reads between them", "[motion][dram]") {
    const DramPart part = dram_part(GENERATE(from_range(part_names)));
    INFO(part.name);
    Dram dram(part, khz, 8);
    std::vector<Dram::Issued> log;
    dram.record(&log);
    Rng rng{7};
    std::vector<bool> under_way(8);
    std::uint64_t written = 0, requested = 0, answered = 0;
    while (written < 600 || requested < 600 || answered < requested || dram.writes()) {
        REQUIRE(dram.now() < 200'000);
        if (dram.valid()) {
            under_way[dram.answer().id] = false;
            ++answered;
        }
        const bool writes = rng.below(2) != 0;
        std::uint32_t id = 0;
        while (id < 8 && under_way[id]) ++id;
        const auto addr = std::uint32_t(rng.below(3) ? rng.below(600) : rng.below(1 << 18));
        const bool goes =
            dram.ready() && rng.below(3) && (writes ? written < 600 : id < 8 && requested < 600);
        const Dram::Answer request{writes ? 0 : id, addr, writes};
        if (goes) {
            if (writes)
                ++written;
            else
                ++requested, under_way[id] = true;
        }
        dram.clock(goes ? &request : nullptr);
    }
    check_writes(part, log);
    const DramStatistics s = dram.statistics();
    CHECK(s.writes == 600);
    CHECK(s.reads == 600);
    CHECK(s.row_hits + s.row_misses + s.row_conflicts == 1200);
    std::uint64_t commands = 0;
    for (const Dram::Issued& i : log) commands += i.command == DramCommand::write;
    CHECK(commands == 600u * unsigned(part.bursts()));
}

TEST_CASE("the host's writes in sequence come near the peak of the memory", "[motion][dram]") {
    for (const char* name : {"ddr3", "sdr"}) {
        INFO(name);
        Config config = named_config("default");
        set_parameter(config, "dram", name, "test");
        Memory memory(config, khz, {});
        std::vector<std::uint32_t> lines;
        for (std::uint32_t i = 0; i < 4000; ++i) lines.push_back(i);
        memory.write(lines);
        std::uint64_t cycles = 0;
        for (; memory.writes(); ++cycles) memory.clock(nullptr);
        CHECK(memory.stats().writes == 4000);
        CHECK(memory.stats().reads == 0);
        const double seconds = double(cycles) / (khz * 1e3),
                     peak = double(peak_bytes_per_second(dram_part(name)));
        CHECK(4000 * 64 / seconds < peak);
        CHECK(4000 * 64 / seconds > 0.8 * peak);
    }
}

TEST_CASE("an ideal memory accepts a write in place of a request", "[motion][dram]") {
    Config config = named_config("default");
    set_parameter(config, "dram", "ideal", "test");
    set_parameter(config, "mem_interval", "3", "test");
    Memory memory(config, khz, {});
    memory.write({1, 2, 3, 4});
    std::uint64_t cycles = 0;
    for (; memory.writes(); ++cycles) memory.clock(nullptr);
    CHECK(cycles == 10);   // in cycles 0, 3, 6 and 9
    CHECK(memory.stats().writes == 4);
}

TEST_CASE("the chip's reads go before the host's writes", "[motion][dram]") {
    Config config = named_config("default");
    set_parameter(config, "dram", "ideal", "test");
    set_parameter(config, "mem_interval", "1", "test");
    Memory memory(config, khz, {});
    memory.write({7, 8, 9});
    for (std::uint32_t i = 0; i < 5; ++i) {
        REQUIRE(memory.ready());
        const Memory::Answer request{i, i};
        memory.clock(&request);
        CHECK(memory.stats().writes == 0);
    }
    for (int i = 0; i < 3; ++i) memory.clock(nullptr);
    CHECK(memory.stats().writes == 3);
    CHECK_FALSE(memory.writes());
    CHECK(memory.stats().reads == 5);
}
