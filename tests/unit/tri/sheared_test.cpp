// The sheared test: it is watertight by itself and through the tree, and differs from the exact one by a
// derived bound.
#include "tests/support/check/image_check.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/unit/tri/sheared.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/trace/trace.hpp"
#include "tests/support/cases/primitive_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Seen {
    long double x, y, z;
};
/// A corner as the ray sees it, in real numbers.
Seen seen(const Vec3i& p, const Vec3i& o, const Vec3i& d, std::size_t kz) {
    const std::size_t kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    const long double z = p[kz] - o[kz];
    return {p[kx] - o[kx] - z * d[kx] / d[kz], p[ky] - o[ky] - z * d[ky] / d[kz], z};
}
/// Returns the distance of (0, 0) from a segment, the larger of x and y.
long double distance_of(const Seen& p, const Seen& q) {
    // The distance is convex along the segment, so halving finds the least.
    const auto at = [&](long double s) {
        return std::max(std::abs(p.x + s * (q.x - p.x)), std::abs(p.y + s * (q.y - p.y)));
    };
    long double lo = 0, hi = 1;
    for (int i = 0; i < 200; ++i) {
        const long double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        if (at(a) < at(b))
            hi = b;
        else
            lo = a;
    }
    return at(lo);
}

}   // namespace

