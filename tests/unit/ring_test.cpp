// Queues, merges and pipes of the model, each against its plain description.
#include "tests/support/world/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("a ring is a queue of its capacity", "[fifo]") {
    const int capacity = GENERATE(1, 2, 3, 4, 16, 64);
    Ring<int> ring{capacity};
    std::deque<int> plain;
    Draw draw{unsigned(capacity)};
    for (int i = 0; i < 5000; ++i) {
        REQUIRE(ring.empty() == plain.empty());
        REQUIRE(ring.full() == (plain.size() == std::size_t(capacity)));
        REQUIRE(ring.size() == plain.size());
        for (std::size_t k = 0; k < plain.size(); ++k)
            if (ring.at(k) != plain[k]) FAIL("entry " << k << " after " << i << " moves");
        if (!plain.empty() && draw.percent(i / 500 % 2 ? 60 : 40)) {
            REQUIRE(ring.front() == plain.front());
            ring.pop();
            plain.pop_front();
        }
        if (int(plain.size()) < capacity && draw.coin()) {
            ring.push(i);
            plain.push_back(i);
        }
    }
}

TEST_CASE("a merge prefers its first source but does not change an offer", "[fifo]") {
    Merge merge;
    Draw draw{4};
    std::optional<bool> held;   // second on offer and refused
    bool first = false, second = false;
    for (int i = 0; i < 5000; ++i) {
        first |= draw.percent(40);   // a source that has something keeps it until it is taken
        second |= draw.percent(40);
        const bool valid = first || second, chosen = merge.second(first);
        if (valid) REQUIRE(chosen == held.value_or(!first));
        const bool taken = valid && draw.coin();
        merge.clock(valid, taken, chosen);
        held = valid && !taken ? std::optional(chosen) : std::nullopt;
        if (taken) (chosen ? second : first) = false;
    }
}

TEST_CASE("a pipe answers after latency + 1 cycles, in order, and holds as many as its queue", "[fifo]") {
    const auto [latency, depth] = GENERATE(table<int, int>({{1, 2}, {3, 2}, {6, 16}, {20, 32}}));
    Pipe<int> pipe{latency, depth};
    std::deque<std::pair<int, int>> plain;   // number, cycle admitted
    Draw draw{unsigned(latency)};
    for (int cycle = 0; cycle < 5000; ++cycle) {
        const bool valid = !plain.empty() && cycle >= plain.front().second + latency + 1;
        REQUIRE(pipe.ready() == (int(plain.size()) < depth));
        REQUIRE(pipe.valid(std::uint64_t(cycle)) == valid);
        const bool admits = int(plain.size()) < depth && draw.percent(cycle / 1000 % 2 ? 90 : 30);
        if (valid && draw.percent(60)) {
            REQUIRE(pipe.front() == plain.front().first);
            pipe.leave();
            plain.pop_front();
        }
        if (admits) {
            pipe.admit(std::uint64_t(cycle)) = cycle;
            plain.emplace_back(cycle, cycle);
        }
    }
}
