// The finished picture, case by case, against values computed by hand from the rules.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "tests/reference/meshes.hpp"

using namespace rayclock;

namespace {

const Material black{"black", {0, 0, 0}, 0, 0, 0, 1, 0, 0, 1};

/// Returns a material that emits the same light in all directions.
Material glowing(const glm::dvec3& colour) { return {"glow", colour, 1, 0, 0, 1, 0, 0, 1}; }

/// Returns a scene without light on a black background. Visible surfaces glow, or reflect a glow.
Scene dark() {
    Scene scene;
    scene.background = glm::dvec3(0);
    return scene;
}

std::uint32_t add(Scene& scene, const Material& material) {
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

void add_quad(Scene& scene, std::uint32_t material, const glm::dvec3& middle, const glm::dvec3& u,
              const glm::dvec3& v) {
    add_triangle(scene, middle - u - v, middle + u - v, middle + u + v);
    add_triangle(scene, middle + u + v, middle - u + v, middle - u - v);
    scene.triangles[scene.triangles.size() - 2].material = scene.triangles.back().material = material;
}

/// Renders a picture of one pixel: one ray from `eye` through `at`.
WhittedFrame one_ray(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& at,
                     const Whitted& settings = {}) {
    const glm::dvec3 gaze = at - eye;
    const glm::dvec3 up =
        std::abs(gaze.y) < 0.9 * glm::length(gaze) ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    return Reference(scene).whitted({eye, at, up, 1}, {1, 1}, settings);
}

void check_colour(const glm::dvec3& is, const glm::dvec3& wanted) {
    for (int k = 0; k < 3; ++k) CHECK(is[k] == Approx(wanted[k]).margin(1e-9));
}

}   // namespace

TEST_CASE("local light is Phong's, and shadows take it away", "[reference][whitted]") {
    Scene scene = dark();
    const std::uint32_t matt = add(scene, {"matt", {1, 0.5, 0.25}, 0.2, 0.5, 0.4, 3, 0, 0, 1});
    add_quad(scene, matt, {0, 0, 0}, {5, 0, 0}, {0, 5, 0});
    scene.lights = {{{3, 0, 4}, {1, 1, 0}}};   // cosine 0.8; mirrored, 0.8 to the eye
    const double highlight = 0.4 * 0.8 * 0.8 * 0.8;
    const WhittedFrame lit = one_ray(scene, {0, 0, 5}, {0, 0, 0});
    check_colour(lit.pixels[0], {0.2 + 0.4 + highlight, 0.1 + 0.2 + highlight, 0.05});
    CHECK(lit.rays == RayCounts{.primary = 1, .shadow = 1, .primary_hits = 1});
    CHECK(lit.hits.hits[0].depth == 5.0f);

    const std::uint32_t blocker = add(scene, black);
    scene.spheres = {{{1.5, 0, 2}, 0.1, blocker}};
    check_colour(one_ray(scene, {0, 0, 5}, {0, 0, 0}).pixels[0], {0.2, 0.1, 0.05});
    scene.spheres[0].centre = {4.5, 0, 6};   // beyond the light
    check_colour(one_ray(scene, {0, 0, 5}, {0, 0, 0}).pixels[0], lit.pixels[0]);
    scene.spheres[0].centre = {-1.5, 0, -2};   // behind the surface
    check_colour(one_ray(scene, {0, 0, 5}, {0, 0, 0}).pixels[0], lit.pixels[0]);
}

TEST_CASE("a light behind the seen side, or in the surface, sends no shadow ray", "[reference][whitted]") {
    Scene scene = dark();
    add_quad(scene, add(scene, {"matt", {1, 1, 1}, 0.1, 0.9, 0, 1, 0, 0, 1}), {0, 0, 0}, {5, 0, 0},
             {0, 5, 0});
    for (const double z : {-2.0, 0.0}) {
        scene.lights = {{{1, 1, z}, {1, 1, 1}}};
        const WhittedFrame frame = one_ray(scene, {0, 0, 5}, {0, 0, 0});
        CHECK(frame.rays.shadow == 0);
        check_colour(frame.pixels[0], glm::dvec3(0.1));
    }
    // Seen from the other side, the same light counts.
    scene.lights = {{{0, 0, -2}, {1, 1, 1}}};
    check_colour(one_ray(scene, {0, 0, -5}, {0, 0, 0}).pixels[0], glm::dvec3(1));
}

TEST_CASE("a light inside a sphere is dark, a camera inside sees out", "[reference][whitted]") {
    Scene scene = dark();
    const std::uint32_t shell = add(scene, black),
                        wall = add(scene, {"wall", {1, 1, 1}, 0.25, 0.5, 0, 1, 0, 0, 1});
    scene.spheres = {{{0, 0, 5}, 1, shell}};
    scene.planes = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, wall}};
    scene.lights = {{{0, 0, 5}, {1, 1, 1}}};
    check_colour(one_ray(scene, {3, 0, 9}, {3, 0, 0}).pixels[0], glm::dvec3(0.25));
    scene.lights[0].position = {0, 0, 9};
    check_colour(one_ray(scene, {0, 0, 5}, {4, 0, 0}).pixels[0],
                 glm::dvec3(0.25 + 0.5 * 9 / std::sqrt(16 + 81.0)));
}

