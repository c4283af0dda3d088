// Embree as a second opinion on streams of rays. It traces the rounded rays in the rounded scene, so only
// Embree's own rounding may cause differences.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/core/settled.hpp"
#include "model/layout/words.hpp"
#include "sim/judge/paths/world.hpp"
#include "sim/load/load.hpp"
#include "sim/run/stream/stream.hpp"
#include "tests/reference/embree_judge.hpp"
#include "tests/support/scenes/embree_scene.hpp"
#include "tests/support/check/streams.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

glm::dvec3 vector_of(const Vec3i& v) { return {v[0], v[1], v[2]}; }

/// Returns the scene in lattice steps, with the vertices that the chip's memory holds.
Scene on_lattice_steps(Scene scene, const Lattice& lattice) {
    for (auto& vertex : scene.vertices) vertex = vector_of(lattice.snap(vertex));
    return scene;
}

}   // namespace

TEST_CASE("Embree answers the rays of a stream as the chip does, except for its rounding",
          "[reference][embree][stream]") {
    const auto spec = GENERATE(as<std::string>{}, "teapot:6", "gears:2", "tetra:5");
    INFO(spec);
    const Scene scene = load_scene(spec);
    const ListedRays rays("random rays", random_rays(scene, 20000, 11));
    const Config config = settled(streaming(named_config("default"), scene));
    const StreamJob stream = make_stream_job(scene, rays, config, Outside::clip);
    const std::vector<Closest> answers = record_frame(stream.job, stream.job.frame).trace.hits;
    const Scene rounded = on_lattice_steps(scene, stream.job.image.lattice);
    const EmbreeScene embree(rounded, RTC_SCENE_FLAG_ROBUST);
    const double unit = std::ldexp(1.0, config.origin_frac());

    int closest = 0, found = 0, disputed = 0, unexplained = 0, blocked = 0, other = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto record = unpack<RayRecord>(stream.job.image.record(std::uint32_t(i)), config);
        const EmbreeJudge judge{rounded, vector_of(record.o) / unit, glm::normalize(vector_of(record.d))};
        const Hit theirs = embree.trace(judge.origin, judge.direction);
        if (record.kind == RayKind::bounce) {
            const std::uint32_t ours = answers[i].found ? answers[i].prim : no_primitive;
            ++closest;
            found += ours != no_primitive;
            if (ours == theirs.primitive) continue;
            ++(judge.explains(ours, theirs.primitive) ? disputed : unexplained);
            continue;
        }
        const double length = record.kind == RayKind::shadow ? glm::length(vector_of(record.d)) / unit
                                                             : std::numeric_limits<double>::infinity();
        const bool theirs_found = theirs.primitive != no_primitive && theirs.depth < length;
        blocked += theirs_found;
        other += theirs_found != (answers[i].found != 0);
    }
    CHECK(unexplained == 0);
    CHECK(disputed <= closest / 500);
    CHECK(found > closest / 20);
    CHECK(other <= int(answers.size()) / 500);
    CHECK(blocked > int(answers.size()) / 20);
}

namespace {

/// A ray and a sphere in lattice steps, and the largest error of Embree's view of them. Embree rounds origin,
/// direction, centre and radius, and computes in single precision with about 16 roundings.
struct SphereSight {
    double away, radius, error;   ///< away: of the centre from the ray's line
    SphereSight(const Sphere& sphere, const glm::dvec3& origin, const glm::dvec3& direction)
        : away(glm::length(glm::cross(sphere.centre - origin, direction))),
          radius(sphere.radius),
          error(0x1p-20 * (glm::length(origin) + glm::length(sphere.centre - origin) + sphere.radius)) {}
    bool is_grazed() const { return std::abs(away - radius) <= error; }
    /// A shift across the ray changes the depth by the tangent of the surface's slope.
    double depth_error() const {
        const double half_chord = std::sqrt(std::max(0.0, radius * radius - away * away));
        return error * (1 + away / std::max(half_chord, error));
    }
};

}   // namespace

TEST_CASE("Embree meets the spheres of a stream as the chip does, except for its rounding",
          "[reference][embree][stream]") {
    const Scene scene = load_scene("wknd");
    REQUIRE(scene.triangles.empty());
    std::vector<StreamRay> given = random_rays(scene, 20000, 13);
    Rng dice(14);
    const auto offset = [&] {
        return glm::dvec3(dice.below(201) - 100, dice.below(201) - 100, dice.below(201) - 100) / 100.0;
    };
    for (std::size_t i = 0; i < given.size(); i += 2) {   // every second ray passes by a small sphere
        const Sphere& s = scene.spheres[i % scene.spheres.size()];
        if (s.radius >= 2) continue;
        given[i] = {};
        given[i].origin = s.centre + 5.0 * offset();
        given[i].direction = s.centre + 1.2 * s.radius * offset() - given[i].origin;
    }
    const ListedRays rays("random rays", std::move(given));
    const Config config = settled(streaming(named_config("default"), scene));
    const StreamJob stream = make_stream_job(scene, rays, config, Outside::clip);
    const std::vector<Closest> answers = record_frame(stream.job, stream.job.frame).trace.hits;
    Scene rounded = scene;
    snap_round(stream.job.image.lattice, rounded);
    const EmbreeSpheres embree(rounded);
    const double unit = std::ldexp(1.0, config.origin_frac());

    int closest = 0, small = 0, disputed = 0, unexplained = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto record = unpack<RayRecord>(stream.job.image.record(std::uint32_t(i)), config);
        if (record.kind != RayKind::bounce) continue;
        const glm::dvec3 origin = vector_of(record.o) / unit, direction = glm::normalize(vector_of(record.d));
        // Embree meets opaque spheres from inside, and the chip does not.
        const bool is_inside = std::ranges::any_of(rounded.spheres, [&](const Sphere& s) {
            return glm::length(origin - s.centre) <= s.radius + SphereSight(s, origin, direction).error;
        });
        if (is_inside) continue;
        const std::uint32_t theirs = embree.trace(origin, direction).primitive,
                            ours = answers[i].found ? answers[i].prim : no_primitive;
        ++closest;
        small += ours != no_primitive && scene.spheres[ours].radius < 2;
        if (ours == theirs) continue;
        bool explained = false;
        double depth[2] = {0, 0}, slack = 0;
        for (const std::uint32_t met : {ours, theirs}) {
            if (met == no_primitive) continue;
            const SphereSight sight(rounded.spheres[met], origin, direction);
            explained = explained || sight.is_grazed();
            depth[met == theirs] =
                glm::dot(rounded.spheres[met].centre - origin, direction) -
                std::sqrt(std::max(0.0, sight.radius * sight.radius - sight.away * sight.away));
            slack += sight.depth_error();
        }
        if (ours != no_primitive && theirs != no_primitive)
            explained = explained || std::abs(depth[0] - depth[1]) <= slack;
        ++(explained ? disputed : unexplained);
    }
    CHECK(unexplained == 0);
    CHECK(disputed <= closest / 100);
    CHECK(closest > 2000);
    CHECK(small > 20);
}
