// Several DRAM channels: each behaves as a separate DRAM, answers come one per cycle, and bandwidths add up.
#include "model/mem/dram_channels.hpp"
#include "tests/support/world/dram_world.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct TimedRequest {
    std::uint64_t cycle;
    Dram::Answer what;
};

/// Sends random requests to `channels` and calls `each` in every cycle. Returns the requests with their
/// cycles.
template <class Each>
std::vector<TimedRequest> drive(DramChannels& channels, int turns, int ids, Each&& each) {
    Rng rng{std::uint64_t(turns)};
    std::vector<char> under_way(std::size_t(ids), 0);
    std::vector<TimedRequest> sent;
    for (int i = 0; i < turns; ++i) {
        if (channels.valid()) {
            REQUIRE(under_way[channels.answer().id]);
            under_way[channels.answer().id] = 0;
        }
        each();
        const auto id = std::uint32_t(rng.below(ids));
        const bool sends = channels.ready() && !under_way[id] && (i / 500 % 2 || rng.below(40) == 0);
        const Dram::Answer request{id, std::uint32_t(rng.below(2) ? rng.below(1 << 20) : rng.below(512))};
        if (sends) {
            sent.push_back({channels.now(), request});
            under_way[id] = 1;
        }
        channels.clock(sends ? &request : nullptr);
    }
    return sent;
}

}   // namespace

TEST_CASE("each channel is a DRAM of its own, and neighbouring words lie in different ones", "[dram]") {
    const std::string name = GENERATE(as<std::string>{}, "sdr", "ddr4", "hbm2");
    const int n = GENERATE(1, 2, 3, 4), khz = GENERATE(66'000, 1'000'000);
    const DramPart part = dram_part(name);
    constexpr int ids = 48;
    DramChannels channels(part, n, khz, ids);
    const auto count = static_cast<std::size_t>(n);
    std::vector<std::vector<Issued>> commands(count), alone(count);
    for (int c = 0; c < n; ++c) channels.record(c, &commands[std::size_t(c)]);
    struct MachineOutput {
        std::uint64_t cycle;
        std::uint32_t addr;
    };
    std::vector<MachineOutput> given;
    const auto sent = drive(channels, 12'000, ids, [&] {
        if (channels.valid()) given.push_back({channels.now(), channels.answer().addr});
    });
    REQUIRE(sent.size() > 50);
    CAPTURE(name, n, khz);

    // The same requests, each to a separate DRAM.
    std::vector<MachineOutput> due;
    for (int c = 0; c < n; ++c) {
        Dram dram(part, khz, ids);
        dram.record(&alone[std::size_t(c)]);
        std::size_t next = 0;
        for (std::uint64_t cycle = 0; cycle < 12'000; ++cycle) {
            if (dram.valid())
                due.push_back({cycle, dram.answer().addr * std::uint32_t(n) + std::uint32_t(c)});
            while (next < sent.size() && sent[next].what.addr % std::uint32_t(n) != std::uint32_t(c)) ++next;
            const bool now = next < sent.size() && sent[next].cycle == cycle;
            const Dram::Answer own{now ? sent[next].what.id : 0,
                                   now ? sent[next].what.addr / std::uint32_t(n) : 0};
            dram.clock(now ? &own : nullptr);
            next += now;
        }
    }
    REQUIRE(commands == alone);
    // One answer per cycle. Of answers in the same cycle, the lowest channel's comes first.
    std::stable_sort(due.begin(), due.end(),
                     [](const MachineOutput& a, const MachineOutput& b) { return a.cycle < b.cycle; });
    std::uint64_t free = 0;
    REQUIRE(given.size() <= due.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::uint64_t cycle = std::max(due[i].cycle, free);
        REQUIRE(given[i].addr == due[i].addr);
        REQUIRE(given[i].cycle == cycle);
        free = cycle + 1;
    }
}

TEST_CASE("channels add their bandwidths, as far as the port goes", "[dram]") {
    const int n = GENERATE(1, 2, 4);
    const DramPart part = dram_part("sdr");
    for (const int khz : {5'000, 200'000}) {
        constexpr std::uint64_t reads = 20'000;
        DramChannels channels(part, n, khz, 64);
        std::uint64_t sent = 0, answered = 0;
        std::vector<std::uint32_t> free;
        for (std::uint32_t id = 0; id < 64; ++id) free.push_back(id);
        while (answered < reads) {
            if (channels.valid()) ++answered, free.push_back(channels.answer().id);
            const bool sends = sent < reads && channels.ready() && !free.empty();
            const Dram::Answer request{sends ? free.back() : 0, std::uint32_t(sent)};
            if (sends) ++sent, free.pop_back();
            channels.clock(sends ? &request : nullptr);
        }
        const double bound = std::min(64e3 * khz, n * double(peak_bytes_per_second(part)));
        const double reached = 64e12 * double(reads) / double(begin_of(channels.now(), khz));
        CAPTURE(n, khz, reached / bound);
        CHECK(reached <= bound);
        CHECK(reached > 0.96 * bound);
    }
}

TEST_CASE("skipping quiet cycles of channels is the same as clocking them, and their account is full",
          "[dram]") {
    const int n = GENERATE(1, 2, 3, 4);
    const DramPart part = dram_part("ddr3");
    DramChannels clocked(part, n, 133'333, 40), skipped(part, n, 133'333, 40);
    Rng rng{std::uint64_t(n)};
    std::vector<char> under_way(40, 0);
    std::uint64_t skips = 0, answered = 0;
    for (int turn = 0; turn < 3000; ++turn) {
        const std::uint64_t target =
            clocked.now() + std::uint64_t(turn % 20 ? rng.below(3) : rng.below(rng.below(2) ? 60 : 6000));
        while (clocked.now() < target) {
            const std::uint64_t until = std::min(target, skipped.quiet_until());
            REQUIRE(until > skipped.now());
            skips += until - skipped.now() > 1;
            skipped.skip(until - skipped.now());
            const bool ready = clocked.ready(), valid = clocked.valid();
            while (clocked.now() < until) {
                REQUIRE((clocked.ready() == ready && clocked.valid() == valid));
                clocked.clock(nullptr);
            }
            REQUIRE((clocked.ready() == skipped.ready() && clocked.valid() == skipped.valid()));
            if (clocked.valid()) under_way[clocked.answer().id] = 0, ++answered;
        }
        const auto id = std::uint32_t(rng.below(40));
        const bool sends = clocked.ready() && !under_way[id];
        const Dram::Answer request{id, std::uint32_t(rng.below(1 << 16))};
        under_way[id] |= char(sends);
        clocked.clock(sends ? &request : nullptr);
        skipped.clock(sends ? &request : nullptr);
        REQUIRE((clocked.ready() == skipped.ready() && clocked.valid() == skipped.valid()));
        if (!clocked.valid()) continue;
        REQUIRE(clocked.answer().addr == skipped.answer().addr);
        under_way[clocked.answer().id] = 0, ++answered;
    }
    CHECK(skips > 100);
    CHECK(answered > 500);
    REQUIRE(clocked.statistics() == skipped.statistics());
    std::uint64_t sum = 0;
    for (int i = 0; i < dram_causes; ++i) {
        REQUIRE(clocked.cycles(DramCause(i)) == skipped.cycles(DramCause(i)));
        sum += clocked.cycles(DramCause(i));
    }
    REQUIRE(sum == clocked.now());
}