TEST_CASE("a mirror sphere shows what lies in the mirrored direction", "[reference][whitted]") {
    // The ray meets the unit sphere at 45 degrees and leaves along x.
    Scene scene = dark();
    const double c = std::sqrt(0.5);
    scene.spheres = {{{0, 0, 0}, 1, add(scene, {"mirror", {0, 0, 0}, 0, 0, 0, 1, 0.75, 0, 1})},
                     {{9, 0, c}, 0.01, add(scene, glowing({0.2, 0.4, 0.8}))}};
    const WhittedFrame frame = one_ray(scene, {c, 0, 8}, {c, 0, 0});
    check_colour(frame.pixels[0], 0.75 * glm::dvec3(0.2, 0.4, 0.8));
    CHECK(frame.rays == RayCounts{.primary = 1, .reflection = 1, .primary_hits = 1});
    check_colour(one_ray(scene, {c, 0, 8}, {c, 0, 0}, {.depth = 0}).pixels[0], glm::dvec3(0));
    scene.background = {0, 0.5, 0};
    check_colour(one_ray(scene, {0.1, 0, 8}, {0.1, 0, 0}).pixels[0], {0, 0.375, 0});
}

TEST_CASE("index 1 lets everything pass straight on", "[reference][whitted]") {
    Scene scene = dark();
    scene.planes = {{{0, 0, -5},
                     {0.1, 0, 0},
                     {0, 0.1, 0},
                     add(scene, {"board", {0.9, 0.1, 0.1}, 1, 0, 0, 1, 0, 0, 1, true, {0.1, 0.1, 0.9}})}};
    const Camera camera{{0.3, 0.2, 6}, {0, 0, 0}, {0, 1, 0}, 40};
    const WhittedFrame bare = Reference(scene).whitted(camera, {64, 48}, {});
    scene.spheres = {{{0, 0, 0}, 1.5, add(scene, {"air", {0, 0, 0}, 0, 0, 0, 1, 0, 1, 1})}};
    const WhittedFrame through = Reference(scene).whitted(camera, {64, 48}, {});
    CHECK(through.rays.refraction > 1000);
    int others = 0;
    for (std::size_t i = 0; i < bare.pixels.size(); ++i)
        others += glm::length(bare.pixels[i] - through.pixels[i]) > 1e-9;
    CHECK(others == 0);
}

