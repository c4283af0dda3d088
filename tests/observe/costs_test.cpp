// What is watched must be what the machine did: every figure closes with its accounts.
#include "tests/observe/watched.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

using Sums = FrameCosts::Sums;

void check_sums(const FrameCosts& costs, const Trace& trace, bool streams) {
    const Sums sums = costs.total();
    CHECK(sums.visits == trace.visits);
    CHECK(sums.tests == trace.triangle_tests);
    CHECK(sums.bytes == 64 * costs.memory.reads);
    Sums by_purpose;
    std::uint64_t places = 0;
    for (const PurposeCost& p : costs.purposes) {
        by_purpose.rays += p.rays, by_purpose.visits += p.visits, by_purpose.tests += p.tests;
        by_purpose.misses += p.all_misses(), by_purpose.bytes += p.bytes;
        places += p.cycles();
    }
    CHECK(by_purpose.rays == sums.rays);
    CHECK(by_purpose.visits == sums.visits);
    CHECK(by_purpose.tests == sums.tests);
    CHECK(by_purpose.misses == sums.misses);
    CHECK(by_purpose.bytes == sums.bytes);
    CHECK(places == sums.cycles);
    if (streams) {   // its rays have requests, not purposes
        CHECK(costs.purposes[0].rays == trace.counts.primary + trace.counts.shadow);
        return;
    }
    CHECK(costs.purposes[0].rays == trace.counts.primary);
    CHECK(costs.purposes[1].rays == trace.counts.shadow);
    CHECK(costs.purposes[2].rays == trace.counts.reflection);
    CHECK(costs.purposes[3].rays <= trace.counts.refraction);   // total reflections send none
}

void check_accounts(const FrameCosts& costs, const Config& config) {
    const auto account = [&](Unit unit, std::size_t code) { return costs.accounts.units[index(unit)][code]; };
    for (std::size_t c = 0; c < ray_caches; ++c) {
        const Unit unit = c == 2 && config.is_stream() ? Unit::stream : cache_units[c];
        if (!is_there(unit, config)) continue;
        std::uint64_t hits = 0, misses = 0, merges = 0;
        for (const PurposeCost& p : costs.purposes)
            hits += p.hits[c], misses += p.misses[c], merges += p.merges[c];
        CHECK(hits + misses + merges > 0);
        CHECK(hits == account(unit, 0));
        CHECK(misses == account(unit, 1));
        CHECK(merges == account(unit, 2));
    }
    if (config.l2_sets == 0) {   // each miss requests its line from the memory, for the ray that missed
        const std::uint64_t words[] = {
            std::uint64_t(config.node_line), std::uint64_t(config.prim_line),
            std::uint64_t(config.is_stream() ? config.stream_line : config.surf_line)};
        for (const PurposeCost& p : costs.purposes)
            CHECK(p.bytes == p.misses[0] * words[0] + p.misses[1] * words[1] + p.misses[2] * words[2]);
    }
    CHECK(costs.moved[index(Link::box_req)] * std::uint64_t(config.box_interval()) == account(Unit::box, 0));
    for (const NodeUnit& u : node_units)
        if (u.unit != Unit::box) CHECK(costs.moved[index(u.req)] == account(u.unit, 0));
    CHECK(costs.moved[index(Link::xform_req)] * std::uint64_t(config.xform_interval) ==
          account(Unit::xform, 0));
    CHECK(costs.moved[index(Link::change)] == costs.moved[index(Link::xform_req)]);
    CHECK(costs.moved[index(Link::tri_req)] * std::uint64_t(config.tri_interval) == account(Unit::tri, 0));
    CHECK(costs.moved[index(Link::ray)] * std::uint64_t(config.raygen_interval) == account(Unit::raygen, 0));
    // raygen stalls only if it refuses the link on which rays begin. It also refuses this link while it is
    // occupied, or while it accepts a ray of shade.
    const Link first = config.is_stream() ? Link::record : Link::slot;
    const std::uint64_t refused = costs.refused[index(first)] + costs.refused[index(Link::spawn)];
    CHECK(account(Unit::raygen, 2) <= refused);
    if (!config.shading && config.raygen_interval == 1) CHECK(account(Unit::raygen, 2) == refused);
    CHECK(costs.refused[index(Link::slot)] == account(Unit::sched, config.is_stream() ? 4 : 3));
    CHECK(costs.moved[index(Link::tile)] == costs.tiles.size());
}

