#pragma once
// The rules of a cache, as checks that run on its model and on its RTL.
#include "tests/support/world/cache_world.hpp"

namespace rayclock::test {

template <class K> std::vector<std::string> quick_shapes() {
    if constexpr (std::is_same_v<K, NodeCache>)
        return {"default", "smallest"};
    else if constexpr (std::is_same_v<K, PrimCache>)
        return {"default", "wide"};
    else
        return {"direct"};
}
template <class K> std::vector<std::string> other_shapes() {
    std::vector<std::string> others;
    const std::vector<std::string> quick = quick_shapes<K>();
    for (const std::string name : {"default", "smallest", "one context", "direct", "wide", "four", "set"})
        if (std::find(quick.begin(), quick.end(), name) == quick.end()) others.push_back(name);
    return others;
}
template <class Dut> constexpr bool is_model = std::is_same_v<Dut, CacheModel<typename Dut::CacheKind>>;

/// Requests a single line. Returns the ids of its words after all of them were requested from memory.
template <class Dut>
std::vector<std::uint32_t> send_for(CacheBench<Dut>& bench, std::uint32_t id, std::uint32_t addr) {
    std::vector<std::uint32_t> words;
    CacheLinks<typename Dut::CacheKind> seen = bench.look_up(id, addr);
    REQUIRE(seen.req.fires());
    for (int n = 0; int(words.size()) < bench.shape.words; ++n) {
        REQUIRE(n < bench.shape.words + 2);
        seen = bench.cycle();
        if (seen.miss.fires()) words.push_back(seen.miss.offer->id);
    }
    return words;
}

template <class Dut> void check_hit_latency(const Config& config) {
    CacheBench<Dut> bench{config};
    for (const std::uint32_t line : {0u, 5u, 77u}) {
        bench.get(bench.addr(line));
        for (std::uint32_t part = 0; part < bench.parts(); ++part) {
            bench.dut.rsp.ready = part % 2 == 0;   // with and without a ready receiver
            REQUIRE(bench.look_up(0, bench.addr(line, part)).req.fires());
            const auto looked_up = bench.cycle();
            REQUIRE(looked_up.outcome == CacheOutcome::hit);
            REQUIRE_FALSE(looked_up.rsp.offer);
            REQUIRE_FALSE(bench.cycle().rsp.offer);
            REQUIRE(bench.right(bench.cycle().rsp.offer, 0, bench.addr(line, part)));
            bench.dut.rsp.ready = true;
            REQUIRE(bench.cycle().rsp.offer.has_value() == (part % 2 != 0));
        }
    }
}

template <class Dut> void check_miss_latency(const Config& config) {
    CacheBench<Dut> bench{config};
    Draw draw{7};
    const auto words = std::uint32_t(bench.shape.words);
    for (std::uint32_t round = 0; round < 40; ++round) {
        const std::uint32_t line = (round * 977 + 3) % ((1u << max_addr_bits) / words),
                            addr = bench.addr(line, round % bench.parts());
        REQUIRE(bench.look_up(0, addr).req.fires());
        const auto looked_up = bench.cycle();
        REQUIRE(looked_up.outcome == CacheOutcome::miss);
        REQUIRE_FALSE(looked_up.miss.offer);
        std::vector<std::uint32_t> ids;
        // Requests start after 2 cycles, one in each cycle.
        for (std::uint32_t word = 0; word < words; ++word) {
            for (int refused = draw.below(3); refused > 0; --refused) {
                bench.dut.miss.ready = false;
                REQUIRE(bench.cycle().miss.offer->addr == line * words + word);
            }
            bench.dut.miss.ready = true;
            const auto seen = bench.cycle();
            REQUIRE(seen.miss.offer);
            REQUIRE(seen.miss.offer->addr == line * words + word);
            REQUIRE(seen.miss.offer->id % words == word);
            ids.push_back(seen.miss.offer->id);
        }
        REQUIRE_FALSE(bench.cycle().miss.offer);
        while (!ids.empty()) {   // words arrive in any order
            for (int pause = draw.below(4); pause > 0; --pause) REQUIRE_FALSE(bench.cycle().rsp.offer);
            const auto at = ids.begin() + draw.below(int(ids.size()));
            REQUIRE_FALSE(bench.cycle({}, *at).rsp.offer);
            ids.erase(at);
        }
        REQUIRE(bench.cycle().outcome == CacheOutcome::drain);
        REQUIRE_FALSE(bench.cycle().rsp.offer);
        REQUIRE(bench.right(bench.cycle().rsp.offer, 0, addr));   // 3 cycles after the last word
        REQUIRE_FALSE(bench.cycle().rsp.offer);
    }
}

template <class Dut> void check_throughput_of_hits(const Config& config) {
    using K = typename Dut::CacheKind;
    CacheBench<Dut> bench{config};
    const auto lines = std::uint32_t(std::min(bench.shape.sets * bench.shape.ways, 8)),
               ids = std::uint32_t(K::ids(config));
    if (ids < 4) return;
    for (std::uint32_t line = 0; line < lines; ++line) bench.get(bench.addr(line));
    const auto addr = [&](std::uint32_t i) { return bench.addr(i % lines, i / lines % bench.parts()); };
    constexpr std::uint32_t n = 600;
    std::uint32_t sent = 0, received = 0;
    int cycle = 0;
    for (; received < n; ++cycle) {
        REQUIRE(cycle < 2 * int(n));
        std::optional<typename K::Req> req;
        if (sent < n && sent - received < ids) req = bench.request(sent % ids, addr(sent));
        const auto seen = bench.cycle(req);
        if (seen.req.fires()) ++sent;
        if (!seen.rsp.fires()) continue;
        REQUIRE(bench.right(seen.rsp.offer, received % ids, addr(received)));
        ++received;
    }
    // A place for an answer is occupied for three cycles, so two places give two hits in three cycles.
    REQUIRE(cycle == (bench.shape.queue >= 4 ? int(n) + 3 : int(n) * 3 / 2 + 2));
}

template <class Dut> void check_hit_under_miss(const Config& config) {
    CacheBench<Dut> bench{config};
    const auto ids = std::uint32_t(Dut::CacheKind::ids(config));
    if (bench.shape.sets * bench.shape.ways < 2 || ids < 8) return;
    bench.get(bench.addr(8));
    const auto words = send_for(bench, ids - 1, bench.addr(9));
    int received = 0;
    for (std::uint32_t n = 0; n < 100; ++n) {
        const auto seen = bench.look_up(n % 4, bench.addr(8));
        REQUIRE(seen.req.fires());
        if (n >= 3) REQUIRE(bench.right(seen.rsp.offer, (n - 3) % 4, bench.addr(8)));
        received += seen.rsp.fires();
    }
    for (int n = 0; n < 3; ++n) received += bench.cycle().rsp.fires();
    REQUIRE(received == 100);
    for (const std::uint32_t word : words) bench.cycle({}, word);
    bench.cycle();
    bench.cycle();
    REQUIRE(bench.right(bench.cycle().rsp.offer, ids - 1, bench.addr(9)));
}

/// Sends `more` requests for a line in flight. The last is accepted `late` cycles after the line's last word.
template <class Dut> void check_merge(const Config& config, std::uint32_t more, int late) {
    CacheBench<Dut> bench{config};
    const auto ids = std::uint32_t(Dut::CacheKind::ids(config));
    if (more >= ids) return;
    INFO(more << " more, the last " << late << " cycles after the last word");
    const auto addr = [&](std::uint32_t i) { return bench.addr(3, i * 5 % bench.parts()); };
    const auto id = [&](std::uint32_t i) { return (i * 11 + 1) % ids; };   // ids is a power of two
    auto words = send_for(bench, id(0), addr(0));
    for (std::uint32_t i = 1; i < more; ++i) REQUIRE(bench.look_up(id(i), addr(i)).req.fires());
    std::uint32_t answered = 0;
    std::vector<int> answers;   // cycles after the last word
    while (words.size() > 1) {
        bench.cycle({}, words.back());
        words.pop_back();
    }
    for (int n = -6; n < int(more) + 12; ++n) {
        std::optional<typename Dut::CacheKind::Req> req;
        if (n == late) req = bench.request(id(more), addr(more));
        const auto seen = bench.cycle(req, n == 0 ? std::optional(words.back()) : std::nullopt);
        if (req) REQUIRE(seen.req.fires());
        if (n < late + 1 && seen.outcome == CacheOutcome::merge) REQUIRE(n < -3);
        if (n == late + 1 && n <= 0) REQUIRE(seen.outcome == CacheOutcome::merge);
        if (!seen.rsp.offer) continue;
        REQUIRE(bench.right(seen.rsp.offer, id(answered), addr(answered)));
        ++answered;
        answers.push_back(n);
    }
    REQUIRE(answered == more + 1);
    REQUIRE(bench.misses == bench.shape.words);
    if (bench.shape.queue < 4) return;   // with two places the answers have gaps
    for (std::uint32_t i = 0; i < more; ++i) REQUIRE(answers[i] == 3 + int(i));
    REQUIRE(answers[more] == std::max(3 + int(more), late + 3));
}
template <class Dut> void check_merges(const Config& config) {
    for (const std::uint32_t more : {1u, 2u, 3u, 15u})
        for (const int late : {-4, -3, -2, -1, 0, 1}) check_merge<Dut>(config, more, late);
}

template <class Dut> void check_eviction(const Config& config) {
    CacheBench<Dut> bench{config};
    Draw draw{11};
    std::map<std::uint32_t, SetJudge> judges;
    int hits = 0;
    for (int n = 0; n < 1500; ++n) {
        const auto set = std::uint32_t(draw.below(2) * (bench.shape.sets - 1));
        const std::uint32_t line = set + std::uint32_t(bench.shape.sets * draw.below(bench.shape.ways + 2));
        SetJudge& judge = judges.try_emplace(set, bench.shape.ways).first->second;
        INFO("request " << n << ", line " << line);
        const bool hit = judge.has(line);
        REQUIRE(bench.get(bench.addr(line)) == hit);
        judge.request(line);
        hits += hit;
    }
    REQUIRE(hits > 200);
    REQUIRE(hits < 1300);
}

/// The pseudo-oldest way waits for a line, so no other line may evict it.
template <class Dut> void check_waiting_way_stays(const Config& config) {
    CacheBench<Dut> bench{config};
    if (bench.shape.ways < 2 || bench.shape.mshrs < 2 || Dut::CacheKind::ids(config) < 4) return;
    Draw draw{13};
    const auto sets = std::uint32_t(bench.shape.sets);
    SetJudge judge{bench.shape.ways};
    for (std::uint32_t round = 0; round < 50; ++round) {
        const std::uint32_t first = sets * 1000 * round + sets - 1;
        for (std::uint32_t n = 0; n < std::uint32_t(bench.shape.ways); ++n) {
            bench.get(bench.addr(first + n * sets));
            judge.request(first + n * sets);
        }
        for (int n = draw.below(8); n > 0; --n) {   // any way may be the pseudo-oldest
            const std::uint32_t line = *judge.line(draw.below(bench.shape.ways));
            REQUIRE(bench.get(bench.addr(line)));
            judge.request(line);
        }
        const std::uint32_t one = first + 100 * sets, two = first + 200 * sets;
        auto words = send_for(bench, 1, bench.addr(one));
        const int waits = judge.request(one);
        while (judge.oldest() != waits) {
            const int way = draw.below(bench.shape.ways);
            if (way == waits) continue;
            REQUIRE(bench.get(bench.addr(*judge.line(way))));
            judge.request(*judge.line(way));
        }
        const auto more = send_for(bench, 2, bench.addr(two));
        judge.request(two, {waits});
        words.insert(words.end(), more.begin(), more.end());
        std::shuffle(words.begin(), words.end(), std::minstd_rand(round));
        for (const std::uint32_t word : words) bench.cycle({}, word);
        for (int n = 0; n < 6; ++n) bench.cycle();
        for (int way = 0; way < bench.shape.ways; ++way) REQUIRE(bench.get(bench.addr(*judge.line(way))));
        for (int way = 0; way < bench.shape.ways; ++way) judge.request(*judge.line(way));
    }
}

/// With `lines` in flight, one more request must stall with `outcome` until the first of them arrives.
template <class Dut> void check_stall(const Config& config, const std::vector<std::uint32_t>& lines,
                                      std::uint32_t blocked, CacheOutcome outcome) {
    CacheBench<Dut> bench{config};
    std::vector<std::uint32_t> words, others;
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        const auto mine = send_for(bench, i, bench.addr(lines[i]));
        (i == 0 ? words : others).insert((i == 0 ? words : others).end(), mine.begin(), mine.end());
    }
    const auto id = std::uint32_t(lines.size());
    REQUIRE(bench.look_up(id, bench.addr(blocked)).req.fires());
    for (int n = 0; n < 20; ++n) {
        const auto seen = bench.cycle();
        REQUIRE(seen.outcome == outcome);
        REQUIRE_FALSE(seen.miss.offer);
    }
    for (const std::uint32_t word : words) REQUIRE(bench.cycle({}, word).outcome == outcome);
    REQUIRE(bench.cycle().outcome == CacheOutcome::drain);
    REQUIRE(bench.cycle().outcome == CacheOutcome::miss);
    REQUIRE(bench.right(bench.cycle().rsp.offer, 0, bench.addr(lines[0])));
    for (int n = 1; n < bench.shape.words; ++n) bench.cycle();
    REQUIRE(bench.misses == int(lines.size() + 1) * bench.shape.words);
}

