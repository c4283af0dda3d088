// trav: the nodes that a ray visits, their order and their timing.
#include "tests/support/world/trav_world.hpp"

namespace rayclock::test::trav_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

Frame frame_at(std::uint32_t root) {
    Frame frame;
    frame.width = frame.height = 1;
    frame.root = root;
    return frame;
}

/// Returns the number of stopped rays.
template <class Dut> int walk_rays(const Config& config, unsigned seed, const Pace& pace, int rays) {
    INFO(config.name << ", " << pace.name << ", seed " << seed);
    const Frame frame = frame_at(1234 + seed);
    Dut dut{frame, config, int(seed)};
    TravWorld world{frame, config, seed, pace, rays};
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
    REQUIRE(world.listings() >= rays);
    return world.stopped();
}

void lockstep(const Config& config, unsigned seed, const Pace& pace, int cycles) {
    const Frame frame = frame_at(77);
    TravModel model{frame, config};
    TravRtl rtl{frame, config, int(seed)};
    TravWorld world{frame, config, seed, pace, 1 << 30};
    for (int cycle = 0; cycle < cycles; ++cycle) {
        INFO(config.name << ", " << pace.name << ", seed " << seed << ", cycle " << cycle);
        world.drive(model);
        static_cast<TravLinks&>(rtl) = model;
        model.eval();
        rtl.eval();
        REQUIRE(same(model.ray, rtl.ray, config));
        REQUIRE(same(model.tested, rtl.tested, config));
        REQUIRE(same(model.node_unit_rsp, rtl.node_unit_rsp, config));
        REQUIRE(same(model.leaves, rtl.leaves, config));
        REQUIRE(model.cause == rtl.cause);
        REQUIRE(same(model.node_rsp, rtl.node_rsp, config));
        REQUIRE(same(model.node_req, rtl.node_req, config));
        REQUIRE(same(model.node_unit_req, rtl.node_unit_req, config));
        REQUIRE(same(model.done, rtl.done, config));
        world.watch(model);
        model.commit();
        rtl.commit();
    }
    REQUIRE(world.nodes() > cycles / 20);
}

/// A node's inner children, and list's answer after it tested the leaf.
struct Visit {
    NodeAnswer answer;
    Tested tested;
};

/// Runs one cycle with everything ready; returns the offers.
template <class Dut> struct Hand {
    Dut dut;
    explicit Hand(const Config& config) : dut{frame_at(9), config} {
        dut.node_req.ready = dut.done.ready = dut.node_unit_req.ready = true;
    }
    TravLinks cycle(std::optional<NodeAnswer> answer = {}, std::optional<Tested> tested = {}) {
        dut.node_unit_rsp.offer = answer;
        dut.tested.offer = tested;
        dut.eval();
        const TravLinks seen = dut;
        dut.commit();
        return seen;
    }
    void start(std::uint32_t ray) {
        dut.start = Start{ray};
        dut.ray.offer = Ray{};
        dut.ray.offer->ray = ray;
        REQUIRE(cycle().ray.fires());
        dut.start.reset();
        dut.ray.offer.reset();
    }
    /// Sends the node's answer, which must have a leaf to test, and then the test's result.
    TravLinks visit(const Visit& visit) {
        REQUIRE(cycle(visit.answer).leaves);
        return cycle({}, visit.tested);
    }
    /// Returns the cycles until a node or an end is offered, after the cycle that brings `tested`.
    int wait(const Visit& v, TravLinks& seen) {
        REQUIRE(visit(v).tested.fires());
        return wait(seen);
    }
    int wait(TravLinks& seen) {
        for (int n = 1; n < 50; ++n) {
            seen = cycle();
            if (seen.node_req.offer || seen.done.offer) return n;
        }
        return 0;
    }
};

/// Returns inner children at `nears`, and a leaf that always matters.
Visit visit_of(std::uint32_t ray, std::uint32_t t_best, std::initializer_list<std::uint32_t> nears,
               std::uint32_t base = 100) {
    Visit visit{{}, {ray, 0, t_best}};
    NodeAnswer& answer = visit.answer;
    answer.ray = ray;
    answer.base = base;
    for (const std::uint32_t near : nears) {
        answer.t_near[answer.inner] = near;
        answer.offset[answer.inner] = 2 * answer.inner;
        ++answer.inner;
    }
    answer.leaves = 1;
    answer.count[answer.inner] = 1;
    return visit;
}

