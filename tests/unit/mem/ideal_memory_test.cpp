// memory: the ideal one has the stated latency and bandwidth; jitter and stalls are seeded and work with
// every kind of memory.
#include <algorithm>
#include <optional>

#include <catch2/catch.hpp>

#include "model/mem/memory.hpp"
#include "tests/support/skipping.hpp"

namespace rayclock::test::ideal_memory_test {

using namespace rayclock;

namespace {

constexpr int khz = 66000;

Config memory(int latency, int interval) {
    Config config;
    config.dram = DramName::ideal;
    config.mem_latency = latency;
    config.mem_interval = interval;
    return config;
}

/// The history of a memory: the cycle in which each request was accepted, and the cycles and the order of the
/// answers.
struct Log {
    std::vector<int> accepted, came, order;
    friend bool operator==(const Log&, const Log&) = default;
};

/// Sends n requests as soon as each is accepted. Ids rotate, and each is used again only after its last
/// answer. The address is the number of the request.
template <class Port> Log run(Port& port, int n, int ids) {
    Log log;
    std::vector<char> seen(std::size_t(n), 0), busy(std::size_t(ids), 0);
    int sent = 0;
    for (int cycle = 0; int(log.order.size()) < n; ++cycle) {
        REQUIRE(cycle < 1000 * n);
        int answered = -1;
        if (port.valid()) {
            const IdealMemory::Answer answer = port.answer();
            REQUIRE(answer.id == answer.addr % std::uint32_t(ids));
            REQUIRE(seen[answer.addr]++ == 0);   // no answer comes twice
            log.came.push_back(cycle);
            log.order.push_back(int(answer.addr));
            answered = int(answer.id);
        }
        const std::uint32_t id = std::uint32_t(sent % ids);
        const IdealMemory::Answer request{id, std::uint32_t(sent)};
        const bool sends = port.ready() && sent < n && !busy[id];
        if (sends) {
            log.accepted.push_back(cycle);
            busy[id] = 1;
            ++sent;
        }
        if (answered >= 0) busy[std::size_t(answered)] = 0;
        port.clock(sends ? &request : nullptr);
    }
    REQUIRE(std::count(seen.begin(), seen.end(), 1) == n);   // no answer is lost
    return log;
}
Log run_ideal(const Config& config, int n) {
    IdealMemory port{config, 64};
    return run(port, n, 64);
}
Log run_disturbed(const Config& config, Disturbance disturbance, int n) {
    Memory port{config, khz, disturbance};
    return run(port, n, 1 << config.mem_id_bits());
}

}   // namespace

TEST_CASE("an answer of the ideal memory comes exactly mem_latency cycles after its request", "[memport]") {
    const int latency = GENERATE(1, 2, 8, 50);
    const Log log = run_ideal(memory(latency, 1), 200);
    for (std::size_t i = 0; i < 200; ++i) {
        REQUIRE(log.order[i] == int(i));
        REQUIRE(log.accepted[i] == int(i));
        REQUIRE(log.came[i] == int(i) + latency);
    }
}

TEST_CASE("the ideal memory accepts one request every mem_interval cycles", "[memport]") {
    const int interval = GENERATE(1, 2, 3, 7);
    const Log log = run_ideal(memory(5, interval), 100);
    for (std::size_t i = 0; i < 100; ++i) {
        REQUIRE(log.accepted[i] == int(i) * interval);
        REQUIRE(log.came[i] == int(i) * interval + 5);
    }
}

TEST_CASE("the ideal memory returns the next cycle with a change, and skips to it", "[memport]") {
    const int latency = GENERATE(1, 8, 50), interval = GENERATE(1, 3);
    IdealMemory stepped{memory(latency, interval), 16}, skipped{memory(latency, interval), 16};
    Rng rng(std::uint64_t(latency * 10 + interval));
    int under_way = 0;
    for (std::uint64_t now = 0, i = 0; i < 500; ++i) {
        INFO("cycle " << now);
        REQUIRE(stepped.valid() == skipped.valid());
        REQUIRE(stepped.ready() == skipped.ready());
        const IdealMemory::Answer request{std::uint32_t(i % 16), std::uint32_t(i)};
        const bool sends = stepped.ready() && under_way < 10 && rng.below(3) == 0;
        under_way += int(sends) - int(stepped.valid());
        stepped.clock(sends ? &request : nullptr);
        skipped.clock(sends ? &request : nullptr);
        ++now;
        test::pass_quiet(stepped, skipped, now);
    }
}

TEST_CASE("without disturbance a memory has the timing of its kind, and counts its work", "[memport]") {
    const Config config = memory(8, 2);
    REQUIRE(run_disturbed(config, {}, 200) == [&] {
        IdealMemory port{config, 1 << config.mem_id_bits()};
        return run(port, 200, 1 << config.mem_id_bits());
    }());
    Memory ideal{config, khz, {}};
    const Log log = run(ideal, 200, 1 << config.mem_id_bits());
    REQUIRE(ideal.stats() == MemoryStats{200, 0, 0, 0});
    Memory again{config, khz, {}};
    for (int cycle = 0; cycle < 30; ++cycle) {
        const IdealMemory::Answer request{0, 7};
        again.clock(cycle == 5 ? &request : nullptr);
    }
    // The answer; the cycles between it and the request; the rest.
    REQUIRE(again.outcomes() == std::array<std::uint64_t, 8>{1, 7, 0, 22});
}

TEST_CASE("jitter lets answers overtake each other within its bound and loses nothing", "[memport]") {
    Config config = memory(8, 1);
    config.dram = GENERATE(DramName::ideal, DramName::sdr, DramName::ddr3);
    config.node_mshrs = 32;
    const Disturbance disturbance{config.dram == DramName::ideal ? 9 : 60, 0, GENERATE(1u, 2u, 3u)};
    INFO(name_of(config.dram) << ", seed " << disturbance.seed);
    const Log log = run_disturbed(config, disturbance, 500);
    REQUIRE_FALSE(std::is_sorted(log.order.begin(), log.order.end()));
    REQUIRE(run_disturbed(config, disturbance, 500) == log);
    Disturbance other = disturbance;
    other.seed += 10;
    REQUIRE_FALSE(run_disturbed(config, other, 500) == log);
    if (config.dram != DramName::ideal) return;
    int late = 0;
    for (std::size_t i = 0; i < 500; ++i) {
        const int waited = log.came[i] - log.accepted[std::size_t(log.order[i])];
        REQUIRE(waited > 8);   // the disturbance adds a cycle
        late += waited > 9;
    }
    REQUIRE(late > 250);
}

TEST_CASE("a stalling memory refuses about the stated share of cycles, the same for the same seed",
          "[memport]") {
    Config config = memory(3, 1);
    config.node_mshrs = 64;
    const Disturbance disturbance{0, 40, 7};
    const Log log = run_disturbed(config, disturbance, 2000);
    const double share = 2000.0 / (log.accepted.back() + 1);
    REQUIRE(share == Approx(0.6).margin(0.03));
    REQUIRE(run_disturbed(config, disturbance, 2000) == log);
}

TEST_CASE("the sink refuses about the stated share of cycles, each sink others", "[memport]") {
    Sink open{Disturbance{}, 0}, half{Disturbance{0, 50, 3}, 0}, other{Disturbance{0, 50, 3}, 1},
        shut{Disturbance{0, 100, 3}, 0};
    int ready = 0, differ = 0, shut_ready = 0;
    for (int i = 0; i < 4000; ++i) {
        REQUIRE(open.ready());
        ready += half.ready();
        differ += half.ready() != other.ready();
        shut_ready += shut.ready();
        for (Sink* sink : {&open, &half, &other, &shut}) sink->clock();
    }
    REQUIRE(ready == Approx(2000).margin(120));
    REQUIRE(differ == Approx(2000).margin(120));
    REQUIRE(shut_ready <= 1);
}

}   // namespace rayclock::test::ideal_memory_test
