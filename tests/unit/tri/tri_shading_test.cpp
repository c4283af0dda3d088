// tri of a shading chip: every kind of ray against every kind of primitive. All answers are exact except a
// sphere's t, which has a bound.
#include "model/unit/tri/origin.hpp"
#include "tests/support/cases/any_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Counts of hits and misses, by kind of ray (4: a bounce from beyond the lattice) and of primitive.
struct Tally {
    int met[5][3] = {}, missed[5][3] = {};
    void count(const TriReq& r, const TriRsp& rsp, const Config& c) {
        const int kind = is_sphere(r, c) ? 2 : is_plane(r, c) ? 1 : 0;
        ++(rsp.closer ? met : missed)[is_far(r) ? 4 : std::size_t(r.kind)][kind];
    }
    void require(int least, const Config& c) const {
        for (int ray = 0; ray < (c.horizon ? 5 : 4); ++ray)
            for (const int kind : {0, 1, 2}) {
                if ((kind == 1 && !c.planes) || (kind == 2 && !c.spheres)) continue;
                CAPTURE(ray, kind, met[ray][kind], missed[ray][kind]);
                REQUIRE((ray == 4 && kind != 1 ? met[ray][kind] == 0 : met[ray][kind] >= least));
                REQUIRE(missed[ray][kind] >= least);
            }
    }
};

template <class Dut> void against_oracle(const Config& config, unsigned seed, const Pace& pace, int count) {
    INFO(config.name << ", seed " << seed);
    Draw draw{seed};
    Dut dut{config, Frame{}, int(seed)};
    Tally tally;
    stream(
        dut, config, pace, draw, count, [&](Draw& from) { return random_any_req(from, config); },
        [&](const TriReq& req, const TriRsp& rsp) {
            CAPTURE(req.kind, req.triangle.kind);
            judge_any(req, rsp, config);
            tally.count(req, rsp, config);
        });
    tally.require(count / 300, config);
}

const char* const names[] = {"default", "small", "narrow", "wide", "fine"};
const std::pair<const char*, const char*> parts[] = {{"default", ""},      {"small", "plane"},
                                                     {"narrow", "sphere"}, {"wide", "plane"},
                                                     {"fine", "sphere"},   {"default", "sphere plane cutout"},
                                                     {"wide", "cutout"}};

/// Tests of the model use all twelve. Slow tests of the RTL do too; quick ones build four.
const std::vector<int> all_parts{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, quick_parts{2, 7, 8, 10};
template <class Dut> const std::vector<int>& parts_of() {
    return std::is_same_v<Dut, Rtl<TriUnit>> ? quick_parts : all_parts;
}

Config any_part(int which) {
    return which < 5 ? any_format(names[which]) : any_format(parts[which - 5].first, parts[which - 5].second);
}

/// The same with the paths of a fast clock.
Config fast_part(int which) {
    Config config = any_part(which);
    config.timing = Timing::fast;
    config.tri_queue = 64;
    return config;
}

/// The same with a primitive every `interval` cycles: products share multipliers, and a root's steps share a
/// stage.
Config shared(Config config, int interval) {
    config.tri_interval = interval;
    return config;
}

/// Returns a corner of the lattice or of another range: bit k of `which` selects the largest or smallest
/// value on axis k.
Vec3i extreme(int which, int bits) {
    const std::int32_t most = std::int32_t((std::int64_t(1) << (bits - 1)) - 1);
    return {which & 1 ? most : -most - 1, which & 2 ? most : -most - 1, which & 4 ? most : -most - 1};
}

/// Returns requests with all operands at the ends of their widths.
std::vector<TriReq> extremes(const Config& c) {
    const int n = c.coord_bits, b = c.origin_bits;
    std::vector<TriReq> all;
    for (int i = 0; i < 1 << 15; ++i) {
        TriReq r;
        r.kind = RayKind(i % 13 % 4);
        r.triangle.kind = PrimKind(i / 13 % 3);
        if ((r.triangle.kind == PrimKind::plane && !c.planes) ||
            (r.triangle.kind == PrimKind::sphere && !c.spheres))
            continue;
        r.is_partial = c.horizon && r.kind == RayKind::bounce && i % 3 == 0;
        r.triangle.a = extreme(i, n);
        r.triangle.b = extreme(i >> 3, n);
        r.triangle.c = extreme(i >> 6, n);
        r.triangle.prim = 7;
        r.self = c.spheres && i % 7 == 0 ? 7 : 0;
        r.is_inside = c.spheres && i % 5 < 2;
        if (r.triangle.kind == PrimKind::sphere) {   // radius: zero, the largest, half the lattice
            const std::uint64_t room = i >> 3 & 1   ? (std::uint64_t(1) << (2 * n)) - 1
                                       : i >> 4 & 1 ? std::uint64_t(1) << (2 * n - 2)
                                                    : 0;
            r.triangle.b = {std::int32_t(std::int64_t(room << (64 - n)) >> (64 - n)),
                            std::int32_t(std::int64_t(room >> n << (64 - n)) >> (64 - n)), i % 3 > 0};
        }
        r.o = leaves(r) ? extreme(i >> 9, n + b) : scaled(extreme(i >> 9, n), b);
        r.d = extreme(i >> 12, c.dir_bits);
        if (is_shadow(r)) {
            const Vec3i end = i % 11 < 5 ? extreme(i >> 12, n + b) : scaled(extreme(i >> 12, n), b);
            for (std::size_t k = 0; k < 3; ++k) r.d[k] = end[k] - r.o[k];
        }
        all.push_back(r);
    }
    return all;
}

template <class Dut> void require_exact_at_extremes(const Config& config) {
    const auto requests = extremes(config);
    Dut dut{config};
    const auto rsps = answers(dut, config, requests);
    Tally tally;
    for (std::size_t i = 0; i < rsps.size(); ++i) {
        CAPTURE(i, requests[i].kind, requests[i].triangle.kind);
        judge_any(requests[i], rsps[i], config);
        tally.count(requests[i], rsps[i], config);
    }
    tally.require(10, config);
}

void same_moves(const Config& config) {
    for (const Pace& pace : paces)
        for (unsigned seed = 11; seed <= 12; ++seed)
            check_lockstep<TriUnit>(config, {}, pace, seed, 1500 * config.tri_interval,
                                    [&](Draw& draw) { return random_any_req(draw, config); });
}

}   // namespace

