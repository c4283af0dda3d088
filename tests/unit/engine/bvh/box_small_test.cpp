// box at small widths, for every operand: the ray's origin and direction, the node's corner and exponents,
// and the children's planes. Judged by exact overlap with cross-multiplication. The RTL must also equal the
// model bit by bit. docs/proofs/boxes.md has the proof.
#include "model/engine/bvh/encode.hpp"
#include "model/unit/tri/tri.hpp"
#include "tests/support/cases/small.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

BoxVerdict try_model(const Config& config, const BoxSpace& space) {
    BoxRequests requests(space, config);
    BoxVerdict verdict;
    for (std::uint64_t n = requests.size(); n-- > 0;) {
        const BoxCase c = requests.next();
        judge_small(c, box(c.req, config, n % 2 ? box_children : box_children_plain), config, verdict);
    }
    REQUIRE(verdict.boxes == requests.boxes());
    return verdict;
}
BoxVerdict try_model(const Config& config, unsigned which) {
    return try_model(config, box_space(config, which));
}

/// Stops at the first answer that differs from the model's.
BoxVerdict try_rtl(const Config& config, const BoxSpace& space) {
    BoxRequests requests(space, config);
    Rtl<BoxUnit> rtl{config};
    std::deque<BoxCase> cases;
    BoxVerdict verdict;
    const auto make = [&] {
        cases.push_back(requests.next());
        return cases.back().req;
    };
    pour(rtl, requests.size(), make, [&](const BoxReq& req, const NodeAnswer& rsp) {
        if (!same(box(req, config), rsp, config)) {
            CAPTURE(req.o, cases.front().d, req.node.org, req.node.exp, req.node.lo, req.node.hi);
            FAIL("model and RTL differ");
        }
        judge_small(cases.front(), rsp, config, verdict);
        cases.pop_front();
    });
    REQUIRE(verdict.boxes == requests.boxes());
    return verdict;
}
BoxVerdict try_rtl(const Config& config, unsigned which) { return try_rtl(config, box_space(config, which)); }

void good(const BoxVerdict& v, double most_extra) {
    INFO(v.boxes << " boxes, " << v.met << " met, " << v.taken << " taken");
    REQUIRE(v.lost == 0);
    REQUIRE(v.late == 0);
    REQUIRE(v.met > 0);
    REQUIRE(double(v.taken - v.met) < most_extra * double(v.boxes));
}

// One axis: N = 3, M = 4, R = 3, F = 1, planes of 2 bits, exponents 0..2: 8 origins, 8 corners, 16
// directions, 3 exponents, 10 pairs of planes. Two axes: N = 2, M = 3, planes of 1 bit. Three: N = 1, M = 2,
// planes of 1 bit, exponents 0 and 1.
const Config one_axis = small_format(3, 4, 3, 1, 2), two_axes = small_format(2, 3, 3, 1, 1),
             three_axes = small_format(1, 2, 3, 1, 1);

/// Returns a shading configuration whose origins have `frac` fraction bits.
Config shading(Config config, int frac) {
    config.name += "shading";
    config.shading = 1;
    config.origin_bits = frac;
    return config;
}
BoxSpace shadow_space(const Config& config, std::size_t axis) {
    BoxSpace space = box_space(config, 1u << axis);
    space.axes[axis] = all_shadow_cases(config);
    return space;
}

/// Counts rays that hit a triangle, among the requests from `first` to `last`. A hit is lost if box() misses
/// the triangle's quantised box or returns a t_near beyond the hit's t.
std::uint64_t hits_lost(const Config& config, std::uint64_t first, std::uint64_t last, std::uint64_t& hits) {
    std::uint64_t lost = 0;
    BoxCase ray;
    for (std::uint64_t i = first; i < last; ++i) {
        const TriReq req = tri_request(i, config);
        const TriRsp hit = tri(req, config);
        if (!hit.closer) continue;
        ++hits;
        LatticeBox bounds;
        for (const Vec3i& point : {req.triangle.a, req.triangle.b, req.triangle.c}) bounds.add(point);
        LatticeBox neighbour{{-1, -1, -1}, {0, 0, 0}};   // so that the node's corner is not the box's
        const bvh::NodeChild children[] = {{bounds, 1}, {neighbour, 1}};
        if (ray.d != req.d || i == first) set_direction(ray, req.d, config);
        ray.req.o = req.o;
        static_cast<Node&>(ray.req.node) = bvh::encode_node(children, 0, config);
        const auto said = reported(box(ray.req, config), 0);
        lost += !said || *said > hit.t;
    }
    return lost;
}

}   // namespace

