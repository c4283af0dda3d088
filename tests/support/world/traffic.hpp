#pragma once
// Drivers for units: four kinds of traffic, and the rules that every unit behind a credit counter obeys under
// each.
#include <deque>

#include <catch2/catch.hpp>

#include "tests/support/cases/draw.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

struct Pace {
    const char* name;
    int idle_percent;    ///< share of cycles in which the source offers nothing
    int stall_percent;   ///< share of cycles in which the sink accepts nothing
};
constexpr std::array<Pace, 4> paces{
    {{"full rate", 0, 0}, {"idle source", 60, 0}, {"stalling sink", 0, 60}, {"both", 40, 40}}};

/// Checks that an offer stays unchanged until it is accepted.
template <class P> class Steady {
public:
    explicit Steady(const Config& config) : config_(config) {}
    void check(const Wire<P>& link) {
        if (held_) REQUIRE((link.offer && same(*link.offer, *held_, config_)));
        held_ = link.fires() ? std::nullopt : link.offer;
    }

private:
    Config config_;
    std::optional<P> held_;
};

/// Sends `count` requests and calls judge(req, rsp) for each, in order. No request may be lost, duplicated or
/// left over, and a stalled answer may not change.
template <class Dut, class Make, class Judge>
void stream(Dut& dut, const Config& config, const Pace& pace, Draw& draw, int count, Make make, Judge judge) {
    using Req = typename Dut::Unit::Req;
    std::deque<Req> waiting;
    std::optional<Req> pending;
    Steady<typename Dut::Unit::Rsp> steady{config};
    int sent = 0, received = 0, quiet = 0;
    for (int cycle = 0; quiet < Dut::Unit::latency(config) + 4; ++cycle) {
        INFO(pace.name << ", cycle " << cycle << ", request " << received);
        REQUIRE(cycle < 20 * count + 1000);
        if (!pending && sent < count && !draw.percent(pace.idle_percent)) pending = make(draw);
        dut.in.offer = pending;
        dut.out.ready = !draw.percent(pace.stall_percent);
        dut.eval();
        steady.check(dut.out);
        if (dut.out.fires()) {
            REQUIRE_FALSE(waiting.empty());
            judge(waiting.front(), *dut.out.offer);
            waiting.pop_front();
            ++received;
        }
        if (dut.in.fires()) {
            waiting.push_back(*pending);
            pending.reset();
            ++sent;
        }
        quiet = received == count ? quiet + 1 : 0;
        dut.commit();
    }
    REQUIRE(received == count);
    REQUIRE(waiting.empty());
}

/// Returns the answers to the given requests, sent at full rate.
template <class Dut>
std::vector<typename Dut::Unit::Rsp> answers(Dut& dut, const Config& config,
                                             const std::vector<typename Dut::Unit::Req>& requests) {
    std::vector<typename Dut::Unit::Rsp> all;
    std::size_t next = 0;
    Draw draw{1};
    stream(
        dut, config, paces[0], draw, int(requests.size()), [&](Draw&) { return requests[next++]; },
        [&](const auto&, const auto& rsp) { all.push_back(rsp); });
    return all;
}

/// A lone request is answered in exactly cycle latency + 1, with or without a waiting sink, after any pause.
template <class Dut, class Make> void check_latency(Dut& dut, const Config& config, Make make) {
    Draw draw{3};
    const int expected = Dut::Unit::latency(config) + 1;
    for (int round = 0; round < 20; ++round) {
        dut.in.offer = make(draw);
        dut.out.ready = round % 2 == 0;
        dut.eval();
        REQUIRE(dut.in.fires());
        REQUIRE_FALSE(dut.out.offer);
        dut.commit();
        dut.in.offer.reset();
        for (int cycle = 1; cycle < expected; ++cycle) {
            INFO("round " << round << ", cycle " << cycle << " of " << expected);
            dut.eval();
            REQUIRE_FALSE(dut.out.offer);
            dut.commit();
        }
        dut.out.ready = true;
        dut.eval();
        REQUIRE(dut.out.fires());
        dut.commit();
        for (int pause = draw.below(5); pause >= 0; --pause) {
            dut.eval();
            REQUIRE_FALSE(dut.out.offer);
            dut.commit();
        }
    }
}

/// Without stalls, n requests take n + latency + 1 cycles if the unit accepts one in every cycle. With a
/// blocked sink, the unit accepts as many as its queue holds.
template <class Dut, class Make> void check_throughput(Dut& dut, const Config& config, Make make) {
    Draw draw{5};
    constexpr int n = 1000;
    const int every = interval_of<typename Dut::Unit>(config), last = (n - 1) * every;
    int received = 0, cycle = 0;
    dut.out.ready = true;
    for (; received < n; ++cycle) {
        REQUIRE(cycle < 3 * n * every);
        dut.in.offer.reset();
        if (cycle <= last) dut.in.offer = make(draw);
        dut.eval();
        if (cycle <= last) REQUIRE(dut.in.ready == (cycle % every == 0));
        received += dut.out.fires();
        dut.commit();
    }
    REQUIRE(cycle == last + 1 + Dut::Unit::latency(config) + 1);

    dut.out.ready = false;
    int admitted = 0;
    for (int i = 0; i < 3 * every * Dut::Unit::queue(config); ++i) {
        dut.in.offer = make(draw);
        dut.eval();
        admitted += dut.in.fires();
        dut.commit();
    }
    REQUIRE(admitted == Dut::Unit::queue(config));
}

/// Requires that model and RTL are equal in every cycle: ready, valid and payload.
template <class Unit, class Make> void check_lockstep(const Config& config, const Frame& frame,
                                                      const Pace& pace, unsigned seed, int cycles,
                                                      Make make) {
    Model<Unit> model{config, frame};
    Rtl<Unit> rtl{config, frame, int(seed)};
    Draw draw{seed};
    std::optional<typename Unit::Req> pending;
    int moved = 0;
    for (int cycle = 0; cycle < cycles; ++cycle) {
        INFO(config.name << ", " << pace.name << ", seed " << seed << ", cycle " << cycle);
        if (!pending && !draw.percent(pace.idle_percent)) pending = make(draw);
        model.in.offer = rtl.in.offer = pending;
        model.out.ready = rtl.out.ready = !draw.percent(pace.stall_percent);
        model.eval();
        rtl.eval();
        REQUIRE(same(model.in, rtl.in, config));
        REQUIRE(same(model.out, rtl.out, config));
        if (model.in.fires()) pending.reset();
        moved += model.out.fires();
        model.commit();
        rtl.commit();
    }
    REQUIRE(moved > cycles / (5 * interval_of<Unit>(config)));
}

}   // namespace rayclock::test
