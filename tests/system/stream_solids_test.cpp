// Streams of rays through spheres and planes: hits, lockstep, the exact judge, the reference.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "model/base/error.hpp"
#include "model/base/rng.hpp"
#include "model/compile/lattice.hpp"
#include "model/compile/surfaces.hpp"
#include "model/core/settled.hpp"
#include "sim/load/load.hpp"
#include "sim/run/stream/input.hpp"
#include "sim/run/stream/make_rays.hpp"
#include "tests/support/check/streams.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::stream_solids {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// A scene with a camera, in its form with true spheres.
Scene native(const std::string& name) {
    Scene scene = load_scene(name, {}, Primitives::native);
    if (!scene.camera) scene.camera = fit_camera(scene, 4.0 / 3);
    return scene;
}

Config chip_for(const Scene& scene, const Values& values = {}) {
    return settled(with(streaming(quick_config("default"), scene), values));
}

/// Random rays in a scene.
struct SolidStream {
    SolidStream(Scene given, std::size_t count, const Values& values = {}, std::uint64_t seed = 1)
        : scene(std::move(given)),
          rays("random rays", random_rays(scene, count, seed)),
          stream(make_stream_job(scene, rays, chip_for(scene, values), Outside::clip)) {}
    Scene scene;
    ListedRays rays;
    StreamJob stream;
};

/// Counts the closest hits by the kind of their primitive.
struct Met {
    int triangles = 0, spheres = 0, planes = 0, backs = 0;
    Met(const Scene& scene, const std::vector<Closest>& answers, const Rays& rays) {
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (!answers[i].found || rays[i].any_hit) continue;
            const std::size_t prim = answers[i].prim;
            ++(prim < scene.triangles.size()                          ? triangles
               : prim < scene.triangles.size() + scene.spheres.size() ? spheres
                                                                      : planes);
            backs += answers[i].back;
        }
    }
};

/// A glass sphere and an opaque one, both of radius 1, and a plane under them with sides of 2 and 3.
Scene by_hand() {
    Scene scene;
    scene.name = "solids";
    Material glass, chalk;
    glass.transmit = 0.9;
    scene.materials = {glass, chalk};
    scene.spheres = {{{0, 0, 0}, 1, 0}, {{4, 0, 0}, 1, 1}};
    scene.planes = {{{1, -2, 1}, {2, 0, 0}, {0, 0, -3}, 1}};
    scene.camera = Camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 60};
    return scene;
}

}   // namespace

TEST_CASE("model and RTL trace a stream through spheres and planes alike, and every answer is right",
          "[stream][solids][long]") {
    struct Run {
        const char* scene;
        Values values;
        Disturbance disturbance{};
    };
    const Run run = GENERATE(Run{"spheres", {}}, Run{"spheres", {}, {60, 40, 3}},
                             Run{"mount:3", {{"structure", int(Structure::kd)}, {"stack_depth", 64}}},
                             Run{"balls:1",
                                 {{"structure", int(Structure::spheres)},
                                  {"raygen_interval", 4},
                                  {"tri_interval", 2},
                                  {"timing", int(Timing::fast)}}});
    INFO(run.scene);
    const SolidStream random(native(run.scene), 1200, run.values, 9);
    const LockstepResult result = check_lockstep(random.stream.job, run.disturbance);
    const StreamJudgement judged = judge_stream(random.stream, result.rtl.answers);
    INFO(judged.first);
    CHECK(judged.wrong == 0);
    const Met met(random.scene, result.rtl.answers, random.rays);
    CHECK(met.spheres > 10);
    CHECK((met.planes > 10) == !random.scene.planes.empty());
}

TEST_CASE("a stream walks two levels with spheres and planes, alike in model and RTL",
          "[stream][solids][slow]") {
    Scene scene = native("spheres");
    const SolidStream random(std::move(scene), 1200, {{"levels", 2}, {"stack_depth", 64}}, 5);
    const LockstepResult result = check_lockstep(random.stream.job);
    const StreamJudgement judged = judge_stream(random.stream, result.rtl.answers);
    INFO(judged.first);
    CHECK(judged.wrong == 0);
    const Met met(random.scene, result.rtl.answers, random.rays);
    CHECK(met.spheres > 20);
    CHECK(met.planes > 20);
}

