// The proof of ranges: no value of a ray lies outside, intervals are as tight as possible, and the widths in
// the table are the RTL's.
#include <catch2/catch.hpp>

#include <fstream>
#include <set>
#include <regex>
#include <sstream>

#include "sim/explore/fit/ranges.hpp"
#include "sim/run/rtl/builder.hpp"
#include "tests/support/cases/draw.hpp"
#include "tests/support/machine/machines.hpp"
#include "tests/support/machine/observed.hpp"

using namespace rayclock;
using namespace rayclock::test;
using fit::Extremes;
using fit::hull;
using fit::Int128;
using fit::Interval;
using fit::point;

namespace {

Config formats(int n, int m, int f, int r, int box, int bary, int width, int leaf) {
    return shaped(named_config("default"), {{"coord_bits", n},
                                            {"dir_bits", m},
                                            {"t_frac_bits", f},
                                            {"recip_bits", r},
                                            {"box_bits", box},
                                            {"bary_bits", bary},
                                            {"node_width", width},
                                            {"leaf_size", leaf},
                                            {"stack_depth", 64}});
}
const std::vector<Config>& configs() {
    static const std::vector<Config> all{
        formats(18, 20, 4, 16, 8, 16, 8, 1), formats(12, 12, 0, 8, 4, 4, 2, 3),
        formats(20, 22, 3, 24, 8, 24, 8, 6), formats(14, 24, 8, 8, 5, 9, 4, 2)};
    return all;
}

std::string shown(const Interval& a) {
    return a.empty() ? "nothing" : fit::text(a.lo) + " .. " + fit::text(a.hi);
}

std::map<std::string, Interval> by_name(const std::vector<fit::Signal>& signals) {
    std::map<std::string, Interval> all;
    for (const fit::Signal& s : signals) all[s.unit + "." + s.name] = s.range;
    return all;
}

void see(std::map<std::string, Interval>& seen, const std::string& name, Int128 value) {
    seen[name] = hull(seen[name], point(value));
}

}   // namespace

TEST_CASE("intervals hold what their operands can make, and no more", "[fit]") {
    Draw draw{5};
    for (int i = 0; i < 2000; ++i) {
        const auto some = [&] {
            const int lo = draw.between(-9, 9);
            return Interval{lo, lo + draw.below(6)};
        };
        const Interval a = some(), b = some();
        Interval sum, product, difference, shifted, shifted_up, size;
        for (Int128 x = a.lo; x <= a.hi; ++x) {
            for (Int128 y = b.lo; y <= b.hi; ++y) {
                sum = hull(sum, point(x + y)), difference = hull(difference, point(x - y)),
                product = hull(product, point(x * y));
            }
            Int128 floor = x / 4, ceiling = x / 4;
            if (floor * 4 > x) --floor;
            if (ceiling * 4 < x) ++ceiling;
            shifted = hull(shifted, point(floor)), shifted_up = hull(shifted_up, point(ceiling)),
            size = hull(size, point(x < 0 ? -x : x));
        }
        INFO(shown(a) << " and " << shown(b));
        REQUIRE(a + b == sum);
        REQUIRE(a - b == difference);
        REQUIRE(a * b == product);
        REQUIRE(fit::right(a, 2) == shifted);
        REQUIRE(fit::right_up(a, 2) == shifted_up);
        REQUIRE(fit::magnitude(a) == size);
    }
    const int bits[][4] = {{0, 0, 1, 1},  {-1, 0, 1, 1},  {0, 1, 2, 1},    {-2, 1, 2, 1},
                           {-3, 1, 3, 1}, {0, 255, 9, 8}, {0, 256, 10, 9}, {-256, 255, 9, 8}};
    for (const auto& b : bits) {
        CHECK(fit::signed_bits({b[0], b[1]}) == b[2]);
        CHECK(fit::unsigned_bits({b[0], b[1]}) == b[3]);
    }
    CHECK(fit::text(-(Int128(1) << 100)) == "-1267650600228229401496703205376");
}