template <class Dut> void check_conflict(const Config& config) {
    const CacheShape shape = Dut::CacheKind::shape(config);
    if (shape.mshrs <= shape.ways || shape.ways >= Dut::CacheKind::ids(config)) return;
    std::vector<std::uint32_t> lines;
    for (int i = 0; i <= shape.ways; ++i) lines.push_back(std::uint32_t(i * shape.sets + shape.sets / 2));
    const std::uint32_t blocked = lines.back();
    lines.pop_back();
    check_stall<Dut>(config, lines, blocked, CacheOutcome::conflict);
}

template <class Dut> void check_full_mshrs(const Config& config) {
    const CacheShape shape = Dut::CacheKind::shape(config);
    if (shape.mshrs > shape.sets * shape.ways || shape.mshrs >= Dut::CacheKind::ids(config)) return;
    std::vector<std::uint32_t> lines;
    for (int i = 0; i < shape.mshrs; ++i) lines.push_back(std::uint32_t(i));
    check_stall<Dut>(config, lines, std::uint32_t(shape.mshrs), CacheOutcome::mshrs);
}

template <class Dut> void check_answers_not_taken(const Config& config) {
    CacheBench<Dut> bench{config};
    const int room = bench.shape.queue + 2;   // answers, and requests before the look-up
    if (room > Dut::CacheKind::ids(config)) return;
    bench.get(bench.addr(2));
    const auto addr = [&](int i) { return bench.addr(2, std::uint32_t(i) % bench.parts()); };
    bench.dut.rsp.ready = false;
    int accepted = 0;
    Steady<typename Dut::CacheKind::Rsp> steady{config};
    for (int n = 0; n < 2 * room; ++n) {
        const auto seen = bench.look_up(std::uint32_t(accepted % room), addr(accepted));
        accepted += seen.req.fires();
        steady.check(seen.rsp);
        if (n > room) REQUIRE(seen.outcome == CacheOutcome::answers);
    }
    REQUIRE(accepted == room);
    bench.dut.rsp.ready = true;
    int answered = 0;
    for (int n = 0; n < 2 * room + 4; ++n) {
        const auto seen = bench.cycle();
        steady.check(seen.rsp);
        if (!seen.rsp.offer) continue;
        REQUIRE(bench.right(seen.rsp.offer, std::uint32_t(answered), addr(answered)));
        ++answered;
    }
    REQUIRE(answered == room);
}