TEST_CASE("every structure gives a stream through spheres and planes the same right answers",
          "[stream][solids][structures]") {
    const Scene scene = native(GENERATE(as<std::string>{}, "spheres", "balls:2", "rings:2", "wknd"));
    INFO(scene.name);
    const ListedRays rays("random rays", random_rays(scene, 2000, 7));
    std::vector<Closest> first;
    for (int s = 0; s < int(names_of<Structure>().size()); ++s) {
        INFO(name_of(Structure(s)));
        const Config config = chip_for(scene, {{"structure", s}, {"stack_depth", 64}, {"addr_bits", 20}});
        const StreamJob stream = make_stream_job(scene, rays, config, Outside::clip);
        const std::vector<Closest> answers = record_frame(stream.job, stream.job.frame).trace.hits;
        const StreamJudgement judged = judge_stream(stream, answers);
        INFO(judged.first);
        CHECK(judged.wrong == 0);
        if (first.empty()) {
            first = answers;
            CHECK(Met(scene, answers, rays).spheres > 5);
        }
        std::size_t differ = 0;
        for (std::size_t i = 0; i < answers.size(); ++i) differ += !same_answer(first[i], answers[i]);
        CHECK(differ == 0);
    }
}

TEST_CASE("the stream of a picture's camera rays has the picture's hits on spheres and planes",
          "[stream][solids]") {
    const Scene scene = native(GENERATE(as<std::string>{}, "spheres", "balls:2", "wknd"));
    INFO(scene.name);
    const Config config = fitted_config(scene, {}, quick_config("default"));
    RayStreamPlan plan;
    plan.size = {48, 36};
    const ListedRays rays("camera rays", make_rays(scene, plan, config));
    const StreamJob stream = make_stream_job(scene, rays, streaming(config, scene), Outside::refuse);
    const Job picture = make_job(scene, *scene.camera, plan.size, config);
    const std::vector<Closest> drawn = record_frame(picture, picture.frame).trace.hits,
                               traced = record_frame(stream.job, stream.job.frame).trace.hits;
    REQUIRE(traced.size() == drawn.size());
    std::size_t found = 0, differ = 0;
    for (std::size_t i = 0; i < traced.size(); ++i) {
        found += drawn[i].found;
        differ += !same_answer(drawn[i], traced[i]);
    }
    CHECK(differ == 0);
    CHECK(found > 500);
}

TEST_CASE("hits on spheres and planes are those of the geometry, on the machine and the reference",
          "[stream][solids]") {
    const Scene scene = by_hand();
    const double root = std::sqrt(0.75), z = 2.5;
    struct Expected {
        StreamRay ray;
        bool hit;
        std::uint32_t primitive = no_primitive;
        bool back = false;
        double t = NAN, u = NAN, v = NAN;
    };
    const std::vector<Expected> all{
        // The glass sphere from outside and from inside, with a direction of length 2.
        {{{0, 0.5, z}, {0, 0, -2}, 0, inf, false}, true, 0, false, (z - root) / 2, 0, 0},
        {{{0, 0.5, 0}, {0, 0, -2}, 0, inf, false}, true, 0, true, root / 2, 0, 0},
        {{{0, 0.5, z}, {0, 0, -2}, (z - root) / 2 + 0.1, inf, false}, true, 0, true, (z + root) / 2, 0, 0},
        {{{0, 0.5, z}, {0, 0, -2}, 0, (z - root) / 2 - 0.01, false}, false},
        // The opaque one from outside. From inside it is not seen, and the ray meets the plane.
        {{{4, 0.5, z}, {0, 0, -1}, 0, inf, false}, true, 1, false, z - root, 0, 0},
        {{{4, 0, 0}, {0, -1, 0}, 0, inf, false}, true, 2, false, 2, 1.5, 1.0 / 3},
        {{{4, 0, 0}, {0, 1, 0}, 0, inf, false}, false},
        // The plane, up to 200 times as far away as the lattice reaches.
        {{{2, 0, 2}, {0, -1, 0}, 0, inf, false}, true, 2, false, 2, 0.5, -1.0 / 3},
        {{{2, 0, 2}, {0, -0.5, -1}, 0, inf, false}, true, 2, false, 4, 0.5, 1},
        {{{2, 0, 2}, {100, -1, 0}, 0, inf, false}, true, 2, false, 2, 100.5, -1.0 / 3},
        {{{2, 0, 2}, {100, -1, 0}, 0, 1.99, false}, false},
        // Any hit: on the way, in the end, and behind it.
        {{{0, 0.5, z}, {0, 0, -2}, 0, inf, true}, true},
        {{{0, 0.5, z}, {0, 0, -2}, 0, 0.7, true}, false},
        {{{0, 0.5, z}, {0, 0, -2}, 0, 1.2, true}, true},
        {{{0, 0.5, 0}, {0, 0, -2}, 0, 0.3, true}, false},
        {{{0, 0.5, 0}, {0, 0, -2}, 0, 0.6, true}, true},
        {{{4, 0, 0}, {0, 0, 1}, 0, inf, true}, false},
        {{{4, 0, 0}, {0, 0, 1}, 0, 2, true}, false},
        {{{2, 0, 2}, {0, -1, 0}, 0, 1.9, true}, false},
        {{{2, 0, 2}, {0, -1, 0}, 0, 2.1, true}, true},
        {{{2, 0, 2}, {100, -1, 0}, 0, inf, true}, true},
        {{{2, 0, 2}, {100, -1, 0}, 0, 1.9, true}, false},
        {{{2, 0, 2}, {100, -1, 0}, 0, 2.1, true}, true},
        {{{2, 0, 2}, {3, 1, 0}, 0, 50, true}, false},
    };
    std::vector<StreamRay> given;
    for (const Expected& one : all) given.push_back(one.ray);
    const StreamInput input(scene, std::make_unique<ListedRays>("rays by hand", given), Outside::refuse);
    const Tracer tracer = GENERATE(Tracer::model, Tracer::reference);
    const std::vector<StreamHit> hits = trace_stream(input, tracer, chip_for(scene)).hits;
    for (std::size_t i = 0; i < all.size(); ++i) {
        INFO(int(tracer) << ", ray " << i);
        CHECK(hits[i].hit == all[i].hit);
        CHECK(hits[i].back == all[i].back);
        CHECK(hits[i].primitive == all[i].primitive);
        if (all[i].primitive == no_primitive) {
            CHECK(std::isnan(hits[i].t + hits[i].u + hits[i].v));
            continue;
        }
        CHECK(hits[i].t == Approx(all[i].t).epsilon(2e-3));
        CHECK(hits[i].u == Approx(all[i].u).epsilon(3e-3).margin(1e-3));
        CHECK(hits[i].v == Approx(all[i].v).epsilon(3e-3).margin(1e-3));
    }
}