/// Returns a single leaf at that distance.
NodeAnswer leaf_at(std::uint32_t ray, std::uint32_t near) {
    NodeAnswer answer;
    answer.ray = ray;
    answer.leaves = answer.count[0] = 1;
    answer.t_near[0] = near;
    return answer;
}

}   // namespace

TEMPLATE_TEST_CASE("trav visits the nodes nearer than the distance to beat, nearest first", "[trav]",
                   TravModel, TravRtl) {
    for (const Pace& pace : paces)
        for (unsigned seed = 1; seed <= 3; ++seed) walk_rays<TestType>(format("default"), seed, pace, 300);
}

TEMPLATE_TEST_CASE(
    "trav visits the nodes nearer than the distance to beat, with four children and a deep stack",
    "[trav][slow]", TravModel, TravRtl) {
    for (const Pace& pace : paces)
        for (unsigned seed = 1; seed <= 10; ++seed) walk_rays<TestType>(format("small"), seed, pace, 300);
}

TEMPLATE_TEST_CASE("trav's decisions take two cycles, and two more for each group it drops", "[trav]",
                   TravModel, TravRtl) {
    Hand<TestType> hand{format("default")};
    hand.start(3);
    TravLinks seen = hand.cycle();   // a new ray requests the root in the next cycle
    REQUIRE(seen.node_req.offer);
    REQUIRE((seen.node_req.offer->ray == 3 && seen.node_req.offer->addr == 9));

    REQUIRE(hand.wait(visit_of(3, 1000, {10, 500}), seen) == 2);   // visit, and 500 is on the stack
    REQUIRE(seen.node_req.offer->addr == 100);
    REQUIRE(hand.wait(visit_of(3, 1000, {20, 400}, 200), seen) == 2);   // 400 is above it
    REQUIRE(seen.node_req.offer->addr == 200);
    REQUIRE(hand.wait(visit_of(3, 1000, {30, 600}, 300), seen) == 2);   // 600 is above that
    REQUIRE(seen.node_req.offer->addr == 300);
    REQUIRE(hand.wait(visit_of(3, 450, {}), seen) == 4);   // another turn drops 600, then 400
    REQUIRE(seen.node_req.offer->addr == 201);
    REQUIRE(hand.wait(visit_of(3, 450, {}), seen) == 2);   // only 500 is left: the end at once
    REQUIRE(seen.done.offer);
    REQUIRE_FALSE(seen.node_req.offer);

    hand.start(3);   // the same context again, with an empty stack
    hand.cycle();
    REQUIRE(hand.wait(visit_of(3, 450, {}), seen) == 2);
    REQUIRE(seen.done.offer);
}

TEMPLATE_TEST_CASE(
    "trav ends a ray immediately when no group on its stack is nearer than the distance to beat", "[trav]",
    TravModel, TravRtl) {
    Hand<TestType> hand{format("default")};
    hand.start(0);
    hand.cycle();
    TravLinks seen;
    for (std::uint32_t level = 0; level < 10; ++level) hand.wait(visit_of(0, 1000, {1, 500 + level}), seen);
    REQUIRE(hand.wait(visit_of(0, 499, {}), seen) == 2);   // ten groups, all beyond: no turn is wasted
    REQUIRE(seen.done.offer);
}

TEMPLATE_TEST_CASE("trav ends a ray that is stopped, and leaves nothing on its stack", "[trav][shading]",
                   TravModel, TravRtl) {
    for (const Pace& pace : paces)
        for (unsigned seed = 1; seed <= 3; ++seed)
            REQUIRE(walk_rays<TestType>(format("shading:default"), seed, pace, 300) > 100);

    Hand<TestType> hand{format("shading:default")};
    hand.start(3);
    hand.cycle();
    TravLinks seen;
    for (std::uint32_t level = 0; level < 10; ++level) hand.wait(visit_of(3, 1000, {1, 500}), seen);
    Visit stop = visit_of(3, 1000, {2, 3});
    stop.tested.stop = 1;
    REQUIRE(hand.wait(stop, seen) == 2);   // ten groups that could all matter
    REQUIRE(seen.done.offer);
    hand.start(3);
    hand.cycle();
    REQUIRE(hand.wait(visit_of(3, 1000, {}), seen) == 2);
    REQUIRE(seen.done.offer);
}

TEST_CASE("a stack that is stopped is empty", "[trav][shading]") {
    Stack stack{format("shading:default")};
    for (int level = 0; level < 10; ++level)
        REQUIRE(stack.decide({3, 0, 1000}, children_of(visit_of(3, 1000, {1, 500}).answer)).action ==
                Decision::Action::visit);
    REQUIRE(stack.height() == 10);
    Visit stop = visit_of(3, 1000, {2, 3});
    stop.tested.stop = 1;
    REQUIRE(stack.decide(stop.tested, children_of(stop.answer)).action == Decision::Action::done);
    REQUIRE(stack.height() == 0);
}

