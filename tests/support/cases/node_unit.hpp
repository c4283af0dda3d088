#pragma once
// Checks that hold for every node unit. `draw_case(draw, config)` draws a request `req` and the
// inputs of its judge. Argument-dependent lookup finds judge(case, answer, config).
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

/// Judges a stream of answers under every kind of pace.
template <class Dut, class DrawCase> void check_judged(const Config& config, DrawCase&& draw_case) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        INFO(config.name << ", seed " << seed);
        Draw draw{seed};
        std::deque<decltype(draw_case(draw, config))> cases;
        Dut dut{config, Frame{}, int(seed)};
        stream(
            dut, config, paces[seed - 1], draw, 1500,
            [&](Draw& from) {
                cases.push_back(draw_case(from, config));
                return cases.back().req;
            },
            [&](const auto&, const NodeAnswer& rsp) {
                judge(cases.front(), rsp, config);
                cases.pop_front();
            });
    }
}

/// Judges answers of the model.
template <class Unit, class DrawCase> void check_answers(const Config& config, DrawCase&& draw_case) {
    INFO(config.name);
    Draw draw{7};
    for (int i = 0; i < 3000; ++i) {
        const auto c = draw_case(draw, config);
        judge(c, Unit::answer(c.req, Frame{}, config), config);
    }
}

/// Compares model and RTL in every cycle, under every kind of pace.
template <class Unit, class DrawCase>
void check_moves(const Config& config, std::initializer_list<unsigned> seeds, DrawCase&& draw_case) {
    for (const Pace& pace : paces)
        for (const unsigned seed : seeds)
            check_lockstep<Unit>(config, {}, pace, int(seed), 2000,
                                 [&](Draw& draw) { return draw_case(draw, config).req; });
}

/// Compares model and RTL in every cycle, at both ends of every width.
template <class Unit, class DrawCase> void check_moves_at_ends(const Config& config, DrawCase&& draw_case) {
    for (unsigned seed = 21; seed <= 22; ++seed)
        check_lockstep<Unit>(config, {}, paces[0], seed, 4000,
                             [&](Draw& draw) { return draw_case(draw, config).req; });
}

/// Requires that the unit answers after exactly its latency, and takes a request in every cycle.
template <class Dut, class DrawCase> void check_pace(const Config& config, DrawCase&& draw_case) {
    const auto request = [&](Draw& draw) { return draw_case(draw, config).req; };
    Dut dut{config};
    check_latency(dut, config, request);
    Dut again{config};
    check_throughput(again, config, request);
}

}   // namespace rayclock::test
