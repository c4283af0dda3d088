// list: the triangles of a node that are tested, their order and their timing.
#include "tests/support/world/list_world.hpp"

namespace rayclock::test::list_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns the world after all rays.
template <class Dut> ListWorld serve_rays(const Config& config, unsigned seed, const Pace& pace, int rays) {
    INFO(config.name << ", " << pace.name << ", seed " << seed);
    Dut dut{config, int(seed)};
    ListWorld world{config, seed, pace, rays};
    Steady<PrimReq> prim_req{config};
    Steady<Tested> tested{config};
    for (int cycle = 0; !world.finished(); ++cycle) {
        INFO("cycle " << cycle);
        REQUIRE(cycle < 2000 * rays);
        world.drive(dut);
        dut.eval();
        prim_req.check(dut.prim_req);
        tested.check(dut.tested);
        world.watch(dut);
        dut.commit();
    }
    REQUIRE(world.triangles() >= rays);
    return world;
}

void lockstep(const Config& config, unsigned seed, const Pace& pace, int cycles) {
    ListModel model{config};
    ListRtl rtl{config, int(seed)};
    ListWorld world{config, seed, pace, 1 << 30};
    for (int cycle = 0; cycle < cycles; ++cycle) {
        INFO(config.name << ", " << pace.name << ", seed " << seed << ", cycle " << cycle);
        world.drive(model);
        static_cast<ListLinks&>(rtl) = model;
        model.eval();
        rtl.eval();
        REQUIRE(same(model.prim_rsp, rtl.prim_rsp, config));
        REQUIRE(same(model.tri_rsp, rtl.tri_rsp, config));
        REQUIRE(same(model.done, rtl.done, config));
        REQUIRE(same(model.prim_req, rtl.prim_req, config));
        REQUIRE(same(model.tri_req, rtl.tri_req, config));
        REQUIRE(same(model.tested, rtl.tested, config));
        REQUIRE(same(model.closest, rtl.closest, config));
        world.watch(model);
        model.commit();
        rtl.commit();
    }
    REQUIRE(world.triangles() > cycles / 20);
}

/// Returns one leaf of `triangles` triangles.
Leaves leaf_of(std::uint32_t ray, std::uint32_t triangles) {
    Leaves leaves;
    leaves.ray = ray;
    leaves.base = 1000 * ray;
    leaves.leaves = 1;
    leaves.offset[0] = 6;
    leaves.count[0] = triangles;
    return leaves;
}

template <class Dut> struct Hand {
    Dut dut;
    explicit Hand(const Config& config) : dut{config} {
        dut.prim_req.ready = dut.tested.ready = dut.tri_req.ready = dut.closest.ready = true;
        for (std::uint32_t ray = 0; ray < std::uint32_t(config.contexts); ++ray) {
            dut.start = Start{ray};
            cycle();
        }
        dut.start.reset();
    }
    ListLinks cycle(std::optional<Leaves> leaves = {}, std::optional<TriRsp> tri = {}) {
        dut.leaves = leaves;
        dut.tri_rsp.offer = tri;
        dut.eval();
        const ListLinks seen = dut;
        dut.commit();
        return seen;
    }
};

TriRsp miss(std::uint32_t ray) {
    TriRsp rsp;
    rsp.ray = ray;
    return rsp;
}

}   // namespace

TEMPLATE_TEST_CASE("list requests each leaf's triangles, nearest leaf first, none beyond the best hit",
                   "[list]", ListModel, ListRtl) {
    for (const Pace& pace : paces)
        for (unsigned seed = 1; seed <= 3; ++seed) serve_rays<TestType>(format("default"), seed, pace, 300);
}

TEMPLATE_TEST_CASE("list tests nothing more for a light that is blocked, and nothing beyond the surface",
                   "[list][shading]", ListModel, ListRtl) {
    for (const auto* name : {"shading:default", "samples:default"})
        for (const Pace& pace : paces)
            for (unsigned seed = 1; seed <= 2; ++seed)
                REQUIRE(serve_rays<TestType>(format(name), seed, pace, 300).stopped() > 50);
}

