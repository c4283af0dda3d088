// Rays of Haines' scenes, counted by his rules and compared with the table that these rules reproduce.
// 513 x 513 rays go through the corners of pixels. Eye rays have depth 1 and the deepest has
// depth 5, which is 4 bounces here.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"

using namespace rayclock;

namespace {

struct Case {
    const char* scene;
    RayCounts rays;
};

/// 512 spacings of pixels span what 511 span in the scene's own angle. The picture's edge is half a pixel
/// farther on each side.
Camera corner_rays(Camera camera) {
    const double half = std::tan(camera.fov_degrees * std::numbers::pi / 360) * 513 / 511;
    camera.fov_degrees = std::atan(half) * 360 / std::numbers::pi;
    return camera;
}

double deviation(std::uint64_t is, std::uint64_t wanted) {
    return wanted == 0 ? static_cast<double>(is)
                       : 100 * (static_cast<double>(is) / static_cast<double>(wanted) - 1);
}

}   // namespace

TEST_CASE("ray counts of Haines' scenes are the published ones", "[reference][whitted][spd][long]") {
    const auto c = GENERATE(values<Case>({
        {"balls:4", {.shadow = 954051, .reflection = 175078, .refraction = 0, .primary_hits = 263169}},
        {"gears:4", {.shadow = 2246825, .reflection = 304629, .refraction = 207543, .primary_hits = 245090}},
        {"mount:6", {.shadow = 412934, .reflection = 354774, .refraction = 354774, .primary_hits = 173132}},
        {"teapot:12", {.shadow = 408005, .reflection = 225518, .refraction = 0, .primary_hits = 161124}},
        {"tetra:6", {.shadow = 46108, .reflection = 0, .refraction = 0, .primary_hits = 49796}},
        {"rings:7:96", {.shadow = 1085002, .reflection = 315236, .refraction = 0, .primary_hits = 263169}},
        {"tree:11:48", {.shadow = 1097419, .reflection = 0, .refraction = 0, .primary_hits = 169836}},
    }));
    const Scene scene = make_builtin(c.scene, Primitives::native);
    const RayCounts rays =
        Reference(scene).whitted(corner_rays(*scene.camera), {513, 513}, {.depth = 4}).rays;
    const double hits = deviation(rays.primary_hits, c.rays.primary_hits),
                 reflected = deviation(rays.reflection, c.rays.reflection),
                 refracted = deviation(rays.refraction, c.rays.refraction),
                 shadow = deviation(rays.shadow, c.rays.shadow);
    WARN(c.scene << ": eye hits " << hits << " %, reflected " << reflected << " %, refracted " << refracted
                 << " %, shadow " << shadow << " %");
    CHECK(rays.primary == 513 * 513);
    for (const double percent : {hits, reflected, refracted, shadow}) CHECK(std::abs(percent) < 1);
}

TEST_CASE("twice as many sides of cones and cylinders change no count by more than 0.2 %",
          "[reference][whitted][spd][long]") {
    const auto [once, twice] = GENERATE(
        table<const char*, const char*>({{"rings:3:96", "rings:3:192"}, {"tree:8:48", "tree:8:96"}}));
    RayCounts rays[2];
    for (const char* name : {once, twice}) {
        const Scene scene = make_builtin(name, Primitives::native);
        rays[name == twice] =
            Reference(scene).whitted(corner_rays(*scene.camera), {257, 257}, {.depth = 4}).rays;
    }
    CAPTURE(once, rays[0].reflection, rays[1].reflection, rays[0].shadow, rays[1].shadow);
    CHECK(std::abs(deviation(rays[1].primary_hits, rays[0].primary_hits)) < 0.2);
    CHECK(std::abs(deviation(rays[1].reflection, rays[0].reflection)) < 0.2);
    CHECK(std::abs(deviation(rays[1].shadow, rays[0].shadow)) < 0.2);
}