TEST_CASE("slopes are the direction's, rounded to nearest", "[primitive]") {
    const Config config = with_test("sheared", GENERATE(12, 16, 18, 20));
    Draw draw{5};
    for (int i = 0; i < 3000; ++i) {
        const Vec3i d = draw.vector(config.dir_bits);
        const Shear shear = shear_of(d, config);
        CAPTURE(d[0], d[1], d[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            REQUIRE(std::abs(d[k]) <= std::abs(d[shear.axis]));
            if (k < shear.axis) REQUIRE(std::abs(d[k]) < std::abs(d[shear.axis]));
        }
        REQUIRE(shear.size == std::uint32_t(std::abs(d[shear.axis])));
        REQUIRE(shear.neg == (d[shear.axis] < 0));
        for (std::size_t j = 0; j < 2; ++j) {
            const std::int64_t along = d[(shear.axis + 1 + j) % 3];
            if (shear.size == 0) {
                REQUIRE(shear.slope[j] == 0);
                continue;
            }
            // |2^S along - slope d_z| <= |d_z| / 2; if equal, the slope is the larger.
            const std::int64_t exact = along << config.slope_frac_bits(),
                               got = std::int64_t(shear.slope[j]) * d[shear.axis];
            REQUIRE(2 * std::abs(exact - got) <= std::int64_t(shear.size));
            if (2 * std::abs(exact - got) == std::int64_t(shear.size))
                REQUIRE(std::abs(got) > std::abs(exact));
        }
    }
}

TEST_CASE("the sheared test neither leaks nor hits twice on a closed surface", "[primitive]") {
    const int bits = GENERATE(12, 13, 14, 15, 16, 17, 18, 19, 20);
    Config config = with_test("sheared", bits);
    const int radius = 1 << (bits - 4);
    const std::vector<PrimData> all = sphere(2, radius);
    Draw draw{unsigned(bits)};
    int grazing = 0;
    for (int i = 0; i < 1200; ++i) {
        config.dir_bits = draw.coin() ? bits + 2 : std::min(24, 62 - 2 * bits);
        const PrimData& t = all[std::size_t(draw.below(int(all.size())))];
        // Corners, an edge's middle and quarters; then anywhere inside.
        const double along = draw.below(5) * 0.25;
        const auto target = draw.percent(80)
                                ? inside(t, along, draw.coin() ? 0 : 1 - along)
                                : inside(t, draw.below(1000) / 2000.0, draw.below(1000) / 2000.0);
        Vec3i o = far_origin(draw, bits, 4 * radius), d = towards(o, target, config.dir_bits);
        if (draw.below(4) == 0) {   // along an axis
            const auto k = std::size_t(draw.below(3));
            for (std::size_t j = 0; j < 3; ++j) o[j] = std::int32_t(std::lround(target[j]));
            o[k] = draw.coin() ? 6 * radius : -6 * radius;
            d = {};
            d[k] = o[k] > 0 ? -1 : 1;
        }
        // The cosine between ray and surface, where the ray enters or leaves.
        const double from_middle = std::hypot(target[0], target[1], target[2]);
        const double cosine = (target[0] * d[0] + target[1] * d[1] + target[2] * d[2]) / from_middle /
                              std::hypot(d[0], d[1], d[2]);
        CAPTURE(bits, i, o[0], o[1], o[2], d[0], d[1], d[2]);
        const int count = crossings(config, all, o, d);
        REQUIRE(count % 2 == 0);   // as many entries as exits, even where the surface is seen edge-on
        if (std::abs(cosine) > 0.4)
            REQUIRE(count == 2);
        else
            ++grazing;
    }
    REQUIRE(grazing > 50);
}

TEST_CASE("the sheared test differs from the exact one next to edges only", "[primitive]") {
    const int bits = GENERATE(12, 16, 18, 20);
    const Config config = with_test("sheared", bits), exact = with_test("exact", bits);
    Draw draw{unsigned(bits) + 40};
    int hits = 0, differ = 0;
    for (int i = 0; i < 20000; ++i) {
        TriReq req = random_tri_req(draw, exact);
        const Shear shear = shear_of(req.d, config);
        if (shear.size == 0) continue;
        const std::size_t kz = shear.axis;
        const Seen a = seen(req.triangle.a, req.o, req.d, kz), b = seen(req.triangle.b, req.o, req.d, kz),
                   c = seen(req.triangle.c, req.o, req.d, kz);
        const long double sign = shear.neg ? -1 : 1;
        // The whole triangle must be ahead.
        if (sign * a.z <= 0 || sign * b.z <= 0 || sign * c.z <= 0) continue;
        const TriRsp there = run_test(exact, req.o, req.d, req.triangle),
                     here = run_test(config, req.o, req.d, req.triangle);
        CAPTURE(bits, i);
        if (there.closer != here.closer) {
            ++differ;
            REQUIRE(std::min({distance_of(a, b), distance_of(b, c), distance_of(c, a)}) <= 1.000001L);
        }
        if (!there.closer || !here.closer) continue;
        ++hits;
        // The plane's z at the ray, and its slope in x and in y.
        const long double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        const long double rise_x = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / area;
        const long double rise_y = ((b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z)) / area;
        const long double z = sign * (a.z - rise_x * a.x - rise_y * a.y),
                          got = (long double)here.num / (long double)here.det;
        REQUIRE(std::abs(got - z) <= (std::abs(rise_x) + std::abs(rise_y)) * 1.000001L + 1e-6L * std::abs(z));
        REQUIRE(got >= std::min({sign * a.z, sign * b.z, sign * c.z}));
        REQUIRE(got <= std::max({sign * a.z, sign * b.z, sign * c.z}));
    }
    REQUIRE(hits > 500);
    REQUIRE(differ > 20);
}

TEST_CASE("the sheared test's distance is rounded up, and its weights down", "[primitive]") {
    const Config config = with_test("sheared", GENERATE(12, 18, 20));
    Draw draw{77};
    int hits = 0;
    for (int i = 0; i < 8000; ++i) {
        const TriReq req = random_tri_req(draw, config);
        const TriRsp rsp = run_test(config, req.o, req.d, req.triangle);
        if (!rsp.closer) continue;
        ++hits;
        const oracle::Rational t(oracle::Int(rsp.num), oracle::Int(rsp.det) * shear_of(req.d, config).size);
        const oracle::Int ticks =
            oracle::ceil(t * oracle::power_of_two(config.dir_bits - 1 + config.t_frac_bits));
        REQUIRE(rsp.t == std::min(ticks, oracle::Int((oracle::Int(1) << config.t_bits()) - 1)));
        const std::uint32_t one = 1u << config.bary_bits;
        REQUIRE(rsp.u + rsp.v <= one);
        REQUIRE(rsp.det < std::int64_t(1) << (config.edge_bits() - 1));
        REQUIRE(rsp.num < std::int64_t(1) << (config.num_bits() - 1));
    }
    REQUIRE(hits > 500);
}

TEST_CASE("the corners of the lattice do not overflow the sheared test", "[primitive]") {
    const Config config = with_test("sheared", 20);
    const auto extreme = [](int which, int bits) {
        const std::int32_t most = (1 << (bits - 1)) - 1;
        return Vec3i{which & 1 ? most : -most - 1, which & 2 ? most : -most - 1,
                     which & 4 ? most : -most - 1};
    };
    Int128 largest_num = 0, largest_det = 0;
    for (int a = 0; a < 8; ++a)
        for (int b = 0; b < 8; ++b)
            for (int c = 0; c < 8; ++c)
                for (int o = 0; o < 8; ++o)
                    for (int d = 0; d < 8; ++d) {
                        if (a == b || b == c || c == a) continue;
                        const TriRsp rsp = run_test(config, extreme(o, 20), extreme(d, config.dir_bits),
                                                    {extreme(a, 20), extreme(b, 20), extreme(c, 20), 7});
                        largest_num = std::max(largest_num, rsp.num);
                        largest_det = std::max(largest_det, rsp.det);
                    }
    REQUIRE(largest_num < std::int64_t(1) << (config.num_bits() - 1));
    REQUIRE(largest_det < std::int64_t(1) << (config.edge_bits() - 1));
    REQUIRE(largest_det > std::int64_t(1) << (config.edge_bits() - 4));
}

TEST_CASE("the tree loses no hit of the sheared test, and a closed surface shows no hole", "[primitive]") {
    const int bits = GENERATE(12, 14, 17, 20);
    Config config = with_test("sheared", bits);
    config.dir_bits = bits + 2;   // the largest errors
    config.leaf_size = GENERATE(1, 4);
    Scene scene = make_builtin("icosphere:4");
    // Near, so that most of the frame is covered and triangles are seen at all angles.
    const Camera camera{{0.9, 0.8, 0.7}, {0.3, 0.2, 0.1}, {0, 1, 0}, 100};
    const MemoryImage image = compile_scene(scene, camera.eye, config);
    REQUIRE(check_image(image, config, &scene).empty());
    std::vector<PrimData> all;
    bvh::for_each_primitive(image, config, [&](const PrimData& t) { all.push_back(t); });
    const Frame frame = make_frame(camera, {48, 48}, image.lattice, config);
    const Trace trace = record_trace(image, frame, config, 1);
    int found = 0;
    for (std::uint32_t y = 0; y < frame.height; ++y)
        for (std::uint32_t x = 0; x < frame.width; ++x) {
            const Shear shear = shear_of(pixel_direction(x, y, frame, config), config);
            TriRsp closest, rsp;
            int crossed = 0;
            Best best;
            for (const PrimData& t : all) {
                sheared_test(frame.eye, shear, t, {}, config, rsp);
                crossed += int(rsp.closer);
                sheared_test(frame.eye, shear, t, best, config, rsp);
                if (!rsp.closer) continue;
                closest = rsp;
                best = {1, rsp.num, rsp.det, rsp.prim};
            }
            const Closest& got = trace.hits[std::size_t(y) * frame.width + x];
            CAPTURE(bits, x, y);
            REQUIRE(crossed % 2 == 0);
            REQUIRE(got.found == best.found);
            if (!best.found) continue;
            ++found;
            REQUIRE(
                (got.prim == closest.prim && got.t == closest.t && got.u == closest.u && got.v == closest.v));
        }
    REQUIRE(found > 500);
}

TEST_CASE("a triangle without area keeps a seam of the sheared test shut", "[primitive]") {
    // A seam from p to q with one triangle on one side, two on the other, and a flat one between them: no
    // T-junction.
    const Config config = with_test("sheared");
    Draw draw{12};
    int open = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3i p{draw.between(-30000, -10000), draw.between(-9000, 9000), 2 * draw.between(-5000, 5000)};
        const Vec3i t{p[0] + draw.between(5000, 15000), p[1] + draw.between(-3000, 3000),
                      p[2] + draw.between(-4000, 4000)};
        const Vec3i q{2 * t[0] - p[0], 2 * t[1] - p[1], 2 * t[2] - p[2]},
            left{draw.between(-9000, 9000), 60000, 0}, right{draw.between(-9000, 9000), -60000, 0};
        const std::vector<PrimData> all{{p, q, left, 0}, {p, right, t, 1}, {t, right, q, 2}, {p, t, q, 3}};
        const double along = 0.05 + draw.below(900) / 1000.0;
        const std::array<double, 3> target{p[0] + along * (q[0] - p[0]), p[1] + along * (q[1] - p[1]),
                                           p[2] + along * (q[2] - p[2])};
        const Vec3i o{draw.between(-40000, 40000), draw.between(-40000, 40000), 120000},
            d = towards(o, target, config.dir_bits);
        CAPTURE(i);
        REQUIRE(crossings(config, all, o, d) % 2 == 1);
        open += crossings(config, {all.begin(), all.end() - 1}, o, d) % 2 == 0;
    }
    REQUIRE(open > 0);   // otherwise the flat triangle would not matter

    // So the compiler keeps it for this test, and drops it for the exact test, which does not need it.
    Scene scene;
    scene.name = "seam";
    scene.materials.emplace_back();
    scene.vertices = {{-2, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 0}};
    for (const std::array<std::uint32_t, 3>& v :
         {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 3, 4}, {4, 3, 1}, {0, 4, 1}, {0, 0, 1}})
        scene.triangles.push_back({v, 0});
    for (const char* name : {"exact", "sheared"}) {
        const MemoryImage image = compile_scene(scene, {0, 0, 4}, with_test(name));
        REQUIRE(check_image(image, with_test(name), &scene).empty());
        REQUIRE(image.report.collapsed == (std::string(name) == "exact" ? 2 : 1));
    }
}