TEMPLATE_TEST_CASE("a ray to a light ignores as many cut-outs as have holes, and ends at the next one",
                   "[list][shading][hole]", ListModel, ListRtl) {
    Config config = format("shading:default");
    config.textures = 1, config.name = "textures";
    for (const Pace& pace : paces) {
        const ListWorld world = serve_rays<TestType>(config, 1, pace, 400);
        CAPTURE(world.passed(), world.cutouts());
        REQUIRE((world.passed() > 30 && world.cutouts() > 30));
    }
}

TEMPLATE_TEST_CASE("list requests each leaf's triangles in nodes of four", "[list][slow]", ListModel,
                   ListRtl) {
    for (const Pace& pace : paces)
        for (unsigned seed = 1; seed <= 10; ++seed) serve_rays<TestType>(format("small"), seed, pace, 300);
}

TEMPLATE_TEST_CASE("list passes on in the next cycle, and the inputs wait for nothing", "[list]", ListModel,
                   ListRtl) {
    Hand<TestType> hand{format("default")};
    REQUIRE_FALSE(hand.cycle(leaf_of(1, 2)).prim_req.offer);
    ListLinks seen = hand.cycle();
    REQUIRE((seen.prim_req.offer && seen.prim_req.offer->ray == 1 && seen.prim_req.offer->addr == 2006));
    REQUIRE_FALSE(seen.tested.offer);
    REQUIRE_FALSE(hand.cycle({}, miss(1)).prim_req.offer);
    seen = hand.cycle();
    REQUIRE((seen.prim_req.offer && seen.prim_req.offer->addr == 2007));
    REQUIRE_FALSE(hand.cycle({}, miss(1)).tested.offer);
    seen = hand.cycle();
    REQUIRE((seen.tested.offer && seen.tested.offer->ray == 1));
    REQUIRE_FALSE(seen.prim_req.offer);

    // Both inputs in one cycle, to the link prim: tri's ray goes first.
    hand.cycle(leaf_of(3, 2));
    hand.cycle();
    hand.cycle(leaf_of(4, 2), miss(3));
    REQUIRE(hand.cycle().prim_req.offer->ray == 3);
    REQUIRE(hand.cycle().prim_req.offer->ray == 4);
    // To two links: both at once.
    hand.cycle(leaf_of(5, 1), miss(3));
    seen = hand.cycle();
    REQUIRE((seen.prim_req.offer && seen.tested.offer));
    REQUIRE((seen.prim_req.offer->ray == 5 && seen.tested.offer->ray == 3));
}

TEMPLATE_TEST_CASE("list accepts leaves and a test in every cycle", "[list]", ListModel, ListRtl) {
    const Config config = format("default");
    Hand<TestType> hand{config};
    const std::uint32_t half = 32;
    for (std::uint32_t ray = half; ray < 2 * half; ++ray) hand.cycle(leaf_of(ray, 1));
    for (int i = 0; i < 3; ++i) hand.cycle();
    int tested = 0, prims = 0;
    for (std::uint32_t i = 0; i < half; ++i) {   // leaves of one half of the rays, tests of the other
        const ListLinks seen = hand.cycle(leaf_of(i, 1), miss(half + i));
        REQUIRE(seen.tri_rsp.fires());
        tested += seen.tested.fires();
        prims += seen.prim_req.fires();
    }
    REQUIRE(tested == int(half) - 1);
    REQUIRE(prims == int(half) - 1);
}

TEST_CASE("model and RTL of list make the same moves in every cycle", "[list][lockstep]") {
    const Config config =
        format(GENERATE("default", "sheared:small", "shading:default", "fast:small", "fast:shading:default"));
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 13; ++seed) lockstep(config, seed, pace, 3000);
}

TEST_CASE("model and RTL of list make the same moves, nodes of four and one context",
          "[list][lockstep][slow]") {
    Config one = format("small");
    one.name = "one context";
    one.contexts = 1;
    for (const Pace& pace : paces)
        for (unsigned seed = 21; seed <= 25; ++seed) {
            lockstep(format("small"), seed, pace, 5000);
            lockstep(one, seed, pace, 5000);
        }
}

}   // namespace rayclock::test::list_test
