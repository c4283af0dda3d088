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
Config streaming_config(const Config& config, Values more = {}) {
    more.insert(more.begin(), {{"shading", 1}, {"source", 1}});
    return with(config, more);
}

/// Two pipelines that share a cache, rays one at a time, and lines of one word.
Config narrow_stream() {
    return streaming_config(named_config("small"), {{"structure", int(Structure::kd)},
                                                    {"pipelines", 2},
                                                    {"tile_bits", 0},
                                                    {"stream_line", 64},
                                                    {"stream_sets", 1},
                                                    {"stream_ways", 1},
                                                    {"stream_mshrs", 1},
                                                    {"l2_sets", 8},
                                                    {"raygen_interval", 4},
                                                    {"stack_depth", 64},
                                                    {"timing", int(Timing::fast)}});
}

Job stream_job(const std::string& name, std::size_t count, const Config& config, std::uint64_t seed = 1) {
    const Scene scene = load_scene(name);
    const glm::dvec3 eye = fit_camera(scene, 1).eye;
    const MemoryImage image = compile_scene(scene, eye, config);
    return make_stream_job(scene, eye, records_of(random_rays(scene, count, seed), image.lattice, config),
                           config);
}

}   // namespace

TEST_CASE("model and RTL trace a stream alike, in every cycle", "[stream]") {
    const Config config = GENERATE(0, 1) == 0 ? streaming_config(quick_config("default")) : narrow_stream();
    for (const std::size_t count : {1, 2, 255, 256, 257, 1001}) {
        INFO(count);
        const LockstepResult result = check_lockstep(stream_job("gears:2", count, config));
        CHECK(result.model.answers.size() == count);
        CHECK(result.model.rays.all() == count);
        CHECK(result.rtl.rays.all() == count);
    }
}

TEST_CASE("model and RTL trace a stream alike under back-pressure", "[stream]") {
    const Config config = GENERATE(0, 1) == 0 ? streaming_config(quick_config("default")) : narrow_stream();
    const Traffic traffic = GENERATE(Traffic{30, 0, 3}, Traffic{0, 50, 4}, Traffic{100, 90, 6});
    check_lockstep(stream_job("teapot:6", 500, config, traffic.seed), traffic, int(traffic.seed));
}
