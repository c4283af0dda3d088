// The arbiter of the memory port: its order, and that an offer stays. tests/system judges the RTL in whole
// frames.
#include <catch2/catch.hpp>

#include "model/mem/arbiter.hpp"
#include "tests/support/cases/draw.hpp"

using namespace rayclock;
using test::Draw;

TEST_CASE("the arbiter serves all offers in turn", "[arbiter]") {
    const int sources = GENERATE(2, 4, 16);
    Arbiter arbiter{sources};
    const std::uint32_t all = (1u << sources) - 1;
    for (int i = 1; i <= 3 * sources; ++i) {   // all sources, one after the other; source 1 is first
        REQUIRE(arbiter.choose(all) == i % sources);
        arbiter.clock(all, i % sources, true);
    }
    for (int source = 0; source < sources; ++source)
        for (int i = 0; i < 3; ++i) {   // a single source is served in every cycle
            REQUIRE(arbiter.choose(1u << source) == source);
            arbiter.clock(1u << source, source, true);
        }
}

TEST_CASE(
    "an offer of the arbiter that is not accepted stays, and no source waits for more than all others once",
    "[arbiter]") {
    const int sources = GENERATE(2, 4, 8, 16);
    const unsigned seed = GENERATE(range(1u, 6u));
    const int ready_percent = GENERATE(20, 60, 100);
    INFO(sources << " sources, seed " << seed << ", ready " << ready_percent << " percent");
    Arbiter arbiter{sources};
    Draw draw{seed};
    const int busy_percent = draw.between(5, 95);
    std::uint32_t valid = 0;
    int held = -1, last = 0;
    std::vector<int> passed(std::size_t(sources), 0);   // number of grants before it since its offer
    for (int cycle = 0; cycle < 5000; ++cycle) {
        for (int s = 0; s < sources; ++s)
            if (draw.percent(busy_percent)) valid |= 1u << s;
        if (valid == 0) {
            arbiter.clock(0, -1, false);
            continue;
        }
        const int chosen = arbiter.choose(valid);
        int turn = (last + 1) % sources;   // the plain rule
        while (!(valid >> turn & 1)) turn = (turn + 1) % sources;
        if (chosen != (held >= 0 ? held : turn))
            FAIL("cycle " << cycle << ": " << chosen << " instead of " << (held >= 0 ? held : turn));
        const bool taken = draw.percent(ready_percent);
        arbiter.clock(valid, chosen, taken);
        held = taken ? -1 : chosen;
        if (!taken) continue;
        last = chosen;
        valid &= ~(1u << chosen);
        passed[std::size_t(chosen)] = 0;
        for (int s = 0; s < sources; ++s)
            if (valid >> s & 1 && ++passed[std::size_t(s)] > sources)
                FAIL("cycle " << cycle << ": " << s << " waits for ever");
    }
}