TEMPLATE_TEST_CASE("tri of a chip that shades decides exactly and measures within its bound",
                   "[tri][any][long]", Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = any_part(GENERATE(from_range(parts_of<TestType>())));
    for (unsigned seed = 1; seed <= 2; ++seed) against_oracle<TestType>(config, seed, paces[seed % 4], 3000);
}

TEMPLATE_TEST_CASE("tri of a chip that shades decides exactly, many draws", "[tri][any][slow]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = any_part(GENERATE(range(0, 10)));
    for (unsigned seed = 101; seed <= 112; ++seed)
        against_oracle<TestType>(config, seed, paces[seed % 4], 6000);
}

TEMPLATE_TEST_CASE("tri of a chip that shades is exact at the ends of every width", "[tri][any]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    require_exact_at_extremes<TestType>(any_format(GENERATE("default", "narrow")));
}

TEMPLATE_TEST_CASE("tri of a chip that shades is exact at the ends of every width, other formats",
                   "[tri][any][slow]", Model<TriUnit>, Rtl<TriUnit>) {
    require_exact_at_extremes<TestType>(any_format(GENERATE("wide", "fine")));
}

TEST_CASE("every value of the sphere test fits its width, and no width has a bit too many", "[any]") {
    const Config config = any_format(GENERATE("default", "narrow", "wide"));
    const int n = config.coord_bits, b = config.origin_bits;
    const SphereWidths w = sphere_widths(n, config.dir_bits, b);
    struct Span {
        oracle::Int lo = 0, hi = 0;
        void add(const oracle::Int& x) { lo = std::min(lo, x), hi = std::max(hi, x); }
        bool fits(int bits) const {
            return lo >= -(oracle::Int(1) << (bits - 1)) && hi < oracle::Int(1) << (bits - 1);
        }
    } along, square, power, disc, num;
    for (const TriReq& r : extremes(config)) {
        if (r.triangle.kind != PrimKind::sphere) continue;
        if (is_far(r)) continue;
        const int scale = is_shadow(r) ? 0 : b;
        oracle::Int bs = 0, a = 0, c = -(oracle::Int(radius_squared(r.triangle, n)) << (2 * scale));
        for (std::size_t k = 0; k < 3; ++k) {
            const oracle::Int s =
                (oracle::Int(r.o[k]) >> (b - scale)) - (oracle::Int(r.triangle.a[k]) << scale);
            REQUIRE((abs(s) < oracle::Int(1) << (w.offset - 1) &&
                     abs(oracle::Int(r.d[k])) <= oracle::Int(1) << (w.direction - 1)));
            bs += s * r.d[k], a += oracle::Int(r.d[k]) * r.d[k], c += s * s;
        }
        along.add(bs), square.add(a), power.add(c), disc.add(bs * bs - a * c);
        if (!is_shadow(r) && bs * bs >= a * c) num.add(abs(bs) + sqrt(oracle::Int(bs * bs - a * c)) + 1);
    }
    REQUIRE((along.fits(w.along) && square.fits(w.square + 1) && power.fits(w.power) && disc.fits(w.disc) &&
             num.fits(w.num + 1)));
    REQUIRE_FALSE((along.fits(w.along - 1) || square.fits(w.square) || power.fits(w.power - 1)));
    REQUIRE_FALSE(disc.fits(w.disc - 1));
    REQUIRE(num.hi >> (w.num - 2) != 0);
}