template <class Dut> void check_random(const Config& config, int seeds, int requests) {
    using K = typename Dut::CacheKind;
    for (const Pace& pace : paces)
        for (int seed = 1; seed <= seeds; ++seed) {
            INFO(pace.name << ", seed " << seed);
            Dut dut{config, seed};
            CacheWorld<K> world{config, unsigned(seed), pace, requests};
            for (int cycle = 0, quiet = 0; quiet < 10; ++cycle) {
                INFO("cycle " << cycle);
                REQUIRE(cycle < 500 * requests);
                world.drive(dut);
                dut.eval();
                world.watch(dut);
                dut.commit();
                quiet = world.finished() ? quiet + 1 : 0;
            }
            REQUIRE(world.answers() == requests);
        }
}

/// Runs model and RTL in lockstep. The RTL runs two rounds, with a reset in the middle of traffic between
/// them.
template <class K> void lockstep(const Config& config, int seeds, int cycles) {
    std::array<int, cache_outcomes> outcomes{};
    for (const Pace& pace : paces)
        for (int seed = 1; seed <= seeds; ++seed) {
            CacheRtl<K> rtl{config, seed};
            for (int round = 0; round < 2; ++round) {
                if (round > 0) rtl.reset();
                CacheModel<K> model{config};
                CacheWorld<K> world{config, unsigned(10 * seed + round), pace, 1 << 30};
                for (int cycle = 0; cycle < cycles; ++cycle) {
                    INFO(config.name << ", " << pace.name << ", seed " << seed << ", round " << round
                                     << ", cycle " << cycle);
                    world.drive(model);
                    static_cast<CacheLinks<K>&>(rtl) = model;
                    model.eval();
                    rtl.eval();
                    REQUIRE(same(model.req, rtl.req, config));
                    REQUIRE(same(model.rsp, rtl.rsp, config));
                    REQUIRE(same(model.miss, rtl.miss, config));
                    world.watch(model);
                    model.commit();
                    REQUIRE(int(model.outcome) == int(rtl.outcome));
                    rtl.commit();
                    ++outcomes[std::size_t(model.outcome)];
                }
                REQUIRE(world.answers() > cycles / 50);
            }
        }
    const CacheShape shape = K::shape(config);
    for (std::size_t outcome = 0; outcome < cache_outcomes; ++outcome) {   // every possible outcome occurred
        INFO(config.name << ", outcome " << outcome);
        if (CacheOutcome(outcome) == CacheOutcome::conflict &&
            (shape.mshrs <= shape.ways || K::ids(config) <= shape.ways))
            continue;
        if (CacheOutcome(outcome) == CacheOutcome::mshrs &&
            (shape.mshrs > shape.sets * shape.ways || K::ids(config) <= shape.mshrs))
            continue;
        if (CacheOutcome(outcome) == CacheOutcome::merge && K::ids(config) == 1) continue;
        if (CacheOutcome(outcome) == CacheOutcome::answers && K::ids(config) <= shape.queue) continue;
        REQUIRE(outcomes[outcome] > 0);
    }
}

template <class Dut, class Check> void in_quick_shapes(Check check) {
    for (const std::string& name : quick_shapes<typename Dut::CacheKind>()) {
        INFO(name);
        check(cache_config(name));
    }
}

}   // namespace rayclock::test
