// bih: compares the exits that a ray meets with exact planes.
#include "model/engine/engines.hpp"
#include "tests/support/cases/node_unit.hpp"
#include "tests/support/cases/treelet_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct BihUnit : NodeUnitOf<bih::Engine> {
    static constexpr const char* name = "rc_bih";
    static NodeAnswer answer(const BihReq& req, const Frame&, const Config& c) { return bih_answer(req, c); }
};

struct BihCase {
    BihReq req;
    Vec3i d{};
    bool is_long = false;
};

Config bih_format(const std::string& name) {
    Config config = format(name);
    config.structure = Structure::bih;
    return config;
}

/// Turns each plane of a treelet into a pair: one plane, an overlap or a gap of any width.
BihCase pairs_of(const TreeletCase& c, Draw& draw, const Config& config) {
    BihCase made{{c.req.ray, c.req.o, c.req.neg, c.req.recip, c.req.len, {}}, c.d, c.is_long};
    const Treelet& from = c.req.node;
    BihNode& node = made.req.node;
    node.open = from.open, node.lo = from.lo, node.hi = from.hi, node.base = from.base, node.kind = from.kind;
    node.axis = from.axis;
    const std::int32_t end = 1 << (config.coord_bits - 1);
    for (std::size_t i = 0; i + 1 < std::size_t(config.node_width); ++i) {
        const std::int32_t apart =
            draw.below(3) * (draw.coin() ? 1 : int(draw.natural(config.coord_bits - 1)));
        node.lower_to[i] = from.at[i];
        node.upper_from[i] = std::clamp(from.at[i] + (draw.coin() ? apart : -apart), -end, end - 1);
    }
    return made;
}
BihCase random_case(Draw& draw, const Config& config) {
    return pairs_of(random_treelet_case(draw, config), draw, config);
}
BihCase case_at_ends(Draw& draw, const Config& config) {
    return pairs_of(treelet_case_at_ends(draw, config), draw, config);
}

/// Returns the times in an exit's cell: the lower half of a pair ends at one plane, the upper starts at the
/// other.
ExitTimes exit_times(const BihCase& c, std::size_t exit, const Config& config) {
    const BihNode& node = c.req.node;
    return rayclock::test::exit_times(c, node, config, [&](ExitTimes&, auto&& side) {
        for_each_plane(exit, config, [&](std::size_t i, bool upper) {
            if (node.axis[i] != no_axis)
                side(node.axis[i], upper ? node.upper_from[i] : node.lower_to[i], upper);
        });
    });
}
void judge(const BihCase& c, const NodeAnswer& rsp, const Config& config) {
    rayclock::test::judge(c, c.req.node, rsp, config);   // finds exit_times() above by its argument
}

}   // namespace

TEMPLATE_TEST_CASE("bih loses no exit that the ray meets and keeps few others", "[bih][long]", Model<BihUnit>,
                   Rtl<BihUnit>) {
    check_judged<TestType>(bih_format(GENERATE("default", "shading:narrow")), random_case);
}

TEST_CASE("bih is right for every pair of planes and origin of one axis, on planes and half-way", "[bih]") {
    Config config = bih_format("default");
    config.coord_bits = config.dir_bits = 12;
    config.node_width = 2;
    config.recip_bits = 8;
    const bool shades = GENERATE(false, true);
    config.shading = shades;
    config.origin_bits = 3;
    const int frac = config.origin_frac();
    for (const int d : {1, -1, 3, -5, 100, 2047, -2048, 0})
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int lower_to = -2; lower_to <= 2; ++lower_to)
                for (int upper_from = -2; upper_from <= 2; ++upper_from)
                    for (int o = -3 * (1 << frac); o <= 4 * (1 << frac); ++o) {
                        BihCase c;
                        c.d[axis] = d;
                        c.req.o[axis] = o;
                        c.req.node.axis[0] = std::uint32_t(axis);
                        c.req.node.lower_to[0] = lower_to;
                        c.req.node.upper_from[0] = upper_from;
                        c.req.node.kind = {2, 1};
                        c.req.node.open = 1;
                        set_reciprocals(c, config);
                        for (std::size_t k = 0; k < 3; ++k) c.req.neg[k] = c.d[k] < 0;
                        CAPTURE(d, axis, lower_to, upper_from, o);
                        judge(c, bih_answer(c.req, config), config);
                    }
}

TEST_CASE("model and RTL of bih make the same moves in every cycle", "[bih][lockstep]") {
    check_moves<BihUnit>(bih_format(GENERATE("default", "shading:narrow", "fast:default")), {11, 12},
                         random_case);
}

TEST_CASE("bih is right at both ends of every width", "[bih]") {
    check_answers<BihUnit>(bih_format(GENERATE("default", "shading:narrow", "wide")), case_at_ends);
}

TEST_CASE("model and RTL of bih make the same moves at both ends of every width", "[bih][lockstep]") {
    check_moves_at_ends<BihUnit>(bih_format(GENERATE("default", "shading:narrow", "fast:default")),
                                 case_at_ends);
}

TEMPLATE_TEST_CASE("bih answers after exactly its latency, and accepts a request in every cycle", "[bih]",
                   Model<BihUnit>, Rtl<BihUnit>) {
    check_pace<TestType>(bih_format(GENERATE("default", "fast:default")), random_case);
}