TEST_CASE("random rays meet what they meet in double precision, except at edges", "[stream][solids]") {
    const Scene scene = native(GENERATE(as<std::string>{}, "spheres", "balls:2", "wknd"));
    INFO(scene.name);
    const std::vector<StreamRay> given = random_rays(scene, 4000, 17);
    const StreamInput input(scene, std::make_unique<ListedRays>("random rays", given), Outside::clip);
    const Config config = chip_for(scene, {{"coord_bits", 20}, {"origin_bits", 10}});
    const std::vector<StreamHit> ours = trace_stream(input, Tracer::model, config).hits,
                                 theirs = trace_stream(input, Tracer::reference, config).hits;
    std::size_t found = 0, other = 0, far = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
        found += ours[i].hit;
        if (ours[i].hit != theirs[i].hit || ours[i].primitive != theirs[i].primitive ||
            ours[i].back != theirs[i].back) {
            ++other;
            continue;
        }
        if (ours[i].primitive == no_primitive) continue;
        far += std::abs(ours[i].t - theirs[i].t) > 1e-3 * (theirs[i].t + 1);
    }
    CHECK(found > given.size() / 20);
    CHECK(other <= given.size() / 50);
    CHECK(far <= given.size() / 50);
}

TEST_CASE("a ray that begins outside the lattice is clipped unless it meets a plane there",
          "[stream][solids]") {
    const Scene scene = by_hand();
    const auto job_of = [&](const StreamRay& ray) {
        // The second ray keeps the first one's origin from becoming a point of the lattice.
        const ListedRays rays("rays by hand", {ray, {{0, 0, 2}, {1, 0, 0}}});
        return make_stream_job(scene, rays, chip_for(scene), Outside::clip).clipped;
    };
    const std::string sentence =
        "rays by hand: ray 0 meets a plane before it enters the lattice that holds the other primitives, and "
        "a "
        "record holds no point outside the lattice";
    CHECK(job_of({{0, 0, 50}, {0, 0, -1}}) == 1);
    CHECK(job_of({{0, 40, 0}, {0, -1, 0}}) == 1);                             // the plane is behind
    CHECK(job_of({{900, -1.9, 0}, {-900, 1.9, 0}}) == 1);                     // just above the plane
    CHECK(job_of({{900, -1.9, 0}, {1, 0.1, 0}}) == 0);                        // misses both
    CHECK(job_of({{900, 5, 0}, {1, -1, 0}, 0, 6.9}) == 0);                    // ends before the plane
    CHECK_THROWS_WITH(job_of({{900, 5, 0}, {1, -1, 0}, 0, 7.1}), sentence);   // misses the lattice
    CHECK_THROWS_WITH(job_of({{900, -50, 0}, {0, 1, 0}}), sentence);          // from below
    CHECK_THROWS_WITH(job_of({{900, 5, 0}, {1, -1, 0}, 0, inf, true}), sentence);
}

