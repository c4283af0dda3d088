// Streams that rayclock rays makes, against formulas, on a floor below a ceiling.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "sim/run/stream/make_rays.hpp"
#include "tests/support/machine/machines.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr double floor_z = 0, ceiling_z = 6;
const glm::dvec3 eye{1, -2, 5};

/// A floor and a ceiling of 20 x 20, a camera between them that sees only the floor, and two lights.
Scene hall() {
    Scene scene;
    scene.name = "hall";
    for (const double z : {floor_z, ceiling_z}) {
        const auto n = std::uint32_t(scene.vertices.size());
        for (const glm::dvec2 corner :
             {glm::dvec2(-10, -10), glm::dvec2(10, -10), glm::dvec2(10, 10), glm::dvec2(-10, 10)})
            scene.vertices.emplace_back(corner.x, corner.y, z);
        scene.triangles.push_back({{n, n + 1, n + 2}, 0});
        scene.triangles.push_back({{n, n + 2, n + 3}, 0});
    }
    scene.materials.emplace_back();
    scene.camera = Camera{eye, {0, 0, 0}, {0, 1, 0}, 50};
    for (const glm::dvec3 position : {glm::dvec3(0, 3, 4), glm::dvec3(-4, 1, 2)}) {
        Light light;
        light.position = position;
        scene.lights.push_back(light);
    }
    return scene;
}

constexpr FrameSize size{24, 16};
constexpr std::size_t pixels = 24 * 16;

std::vector<StreamRay> made(RayStreamKind kind, const std::function<void(RayStreamPlan&)>& change = {},
                            int threads = 0) {
    RayStreamPlan plan;
    plan.kind = kind, plan.size = size;
    if (change) change(plan);
    return make_rays(hall(), plan, named_config("default"), threads);
}

using Numbers = std::array<double, 9>;
Numbers numbers_of(const StreamRay& r) {
    return {r.origin.x,    r.origin.y, r.origin.z, r.direction.x,    r.direction.y,
            r.direction.z, r.t_min,    r.t_max,    double(r.any_hit)};
}
std::vector<Numbers> numbers_of(const std::vector<StreamRay>& rays) {
    std::vector<Numbers> all;
    for (const StreamRay& ray : rays) all.push_back(numbers_of(ray));
    return all;
}
std::multiset<Numbers> set_of(const std::vector<StreamRay>& rays) {
    const std::vector<Numbers> all = numbers_of(rays);
    return {all.begin(), all.end()};
}

/// Requires that a ray begins just off a plane of constant z.
void require_at(const StreamRay& ray, double z, double side) {
    const double diagonal = std::sqrt(20.0 * 20 + 20 * 20 + 6 * 6), off = diagonal * 0x1p-16;
    REQUIRE((ray.origin.z - z) * side == Approx(off).epsilon(1e-6));
}

}   // namespace

TEST_CASE("camera rays of a stream begin at the eye, one for each pixel", "[stream][rays]") {
    const std::vector<StreamRay> rays = made(RayStreamKind::camera);
    REQUIRE(rays.size() == pixels);
    for (const StreamRay& ray : rays) {
        REQUIRE(glm::distance(ray.origin, eye) < 1e-9);
        REQUIRE(ray.direction == glm::round(ray.direction));
        REQUIRE_FALSE(ray.any_hit);
        REQUIRE(std::isinf(ray.t_max));
    }
}

TEST_CASE("shadow rays lead from each hit to each light", "[stream][rays]") {
    const std::vector<StreamRay> rays = made(RayStreamKind::shadow);
    const Scene scene = hall();
    REQUIRE(rays.size() == 2 * pixels);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        require_at(rays[i], floor_z, 1);
        REQUIRE(glm::distance(rays[i].origin + rays[i].direction, scene.lights[i % 2].position) < 1e-9);
        REQUIRE(rays[i].t_min == 0);
        REQUIRE(rays[i].t_max == 1);
        REQUIRE(rays[i].any_hit);
    }
}

TEST_CASE("mirrored rays turn back at the floor, and at the ceiling after it", "[stream][rays]") {
    const std::vector<StreamRay> camera = made(RayStreamKind::camera), first = made(RayStreamKind::mirror);
    REQUIRE(first.size() == pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const glm::dvec3 d = camera[i].direction;
        require_at(first[i], floor_z, 1);
        REQUIRE(glm::distance(first[i].direction, {d.x, d.y, -d.z}) < 1e-9 * glm::length(d));
        REQUIRE(glm::length(glm::cross(first[i].origin - eye, d)) < 1e-2 * glm::length(d));
    }
    const std::vector<StreamRay> second =
        made(RayStreamKind::mirror, [](RayStreamPlan& plan) { plan.bounce = 2; });
    REQUIRE(second.size() > pixels / 2);
    for (const StreamRay& ray : second) {
        require_at(ray, ceiling_z, -1);
        REQUIRE(ray.direction.z < 0);
    }
}

