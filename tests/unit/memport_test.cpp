// memport: latency and bandwidth as stated; jitter and stalls as seeded.
#include <algorithm>
#include <optional>

#include <catch2/catch.hpp>

#include "model/mem/memport.hpp"

using namespace rayclock;

namespace {

Config memory(int latency, int interval) {
    Config config;
    config.mem_latency = latency;
    config.mem_interval = interval;
    return config;
}

/// What a port did: when each request was accepted and when its answer was first on offer.
struct Log {
    std::vector<int> accepted, offered, order;
    friend bool operator==(const Log&, const Log&) = default;
};

/// Sends n requests as soon as each is accepted, contexts in turn; takes answers except every `refuse`th cycle. The address
/// is the number of the request.
Log run(const Config& config, Traffic traffic, int n, int refuse = 0) {
    Memport port{config, traffic};
    Log log;
    std::vector<char> seen(std::size_t(n), 0);
    std::optional<Memport::Answer> held;
    int sent = 0, pending = 0;
    for (int cycle = 0; int(log.order.size()) < n; ++cycle) {
        REQUIRE(cycle < 1000 * n);
        const bool take = refuse == 0 || cycle % refuse != 0;
        if (held) REQUIRE((port.valid() && port.answer().addr == held->addr && port.answer().ray == held->ray));
        if (port.valid() && !held) log.offered.push_back(cycle);
        held.reset();
        if (port.valid()) {
            const Memport::Answer answer = port.answer();
            REQUIRE(answer.ray == answer.addr % 64);
            if (take) {
                REQUIRE(seen[answer.addr]++ == 0);   // nothing twice
                log.order.push_back(int(answer.addr));
            } else {
                held = answer;
            }
        }
        const bool taken = port.valid() && take;
        pending -= taken;
        const Memport::Answer request{std::uint32_t(sent) % 64, std::uint32_t(sent)};
        const bool sends = port.ready() && sent < n && pending < 60;
        if (sends) {
            log.accepted.push_back(cycle);
            ++sent;
            ++pending;
        }
        port.clock(sends ? &request : nullptr, taken);
    }
    REQUIRE(std::count(seen.begin(), seen.end(), 1) == n);   // nothing lost
    return log;
}

} // namespace

TEST_CASE("a memory answer comes exactly mem_latency cycles after its request", "[memport]") {
    const int latency = GENERATE(1, 2, 8, 50);
    const Log log = run(memory(latency, 1), {}, 200);
    for (std::size_t i = 0; i < 200; ++i) {
        REQUIRE(log.order[i] == int(i));
        REQUIRE(log.accepted[i] == int(i));
        REQUIRE(log.offered[i] == int(i) + latency);
    }
}

TEST_CASE("a memory port takes one request every mem_interval cycles", "[memport]") {
    const int interval = GENERATE(1, 2, 3, 7);
    const Log log = run(memory(5, interval), {}, 100);
    for (std::size_t i = 0; i < 100; ++i) {
        REQUIRE(log.accepted[i] == int(i) * interval);
        REQUIRE(log.offered[i] == int(i) * interval + 5);
    }
}

TEST_CASE("an answer that is not taken stays, and the others wait in order", "[memport]") {
    const Log log = run(memory(4, 1), {}, 200, 2);
    REQUIRE(std::is_sorted(log.order.begin(), log.order.end()));
}

TEST_CASE("jitter lets answers overtake each other within its bound and loses nothing", "[memport]") {
    const Traffic traffic{9, 0, GENERATE(1u, 2u, 3u)};
    const Log log = run(memory(8, 1), traffic, 500);
    REQUIRE_FALSE(std::is_sorted(log.order.begin(), log.order.end()));
    int late = 0;
    for (std::size_t i = 0; i < 500; ++i) {
        const int waited = log.offered[i] - log.accepted[std::size_t(log.order[i])];
        REQUIRE(waited >= 8);
        late += waited > 8;
    }
    REQUIRE(late > 250);
    REQUIRE(run(memory(8, 1), traffic, 500) == log);
    Traffic other = traffic;
    other.seed += 10;
    REQUIRE_FALSE(run(memory(8, 1), other, 500) == log);
}

TEST_CASE("a stalling memory port refuses about the stated share of cycles, the same for the same seed", "[memport]") {
    const Traffic traffic{0, 40, 7};
    const Log log = run(memory(3, 1), traffic, 2000);
    const double share = 2000.0 / (log.accepted.back() + 1);
    REQUIRE(share == Approx(0.6).margin(0.03));
    REQUIRE(run(memory(3, 1), traffic, 2000) == log);
}

TEST_CASE("the sink refuses about the stated share of cycles", "[memport]") {
    Sink open{Traffic{}}, half{Traffic{0, 50, 3}};
    int ready = 0;
    for (int i = 0; i < 4000; ++i) {
        REQUIRE(open.ready());
        ready += half.ready();
        open.clock();
        half.clock();
    }
    REQUIRE(ready == Approx(2000).margin(120));
}
