// trav: which nodes a ray visits, in which order, and when.
#include "tests/support/world/trav_world.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Frame frame_at(std::uint32_t root) {
    Frame frame;
    frame.width = frame.height = 1;
    frame.root = root;
    return frame;
}

/// Returns how many rays were stopped.
template <class Dut> int walk_rays(const Config& config, unsigned seed, const Flow& flow, int rays) {
    INFO(config.name << ", " << flow.name << ", seed " << seed);
    const Frame frame = frame_at(1234 + seed);
    Dut dut{frame, config, int(seed)};
    TravWorld world{frame, config, seed, flow, rays};
    Steady<NodeReq> node_req{config};
    Steady<Done> done{config};
    for (int cycle = 0; !world.finished(); ++cycle) {
        INFO("cycle " << cycle);
        REQUIRE(cycle < 2000 * rays);
        world.drive(dut);
        dut.eval();
        node_req.check(dut.node_req);
        done.check(dut.done);
        world.watch(dut);
        dut.commit();
    }
    REQUIRE(world.nodes() >= rays);
    return world.stopped();
}

void lockstep(const Config& config, unsigned seed, const Flow& flow, int cycles) {
    const Frame frame = frame_at(77);
    TravModel model{frame, config};
    TravRtl rtl{frame, config, int(seed)};
    TravWorld world{frame, config, seed, flow, 1 << 30};
    for (int cycle = 0; cycle < cycles; ++cycle) {
        INFO(config.name << ", " << flow.name << ", seed " << seed << ", cycle " << cycle);
        world.drive(model);
        static_cast<TravLinks&>(rtl) = model;
        model.eval();
        rtl.eval();
        REQUIRE(same(model.ray, rtl.ray, config));
        REQUIRE(same(model.step, rtl.step, config));
        REQUIRE(same(model.node_rsp, rtl.node_rsp, config));
        REQUIRE(same(model.node_req, rtl.node_req, config));
        REQUIRE(same(model.box_req, rtl.box_req, config));
        REQUIRE(same(model.done, rtl.done, config));
        world.watch(model);
        model.commit();
        rtl.commit();
    }
    REQUIRE(world.nodes() > cycles / 20);
}

/// One cycle with everything ready; returns what was on offer.
template <class Dut> struct Hand {
    Dut dut;
    explicit Hand(const Config& config) : dut{frame_at(9), config} {
        dut.node_req.ready = dut.done.ready = dut.box_req.ready = true;
    }
    TravLinks cycle(std::optional<Step> step = {}, std::optional<Ray> ray = {}) {
        dut.step.offer = step;
        dut.ray.offer = ray;
        dut.eval();
        const TravLinks seen = dut;
        dut.commit();
        return seen;
    }
    /// Cycles until a node or an end is on offer, after a cycle that brings `step`.
    int wait(const Step& step, TravLinks& seen) {
        REQUIRE(cycle(step).step.fires());
        for (int n = 1; n < 50; ++n) {
            seen = cycle();
            if (seen.node_req.offer || seen.done.offer) return n;
        }
        return 0;
    }
};

Ray ray_of(std::uint32_t number) {
    Ray ray;
    ray.ray = number;
    return ray;
}

Step step_of(std::uint32_t ray, std::uint32_t t_best, std::initializer_list<std::uint32_t> nears,
             std::uint32_t base = 100) {
    Step step;
    step.ray = ray;
    step.t_best = t_best;
    step.base = base;
    for (const std::uint32_t near : nears) {
        step.t_near[step.inner] = near;
        step.slot[step.inner] = step.inner;
        ++step.inner;
    }
    return step;
}

}   // namespace

TEMPLATE_TEST_CASE("trav visits what can still matter, nearest first", "[trav]", TravModel, TravRtl) {
    for (const Flow& flow : flows)
        for (unsigned seed = 1; seed <= 3; ++seed) walk_rays<TestType>(format("default"), seed, flow, 300);
}

TEMPLATE_TEST_CASE("trav visits what can still matter with four children and a deep stack", "[trav][slow]",
                   TravModel, TravRtl) {
    for (const Flow& flow : flows)
        for (unsigned seed = 1; seed <= 10; ++seed) walk_rays<TestType>(format("small"), seed, flow, 300);
}

TEMPLATE_TEST_CASE("trav's decisions take two cycles, and two more for each group it drops", "[trav]",
                   TravModel, TravRtl) {
    Hand<TestType> hand{format("default")};
    REQUIRE(hand.cycle({}, ray_of(3)).ray.fires());
    TravLinks seen = hand.cycle();   // a new ray asks for the root in the next cycle
    REQUIRE(seen.node_req.offer);
    REQUIRE((seen.node_req.offer->ray == 3 && seen.node_req.offer->addr == 9));

    REQUIRE(hand.wait(step_of(3, 1000, {10, 500}), seen) == 2);   // visit, and 500 on the stack
    REQUIRE(seen.node_req.offer->addr == 100);
    REQUIRE(hand.wait(step_of(3, 1000, {20, 400}, 200), seen) == 2);   // 400 above it
    REQUIRE(seen.node_req.offer->addr == 200);
    REQUIRE(hand.wait(step_of(3, 1000, {30, 600}, 300), seen) == 2);   // 600 above that
    REQUIRE(seen.node_req.offer->addr == 300);
    REQUIRE(hand.wait(step_of(3, 450, {}), seen) == 4);   // 600 dropped by another turn, then 400
    REQUIRE(seen.node_req.offer->addr == 201);
    REQUIRE(hand.wait(step_of(3, 450, {}), seen) == 2);   // only 500 is left: the end at once
    REQUIRE(seen.done.offer);
    REQUIRE_FALSE(seen.node_req.offer);

    REQUIRE(hand.cycle({}, ray_of(3)).ray.fires());   // the same context again, with an empty stack
    hand.cycle();
    REQUIRE(hand.wait(step_of(3, 450, {}), seen) == 2);
    REQUIRE(seen.done.offer);
}