TEST_CASE("a slab moves a ray aside by Snell's law", "[reference][whitted]") {
    // The shift across the ray for a slab of thickness t: t sin(a) (1 - cos(a) / sqrt(n^2 - sin^2(a))).
    const double index = 1.5, thickness = 2, angle = 40 * std::numbers::pi / 180;
    const double across =
        thickness * std::sin(angle) *
        (1 - std::cos(angle) / std::sqrt(index * index - std::sin(angle) * std::sin(angle)));
    Scene scene = box({-50, -50, 0}, {50, 50, thickness});
    scene.background = glm::dvec3(0);
    scene.materials = {{"glass", {0, 0, 0}, 0, 0, 0, 1, 0, 1, index}};
    const glm::dvec3 d(std::sin(angle), 0, -std::cos(angle)), side(std::cos(angle), 0, std::sin(angle)),
        eye = glm::dvec3(0, 0, thickness) - 5.0 * d;
    // The slab is denser, so the ray bends towards the normal inside and leaves behind the straight line.
    const glm::dvec3 target = eye - across * side + 20.0 * d;
    scene.spheres = {{target, 1e-5, add(scene, glowing({1, 1, 1}))}};
    check_colour(one_ray(scene, eye, eye + d).pixels[0], glm::dvec3(1));
    scene.spheres[0].centre += 2e-5 * side;
    check_colour(one_ray(scene, eye, eye + d).pixels[0], glm::dvec3(0));
}

TEST_CASE("beyond the critical angle all is reflected, and nothing passes", "[reference][whitted]") {
    // From inside glass (index 1.5) towards a plane boundary: the sine of the critical angle is 2/3.
    Scene scene = dark();
    const std::uint32_t glass = add(scene, {"glass", {0, 0, 0}, 0, 0, 0, 1, 0.1, 0.8, 1.5});
    scene.planes = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glass}};   // outside is z > 0
    scene.planes.push_back({{0, 0, 50}, {1, 0, 0}, {0, 1, 0}, add(scene, glowing({0, 1, 0}))});
    scene.planes.push_back({{0, 0, -50}, {1, 0, 0}, {0, 1, 0}, add(scene, glowing({1, 0, 0}))});
    const auto at_sine = [&](double sine) {
        return one_ray(scene, {0, 0, -3}, {3 * sine / std::sqrt(1 - sine * sine), 0, 0});
    };
    const WhittedFrame below = at_sine(2.0 / 3 - 1e-6), above = at_sine(2.0 / 3 + 1e-6);
    check_colour(below.pixels[0], {0.1, 0.8, 0});
    check_colour(above.pixels[0], {0.9, 0, 0});
    for (const WhittedFrame* frame : {&below, &above})
        CHECK(frame->rays == RayCounts{.primary = 1, .reflection = 1, .refraction = 1, .primary_hits = 1});
    // From outside there is no critical angle.
    const double sine = 0.999;
    check_colour(one_ray(scene, {0, 0, 3}, {3 * sine / std::sqrt(1 - sine * sine), 0, 0}).pixels[0],
                 {0.8, 0.1, 0});
}

TEST_CASE("Schlick's term is R0 straight ahead and grows to 1", "[reference][whitted]") {
    Scene scene = dark();
    const double index = GENERATE(1.0, 1.5, 2.4), r0 = std::pow((index - 1) / (index + 1), 2);
    const std::uint32_t glass = add(scene, {"glass", {0, 0, 0}, 0, 0, 0, 1, 0, 1, index, false, {}, true});
    scene.planes = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glass},
                    {{0, 0, 50}, {1, 0, 0}, {0, 1, 0}, add(scene, glowing({0, 1, 0}))},
                    {{0, 0, -50}, {1, 0, 0}, {0, 1, 0}, add(scene, glowing({1, 0, 0}))}};
    check_colour(one_ray(scene, {0, 0, 3}, {0, 0, 0}).pixels[0], {1 - r0, r0, 0});
    const double slant = r0 + (1 - r0) * std::pow(0.5, 5);   // 60 degrees
    check_colour(one_ray(scene, {0, 0, 3}, {3 * std::sqrt(3.0), 0, 0}).pixels[0], {1 - slant, slant, 0});
    // At any angle no energy is lost.
    scene.materials[glass].mirror = 0;
    const glm::dvec3 flat = one_ray(scene, {0, 0, 3}, {300, 0, 0}).pixels[0];
    CHECK(flat.r + flat.g == Approx(1));
    CHECK(flat.g > 0.9);
}

