// box at small widths, for every operand: the ray's origin and direction, the node's corner and exponents, the children's
// planes. Judged by cross-multiplied exact overlap; the RTL by the model as well, to the bit. docs/boxes.md has the proof.
#include "tests/support/small.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

BoxVerdict try_model(const Config& config, unsigned which) {
    BoxRequests requests(box_space(config, which), config);
    BoxVerdict verdict;
    BoxRsp rsp;
    for (std::uint64_t n = requests.size(); n-- > 0;) {
        const BoxCase c = requests.next();
        const WideNode node = widen(c.req.node, config.node_width);
        const BoxRay ray{c.req.o, c.req.neg, c.req.recip, c.req.len};
        if (n % 2) box_children(ray, node, config, rsp);
        else box_children_plain(ray, node, config, rsp);
        judge_small(c, rsp, config, verdict);
    }
    REQUIRE(verdict.boxes == requests.boxes());
    return verdict;
}

/// Ends at the first answer that differs from the model's.
BoxVerdict try_rtl(const Config& config, unsigned which) {
    BoxRequests requests(box_space(config, which), config);
    Rtl<BoxUnit> rtl{config};
    std::deque<BoxCase> cases;
    BoxVerdict verdict;
    const auto make = [&] {
        cases.push_back(requests.next());
        return cases.back().req;
    };
    pour(rtl, requests.size(), make, [&](const BoxReq& req, const BoxRsp& rsp) {
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

void good(const BoxVerdict& v, double most_extra) {
    INFO(v.boxes << " boxes, " << v.met << " met, " << v.taken << " taken");
    REQUIRE(v.lost == 0);
    REQUIRE(v.late == 0);
    REQUIRE(v.met > 0);
    REQUIRE(double(v.taken - v.met) < most_extra * double(v.boxes));
}

// One axis: N = 3, M = 4, R = 3, F = 1, planes of 2 bits, exponents 0..2: 8 origins, 8 corners, 16 directions, 3 exponents, 10
// pairs of planes. Two axes: N = 2, M = 3, planes of 1 bit. Three: N = 1, M = 2, planes of 1 bit, exponents 0 and 1.
const Config one_axis = small_format(3, 4, 3, 1, 2), two_axes = small_format(2, 3, 3, 1, 1), three_axes = small_format(1, 2, 3, 1, 1);

} // namespace

TEST_CASE("model of box is right for every operand at small widths", "[box][small]") {
    for (const unsigned axis : {1u, 2u, 4u}) good(try_model(one_axis, axis), 0.2);
    for (const unsigned axes : {3u, 5u, 6u}) good(try_model(two_axes, axes), 0.2);
    good(try_model(three_axes, 7), 0.2);
}

TEST_CASE("rtl of box is right for every operand of an axis and of all three at small widths", "[box][small]") {
    for (const unsigned axis : {1u, 2u, 4u}) good(try_rtl(one_axis, axis), 0.2);
    good(try_rtl(three_axes, 7), 0.2);
}

TEST_CASE("rtl of box is right for every operand of two axes at small widths", "[box][small][slow]") {
    for (const unsigned axes : {3u, 5u, 6u}) good(try_rtl(two_axes, axes), 0.2);
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
