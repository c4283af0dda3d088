#pragma once
// Shared by the tests of the DRAM: formulas, a driver, and an independent check of command logs.
#include <algorithm>
#include <map>
#include <optional>

#include <catch2/catch.hpp>

#include "model/mem/dram.hpp"
#include "model/mem/ideal_memory.hpp"

namespace rayclock::test {

using Command = DramCommand;
using Issued = Dram::Issued;

inline std::int64_t clocks(const DramPart& part, int ps) { return (ps + part.tck - 1) / part.tck; }
inline std::uint64_t begin_of(std::uint64_t cycle, int khz) {
    return cycle * 1'000'000'000 / std::uint64_t(khz);
}
inline std::uint64_t cycle_from(std::uint64_t ps, int khz) {
    std::uint64_t cycle = ps / 1'000'000 * std::uint64_t(khz) / 1'000;   // not later than that
    while (begin_of(cycle, khz) < ps) ++cycle;
    return cycle;
}
inline std::uint32_t row_words(const DramPart& part) { return std::uint32_t(part.row_bytes() / 64); }
inline std::uint32_t address(const DramPart& part, std::uint32_t row, std::uint32_t bank,
                             std::uint32_t word) {
    const std::uint32_t groups = std::uint32_t(part.bank_groups), banks = std::uint32_t(part.banks);
    return ((row * (banks / groups) + bank / groups) * row_words(part) + word) * groups + bank % groups;
}
/// Returns the DRAM clocks between consecutive read commands of a request.
inline std::int64_t read_step(const DramPart& part) {
    return std::max({clocks(part, part.tccd), clocks(part, part.tccd_l), std::int64_t(part.burst_clocks())});
}

/// The results of requests by number, and the commands of the memory.
struct Log {
    std::vector<std::uint64_t> accepted, answered;   // in cycles
    std::vector<std::size_t> order;                  // in order of the answers
    std::vector<Issued> commands;
    DramStatistics statistics;
    std::vector<std::uint64_t> causes;
    std::uint64_t cycles = 0;
    friend bool operator==(const Log&, const Log&) = default;
};

/// Sends the addresses in turn. Each is sent when the memory accepts it and fewer than `most` are in flight,
/// or after a pause.
inline Log run(const DramPart& part, int khz, const std::vector<std::uint32_t>& addresses, std::size_t most,
               int most_pause = 0) {
    Dram dram{part, khz, int(most)};
    Log log;
    dram.record(&log.commands);
    const std::size_t n = addresses.size();
    log.accepted.resize(n);
    log.answered.resize(n);
    std::vector<std::optional<std::size_t>> under_way(most);   // by id: number of the request
    std::size_t sent = 0;
    Rng rng{n + most};
    int pause = 0;
    while (log.order.size() < n) {
        const std::uint64_t cycle = dram.now();
        if (cycle > 5000 * (n + 10)) FAIL("no answer for " << n - log.order.size() << " requests");
        if (dram.valid()) {
            auto& own = under_way[dram.answer().id];
            REQUIRE(own);   // no answer comes twice
            REQUIRE(dram.answer().addr == addresses[*own]);
            log.answered[*own] = cycle;
            log.order.push_back(*own);
            own.reset();
        }
        const auto free = std::find(under_way.begin(), under_way.end(), std::nullopt);
        const bool sends = sent < n && free != under_way.end() && dram.ready() && --pause < 0;
        const Dram::Answer request{std::uint32_t(free - under_way.begin()), sends ? addresses[sent] : 0};
        if (sends) {
            *free = sent;
            log.accepted[sent++] = cycle;
            if (most_pause > 0) pause = rng.below(most_pause);
        }
        dram.clock(sends ? &request : nullptr);
    }
    log.statistics = dram.statistics();
    for (int i = 0; i < dram_causes; ++i) log.causes.push_back(dram.cycles(DramCause(i)));
    log.cycles = dram.now();
    return log;
}

inline std::vector<std::uint32_t> sequence(std::size_t n) {
    std::vector<std::uint32_t> all(n);
    for (std::size_t i = 0; i < n; ++i) all[i] = std::uint32_t(i);
    return all;
}

/// Half of the addresses are close to each other, so that some hit open rows.
inline std::vector<std::uint32_t> mixed(std::size_t n, std::uint64_t seed) {
    Rng rng{seed};
    std::vector<std::uint32_t> all(n);
    for (auto& a : all) a = std::uint32_t(rng.below(2) ? rng.below(1 << 20) : rng.below(512));
    return all;
}

inline double bytes_per_second(const Log& log, int khz) {
    const auto ps = begin_of(log.answered[log.order.back()], khz) - begin_of(log.accepted[0], khz);
    return 64e12 * double(log.order.size()) / double(ps);
}

/// Judges a list of commands by the data sheet, in picoseconds and pair by pair. Shares no code with
/// DramBanks.
inline void check_commands(const DramPart& part, const std::vector<Issued>& all) {
    std::map<int, std::uint32_t> open;
    const auto gate = [&](std::size_t from, std::size_t to, int ps, const char* name) {
        if ((all[to].clock - all[from].clock) * part.tck < ps)
            FAIL(name << " of " << part.name << " at clock " << all[to].clock);
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Issued& c = all[i];
        const bool closes = c.command == Command::precharge || c.command == Command::precharge_all;
        if (i > 0) REQUIRE(c.clock > all[i - 1].clock);
        if (c.command == Command::read) REQUIRE((open.count(c.bank) && open[c.bank] == c.row));
        if (c.command == Command::precharge) REQUIRE(open.erase(c.bank) == 1);
        if (c.command == Command::precharge_all) open.clear();
        if (c.command == Command::refresh) REQUIRE(open.empty());
        if (c.command == Command::activate) REQUIRE(open.emplace(c.bank, c.row).second);
        int activates = 0;
        for (std::size_t k = i; k-- > 0 && i - k < 200;) {
            const bool same =
                all[k].bank == c.bank || c.command == Command::precharge_all || c.command == Command::refresh;
            const bool after_close =
                (all[k].command == Command::precharge && same) || all[k].command == Command::precharge_all;
            const bool same_group = all[k].bank % part.bank_groups == c.bank % part.bank_groups;
            switch (all[k].command) {
                case Command::activate:
                    if (c.command == Command::activate && same_group) gate(k, i, part.trrd_l, "tRRD_L");
                    if (c.command == Command::activate && ++activates == 4) gate(k, i, part.tfaw, "tFAW");
                    if (c.command == Command::activate) gate(k, i, part.trrd, "tRRD");
                    if ((c.command == Command::activate || c.command == Command::refresh) && same)
                        gate(k, i, part.trc, "tRC");
                    if (c.command == Command::read && same) gate(k, i, part.trcd, "tRCD");
                    if (closes && same) gate(k, i, part.tras, "tRAS");
                    break;
                case Command::read:
                    if (c.command == Command::read)
                        gate(k, i, std::max(part.tccd, part.burst_clocks() * part.tck), "tCCD");
                    if (c.command == Command::read && same_group) gate(k, i, part.tccd_l, "tCCD_L");
                    if (closes && same) gate(k, i, part.trtp, "tRTP");
                    break;
                case Command::refresh: gate(k, i, part.trfc, "tRFC"); break;
                default:
                    if ((c.command == Command::activate || c.command == Command::refresh) && after_close)
                        gate(k, i, part.trp, "tRP");
            }
        }
    }
}

inline std::string any_part() {
    return GENERATE(as<std::string>{}, "sdr", "sdr_half", "ddr3", "rpu", "ddr4", "lpddr4", "hbm2");
}

/// Selects parts whose answers take many cycles of a chip of some hundred MHz.
inline std::string slow_part() { return GENERATE(as<std::string>{}, "sdr", "sdr_half", "ddr3", "rpu"); }

/// Returns a part with timings that no real part combines: a row may close before the next read, and it has
/// short bursts, few banks and a small queue.
inline DramPart odd_part() {
    DramPart part = dram_part("ddr3");
    part.name = "odd";
    part.burst_length = 4;
    part.banks = 3;
    part.tck = 3'001;
    part.cl = 9;
    part.trtp = part.trrd = 1;
    part.tras = 20'000;
    part.trc = 60'000;
    part.tccd = 13'000;
    part.trefi = 900'000;
    part.queue = 5;
    part.request_ps = 0;
    part.answer_ps = 1;
    return part;
}

}   // namespace rayclock::test