TEST_CASE("two mirrors count down the depth", "[reference][whitted]") {
    Scene scene = dark();
    const std::uint32_t mirror = add(scene, {"mirror", {1, 1, 1}, 0.1, 0, 0, 1, 0.5, 0, 1});
    scene.planes = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, mirror}, {{0, 0, 9}, {1, 0, 0}, {0, 1, 0}, mirror}};
    for (int depth = 0; depth <= max_depth; ++depth) {
        CAPTURE(depth);
        const WhittedFrame frame = one_ray(scene, {0, 0, 5}, {0.5, 0, 0}, {.depth = depth});
        check_colour(frame.pixels[0], glm::dvec3(0.2 * (1 - std::pow(0.5, depth + 1))));
        CHECK(frame.rays ==
              RayCounts{.primary = 1, .reflection = static_cast<std::uint64_t>(depth), .primary_hits = 1});
    }
    // Weights 1/2, 1/4, 1/8, ...: a ray exactly at the threshold is still sent.
    for (const auto& [threshold, rays] :
         {std::pair(0.5, 1u), {0.500001, 0u}, {0.2, 2u}, {0.125, 3u}, {0.0, 15u}})
        CHECK(one_ray(scene, {0, 0, 5}, {0.5, 0, 0}, {.depth = 15, .threshold = threshold}).rays.reflection ==
              rays);
}

TEST_CASE("a transmitting surface reflects also without a mirror, and its rays count",
          "[reference][whitted]") {
    Scene scene = dark();
    scene.planes = {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, add(scene, {"clear", {0, 0, 0}, 0, 0, 0, 1, 0, 0.8, 1.1})}};
    const WhittedFrame frame = one_ray(scene, {0, 0, 5}, {1, 0, 0});
    CHECK(frame.rays == RayCounts{.primary = 1, .reflection = 1, .refraction = 1, .primary_hits = 1});
    CHECK(one_ray(scene, {0, 0, 5}, {1, 0, 0}, {.threshold = 0.01}).rays.reflection == 0);
}

TEST_CASE("smooth normals send no ray through the surface", "[reference][whitted]") {
    Scene scene = dark();
    add_quad(scene, add(scene, {"mirror", {0, 0, 0}, 0, 0, 0, 1, 1, 0, 1}), {0, 0, 0}, {5, 0, 0}, {0, 5, 0});
    scene.background = glm::dvec3(0.5);
    scene.normals.assign(scene.vertices.size(), glm::normalize(glm::dvec3(1, 0, 1)));
    // From above, mirrored about 45 degrees: slightly above the surface, or slightly below it.
    CHECK(one_ray(scene, {0.01, 0, 5}, {0, 0, 0}).rays.reflection == 1);
    CHECK(one_ray(scene, {-0.01, 0, 5}, {0, 0, 0}).rays.reflection == 0);
}

TEST_CASE("a sample is clipped at white before the mean is taken", "[reference][whitted]") {
    Scene scene = dark();
    add_quad(scene, add(scene, {"white", {1, 1, 1}, 1, 1, 0, 1, 0, 0, 1}), {-5, 0, 0}, {5, 0, 0}, {0, 5, 0});
    scene.lights = {{{0, 0, 1000}, {1, 1, 1}}};
    // The edge x = 0 halves the pixel. The surface would be twice as bright as white.
    const WhittedFrame frame = one_ray(scene, {0, 0, 5}, {0, 0, 0}, {.aa = 4});
    check_colour(frame.pixels[0], glm::dvec3(0.5));
    CHECK(frame.rays.primary == 16);
    CHECK(frame.rays.primary_hits == 8);
}

