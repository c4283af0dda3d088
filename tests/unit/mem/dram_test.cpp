// dram: commands follow the data sheet, latency and bandwidth follow formulas. Also refresh, order, accounts,
// and skipping of quiet cycles.
#include "tests/support/world/dram_world.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("all commands under mixed traffic keep the data sheet, and give each request its reads", "[dram]") {
    const std::string name =
        GENERATE(as<std::string>{}, "sdr", "sdr_half", "ddr3", "rpu", "ddr4", "lpddr4", "hbm2", "odd");
    const DramPart part = name == "odd" ? odd_part() : dram_part(name);
    const auto [most, pause] = GENERATE(table<std::size_t, int>({{64, 0}, {5, 0}, {64, 40}, {1, 0}}));
    const Log log = run(part, 100'000, mixed(3000, most), most, pause);
    check_commands(part, log.commands);
    const auto count = [&](Command c) {
        const auto is = [c](const Issued& i) { return i.command == c; };
        return std::uint64_t(std::count_if(log.commands.begin(), log.commands.end(), is));
    };
    REQUIRE(count(Command::read) == 3000 * std::uint64_t(part.bursts()));
    const DramStatistics& s = log.statistics;
    REQUIRE(s.reads == 3000);
    REQUIRE(s.row_hits + s.row_misses + s.row_conflicts == 3000);
    REQUIRE(s.refreshes == count(Command::refresh));
    REQUIRE(s.bytes == 64 * 3000);
    REQUIRE(s.bus_ps == 3000 * std::uint64_t(part.bursts() * part.burst_clocks() * part.tck));
    CHECK(s.row_hits > 50);
    CHECK(s.row_conflicts > 50);
    REQUIRE(run(part, 100'000, mixed(3000, most), most, pause) == log);   // a second run is equal
}

TEST_CASE("a lone read takes as long as its row's state says, to the cycle", "[dram]") {
    const DramPart part = dram_part(any_part());
    const int khz = GENERATE(25'000, 66'000, 100'000, 133'333, 333'333, 1'000'000);
    const std::vector<std::uint32_t> addresses{address(part, 0, 1, 3), address(part, 0, 1, 4),
                                               address(part, 5, 1, 3)};
    const Log log = run(part, khz, addresses, 1);
    const std::int64_t row = clocks(part, part.trcd), close = clocks(part, part.trp);
    const std::int64_t waits[]{row, 0, close + row};   // closed, open, another row open
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(part.name, khz, i);
        const std::uint64_t arrival = begin_of(log.accepted[i] + 1, khz) + std::uint64_t(part.request_ps);
        std::int64_t clock =
            std::int64_t((arrival + std::uint64_t(part.tck) - 1) / std::uint64_t(part.tck)) + waits[i];
        // A newly opened row may have to stay open for tRAS, and the bank to wait for tRC.
        if (i == 2) {
            const std::int64_t opened = log.commands[0].clock,
                               last = log.commands[2 * std::size_t(part.bursts())].clock;
            const std::int64_t may_close =
                std::max(opened + clocks(part, part.tras), last + clocks(part, part.trtp));
            clock = std::max({clock, may_close + close + row, opened + clocks(part, part.trc) + row});
        }
        clock += (part.bursts() - 1) * read_step(part) + part.cl + part.burst_clocks();
        REQUIRE(log.answered[i] == cycle_from(std::uint64_t(clock * part.tck + part.answer_ps), khz));
    }
    REQUIRE(log.statistics.row_misses == 1);
    REQUIRE(log.statistics.row_hits == 1);
    REQUIRE(log.statistics.row_conflicts == 1);
}

TEST_CASE("reads in sequence reach the peak bandwidth less refresh, and never more", "[dram]") {
    const DramPart part = dram_part(any_part());
    const int slow = GENERATE(66'000, 200'000);
    // So fast that the port does not limit.
    const int khz = 64e3 * slow > double(peak_bytes_per_second(part)) ? slow : 10 * slow;
    const Log log = run(part, khz, sequence(20'000), 64);
    check_commands(part, log.commands);
    const double peak = double(peak_bytes_per_second(part)), reached = bytes_per_second(log, khz);
    // A refresh costs: last read, precharge, refresh, activate, first read.
    const std::int64_t closing = clocks(part, part.trtp) + clocks(part, part.trp);
    const std::int64_t around = closing + clocks(part, part.trfc) + clocks(part, part.trcd);
    const double lost = double(around * part.tck);
    CAPTURE(part.name, khz, reached / peak, lost / part.trefi);
    CHECK(reached <= peak);
    // Banks of several groups are opened one after the other.
    CHECK(reached >= peak * (1 - lost / part.trefi) * (part.bank_groups > 1 ? 0.93 : 0.999));
    CHECK(reached <= peak * (1 - part.trfc / double(part.trefi)));
}

TEST_CASE("reads of ever other rows of a bank take a row cycle each, and dependent reads their latency",
          "[dram]") {
    const DramPart part = dram_part(any_part());
    std::vector<std::uint32_t> rows(2000);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = address(part, std::uint32_t(i), 2, 0);
    const Log log = run(part, 200'000, rows, 64);
    const std::int64_t reads = (part.bursts() - 1) * read_step(part);
    const std::int64_t to_close =
        std::max(clocks(part, part.tras), clocks(part, part.trcd) + reads + clocks(part, part.trtp));
    const std::int64_t turn = std::max(clocks(part, part.trc), to_close + clocks(part, part.trp));
    const double bound = 64e12 / double(turn * part.tck), reached = bytes_per_second(log, 200'000);
    CHECK(reached <= bound);
    CHECK(reached >= bound * std::min(0.96, 1 - 1.35 * part.trfc / part.trefi));   // refresh
    CHECK(bound < 0.9 * double(peak_bytes_per_second(part)));
    CHECK(log.statistics.row_hits == 0);

    const double one_by_one = bytes_per_second(run(part, 100'000, mixed(2000, 1), 1), 100'000);
    const double together = bytes_per_second(run(part, 100'000, mixed(2000, 1), 64), 100'000);
    CHECK(one_by_one < 0.7 * together);
    CHECK(together < double(peak_bytes_per_second(part)));
}

TEST_CASE("a DRAM refreshes every tREFI, busy or idle or skipped, and nothing happens for tRFC", "[dram]") {
    const DramPart part = dram_part(any_part());
    const std::int64_t every = part.trefi / part.tck;
    const bool skips = GENERATE(false, true);
    Dram dram{part, 100'000, 4};
    std::vector<Issued> log;
    dram.record(&log);
    const std::uint64_t idle = 100'000;   // in cycles; one millisecond
    if (skips) {
        REQUIRE(dram.quiet_until() > idle);
        dram.skip(idle);
    } else {
        for (std::uint64_t i = 0; i < idle; ++i) dram.clock(nullptr);
    }
    REQUIRE(dram.now() == idle);
    REQUIRE(dram.cycles(DramCause::starved) == idle);
    REQUIRE(log.size() == std::size_t(1'000'000'000 / (every * part.tck)));
    for (std::size_t k = 0; k < log.size(); ++k)
        REQUIRE(log[k] == Issued{std::int64_t(k + 1) * every, Command::refresh, 0, 0});
    REQUIRE(dram.statistics().refreshes == log.size());

    // A request that arrives when a refresh begins waits for its end.
    const std::int64_t due = std::int64_t(log.size() + 1) * every;
    const auto arrival = [&](std::uint64_t cycle) {
        return begin_of(cycle + 1, 100'000) + std::uint64_t(part.request_ps);
    };
    while (arrival(dram.now() + 1) <= std::uint64_t(due * part.tck)) dram.clock(nullptr);
    log.clear();
    dram.clock(nullptr);
    const Dram::Answer request{2, 77};
    const std::uint64_t accepted = dram.now();
    dram.clock(&request);
    while (!dram.valid()) dram.clock(nullptr);
    REQUIRE(log.size() >= 3);
    REQUIRE(log[0] == Issued{due, Command::refresh, 0, 0});
    REQUIRE(log[1].command == Command::activate);
    REQUIRE(log[1].clock == due + clocks(part, part.trfc));
    const auto from = std::uint64_t(due * part.tck), until = from + std::uint64_t(part.trfc);
    std::uint64_t blocked = 0;
    for (std::uint64_t cycle = accepted + 1; begin_of(cycle, 100'000) < until; ++cycle)
        blocked += begin_of(cycle + 1, 100'000) > from;
    REQUIRE(dram.cycles(DramCause::refresh) == blocked);

    // Under load each refresh comes at most the longest request and row time after it is due.
    const Log load = run(part, 100'000, mixed(5000, 3), 64);
    std::int64_t k = 0;
    for (const Issued& c : load.commands)
        if (c.command == Command::refresh) {
            const std::int64_t late = c.clock - ++k * every;
            REQUIRE(late >= 0);
            const std::int64_t to_close =
                part.bursts() * read_step(part) + clocks(part, part.tras) + clocks(part, part.trtp);
            REQUIRE(late <= to_close + clocks(part, part.trp) + 2);
        }
    REQUIRE(k >= load.commands.back().clock / every - 1);
}

TEST_CASE("a faster chip waits more cycles but not more time for the same reads", "[dram]") {
    const DramPart part = dram_part(slow_part());
    std::vector<std::uint64_t> cycles, ps;
    for (const int khz : {50'000, 100'000, 200'000, 400'000}) {
        const Log log = run(part, khz, mixed(500, 9), 1);
        cycles.push_back(log.cycles);
        ps.push_back(begin_of(log.cycles, khz));
    }
    for (std::size_t i = 1; i < cycles.size(); ++i) {
        CHECK(double(cycles[i]) > 1.7 * double(cycles[i - 1]));
        CHECK(ps[i] <= ps[i - 1]);
    }
    CHECK(double(ps[3]) > 0.8 * double(ps[0]));
}

TEST_CASE(
    "a read of an open row goes before older reads, but no request is overtaken more often than the cap",
    "[dram]") {
    DramPart part = dram_part(slow_part());
    part.age_cap = GENERATE(1, 3, 16, 40);
    part.trefi = 1'000'000'000;   // a refresh would end the run of hits
    // Some requests go to another row of the bank that all the others hit.
    std::vector<std::uint32_t> addresses(1500);
    for (std::size_t i = 0; i < addresses.size(); ++i)
        addresses[i] = address(part, i % 60 == 20 ? 1 : 0, 0, std::uint32_t(i) % row_words(part));
    const auto most_overtaken = [](const Log& log) {
        std::size_t most = 0;
        for (std::size_t at = 0; at < log.order.size(); ++at)
            most = std::max(
                most, std::size_t(std::count_if(log.order.begin(), log.order.begin() + std::ptrdiff_t(at),
                                                [&](std::size_t other) { return other > log.order[at]; })));
        return most;
    };
    const Log log = run(part, 200'000, addresses, 64);
    CAPTURE(part.name, part.age_cap);
    REQUIRE(most_overtaken(log) == std::size_t(part.age_cap));
    const std::size_t mixed_most = most_overtaken(run(part, 200'000, mixed(1500, 5), 64));
    REQUIRE(mixed_most > 0);
    REQUIRE(mixed_most <= std::size_t(part.age_cap));
}

TEST_CASE("a row is not closed while a request for it waits, even if the bus belongs to another bank",
          "[dram]") {
    DramPart part = dram_part(slow_part());
    part.trefi = 1'000'000'000;
    Dram dram{part, 400'000, 8};
    std::vector<std::uint32_t> order;
    const auto send = [&](std::vector<std::uint32_t> addresses) {
        for (const std::uint32_t addr : addresses) {
            const Dram::Answer request{addr % 8, addr};
            dram.clock(&request);
        }
        for (std::size_t answered = 0; answered < addresses.size(); dram.clock(nullptr))
            if (dram.valid()) {
                order.push_back(dram.answer().addr);
                ++answered;
            }
    };
    send({address(part, 0, 0, 0), address(part, 0, 1, 1)});   // two open rows
    const std::uint32_t other_row = address(part, 1, 0, 6), same_row = address(part, 0, 0, 7);
    send({address(part, 0, 1, 2), address(part, 0, 1, 3), address(part, 0, 1, 4), same_row, other_row});
    REQUIRE(order[5] == same_row);
    REQUIRE(order[6] == other_row);
    REQUIRE(dram.statistics().row_hits == 4);
    REQUIRE(dram.statistics().row_conflicts == 1);
}

TEST_CASE("the controller accepts requests until its queue is full, and another when one has its last read",
          "[dram]") {
    const DramPart part = dram_part(slow_part());
    Dram dram{part, 400'000, 64};
    std::vector<Issued> log;
    dram.record(&log);
    for (std::uint32_t i = 0; i < std::uint32_t(part.queue); ++i) {
        REQUIRE(dram.ready());
        const Dram::Answer request{i, address(part, 0, 0, i)};
        dram.clock(&request);
    }
    REQUIRE_FALSE(dram.ready());
    while (!dram.ready()) dram.clock(nullptr);
    REQUIRE(log.size() == std::size_t(1 + part.bursts()));
    REQUIRE(dram.now() == cycle_from(std::uint64_t(log.back().clock * part.tck), 400'000));
}

TEST_CASE("the causes of a DRAM's cycles are a full account, and busy are those with data on the bus",
          "[dram]") {
    const DramPart part = dram_part(any_part());
    const auto [most, pause] = GENERATE(table<std::size_t, int>({{1, 0}, {8, 0}, {64, 0}, {8, 3000}}));
    const int khz = GENERATE(20'000, 133'333, 700'000);
    const Log log = run(part, khz, mixed(1500, 11), most, pause);
    std::uint64_t busy = 0, next = 0, sum = 0;
    for (const Issued& c : log.commands)
        if (c.command == Command::read) {
            const auto from = std::uint64_t((c.clock + part.cl) * part.tck);
            const auto until = from + std::uint64_t(part.burst_clocks() * part.tck);
            std::uint64_t cycle = cycle_from(from + 1, khz) - 1;   // the cycle in which it begins
            for (cycle = std::max(cycle, next); begin_of(cycle, khz) < until; ++cycle) {
                ++busy;
                next = cycle + 1;
            }
        }
    for (const std::uint64_t n : log.causes) sum += n;
    REQUIRE(sum == log.cycles);
    REQUIRE(log.causes[std::size_t(DramCause::busy)] == busy);
    REQUIRE(log.causes[std::size_t(DramCause::row)] > 0);
    if (pause > 0) REQUIRE(log.causes[std::size_t(DramCause::starved)] > log.cycles / 10);
}

TEST_CASE("skipping quiet cycles of a DRAM is the same as clocking them", "[dram]") {
    const DramPart part = dram_part(any_part());
    const int khz = GENERATE(20'000, 133'333, 700'000);
    const int ids = 40;
    Dram clocked{part, khz, ids}, skipped{part, khz, ids};
    std::vector<Issued> one, other;
    clocked.record(&one);
    skipped.record(&other);
    Rng rng{std::uint64_t(khz)};
    std::vector<char> under_way(std::size_t(ids), 0);
    std::uint64_t sent = 0, answered = 0, skips = 0;
    const auto same = [&] {
        if (clocked.ready() != skipped.ready() || clocked.valid() != skipped.valid())
            FAIL("the answers differ in cycle " << clocked.now());
        if (clocked.valid() &&
            (clocked.answer().id != skipped.answer().id || clocked.answer().addr != skipped.answer().addr))
            FAIL("answers differ in cycle " << clocked.now());
    };
    const auto take = [&] {
        if (!clocked.valid()) return;
        REQUIRE(under_way[clocked.answer().id]);
        under_way[clocked.answer().id] = 0;
        ++answered;
    };
    for (int turn = 0; turn < 6000; ++turn) {
        // Requests come in bursts, with gaps of any length between them.
        const int gap = turn % 20 ? rng.below(3) : rng.below(rng.below(2) ? 60 : 6000);
        const std::uint64_t target = clocked.now() + std::uint64_t(gap);
        while (clocked.now() < target) {
            const std::uint64_t until = std::min(target, skipped.quiet_until());
            REQUIRE(until > skipped.now());
            skips += until - skipped.now() > 1;
            skipped.skip(until - skipped.now());
            const bool ready = clocked.ready(), valid = clocked.valid();
            while (clocked.now() < until) {
                if (clocked.ready() != ready || clocked.valid() != valid)
                    FAIL("not quiet in cycle " << clocked.now());
                clocked.clock(nullptr);
            }
            same();
            take();
        }
        const auto id = std::uint32_t(rng.below(ids));
        const bool sends = clocked.ready() && !under_way[id];
        const Dram::Answer request{id, std::uint32_t(rng.below(2) ? rng.below(1 << 20) : rng.below(512))};
        under_way[id] |= char(sends);
        sent += sends;
        clocked.clock(sends ? &request : nullptr);
        skipped.clock(sends ? &request : nullptr);
        same();
        take();
    }
    REQUIRE(sent > 1000);
    REQUIRE(skips > 200);
    REQUIRE(sent - answered == std::uint64_t(std::count(under_way.begin(), under_way.end(), 1)));
    REQUIRE(clocked.statistics() == skipped.statistics());
    REQUIRE(one == other);
    for (int i = 0; i < dram_causes; ++i)
        REQUIRE(clocked.cycles(DramCause(i)) == skipped.cycles(DramCause(i)));
}