TEMPLATE_TEST_CASE("trav ends a ray at once when nothing below can matter", "[trav]", TravModel, TravRtl) {
    Hand<TestType> hand{format("default")};
    hand.cycle({}, ray_of(0));
    hand.cycle();
    TravLinks seen;
    for (std::uint32_t level = 0; level < 10; ++level) hand.wait(step_of(0, 1000, {1, 500 + level}), seen);
    REQUIRE(hand.wait(step_of(0, 499, {}), seen) == 2);   // ten groups, all beyond: no turn is wasted
    REQUIRE(seen.done.offer);
}

TEMPLATE_TEST_CASE("trav ends a ray that is stopped, and leaves nothing on its stack", "[trav][shading]",
                   TravModel, TravRtl) {
    for (const Flow& flow : flows)
        for (unsigned seed = 1; seed <= 3; ++seed)
            REQUIRE(walk_rays<TestType>(format("shading:default"), seed, flow, 300) > 100);

    Hand<TestType> hand{format("shading:default")};
    hand.cycle({}, ray_of(3));
    hand.cycle();
    TravLinks seen;
    for (std::uint32_t level = 0; level < 10; ++level) hand.wait(step_of(3, 1000, {1, 500}), seen);
    Step stop = step_of(3, 1000, {2, 3});
    stop.stop = 1;
    REQUIRE(hand.wait(stop, seen) == 2);   // ten groups that all could matter
    REQUIRE(seen.done.offer);
    hand.cycle({}, ray_of(3));
    hand.cycle();
    REQUIRE(hand.wait(step_of(3, 1000, {}), seen) == 2);
    REQUIRE(seen.done.offer);
}

TEST_CASE("a stack that is stopped is empty", "[trav][shading]") {
    Stack stack{format("shading:default")};
    for (int level = 0; level < 10; ++level)
        REQUIRE(stack.decide(step_of(3, 1000, {1, 500})).kind == Turn::Kind::visit);
    REQUIRE(stack.height() == 10);
    Step stop = step_of(3, 1000, {2, 3});
    stop.stop = 1;
    REQUIRE(stack.decide(stop).kind == Turn::Kind::done);
    REQUIRE(stack.height() == 0);
}

TEMPLATE_TEST_CASE("trav takes a child exactly as far as the best hit", "[trav]", TravModel, TravRtl) {
    Hand<TestType> hand{format("default")};
    hand.cycle({}, ray_of(1));
    hand.cycle();
    TravLinks seen;
    REQUIRE(hand.wait(step_of(1, 70, {70, 70, 71}), seen) == 2);
    REQUIRE(seen.node_req.offer->addr == 100);
    REQUIRE(hand.wait(step_of(1, 70, {}), seen) == 2);
    REQUIRE(seen.node_req.offer->addr == 101);
    REQUIRE(hand.wait(step_of(1, 70, {}), seen) == 2);
    REQUIRE(seen.done.offer);
}

TEMPLATE_TEST_CASE("trav decides a step in every cycle, and no step enters in a second turn", "[trav]",
                   TravModel, TravRtl) {
    const Config config = format("default");
    Hand<TestType> hand{config};
    for (std::uint32_t ray = 0; ray < 64; ++ray) REQUIRE(hand.cycle({}, ray_of(ray)).ray.fires());
    for (int i = 0; i < 4; ++i) hand.cycle();
    int visits = 0;
    for (std::uint32_t cycle = 0; cycle < 64 * 8; ++cycle) {
        const TravLinks seen = hand.cycle(step_of(cycle % 64, 1000, {cycle / 64, 900 - cycle / 64}));
        REQUIRE(seen.step.fires());
        visits += seen.node_req.fires();
    }
    REQUIRE(visits == 64 * 8 - 2);
    hand.cycle(step_of(5, 895, {}));   // 893 on top matters
    hand.cycle(step_of(6, 892, {}));   // top 893 does not, and nothing below: end
    for (int i = 0; i < 3; ++i) REQUIRE(hand.cycle().step.ready);
    Hand<TestType> other{config};
    other.cycle({}, ray_of(5));
    other.cycle();
    TravLinks seen;
    other.wait(step_of(5, 1000, {1, 400}), seen);
    other.wait(step_of(5, 1000, {1, 600}), seen);
    REQUIRE(other.cycle(step_of(5, 500, {})).step.ready);
    REQUIRE(other.cycle().step.ready);
    REQUIRE_FALSE(other.cycle(step_of(9, 0, {})).step.ready);   // the ray of 5 goes round
    REQUIRE(other.cycle().step.ready);
}

TEST_CASE("model and rtl of trav make the same moves in every cycle", "[trav][lockstep]") {
    const Config config = format(GENERATE("default", "shading:default"));
    for (const Flow& flow : flows)
        for (unsigned seed = 11; seed <= 13; ++seed) lockstep(config, seed, flow, 3000);
}

TEST_CASE("model and rtl of trav make the same moves, four children, one context and many",
          "[trav][lockstep][slow]") {
    Config one = format("small"), many = one;
    one.name = "one context";
    one.contexts = 1;
    many.name = "128 contexts";
    many.contexts = 128;
    for (const Flow& flow : flows)
        for (unsigned seed = 21; seed <= 25; ++seed) {
            lockstep(format("small"), seed, flow, 5000);
            lockstep(one, seed, flow, 5000);
            lockstep(many, seed, flow, 5000);
        }
}