TEST_CASE("every value that the rays of a frame meet lies in its interval", "[fit]") {
    const Config& config = configs()[GENERATE(range(std::size_t(0), std::size_t(4)))];
    const char* scene = GENERATE("teapot:4", "gears:1", "mount:3", "cornell", "tree:3");
    const Job job = small_job(scene, {40, 30}, config);
    const fit::Ranges ranges = fit::prove_ranges(job.image, job.frame, config);
    Observed observed(job.image, job.frame, config);
    observed.frame();
    INFO(scene << ", " << config.name);
    CHECK(ranges.proven());
    std::set<std::string> names;
    for (const fit::Signal& s : ranges.signals) {
        const std::string name = s.unit + "." + s.name;
        const Interval seen = observed.seen[name];
        INFO(name << ": seen " << shown(seen) << ", proven " << shown(s.range) << ", " << s.there << " bits");
        REQUIRE(names.insert(name).second);
        REQUIRE(!seen.empty());
        CHECK(s.range.holds(seen.lo));
        CHECK(s.range.holds(seen.hi));
    }
    for (const auto& [name, seen] : observed.seen) {
        INFO(name);
        CHECK(names.count(name) == 1);
    }
    for (const char* exact :
         {"raygen.d", "raygen.s1_sum", "raygen.s1_right", "raygen.s1_down", "raygen.eye", "raygen.x"}) {
        INFO(exact);
        CHECK(observed.seen[exact] == by_name(ranges.signals)[exact]);
    }
}

TEST_CASE("reciprocals of an interval are those of its directions", "[fit]") {
    Config config = formats(12, 12, 0, 9, 8, 8, 2, 1);
    for (const Interval d : {Interval{-2047, 2047}, Interval{3, 700}, Interval{-40, -7}, Interval{-5, 2},
                             Interval{0, 0}, Interval{512, 1023}}) {
        std::map<std::pair<bool, int>, std::array<Interval, 3>> seen;
        for (std::int32_t x = std::int32_t(d.lo); x <= std::int32_t(d.hi); ++x) {
            const Recip r = reciprocal(x, config);
            auto& [size, aligned, recip] = seen[{x < 0, int(r.len)}];
            const Int128 magnitude = x < 0 ? -x : x;
            size = hull(size, point(magnitude)),
            aligned = hull(aligned, point(magnitude << (12 - int(r.len)))),
            recip = hull(recip, point(r.recip));
        }
        const auto classes = fit::recip_classes(d, config);
        CHECK(classes.size() == seen.size());
        for (const fit::RecipClass& c : classes) {
            INFO(shown(d) << ", bit length " << c.len);
            REQUIRE(seen.count({c.negative, c.len}) == 1);
            const auto& [size, aligned, recip] = seen[{c.negative, c.len}];
            CHECK(c.size == size);
            CHECK(c.aligned == aligned);
            CHECK(c.recip == recip);
        }
    }
}