TEST_CASE("rays from outside meet spheres at their outermost points, and graze them there",
          "[stream][solids]") {
    // On a coarse lattice rounding moves many spheres outward, so that a ray just outside the scene grazes
    // one.
    constexpr int steps = (1 << 11) - 1;
    Rng dice(3);
    const auto number = [&] { return double(dice.below(1 << 20)) / (1 << 20); };
    int met = 0, all = 0, grazed = 0;
    std::size_t wrong = 0;
    for (int round = 0; round < 60; ++round) {
        Scene scene;
        scene.name = "two spheres";
        scene.materials.emplace_back();
        for (int i = 0; i < 2; ++i)
            scene.spheres.push_back({{number(), number(), number()}, 0.02 + 0.3 * number(), 0});
        scene.camera = fit_camera(scene, 1);
        std::vector<StreamRay> given, past;
        const Bounds box = bounds(scene);
        const glm::dvec3 extent = box.hi - box.lo;
        const double longest = std::max({extent.x, extent.y, extent.z});
        for (int k = 0; k < 3; ++k)
            for (const double side : {1.0, -1.0}) {
                const auto reach = [&](const Sphere& s) { return side * s.centre[k] + s.radius; };
                const Sphere& outer =
                    reach(scene.spheres[0]) > reach(scene.spheres[1]) ? scene.spheres[0] : scene.spheres[1];
                StreamRay ray;
                ray.origin = outer.centre;
                ray.origin[k] = side * 20;
                ray.direction[k] = -side;
                ray.any_hit = round % 2;
                given.push_back(ray);
                const double pitch = longest / 2 / steps;
                for (int i = 1; i <= 8; ++i) {
                    StreamRay grazing = ray;
                    grazing.origin = outer.centre;
                    grazing.origin[k] = (side > 0 ? box.hi : box.lo)[k] + side * 0.2 * i * pitch;
                    grazing.origin[(k + 1) % 3] = -20;
                    grazing.direction = {};
                    grazing.direction[(k + 1) % 3] = 1;
                    past.push_back(grazing);
                }
            }
        REQUIRE(box.hi.x < 20);
        const ListedRays rays("rays from outside", given);
        const Config config = chip_for(scene, {{"coord_bits", 12}});
        const StreamJob stream = make_stream_job(scene, rays, config, Outside::clip);
        CHECK(stream.clipped == given.size());
        for (const Closest& answer : record_frame(stream.job, stream.job.frame).trace.hits)
            met += answer.found && !answer.back, ++all;
        const ListedRays passing("rays past the scene", past);
        const StreamJob passed = make_stream_job(scene, passing, config, Outside::clip);
        CHECK(passed.missing == 0);   // the lattice has a margin, and they lie in it
        const std::vector<Closest> answers = record_frame(passed.job, passed.job.frame).trace.hits;
        for (const Closest& answer : answers) grazed += answer.found;
        wrong += judge_stream(passed, answers).wrong;
    }
    CHECK(met == all);
    CHECK(wrong == 0);
    CHECK(grazed > 0);
}

TEST_CASE("secondary rays of spheres and planes begin off their surfaces", "[stream][solids]") {
    const Scene scene = native("spheres");
    for (const RayStreamKind kind : {RayStreamKind::mirror, RayStreamKind::diffuse, RayStreamKind::shadow}) {
        RayStreamPlan plan;
        plan.kind = kind;
        plan.size = {24, 18};
        const std::vector<StreamRay> made = make_rays(scene, plan, quick_config("default"));
        const Bounds box = bounds(scene);
        const double off = glm::length(box.hi - box.lo) * 0x1p-16;
        int on_sphere = 0, on_plane = 0;
        for (const StreamRay& ray : made) {
            double nearest =
                std::abs(glm::dot(ray.origin - scene.planes[0].point,
                                  glm::normalize(glm::cross(scene.planes[0].u, scene.planes[0].v))));
            bool is_plane = true;
            for (const Sphere& s : scene.spheres) {
                const double d = std::abs(glm::length(ray.origin - s.centre) - s.radius);
                if (d < nearest) nearest = d, is_plane = false;
            }
            CHECK(nearest == Approx(off).epsilon(1e-6));
            ++(is_plane ? on_plane : on_sphere);
        }
        CHECK(on_sphere > 50);
        CHECK(on_plane > 50);
        const ListedRays rays("made", made);
        const StreamJob stream = make_stream_job(scene, rays, chip_for(scene), Outside::clip);
        CHECK(judge_stream(stream, record_frame(stream.job, stream.job.frame).trace.hits).wrong == 0);
    }
}

}   // namespace rayclock::test::stream_solids
