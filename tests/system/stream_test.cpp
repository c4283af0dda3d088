// Streams of rays: model and RTL in lockstep.
#include <catch2/catch.hpp>

#include "model/base/error.hpp"
#include "sim/load/load.hpp"
#include "tests/support/check/streams.hpp"
#include "tests/system/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// The parameters of a chip for streams.
Values streaming(Values more = {}) {
    more.insert(more.begin(), {{"shading", 1}, {"source", 1}});
    return more;
}

Job stream_job(const std::string& name, std::size_t count, const Config& config, std::uint64_t seed = 1) {
    const Scene scene = load_scene(name);
    const glm::dvec3 eye = fit_camera(scene, 1).eye;
    const MemoryImage image = compile_scene(scene, eye, config);
    return make_stream_job(scene, eye, records_of(random_rays(scene, count, seed), image.lattice, config), config);
}

}   // namespace

TEST_CASE("model and RTL trace a stream alike, in every cycle", "[stream]") {
    const Config config = with(quick_config("default"), streaming());
    for (const std::size_t count : {1, 2, 255, 256, 257, 1001}) {
        INFO(count);
        const LockstepResult result = check_lockstep(stream_job("gears:2", count, config));
        CHECK(result.model.answers.size() == count);
        CHECK(result.model.rays.all() == count);
    }
}