void check_windows(const FrameCosts& costs, std::uint64_t window) {
    std::uint64_t cycles = 0, contexts = 0, reads = 0;
    Accounts accounts;
    for (const Window& w : costs.windows) {
        CHECK(w.first == cycles);
        CHECK(w.cycles <= window);
        cycles += w.cycles, contexts += w.contexts, reads += w.memory.reads;
        accounts += w.accounts;
    }
    CHECK(cycles == costs.cycles);
    CHECK(reads == costs.memory.reads);
    CHECK(accounts == costs.accounts);
    // A context is in use from the cycle of its slot to that before its pixel leaves.
    CHECK(contexts == costs.total().cycles);
}

}   // namespace

TEST_CASE("a watched frame takes the cycles of one that is not, and what is seen closes with its accounts") {
    for (const Watched& w : watched_machines()) {
        INFO(w.scene << ", case " << (&w - watched_machines().data()));
        const Watching made = watching(w);
        const FrameTiming timing = replay(made.job.config, 66000, made.traces, w.disturbance).back();
        const FrameCosts costs = observe(made.job.config, 66000, made.traces, w.disturbance, 1000, nullptr);
        CHECK(costs.cycles == timing.cycles);
        CHECK(costs.accounts == timing.accounts);
        CHECK(costs.memory == timing.memory);
        check_sums(costs, made.traces.back().trace, made.job.config.is_stream());
        check_accounts(costs, made.job.config);
        check_windows(costs, 1000);
    }
}

TEST_CASE("a ray alone in flight pays for every line that it misses, including the line of its record") {
    const Watching made = watching({"gears:2",
                                    {{"contexts", "1"},
                                     {"node_width", "4"},
                                     {"node_line", "64"},
                                     {"prim_line", "64"},
                                     {"stream_line", "64"},
                                     {"stack_depth", "64"}},
                                    false,
                                    {},
                                    1,
                                    1},
                                   {20, 10});
    const FrameCosts costs = observe(made.job.config, 66000, made.traces, {}, 0, nullptr);
    REQUIRE(costs.pixels.size() == 200);
    for (std::size_t ray = 0; ray < costs.pixels.size(); ++ray) {
        INFO("ray " << ray);
        CHECK(costs.pixels[ray].bytes == 64 * costs.pixels[ray].misses);
        if (ray % 2 == 0) CHECK(costs.pixels[ray].misses > 0);   // a line holds two records
    }
}

TEST_CASE("the pixels of some cycles are in the chip in one of them, and leave in their last cycle") {
    FrameCosts costs;
    costs.width = 4, costs.height = 1;
    costs.pixels.resize(4);
    // Pixel 0 is in the chip from cycle 10 on and leaves in cycle 15, pixel 2 from 20 to 26. The others have
    // no rays.
    costs.pixels[0].rays = 1, costs.pixels[0].first = 10, costs.pixels[0].cycles = 5;
    costs.pixels[2].rays = 1, costs.pixels[2].first = 20, costs.pixels[2].cycles = 6;
    const auto check = [&](std::uint64_t first, std::uint64_t last, int x, int width) {
        INFO("cycles " << first << " to " << last);
        const PixelRect rect = costs.pixels_in(first, last);
        CHECK(rect.x == x);
        CHECK(rect.size.width == width);
    };
    check(0, 10, 0, 0);
    check(0, 11, 0, 1);
    check(15, 16, 0, 1);
    check(16, 20, 0, 0);
    check(15, 21, 0, 3);
    check(26, 27, 2, 1);
    check(27, 99, 0, 0);
}

TEST_CASE("every tile was worked on by one pipeline, and its pixels lie within its time") {
    const Watching made = watching(watched_machines()[1]);
    const FrameCosts costs = observe(made.job.config, 66000, made.traces, {}, 0, nullptr);
    CHECK(costs.windows.empty());
    REQUIRE(costs.tiles.size() == 3 * 2);
    for (const TileSpan& tile : costs.tiles) {
        std::uint64_t first = ~0ull, last = 0;
        for (std::uint32_t y = 16 * tile.y; y < std::min(16 * tile.y + 16, costs.height); ++y)
            for (std::uint32_t x = 16 * tile.x; x < std::min(16 * tile.x + 16, costs.width); ++x) {
                const PixelCost& p = costs.pixels[y * costs.width + x];
                first = std::min<std::uint64_t>(first, p.first);
                last = std::max<std::uint64_t>(last, p.first + p.cycles);
            }
        CHECK(tile.first == first);
        CHECK(tile.last == last);
    }
}
