// Compares the exact ray-box overlap in wide integers with the fractions of fractions.hpp, and measures what
// the machine's box test adds to it.
#include "sim/judge/oracle/extra_visits.hpp"
#include "sim/judge/oracle/overlap.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/scene/builtin.hpp"
#include "model/trace/trace.hpp"
#include "tests/support/cases/box_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

oracle::LatticeVec wide(const Vec3i& v) { return {v[0], v[1], v[2]}; }

/// Requires that both agree, and returns whether the ray meets the box.
bool agree(const Vec3i& o, const Vec3i& d, const Vec3i& lo, const Vec3i& hi) {
    const auto said = oracle::overlap(wide(o), wide(d), wide(lo), wide(hi));
    const auto exact =
        oracle::interval(oracle::point(o), oracle::point(d), {oracle::point(lo), oracle::point(hi), {}}, 1);
    if (said.has_value() != exact.has_value() ||
        (said && oracle::Rational(said->num, said->den) != exact->enter)) {
        CAPTURE(o, d, lo, hi);
        REQUIRE(said.has_value() == exact.has_value());
        REQUIRE(oracle::Rational(said->num, said->den) == exact->enter);
    }
    return said.has_value();
}

/// Returns digit `k` of `number` in base `base`, plus `from`.
std::int32_t digit(int number, int k, int base, int from) {
    for (; k > 0; --k) number /= base;
    return number % base + from;
}
Vec3i digits(int number, int base, int from) {
    return {digit(number, 0, base, from), digit(number, 1, base, from), digit(number, 2, base, from)};
}

ExtraVisits measure(const char* spec, const Config& config, FrameSize size, int every) {
    const Scene scene = make_builtin(spec);
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, 4.0 / 3);
    const MemoryImage image = compile_scene(scene, camera.eye, config);
    const ExtraVisits extra =
        extra_visits(image, make_frame(camera, size, image.lattice, config), config, every);
    INFO(spec << ", N " << config.coord_bits << ", R " << config.recip_bits);
    CHECK(extra.boxes_lost == 0);
    CHECK(extra.t_late == 0);
    CHECK(extra.other_hits == 0);
    CHECK(extra.rays > 0);
    return extra;
}

}   // namespace

TEST_CASE("the overlap is exact for every small ray and box", "[overlap]") {
    // The corner is at the origin, because only differences count. All boxes up to 1 x 1 x 1, origins -1 ..
    // 2, directions -2 .. 2.
    int met = 0;
    for (int box = 0; box < 8; ++box)
        for (int from = 0; from < 64; ++from)
            for (int way = 0; way < 125; ++way)
                met += agree(digits(from, 4, -1), digits(way, 5, -2), {}, digits(box, 2, 0));
    REQUIRE(met > 5000);
}

TEST_CASE("the overlap is exact at full width", "[overlap]") {
    const Config config = format(GENERATE("default", "narrow", "wide"));
    Draw draw{7};
    int met = 0;
    for (int i = 0; i < 3000; ++i) {
        const BoxCase c = random_box_case(draw, config);
        const oracle::Box box = child_box(c.req.node, 0);
        Vec3i lo, hi;
        for (std::size_t k = 0; k < 3; ++k)
            lo[k] = box.lo[k].convert_to<std::int32_t>(), hi[k] = box.hi[k].convert_to<std::int32_t>();
        met += agree(c.req.o, c.d, lo, hi);
    }
    REQUIRE(met > 200);
}

TEST_CASE("no child box that a frame's rays meet is lost, and few others are kept", "[overlap]") {
    Config config;
    config.coord_bits = GENERATE(12, 18, 20);
    config.recip_bits = GENERATE(8, 16);
    config.node_width = GENERATE(2, 8);
    config.stack_depth = 64;
    const ExtraVisits extra = measure("gears:2", config, {96, 72}, 1);
    REQUIRE(extra.boxes > extra.machine.taken);
    REQUIRE(extra.machine.taken > extra.boxes_extra);
    REQUIRE(extra.rounding() < (config.recip_bits == 16 ? 0.005 : 0.08));
    REQUIRE(extra.quantisation() < 0.06);
    REQUIRE(extra.exact.visits >= extra.real.visits);
}

TEST_CASE("the machine's walk is the one that the work is counted on", "[overlap]") {
    const Config config;
    const Scene scene = make_builtin("balls:2");
    const MemoryImage image = compile_scene(scene, scene.camera->eye, config);
    const Frame frame = make_frame(*scene.camera, {64, 48}, image.lattice, config);
    const Trace trace = record_trace(image, frame, config);
    const ExtraVisits extra = extra_visits(image, frame, config, 1);
    CHECK(extra.rays == trace.rays.size());
    CHECK(extra.machine.visits == trace.visits);
    CHECK(extra.machine.triangles == trace.triangle_tests);
}

TEST_CASE("conservative boxes cost at most 2 % more visits than exact ones", "[overlap][slow]") {
    Config config;
    config.coord_bits = GENERATE(12, 16, 18, 20);
    const auto scene = GENERATE("gears:8", "balls:3", "mount:8", "tree:6", "teapot:12");
    REQUIRE(measure(scene, config, {512, 384}, 7).rounding() < 0.02);
}