TEST_CASE("rays of ambient occlusion are cosine-weighted and end at the radius", "[stream][rays]") {
    const std::vector<StreamRay> rays = made(RayStreamKind::ao, [](RayStreamPlan& plan) {
        plan.samples = 64;
        plan.radius = 2.5;
    });
    REQUIRE(rays.size() == 64 * pixels);
    double cosines = 0, squares = 0, across = 0;
    for (const StreamRay& ray : rays) {
        require_at(ray, floor_z, 1);
        REQUIRE(glm::length(ray.direction) == Approx(1));
        REQUIRE(ray.direction.z >= 0);
        REQUIRE(ray.t_max == 2.5);
        REQUIRE(ray.any_hit);
        cosines += ray.direction.z;
        squares += ray.direction.z * ray.direction.z;
        across += ray.direction.x * ray.direction.y;
    }
    // With density cos / pi over the hemisphere, the mean of cos is 2/3, and the mean of cos^2 is 1/2.
    const auto n = double(rays.size());
    CHECK(cosines / n == Approx(2.0 / 3).margin(0.01));
    CHECK(squares / n == Approx(0.5).margin(0.01));
    CHECK(across / n == Approx(0).margin(0.01));
}

TEST_CASE("the second diffuse bounce begins at the ceiling", "[stream][rays]") {
    const auto bounce = [](int k) {
        return made(RayStreamKind::diffuse, [k](RayStreamPlan& plan) { plan.bounce = k, plan.samples = 3; });
    };
    const std::vector<StreamRay> first = bounce(1), second = bounce(2), third = bounce(3);
    REQUIRE(first.size() == 3 * pixels);
    for (const StreamRay& ray : first) require_at(ray, floor_z, 1);
    REQUIRE(second.size() > 0);
    REQUIRE(second.size() < first.size());
    for (const StreamRay& ray : second) {
        require_at(ray, ceiling_z, -1);
        REQUIRE(ray.direction.z <= 0);
        REQUIRE_FALSE(ray.any_hit);
        REQUIRE(std::isinf(ray.t_max));
    }
    REQUIRE(third.size() < second.size());
    for (const StreamRay& ray : third) require_at(ray, floor_z, 1);
}

TEST_CASE("Morton and random order only permute a stream", "[stream][rays]") {
    const std::vector<StreamRay> recorded = made(RayStreamKind::ao);
    const auto ordered = [&](RayOrder order, std::uint64_t seed) {
        std::vector<StreamRay> rays = recorded;
        order_rays(rays, order, seed);
        return rays;
    };
    for (const RayOrder order : {RayOrder::morton, RayOrder::random}) {
        const std::vector<StreamRay> rays = ordered(order, 1);
        CHECK(set_of(rays) == set_of(recorded));
        CHECK(numbers_of(rays) != numbers_of(recorded));
        CHECK(numbers_of(rays) == numbers_of(ordered(order, 1)));
    }
    CHECK(numbers_of(ordered(RayOrder::random, 1)) != numbers_of(ordered(RayOrder::random, 2)));
    CHECK(numbers_of(ordered(RayOrder::recorded, 1)) == numbers_of(recorded));

    const auto steps = [](const std::vector<StreamRay>& rays) {
        double sum = 0;
        for (std::size_t i = 1; i < rays.size(); ++i)
            sum += glm::distance(rays[i].origin, rays[i - 1].origin);
        return sum;
    };
    CHECK(steps(ordered(RayOrder::morton, 1)) < 0.5 * steps(ordered(RayOrder::random, 1)));
}

TEST_CASE("a stream depends on its seed, and not on the number of threads", "[stream][rays]") {
    const auto seeded = [](std::uint64_t seed, int threads) {
        return made(
            RayStreamKind::diffuse, [seed](RayStreamPlan& plan) { plan.seed = seed; }, threads);
    };
    const std::vector<Numbers> one = numbers_of(seeded(1, 1));
    CHECK(one == numbers_of(seeded(1, 4)));
    // No direction occurs twice, within a stream or in the streams of neighbouring seeds.
    std::set<std::array<double, 3>> directions;
    std::size_t rays = 0;
    for (const std::uint64_t seed : {0, 1, 2, 3})
        for (const StreamRay& ray : seeded(seed, 0)) {
            ++rays;
            directions.insert({ray.direction.x, ray.direction.y, ray.direction.z});
        }
    CHECK(directions.size() == rays);
}

TEST_CASE("a stream without lights or with too many rays is refused", "[stream][rays]") {
    Scene dark = hall();
    dark.lights.clear();
    RayStreamPlan plan;
    plan.kind = RayStreamKind::shadow, plan.size = size;
    CHECK_THROWS_WITH(make_rays(dark, plan, named_config("default")),
                      "hall: there is no light, so there are no shadow rays");
    plan.kind = RayStreamKind::ao, plan.size = {16384, 16384}, plan.samples = 1;
    CHECK_THROWS_WITH(make_rays(dark, plan, named_config("default")),
                      "up to 268435456 rays would be made, and a stream has at most 268435455");
}
