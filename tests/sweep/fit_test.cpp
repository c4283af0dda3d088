// The search of fit: its result keeps the bound, no parameter can be one step smaller, and no pair of N and M
// is cheaper.
#include <catch2/catch.hpp>

#include "model/base/error.hpp"
#include "model/engine/check.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/core/parameters.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/explore/fit/dominant.hpp"
#include "sim/explore/fit/search.hpp"
#include "sim/view/report/json.hpp"
#include "tests/support/machine/machines.hpp"

using namespace rayclock;
using namespace rayclock::test;
using fit::Goal;
using fit::Measurer;
using fit::Search;

namespace {

Scene ready(const std::string& name, FrameSize size) {
    Scene scene = make_builtin(name);
    if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
    return scene;
}

/// A configuration's frame, measured without any code of fit.
struct Plain {
    bool possible = false;
    FrameError error;
    double work = 0;
    bool deep = false;   ///< in every corner t is rounded by less than a lattice step
};
Plain plain(const Scene& scene, FrameSize size, const HitFrame& reference, const Config& config) {
    Plain p;
    try {
        check_config(config, "test");
        const Job job = make_job(scene, *scene.camera, size, config);
        const RecordedFrame frame = record_frame(job, job.frame);
        p.error = frame_error(scene, hits_of(job, frame), reference);
        p.work = double(frame.trace.visits + frame.trace.triangle_tests);
        p.deep = true;
        for (int x = 0; x < size.width; ++x)
            for (int y = 0; y < size.height; ++y) {
                double square = 0;
                for (const std::int32_t d :
                     pixel_direction(std::uint32_t(x), std::uint32_t(y), job.frame, job.config))
                    square += double(d) * d;
                p.deep =
                    p.deep && std::sqrt(square) <= std::ldexp(1.0, config.dir_bits - 1 + config.t_frac_bits);
            }
        p.possible = true;
    } catch (const UserError&) {}
    return p;
}

Config wide_fields(Config c) {
    c.recip_bits = 24, c.box_bits = 8, c.bary_bits = 24;
    c.t_frac_bits = std::min(8, 68 - 2 * c.coord_bits - c.dir_bits);
    return c;
}

/// The goal as stated in docs/guide/report.md.
bool keeps(const Scene& scene, FrameSize size, const HitFrame& reference, const Config& config,
           const Goal& goal) {
    const Plain now = plain(scene, size, reference, config);
    if (!now.possible) return false;
    const Plain wide = plain(scene, size, reference, wide_fields(config));
    REQUIRE(wide.possible);
    const bool colour = goal.min_psnr ? now.error.psnr_db >= *goal.min_psnr
                                      : now.error.psnr_db >= std::min(wide.error.psnr_db, 60.0) - 0.1;
    return double(now.error.pixels_other_primitive) * 100 <= goal.max_error * double(now.error.pixels) &&
           colour && now.work <= wide.work * (1 + goal.max_work / 100) * (1 + 1e-12) && now.deep;
}

constexpr FrameSize frame_size{160, 120};

}   // namespace

TEST_CASE("what fit finds keeps the goal, and nothing in it can be a step lower", "[fit]") {
    struct Case {
        const char* scene;
        Goal goal;
        const char* base;
    };
    const Case c =
        GENERATE(Case{"teapot:4", {0.1, {}, 2}, "default"}, Case{"gears:1", {0.5, 42.0, 5}, "small"},
                 Case{"cornell", {2, {}, 0}, "wide"}, Case{"tetra:5", {0.3, {}, 1}, "default"},
                 Case{"icosphere:3", {1, {}, 300}, "default"});
    const Scene scene = ready(c.scene, frame_size);
    const HitFrame reference = Reference(scene).frame(*scene.camera, frame_size);
    Measurer measure(scene, frame_size, 0);
    const auto found = Search(measure, named_config(c.base), c.goal).run();
    INFO(c.scene);
    REQUIRE(found);
    CHECK(keeps(scene, frame_size, reference, found->config, c.goal));
    REQUIRE(found->parameters.size() == 10);
    for (const fit::Fitted& f : found->parameters) {
        INFO(f.parameter->key << " " << f.value << ", one step below: " << f.below);
        CHECK(f.parameter->get(found->config) == f.value);
        Config lower = found->config;
        f.parameter->set(lower, f.parameter->power_of_two() ? f.value / 2 : f.value - 1);
        CHECK(!keeps(scene, frame_size, reference, lower, c.goal));
        CHECK(!f.below.empty());
    }
    // The shape must not change.
    Config shape = named_config(c.base);
    for (const fit::Fitted& f : found->parameters) f.parameter->set(shape, f.value);
    for (const Parameter& p : parameters()) {
        INFO(p.key);
        CHECK(p.get(shape) == p.get(found->config));
    }
    CHECK(found->cost.total() < found->base_cost.total());
}