TEST_CASE("contrast spends the other samples where the first four differ", "[reference][whitted]") {
    Scene scene = make_builtin("square");
    const FrameSize size{64, 64};
    const Reference reference(scene);
    const WhittedFrame all = reference.whitted(*scene.camera, size, {.aa = 4}),
                       some = reference.whitted(*scene.camera, size, {.aa = 4, .contrast = 0.1});
    CHECK(all.rays.primary == 64 * 64 * 16);
    std::uint64_t edges = 0;
    for (const glm::dvec3& p : all.pixels) edges += p.r > 0 && p.r < 1;
    const std::uint64_t refined = (some.rays.primary - 64 * 64 * 4) / 12;
    CHECK(some.rays.primary == 64 * 64 * 4 + 12 * refined);
    CHECK(refined > edges / 2);
    CHECK(refined <= edges);
    std::uint64_t others = 0;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) others += all.pixels[i] != some.pixels[i];
    CHECK(others <= edges - refined);
    CHECK(reference.whitted(*scene.camera, size, {.aa = 2, .contrast = 0.1}).rays.primary == 64 * 64 * 4);
    CHECK(reference.whitted(*scene.camera, size, {.aa = 1, .contrast = 0.1}).rays.primary == 64 * 64);
}

TEST_CASE("the first sample's hits are those of frame()", "[reference][whitted]") {
    const Scene scene = make_builtin("mount:3", Primitives::native);
    const Reference reference(scene);
    CHECK(reference.whitted(*scene.camera, {60, 45}, {}).hits.hits ==
          reference.frame(*scene.camera, {60, 45}).hits);
}

TEST_CASE("pictures and counts do not depend on the number of threads", "[reference][whitted]") {
    const Scene scene = make_builtin("spheres");
    const Reference reference(scene);
    const Whitted settings{.depth = 6, .aa = 3, .jitter = true, .contrast = 0.05, .seed = 7};
    const WhittedFrame one = reference.whitted(*scene.camera, {101, 70}, settings, 1);
    for (const int threads : {2, 5, 0}) {
        const WhittedFrame many = reference.whitted(*scene.camera, {101, 70}, settings, threads);
        CHECK(many.rays == one.rays);
        CHECK(many.pixels == one.pixels);
        CHECK(many.hits.hits == one.hits.hits);
    }
    Whitted other = settings;
    other.seed = 8;
    CHECK(reference.whitted(*scene.camera, {101, 70}, other).pixels != one.pixels);
}

TEST_CASE("a higher threshold or a smaller depth never sends more rays", "[reference][whitted]") {
    const Scene scene = make_builtin(GENERATE("spheres", "gears:2", "mirrors"), Primitives::native);
    const Reference reference(scene);
    const auto rays = [&](const Whitted& settings) {
        return reference.whitted(*scene.camera, {64, 48}, settings).rays;
    };
    RayCounts last = rays({.depth = 8});
    for (const double threshold : {0.001, 0.01, 0.05, 0.2, 0.5, 1.0}) {
        CAPTURE(threshold);
        const RayCounts now = rays({.depth = 8, .threshold = threshold});
        CHECK(now.reflection <= last.reflection);
        CHECK(now.refraction <= last.refraction);
        CHECK(now.shadow <= last.shadow);
        last = now;
    }
    CHECK(last.all() < rays({.depth = 8}).all() / 2 + last.primary + last.shadow);
    last = rays({.depth = 8});
    for (int depth = 7; depth >= 0; --depth) {
        const RayCounts now = rays({.depth = depth});
        CHECK(now.all() <= last.all());
        last = now;
    }
    CHECK(last.reflection + last.refraction == 0);
}

TEST_CASE("pictures of all built-in scenes are finite and within 0 and 1", "[reference][whitted]") {
    for (const Builtin& b : builtins())
        for (const Primitives form : {Primitives::triangles, Primitives::native}) {
            CAPTURE(b.name);
            const Scene scene = b.make(1, form);
            const WhittedFrame frame = Reference(scene).whitted(*scene.camera, {48, 36}, {});
            int bad = 0;
            glm::dvec3 darkest(1), brightest(0);
            for (const glm::dvec3& p : frame.pixels) {
                for (int k = 0; k < 3; ++k) bad += !(p[k] >= 0 && p[k] <= 1);
                darkest = glm::min(darkest, p);
                brightest = glm::max(brightest, p);
            }
            CHECK(bad == 0);
            CHECK(glm::length(brightest - darkest) > 0.3);
        }
}
