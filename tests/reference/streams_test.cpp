// Embree as a second opinion on streams of rays. It traces the rounded rays in the rounded scene, so only
// Embree's own rounding may cause differences.
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "model/core/settled.hpp"
#include "model/layout/words.hpp"
#include "sim/load/load.hpp"
#include "sim/run/stream/stream.hpp"
#include "tests/reference/embree_judge.hpp"
#include "tests/reference/embree_scene.hpp"
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
    const Config config = settled(streaming(named_config("default")));
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