TEST_CASE("box's intervals are exactly what all rays and planes of a small world make", "[fit]") {
    const Config config = formats(12, 12, 1, 8, 8, 8, 2, 1);
    Draw draw{11};
    for (int round = 0; round < 30; ++round) {
        Extremes e;
        const int axis = draw.below(3), exp = draw.below(6), eye = draw.between(-2000, 2000),
                  first = draw.between(-2000, 1990);
        const auto k = std::size_t(axis);
        for (std::size_t other = 0; other < 3; ++other)
            e.direction[other] = point(2047), e.eye[other] = point(0);
        const int d0 = draw.coin() ? draw.between(-6, 3) : draw.between(-2000, 1900),
                  d1 = std::min(2047, d0 + draw.below(12));
        e.direction[k] = {d0, d1};
        e.eye[k] = point(eye);
        const Interval origin{first, first + 3}, lo{draw.below(9), 10}, hi{11, 11 + draw.below(200)};
        e.groups[k][std::size_t(exp)] = {origin, lo, hi};
        std::vector<fit::Signal> signals;
        fit::box_ranges(e, config, signals);

        std::map<std::string, Interval> seen;
        for (int d = d0; d <= d1; ++d)
            for (Int128 org = origin.lo; org <= origin.hi; ++org)
                for (const Int128 l : {lo.lo, lo.hi})
                    for (const Int128 h : {hi.lo, hi.hi}) {
                        const Recip recip = reciprocal(d, config);
                        const bool neg = d < 0;
                        const Int128 r = recip.recip, up = r + (d != 0),
                                     distance = neg ? eye - org : org - eye;
                        const Int128 near = (distance * r) >> exp, far = -((-distance * up) >> exp);
                        see(seen, "box.s1_distance", distance);
                        see(seen, "box.s1_near", distance * r);
                        see(seen, "box.s1_far", distance * up);
                        see(seen, "box.s2_near", near);
                        see(seen, "box.s2_far", far);
                        const Int128 near_step = (neg ? h : l) * r, far_step = (neg ? l : h) * up;
                        see(seen, "box.step", near_step);
                        see(seen, "box.step", far_step);
                        see(seen, "box.s3_near", neg ? near - near_step : near + near_step);
                        see(seen, "box.s3_far", neg ? far - far_step : far + far_step);
                        if (d == 0) continue;
                        const int shift =
                            config.t_frac_bits + config.dir_bits - config.recip_bits - int(recip.len) + exp;
                        see(seen, "box.s3_left", std::clamp(shift, 0, config.t_bits()));
                        see(seen, "box.s3_right", std::max(-shift, 0));
                    }
        const auto proven = by_name(signals);
        for (const auto& [name, range] : seen) {
            INFO(round << ": " << name << ": seen " << shown(range) << ", proven " << shown(proven.at(name)));
            REQUIRE(proven.at(name).holds(range.lo));
            REQUIRE(proven.at(name).holds(range.hi));
            // One bit length and sign: looking at operands separately loses nothing.
            if (fit::recip_classes(e.direction[k], config).size() == 1 &&
                name.find("s3_") == std::string::npos)
                CHECK(proven.at(name) == range);
        }
    }
}