TEST_CASE("no pair of N and M that keeps the goal is cheaper", "[fit]") {
    const char* name = GENERATE("teapot:3", "tetra:4");
    constexpr FrameSize small{96, 72};
    const Scene scene = ready(name, small);
    const HitFrame reference = Reference(scene).frame(*scene.camera, small);
    const Goal goal{0.5, {}, 2};
    Measurer measure(scene, small, 0);
    const auto found = Search(measure, named_config("default"), goal).run();
    REQUIRE(found);
    const auto cost = [&](int n, int m) {
        Config c = found->config;
        c.coord_bits = n, c.dir_bits = m;
        return fit::cost_of(wide_fields(c)).total();
    };
    for (int n = 12; n <= 20; ++n)
        for (int m = 12; m <= 24 && 2 * n + m <= 62; ++m) {
            if (cost(n, m) >= cost(found->config.coord_bits, found->config.dir_bits)) continue;
            Config c = found->config;
            c.stack_depth = 64, c.addr_bits = 24;
            c.coord_bits = n, c.dir_bits = m;
            const Plain p = plain(scene, small, reference, wide_fields(c));
            INFO(name << ", N = " << n << ", M = " << m);
            CHECK((!p.possible ||
                   100 * double(p.error.pixels_other_primitive) > goal.max_error * double(p.error.pixels)));
        }
}

TEST_CASE("fit is the same for any number of threads", "[fit]") {
    const Scene scene = ready("mount:4", {64, 48});
    std::vector<Config> found;
    for (const int threads : {1, 3}) {
        Measurer measure(scene, {64, 48}, threads);
        found.push_back(Search(measure, named_config("default"), {1, {}, 2}).run()->config);
    }
    for (const Parameter& p : parameters()) CHECK(p.get(found[0]) == p.get(found[1]));
}

TEST_CASE("the cost counts every multiplier and every memory", "[fit]") {
    // Computed by hand for the default; see rtl/README.md and the modules.
    const Config c;
    const fit::Cost cost = fit::cost_of(c);
    CHECK(cost.multiplier_adders == 3 * 2 * 34 * 14 + 3 * (2 * 19 * 17 + 16 * 8 * 17) + 12 * 20 * 19 +
                                        6 * 19 * 19 + 9 * 40 * 19 + 3 * 39 * 19 + 2 * 56 * 58);
    CHECK(cost.divider_adders == 3 * 20 * 16 + 58 * (24 + 16 + 16));
    CHECK(cost.stack_bits == 64 * 16 * (24 + 24 + 4 + 7 * (24 + 3)));
    CHECK(cost.ray_bits > cost.stack_bits);
    CHECK(cost.cache_bits ==
          64 * 4 * (24 - 6 + 1 + (54 + 15 + 24 + 24 + 384)) + 64 * 4 * (24 - 6 + 1 + 2 * (162 + 32)));
    for (int Config::*member :
         {&Config::coord_bits, &Config::dir_bits, &Config::recip_bits, &Config::box_bits, &Config::bary_bits,
          &Config::stack_depth, &Config::addr_bits, &Config::prim_bits, &Config::pixel_bits}) {
        Config more = c;
        more.*member += member == &Config::stack_depth ? more.*member : 2;
        CHECK(fit::cost_of(more).total() > cost.total());
    }
}

TEST_CASE("the part that makes a scene large is named", "[fit]") {
    Scene scene;
    scene.camera = Camera{};
    scene.camera->eye = {0, 0, 3};
    scene.materials.resize(2);
    scene.materials[0].name = "cup";
    scene.materials[1].name = "sky";
    const auto add = [&](double extent, std::uint32_t material) {
        const auto first = std::uint32_t(scene.vertices.size());
        for (const glm::dvec3& v : {glm::dvec3{0}, glm::dvec3{extent, 0, 0}, glm::dvec3{0, extent, 0}})
            scene.vertices.push_back(v);
        scene.triangles.push_back({{first, first + 1, first + 2}, material});
    };
    for (int i = 0; i < 10; ++i) add(1 + 0.01 * i, 0);
    CHECK(!fit::dominant_part(scene));   // even distribution: no part stands out
    add(3000, 1);
    add(2000, 1);
    auto part = fit::dominant_part(scene);
    REQUIRE(part);
    CHECK(part->what == "material 'sky' (2 triangles)");
    CHECK(part->triangles == 2);
    CHECK(part->without.triangles.size() == 10);
    CHECK(part->ratio == Approx(1000));

    // One material for all, so the parts are found by triangles.
    for (Triangle& t : scene.triangles) t.material = 0;
    part = fit::dominant_part(scene);
    REQUIRE(part);
    CHECK(part->what == "the 2 largest triangles (10 first)");
    CHECK(part->triangles == 2);
    scene.triangles.pop_back();
    REQUIRE(fit::dominant_part(scene));
    CHECK(fit::dominant_part(scene)->what == "triangle 10");

    // A part that is the whole scene is not named, because nothing would be left without it.
    scene.triangles.erase(scene.triangles.begin(), scene.triangles.begin() + 10);
    for (Triangle& t : scene.triangles) t.material = 1;
    CHECK(!fit::dominant_part(scene));
}