TEMPLATE_TEST_CASE("trav visits a child exactly as far away as the best hit", "[trav]", TravModel, TravRtl) {
    Hand<TestType> hand{format("default")};
    hand.start(1);
    hand.cycle();
    TravLinks seen;
    REQUIRE(hand.wait(visit_of(1, 70, {70, 70, 71}), seen) == 2);
    REQUIRE(seen.node_req.offer->addr == 100);
    REQUIRE(hand.wait(visit_of(1, 70, {}), seen) == 2);
    REQUIRE(seen.node_req.offer->addr == 101);
    REQUIRE(hand.wait(visit_of(1, 70, {}), seen) == 2);
    REQUIRE(seen.done.offer);
}

TEMPLATE_TEST_CASE("trav sends a node's leaves to list immediately if the nearest is in reach", "[trav]",
                   TravModel, TravRtl) {
    const Config config = format("shading:default");
    Hand<TestType> hand{config};
    hand.start(2);
    TravLinks seen = hand.cycle();
    NodeAnswer answer = visit_of(2, 0, {5, 6}, 300).answer;   // two inner children, then three leaves
    answer.leaves = 3;
    for (std::uint32_t i = 0; i < 3; ++i) {
        answer.t_near[2 + i] = 10 + i;
        answer.offset[2 + i] = 20 + i;
        answer.count[2 + i] = 1 + i;
    }
    seen = hand.cycle(answer);
    REQUIRE(seen.leaves);
    REQUIRE((seen.leaves->ray == 2 && seen.leaves->base == 300 && seen.leaves->leaves == 3));
    for (std::uint32_t i = 0; i < std::uint32_t(config.node_width); ++i) {
        REQUIRE(seen.leaves->t_near[i] == (i < 3 ? 10 + i : 0));
        REQUIRE(seen.leaves->offset[i] == (i < 3 ? 20 + i : 0));
        REQUIRE(seen.leaves->count[i] == (i < 3 ? 1 + i : 0));
    }
    for (int i = 0; i < 5; ++i) {   // nothing happens until list has tested them
        seen = hand.cycle();
        REQUIRE_FALSE((seen.node_req.offer || seen.done.offer || seen.leaves));
        REQUIRE(seen.cause == 1);
    }
    REQUIRE(hand.cycle({}, Tested{2, 0, 70}).tested.fires());
    REQUIRE(hand.wait(seen) == 2);
    REQUIRE(seen.node_req.offer->addr == 300);

    // A leaf beyond 70 cannot matter, and one exactly as far can. Without leaves the next node takes one
    // cycle more than after `tested`, which is the queue's.
    REQUIRE(hand.cycle(leaf_at(2, 70)).leaves);
    REQUIRE(hand.cycle({}, Tested{2, 0, 70}).tested.fires());
    REQUIRE(hand.wait(seen) == 2);
    REQUIRE(seen.node_req.offer->addr == 301);
    REQUIRE_FALSE(hand.cycle(leaf_at(2, 71)).leaves);
    REQUIRE(hand.wait(seen) == 3);
    REQUIRE(seen.done.offer);

    // When the ray starts again, every leaf can matter. A shadow ray searches as far as the surface.
    for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::away}) {
        hand.dut.start = Start{2, kind};
        hand.cycle();
        hand.dut.start.reset();
        const std::uint32_t most = (1u << config.t_bits()) - 1,
                            surface = 1u << (config.coord_bits + config.t_frac_bits);
        REQUIRE(hand.cycle(leaf_at(2, kind == RayKind::shadow ? surface : most)).leaves);
        REQUIRE(hand.cycle(leaf_at(2, surface + 1)).leaves.has_value() == (kind != RayKind::shadow));
        for (int i = 0; i < 4; ++i) hand.cycle();
    }
}

TEMPLATE_TEST_CASE("a fast trav sends leaves to list some cycles later, up to the distance to beat",
                   "[trav][shading]", TravModel, TravRtl) {
    const Config config = format("fast:shading:default");
    Hand<TestType> hand{config};
    const std::uint32_t most = (1u << config.t_bits()) - 1,
                        surface = 1u << (config.coord_bits + config.t_frac_bits);
    const auto are_given = [&](std::uint32_t near) {
        bool given = hand.cycle(leaf_at(2, near)).leaves.has_value();
        for (int i = 0; i < 20; ++i) given |= hand.cycle().leaves.has_value();
        return given;
    };
    for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::away}) {
        hand.dut.start = Start{2, kind};
        hand.cycle();
        hand.dut.start.reset();
        for (int i = 0; i < 4; ++i) hand.cycle();
        REQUIRE(are_given(kind == RayKind::shadow ? surface : most));
        REQUIRE(are_given(surface + 1) == (kind != RayKind::shadow));
    }
}