TEST_CASE("tri's intervals are exactly what the corners of the box of directions make", "[fit]") {
    Draw draw{3};
    const Config config = formats(14, 14, 1, 8, 8, 8, 2, 1);
    for (int round = 0; round < 20; ++round) {
        Scene scene;
        scene.materials.resize(1);
        for (int i = 0; i < 3; ++i)
            scene.vertices.push_back(
                {draw.between(-100, 100), draw.between(-100, 100), draw.between(-100, 100)});
        scene.triangles.push_back({{0, 1, 2}, 0});
        Camera camera;
        camera.eye = {double(draw.between(-150, 150)), double(draw.between(-150, 150)), 160};
        const Job job = make_job(scene, camera, {9, 7}, config);
        const Extremes e = fit::extremes(job.image, job.frame, config);
        const PrimData t = read_primitive(job.image, 2 * bvh::read_node(job.image, 0, config).base, config);
        Interval det, u, v, w, p1, p2, num;
        for (int corner = 0; corner < 8; ++corner) {
            using Vec = std::array<Int128, 3>;
            Vec d{}, e1{}, e2{}, s{};
            for (std::size_t k = 0; k < 3; ++k) {
                d[k] = corner >> k & 1 ? e.direction[k].hi : e.direction[k].lo;
                e1[k] = Int128(t.b[k]) - t.a[k], e2[k] = Int128(t.c[k]) - t.a[k],
                s[k] = Int128(job.frame.eye[k]) - t.a[k];
            }
            const auto cross = [](const Vec& a, const Vec& b) {
                return Vec{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
            };
            const auto dot = [](const Vec& a, const Vec& b) {
                return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            };
            const Vec q1 = cross(d, e1), q2 = cross(d, e2);
            const Int128 a = dot(q2, e1), b = dot(q2, s), c = -dot(q1, s);
            det = hull(det, point(a)), u = hull(u, point(b)), v = hull(v, point(c)),
            w = hull(w, point(a - b - c)), num = hull(num, point(dot(cross(e1, e2), s)));
            for (std::size_t k = 0; k < 3; ++k) p1 = hull(p1, point(q1[k])), p2 = hull(p2, point(q2[k]));
        }
        const auto axes = [](const Extremes::Axes& a) { return hull(hull(a[0], a[1]), a[2]); };
        INFO(round);
        CHECK(e.det == det);
        CHECK(e.u == u);
        CHECK(e.v == v);
        CHECK(e.w == w);
        CHECK(e.num == num);
        CHECK(axes(e.p1) == p1);
        CHECK(axes(e.p2) == p2);
        CHECK(e.prim == point(0));
    }
}

TEST_CASE("a signal that is a bit too narrow is an overflow", "[fit]") {
    fit::Ranges ranges;
    ranges.signals.push_back({"tri", "det", {-8, 7}, true, 4, fit::Excess::never});
    CHECK(ranges.proven());
    ranges.signals[0].range.hi = 8;
    CHECK(!ranges.proven());
    ranges.signals[0].excess = fit::Excess::wraps;
    CHECK(ranges.proven());
}

TEST_CASE("the widths in the table of ranges are the RTL's", "[fit]") {
    const std::pair<const char*, std::vector<const char*>> texts[] = {
        {"unit/tri/rc_edges.sv",
         {"localparam int unsigned DiffW = N + 1;",
          "localparam int unsigned RayCrossW = RayDirBits + DiffW + 1;",
          "localparam int unsigned EdgeCrossW = 2 * DiffW + 1;",
          "localparam int unsigned EdgeBits = rc_pkg::EdgeBits",
          "localparam int unsigned NumBits = rc_pkg::NumBits"}},
        {"unit/tri/rc_tri.sv",
         {"logic [NumBits+EdgeBits-1:0] f0_mine, f0_theirs, f1_mine_q, f1_theirs_q;",
          "localparam int unsigned EdgeBits = rc_pkg::EdgeBits;"}},
        {"unit/tri/rc_hitdiv.sv",
         {"localparam int unsigned WideW = (NumBits + Left > DenW ? NumBits + Left : DenW) + 1;",
          "rc_pkg::DirBits - rc_pkg::CoordBits - 3 : 0;"}},
        {"engine/bvh/rc_slab.sv",
         {"localparam int unsigned R1 = rc_pkg::RecipBits + 1", "localparam int unsigned DistanceW = N + 1;",
          "localparam int unsigned ProductW = DistanceW + R1 + 1;",
          "localparam int unsigned SumW = ProductW + 1;",
          "logic [RightW-1:0] placed_move, placed_right, ready_move;", "logic [R1-1:0] placed_up;"}},
        {"unit/raygen/rc_raygen.sv",
         {"logic signed [GuardSumW-1:0] s1_right_q, s1_down_q, s1_corner;",
          "localparam int unsigned GuardDirBits = rc_pkg::GuardDirBits;",
          "localparam int unsigned GuardSumW = GuardDirBits + SubBits;"}},
        {"fixed/rc_recip.sv", {"logic [RayDirBits-1:0] s0_mag, mag;"}}};
    for (const auto& [name, lines] : texts) {
        std::ifstream file(rtl_sources() / name);
        std::ostringstream text;
        text << file.rdbuf();
        const std::string spaced = std::regex_replace(text.str(), std::regex(" +"), " ");
        for (const char* line : lines) {
            INFO(name << " has no line " << line);
            CHECK((spaced.find(line) != std::string::npos));
        }
    }
}
