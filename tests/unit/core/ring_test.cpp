// Compares the model's queues, merges and pipes with plain descriptions.
#include <algorithm>

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
    std::optional<bool> held;   // the second source was offered and refused
    bool first = false, second = false;
    for (int i = 0; i < 5000; ++i) {
        first |= draw.percent(40);   // a source keeps its offer until it is accepted
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
    std::deque<std::pair<int, int>> plain;   // number, and cycle of admission
    Draw draw{unsigned(latency)};
    for (int cycle = 0; cycle < 5000; ++cycle) {
        const bool valid = !plain.empty() && cycle >= plain.front().second + latency + 1;
        REQUIRE(pipe.ready() == (int(plain.size()) < depth));
        REQUIRE(pipe.valid(std::uint64_t(cycle)) == valid);
        const bool admits = int(plain.size()) < depth && draw.percent(cycle / 1000 % 2 ? 90 : 30);
        const bool taken = valid && draw.percent(60);
        if (taken) {
            REQUIRE(pipe.front() == plain.front().first);
            plain.pop_front();
        }
        pipe.clock(std::uint64_t(cycle), taken, admits, cycle);
        if (admits) plain.emplace_back(cycle, cycle);
    }
}

TEST_CASE("a queue of contexts keeps their order, for few and for many of them", "[fifo]") {
    const int capacity = GENERATE(1, 64, 255, 256, 1024);
    RayRing queue(capacity);
    std::deque<RayNumber> plain;
    Draw draw{unsigned(capacity)};
    for (int i = 0; i < 20000; ++i) {
        const auto ray = RayNumber(draw.below(capacity));
        const bool few = capacity <= RayRing::most_few && draw.coin();
        if (!plain.empty()) REQUIRE((few ? queue.front<true>() : queue.front()) == plain.front());
        const bool pops = !plain.empty() && draw.coin(),
                   pushes = int(plain.size()) - pops < capacity && draw.percent(i / 5000 % 2 ? 20 : 80);
        queue.pop(pops);
        if (pops) plain.pop_front();
        few ? queue.push<true>(ray, pushes) : queue.push(ray, pushes);
        if (pushes) plain.push_back(ray);
        REQUIRE(queue.size() == plain.size());
        REQUIRE(queue.empty() == plain.empty());
        REQUIRE(queue.contains(ray) == (std::find(plain.begin(), plain.end(), ray) != plain.end()));
    }
}

TEST_CASE("a delay repeats an answer that it keeps, skipped cycles or not", "[fifo]") {
    const auto [latency, kept] = GENERATE(table<int, int>({{3, 2}, {20, 3}}));
    Delay delay{latency, 100, kept};
    std::vector<int> answers(6000, -1);   // [cycle]: a ray, or -1
    Draw draw{unsigned(latency)};
    const auto at = [&](std::uint64_t cycle) { return answers[cycle]; };
    for (std::uint64_t cycle = std::uint64_t(kept); cycle < 5000; ++cycle) {
        if (draw.percent(20)) {
            const std::uint64_t next = std::min(delay.due(cycle), cycle + std::uint64_t(draw.below(900)));
            delay.skip(cycle, next - cycle);
            cycle = std::min<std::uint64_t>(next, 5000);
        }
        for (const std::uint64_t back : {0, kept}) {
            const LinkRay answer = delay.answer(cycle - back);
            REQUIRE((answer.valid ? int(answer.ray) : -1) == at(cycle - back));
        }
        const LinkRay in{draw.percent(cycle / 500 % 2 ? 80 : 3), std::uint32_t(draw.below(1024))};
        delay.clock(cycle, in);
        if (in.valid) answers[cycle + std::uint64_t(latency) + 1] = int(in.ray);
    }
}

TEST_CASE("a delay answers in the cycle after its latency, whatever was skipped before", "[fifo]") {
    const auto [latency, depth] = GENERATE(table<int, int>({{1, 2}, {3, 2}, {6, 16}, {20, 32}, {63, 70}}));
    Delay delay{latency, depth};
    std::deque<std::pair<std::uint32_t, std::uint64_t>> plain;   // ray, and cycle of its answer
    Draw draw{unsigned(latency)};
    for (std::uint64_t cycle = 0; cycle < 5000; ++cycle) {
        if (draw.percent(5)) {   // skips idle time, sometimes more than all entries
            const std::uint64_t next = std::min(delay.due(cycle), cycle + std::uint64_t(draw.below(1500)));
            delay.skip(cycle, next - cycle);
            cycle = next;
        }
        const bool due = !plain.empty() && plain.front().second == cycle;
        REQUIRE(delay.ready() == (int(plain.size()) < depth));
        REQUIRE(delay.due(cycle) == (plain.empty() ? ~std::uint64_t(0) : plain.front().second));
        const LinkRay answer = delay.answer(cycle);
        REQUIRE(answer.valid == due);
        REQUIRE(answer.ray < 1024);   // a valid context number even without an answer
        if (due) REQUIRE(answer.ray == plain.front().first);
        const LinkRay in{delay.ready() && draw.percent(cycle / 1000 % 2 ? 90 : 30),
                         std::uint32_t(draw.below(1024))};
        delay.clock(cycle, in);
        if (due) plain.pop_front();
        if (in.valid) plain.emplace_back(in.ray, cycle + std::uint64_t(latency) + 1);
        const std::uint32_t absent = (in.ray + 1) % 1024;
        const bool known =
            std::any_of(plain.begin(), plain.end(), [&](const auto& entry) { return entry.first == absent; });
        REQUIRE(delay.contains(RayNumber(absent), cycle + 1) == known);
        if (in.valid) REQUIRE(delay.contains(RayNumber(in.ray), cycle + 1));
    }
}