TEMPLATE_TEST_CASE("trav's rays that are tested go before those without leaves", "[trav]", TravModel,
                   TravRtl) {
    Hand<TestType> hand{format("default")};
    for (std::uint32_t ray = 0; ray < 4; ++ray) hand.start(ray);
    for (int i = 0; i < 5; ++i) hand.cycle();
    const auto children = [](std::uint32_t ray) {
        NodeAnswer answer = visit_of(ray, 0, {5}, 100 * ray).answer;
        answer.leaves = answer.count[1] = 0;
        return answer;
    };
    for (const std::uint32_t ray : {2, 3})
        REQUIRE(hand.cycle(visit_of(ray, 0, {5}, 100 * ray).answer).leaves);
    hand.cycle(children(0));
    REQUIRE(hand.cycle(children(1), Tested{2, 0, 50}).tested.fires());   // before ray 0, which waits
    REQUIRE(hand.cycle({}, Tested{3, 0, 50}).tested.fires());
    std::vector<std::uint32_t> order;
    for (int i = 0; i < 8; ++i) {
        const TravLinks seen = hand.cycle();
        if (seen.node_req.offer) order.push_back(seen.node_req.offer->ray);
    }
    REQUIRE(order == std::vector<std::uint32_t>{2, 3, 0, 1});
}

TEMPLATE_TEST_CASE("trav decides a step in every cycle, and no step enters in a second turn", "[trav]",
                   TravModel, TravRtl) {
    const Config config = format("default");
    Hand<TestType> hand{config};
    for (std::uint32_t ray = 0; ray < 64; ++ray) hand.start(ray);
    for (int i = 0; i < 4; ++i) hand.cycle();
    const auto visit_in = [](std::uint32_t cycle) {
        return visit_of(cycle % 64, 1000, {cycle / 64, 900 - cycle / 64});
    };
    hand.cycle(visit_in(0).answer);
    int visits = 0;
    for (std::uint32_t cycle = 0; cycle < 64 * 8; ++cycle) {   // one node's answer, and another's tests
        const TravLinks seen = hand.cycle(visit_in(cycle + 1).answer, visit_in(cycle).tested);
        REQUIRE((seen.tested.fires() && seen.node_unit_rsp.fires() && seen.leaves && seen.cause == 0));
        visits += seen.node_req.fires();
    }
    REQUIRE(visits == 64 * 8 - 2);
    hand.visit(visit_of(5, 895, {}));   // 893 on top matters
    hand.visit(visit_of(6, 892, {}));   // the top 893 does not, and nothing below it: end
    for (int i = 0; i < 3; ++i) REQUIRE(hand.cycle().cause == 1);
    Hand<TestType> other{config};
    other.start(5);
    other.cycle();
    TravLinks seen;
    other.wait(visit_of(5, 1000, {1, 400}), seen);
    other.wait(visit_of(5, 1000, {1, 600}), seen);
    REQUIRE(other.visit(visit_of(5, 500, {})).tested.ready);
    REQUIRE(other.cycle().cause == 1);
    seen = other.cycle({}, Tested{9, 0, 0});
    REQUIRE_FALSE(seen.tested.ready);   // the ray of 5 takes another turn
    REQUIRE(seen.cause == 2);
    REQUIRE(other.cycle().cause == 1);
}

TEST_CASE("model and RTL of trav make the same moves in every cycle", "[trav][lockstep]") {
    const Config config =
        format(GENERATE("default", "shading:default", "fast:small", "fast:shading:default"));
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed) lockstep(config, seed, pace, 3000);
}

TEST_CASE("model and RTL of trav make the same moves, four children, one context and many",
          "[trav][lockstep][slow]") {
    Config one = format("small"), many = one;
    one.name = "one context";
    one.contexts = 1;
    many.name = "128 contexts";
    many.contexts = 128;
    for (const Pace& pace : paces)
        for (unsigned seed = 21; seed <= 25; ++seed) {
            lockstep(format("small"), seed, pace, 5000);
            lockstep(one, seed, pace, 5000);
            lockstep(many, seed, pace, 5000);
        }
}

}   // namespace rayclock::test::trav_test