TEST_CASE("the root is rounded down, to 28 bits", "[any]") {
    Draw draw{5};
    for (int i = 0; i < 20000; ++i) {
        const int bits = draw.below(123);
        Int128 square = wide_bits(draw, bits);
        if (draw.coin()) {   // a square, or a neighbour of one, shifted left
            const Int128 side = wide_bits(draw, bits / 2);
            square = side * side + (side > 0 ? draw.between(-1, 1) : 0);
        }
        const Root r = root(WideNatural(square));
        CAPTURE(i, r.whole, r.shift);
        const oracle::Int whole = oracle::Int(r.whole) << r.shift, next = oracle::Int(r.whole + 1) << r.shift;
        REQUIRE(r.whole >> root_bits == 0);
        REQUIRE(whole * whole <= big(square));
        REQUIRE(next * next > big(square));
        REQUIRE(r.rest == (whole * whole != big(square)));
        if (r.shift > 0) REQUIRE(r.whole >> (root_bits - 1) == 1);   // no bit of precision is lost
    }
}

TEMPLATE_TEST_CASE("tri of a chip that shades answers after exactly its latency", "[tri][any]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = any_part(GENERATE(0, 2, 7, 8));
    TestType dut{config};
    check_latency(dut, config, [&](Draw& draw) { return random_any_req(draw, config); });
}

TEMPLATE_TEST_CASE("tri of a chip that shades accepts a primitive in every cycle", "[tri][any]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = any_part(GENERATE(0, 8));
    TestType dut{config};
    check_throughput(dut, config, [&](Draw& draw) { return random_any_req(draw, config); });
}

TEST_CASE("model and RTL of tri of a chip that shades make the same moves in every cycle",
          "[tri][any][lockstep]") {
    same_moves(any_part(GENERATE(from_range(quick_parts))));
}

TEMPLATE_TEST_CASE("fast tri of a chip that shades answers after exactly its latency",
                   "[tri][any][fast][long]", Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = fast_part(GENERATE(0, 2));
    TestType dut{config};
    check_latency(dut, config, [&](Draw& draw) { return random_any_req(draw, config); });
}

TEST_CASE("model and RTL of a fast tri of a chip that shades make the same moves in every cycle",
          "[tri][any][lockstep][fast][long]") {
    same_moves(fast_part(GENERATE(0, 2, 8)));
}

TEST_CASE("model and RTL of tri of a chip that shades make the same moves with every format",
          "[tri][any][lockstep][slow]") {
    same_moves(any_part(GENERATE(from_range(all_parts))));
}

TEST_CASE("model and RTL of a tri that shades and shares multipliers make the same moves in every cycle",
          "[tri][any][lockstep][interval][long]") {
    same_moves(GENERATE(shared(fast_part(0), 4), shared(any_part(8), 2)));
}

TEST_CASE("model and RTL of a tri that shades and shares multipliers make the same moves in every format",
          "[tri][any][lockstep][interval][slow]") {
    const int interval = GENERATE(2, 4), which = GENERATE(0, 1, 2, 3, 4, 7, 8);
    same_moves(shared(any_part(which), interval));
    same_moves(shared(fast_part(which), interval));
}

TEST_CASE("a fast tri that shades and shares multipliers decides exactly and measures within its bound",
          "[tri][any][interval]") {
    against_oracle<Rtl<TriUnit>>(shared(fast_part(0), 4), 102, paces[2], 6000);
}
