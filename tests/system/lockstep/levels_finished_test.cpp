// Finished pictures of two levels: the RTL computes the model's colours in the same cycles.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "tests/support/levels/finished_instances.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::levels_finished_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns a chip. Units, paths, intervals and formats differ between chips.
Config chip(const std::string& name, bool is_smooth, const Values& more) {
    Values values{{"levels", 2}, {"stack_depth", 64}};
    values.insert(values.end(), more.begin(), more.end());
    Whitted settings;
    settings.depth = 4, settings.aa = is_smooth ? 2 : 1;
    return fitted_config(flattened(mixed(is_smooth)), settings, with(quick_config(name), values));
}

/// Returns a chip with a plane and true spheres in addition to the instances.
Config round_chip(const std::string& name, const Values& more) {
    Values values{{"levels", 2}, {"stack_depth", 64}};
    values.insert(values.end(), more.begin(), more.end());
    Whitted settings;
    settings.depth = 4;
    return fitted_config(flattened(mixed_with_round(false)), settings, with(quick_config(name), values));
}

Values fast(Values more) {
    more.insert(more.begin(), {{"timing", 1}, {"raygen_queue", 32}, {"box_queue", 32}, {"tri_queue", 64}});
    return more;
}

const std::vector<Config>& chips() {
    static const std::vector<Config> all{
        chip("default", true, {}), chip("small", false, fast({{"xform_interval", 1}, {"shade_interval", 8}})),
        chip("small", true, {{"structure", int(Structure::bvh)}, {"mesh_structure", 2}}),   // over kd
        chip("small", true, {{"structure", int(Structure::spheres)}})};
    return all;
}

/// Returns the chips of the slow tests.
const std::vector<Config>& more_chips() {
    static const std::vector<Config> all{
        chip("narrow", true,
             {{"bary_bits", 12}, {"t_frac_bits", 2}, {"xform_interval", 4}, {"shade_interval", 8}}),
        chip("broad", false, {{"dir_bits", 20}}), chip("small", false, {{"structure", int(Structure::kd)}}),
        chip("small", false, fast({{"structure", int(Structure::bsp)}}))};
    return all;
}

Config round_chip_of_a_kd_tree() { return round_chip("default", {{"structure", int(Structure::kd)}}); }

Job job_of(const Scene& scene, FrameSize size, const Config& config, const Whitted& settings) {
    return make_job(scene, *scene.camera, size, config, {}, settings);
}

}   // namespace

TEST_CASE("the RTL of two levels that shades builds", "[.build]") {
    std::vector<RtlJob> jobs;
    for (const Config& config : chips())
        jobs.push_back({"rc_chip", config.name + ", two levels, finished", config});
    jobs.push_back({"rc_chip", "two levels with planes and spheres", round_chip_of_a_kd_tree()});
    REQUIRE_NOTHROW(build_all(jobs));
}

namespace {

void check_instances(const Config& config) {
    INFO(config.name << ", " << name_of(config.structure) << ", a pass every " << config.shade_interval);
    const Scene scene = flattened(mixed(config.smooth));
    Whitted settings;
    settings.depth = 4, settings.aa = config.supersampling ? 2 : 1;
    const Job job = job_of(scene, {16, 12}, config, settings);
    const LockstepResult result = check_lockstep(job);
    CHECK(result.model.rays.shadow > 100);
    CHECK(result.model.rays.reflection > 50);
    CHECK(result.model.rays.refraction > 5);
    settings.aa = 1;
    check_lockstep(job_of(scene, {10, 8}, config, settings), {9, 30, 77}, 77);
}

void check_planes_and_spheres(const Config& config) {
    INFO(config.name << ", a pass every " << config.shade_interval);
    const Scene scene = flattened(mixed_with_round(false));
    Whitted settings;
    settings.depth = 4;
    const LockstepResult result = check_lockstep(job_of(scene, {16, 12}, config, settings));
    CHECK(result.model.rays.shadow > 100);
    CHECK(result.model.rays.refraction > 5);
    check_lockstep(job_of(scene, {10, 8}, config, settings), {9, 30, 77}, 77);
    // Far away on the plane, from where rays must reach the lattice.
    const Scene plane = make_builtin("plane");
    check_lockstep(job_of(plane, {16, 12}, fitted_config(plane, settings, config), settings));
    // Primitive 0 is a sphere. Camera rays must not treat it as the primitive that they leave.
    const Scene spheres = make_builtin("spheres", Primitives::native);
    check_lockstep(job_of(spheres, {16, 12}, fitted_config(spheres, settings, config), settings));
}

}   // namespace

TEST_CASE("model and RTL draw instances alike", "[levels]") {
    check_instances(GENERATE(from_range(chips())));
}

TEST_CASE("model and RTL draw instances alike, more chips", "[levels][slow]") {
    check_instances(GENERATE(from_range(more_chips())));
}

TEST_CASE("model and RTL send no refracted ray of instances that is too short", "[levels]") {
    const Scene scene = flattened(under_a_pane());
    Whitted settings;
    settings.depth = 4, settings.aa = 2;
    const LockstepResult result = check_lockstep(job_of(scene, {16, 12}, chips()[0], settings));
    CHECK(result.model.rays.refraction > 5);
}

TEST_CASE("model and RTL draw planes and true spheres next to instances alike", "[levels][long]") {
    check_planes_and_spheres(round_chip_of_a_kd_tree());
}

TEST_CASE("model and RTL draw planes and true spheres next to instances alike, fast", "[levels][slow]") {
    check_planes_and_spheres(round_chip("small", fast({{"shade_interval", 4}})));
}

}   // namespace rayclock::test::levels_finished_test