TEST_CASE("model of box is right for every operand at small widths", "[box][small]") {
    for (const unsigned axis : {1u, 2u, 4u}) good(try_model(one_axis, axis), 0.2);
    for (const unsigned axes : {3u, 5u, 6u}) good(try_model(two_axes, axes), 0.2);
    good(try_model(three_axes, 7), 0.2);
}

TEST_CASE("RTL of box is right for every operand of an axis and of all three at small widths",
          "[box][small][long]") {
    for (const unsigned axis : {1u, 2u, 4u}) good(try_rtl(one_axis, axis), 0.2);
    good(try_rtl(three_axes, 7), 0.2);
}

TEST_CASE("RTL of box is right for every operand of two axes at small widths", "[box][small][slow]") {
    for (const unsigned axes : {3u, 5u, 6u}) good(try_rtl(two_axes, axes), 0.2);
}

TEST_CASE(
    "model of box is right for every origin between lattice points and every shadow ray at small widths",
    "[box][small][shading]") {
    for (const std::size_t axis : {0u, 1u, 2u}) {
        good(try_model(shading(one_axis, 2), 1u << axis), 0.25);
        good(try_model(shading(one_axis, 2), shadow_space(shading(one_axis, 2), axis)), 0.25);
    }
    for (const unsigned axes : {3u, 5u, 6u}) good(try_model(shading(two_axes, 1), axes), 0.3);
    good(try_model(shading(three_axes, 1), 7), 0.3);
}

TEST_CASE(
    "RTL of box is right for every origin between lattice points and every shadow ray of an axis at small "
    "widths",
    "[box][small][shading][long]") {
    for (const std::size_t axis : {0u, 1u, 2u}) {
        good(try_rtl(shading(one_axis, 2), 1u << axis), 0.25);
        good(try_rtl(shading(one_axis, 2), shadow_space(shading(one_axis, 2), axis)), 0.25);
    }
}

TEST_CASE("RTL of box is right for every origin between lattice points of two and three axes at small widths",
          "[box][small][shading][slow]") {
    for (const unsigned axes : {3u, 5u, 6u}) good(try_rtl(shading(two_axes, 1), axes), 0.3);
    good(try_rtl(shading(three_axes, 1), 7), 0.3);
}

TEST_CASE("box at small widths is as far outside as it may be", "[box][small]") {
    for (const unsigned axis : {1u, 2u, 4u}) {
        BoxRequests requests(box_space(one_axis, axis), one_axis);
        for (std::uint64_t n = requests.size(); n-- > 0;) {
            const BoxCase c = requests.next();
            if (n % 7 == 0) judge_boxes(c, box(c.req, one_axis), one_axis);
        }
    }
}

TEMPLATE_TEST_CASE("box does not mind a zero component that is called negative", "[box][small]",
                   Model<BoxUnit>, Rtl<BoxUnit>) {
    TestType dut{one_axis};
    for (const std::size_t axis : {0u, 1u, 2u}) {
        BoxSpace space = box_space(one_axis, 1u << axis);
        std::erase_if(space.axes[axis], [](const AxisCase& a) { return a.d != 0; });
        BoxRequests requests(space, one_axis);
        const auto make = [&] {
            BoxReq req = requests.next().req;
            req.neg = {1, 1, 1};
            return req;
        };
        std::uint64_t met = 0, wrong = 0;
        pour(dut, requests.size(), make, [&](BoxReq req, const NodeAnswer& rsp) {
            req.neg = {};
            wrong += !same(box(req, one_axis), rsp, one_axis);
            met += rsp.inner;
        });
        REQUIRE(wrong == 0);
        REQUIRE(met > 0);
    }
}

TEST_CASE("no box of a triangle that is hit is left out or comes too late", "[box][small]") {
    std::uint64_t hits = 0;
    REQUIRE(hits_lost(three_axes, 0, tri_requests(three_axes), hits) == 0);
    REQUIRE(hits > 1000);
}

TEST_CASE("no box of a triangle of 64 points that is hit is left out or comes too late",
          "[box][small][slow]") {
    // One corner in the middle, (0, -1, 0): 2^24 rays and triangles.
    const Config config = small_format(2, 2, 3, 1, 1);
    std::uint64_t hits = 0;
    const std::uint64_t a = 2 + 4 * 1 + 16 * 2, block = tri_requests(config) / 64;
    REQUIRE(hits_lost(config, a * block, (a + 1) * block, hits) == 0);
    REQUIRE(hits > 10000);
}
