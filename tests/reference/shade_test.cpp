// shade(): each term against a value computed by hand, with sides, smooth normals and their edge cases.
#include <catch2/catch.hpp>

#include "model/scene/hit_shading.hpp"
#include "tests/reference/meshes.hpp"

using namespace rayclock;

namespace {

/// One triangle in the plane z = 0 around the origin, seen from z = 5. The only pixel hits its point (0, 0,
/// 0).
struct Bench {
    Scene scene = empty_scene();
    HitFrame frame{{1, 1}, {{0, 5.0f, 0.25f, 0.5f}}};

    Bench() {
        add_triangle(scene, {-2, -3, 0}, {2, -1, 0}, {0, 2, 0});
        scene.camera = Camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 45};
        scene.materials[0] = Material{"", {1, 0.5, 0.25}, 0.2, 0.5, 0, 1, 0, 0, 1};
    }
    glm::vec3 colour() const { return shade(scene, frame).pixels.at(0); }
};

void check_colour(const glm::vec3& is, const glm::dvec3& wanted) {
    CHECK(is.r == Approx(wanted.r).margin(1e-7));
    CHECK(is.g == Approx(wanted.g).margin(1e-7));
    CHECK(is.b == Approx(wanted.b).margin(1e-7));
}

}   // namespace

TEST_CASE("without lights only the ambient term is left", "[shade]") {
    check_colour(Bench().colour(), {0.2, 0.1, 0.05});
}

TEST_CASE("lambert's cosine weighs each light, without distance", "[shade]") {
    Bench bench;
    bench.scene.lights = {{{0, 0, 7}, {1, 1, 1}}, {{30, 0, 30}, {1, 0, 0.5}}};
    const double c = std::sqrt(0.5);
    check_colour(bench.colour(), {0.2 + 0.5 + 0.5 * c, 0.1 + 0.25, 0.05 + 0.125 + 0.0625 * c});
}

TEST_CASE("the highlight is the mirrored light's cosine to the power of shine, in the light's colour",
          "[shade]") {
    Bench bench;
    bench.scene.materials[0].highlight = 0.4;
    bench.scene.materials[0].shine = 3;
    bench.scene.lights = {{{3, 0, 4}, {1, 1, 0}}};   // cosine 0.8 to the normal, which points to the eye
    const double highlight = 0.4 * 0.8 * 0.8 * 0.8;
    check_colour(bench.colour(), {0.2 + 0.4 + highlight, 0.1 + 0.2 + highlight, 0.05});
}

TEST_CASE("both sides are shaded alike, and light from beyond the surface does not count", "[shade]") {
    Bench bench;
    bench.scene.lights = {{{0, 0, 9}, {1, 1, 1}}};
    const glm::vec3 front = bench.colour();
    std::swap(bench.scene.triangles[0].vertex[1], bench.scene.triangles[0].vertex[2]);
    std::swap(bench.frame.hits[0].u, bench.frame.hits[0].v);
    check_colour(front, bench.colour());
    bench.scene.lights[0].position.z = -9;
    check_colour(bench.colour(), {0.2, 0.1, 0.05});
}

TEST_CASE("colours are not clamped", "[shade]") {
    Bench bench;
    bench.scene.lights.assign(10, {{0, 0, 9}, {1, 1, 1}});
    CHECK(bench.colour().r == Approx(5.2));
}

TEST_CASE("misses show the background", "[shade]") {
    Bench bench;
    bench.frame.hits[0] = {};
    check_colour(bench.colour(), bench.scene.background);
}

TEST_CASE("vertex normals are interpolated by the weights and turned to the visible side", "[shade]") {
    Bench bench;
    bench.scene.lights = {{{0, 0, 9}, {1, 1, 1}}};
    // Weights 1/4, 1/4, 1/2: the sum is (0, 0.5, 0.5), at 45 degrees to the light.
    bench.scene.normals = {{1, 0, 0}, {-1, 0, 0}, glm::normalize(glm::dvec3(0, 1, 1))};
    const double c = std::sqrt(0.5);
    check_colour(bench.colour(), {0.2 + 0.5 * c, 0.1 + 0.25 * c, 0.05 + 0.125 * c});
    for (glm::dvec3& n : bench.scene.normals) n = -n;
    check_colour(bench.colour(), {0.2 + 0.5 * c, 0.1 + 0.25 * c, 0.05 + 0.125 * c});
}

TEST_CASE("vertex normals that cancel fall back to the triangle's normal", "[shade]") {
    Bench bench;
    bench.scene.lights = {{{0, 0, 9}, {1, 1, 1}}};
    bench.scene.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}};
    check_colour(bench.colour(), {0.7, 0.35, 0.175});
}

TEST_CASE("a light in the surface, or the eye in it, gives finite colours", "[shade]") {
    Bench bench;
    bench.scene.materials[0].highlight = 1;
    bench.scene.lights = {{{0, 0, 0}, {1, 1, 1}}};
    CHECK(std::isfinite(bench.colour().r));
    bench.scene.camera->eye = {0, 0, 0};
    CHECK(std::isfinite(bench.colour().r));
    bench.scene.triangles[0].vertex = {0, 0, 0};   // no normal
    CHECK(std::isfinite(bench.colour().r));
}

TEST_CASE("shading without a camera or with an unknown primitive is refused", "[shade]") {
    Bench bench;
    bench.frame.hits[0].primitive = 1;
    CHECK_THROWS(bench.colour());
    bench.frame.hits[0].primitive = 0;
    bench.scene.camera.reset();
    CHECK_THROWS(bench.colour());
}

TEST_CASE("a sphere is shaded by its depth, a plane by its square", "[shade]") {
    Bench bench;
    bench.scene.lights = {{{3, 0, 4}, {1, 1, 1}}};
    bench.scene.triangles.clear();
    bench.scene.vertices.clear();
    bench.scene.spheres = {{{0, 0, -2}, 2, 0}};
    bench.frame.hits[0] = {0, 5, 0, 0};   // the point (0, 0, 0), whose normal is (0, 0, 1)
    check_colour(bench.colour(), {0.2 + 0.5 * 0.8, 0.1 + 0.25 * 0.8, 0.05 + 0.125 * 0.8});
    bench.scene.spheres[0].centre.z = 2;   // seen from inside: the normal is reversed
    check_colour(bench.colour(), {0.2 + 0.5 * 0.8, 0.1 + 0.25 * 0.8, 0.05 + 0.125 * 0.8});

    bench.scene.planes = {{{-1, -2, 0}, {2, 0, 0}, {0, -1, 0}, 0}};
    bench.scene.materials[0].other = {0.5, 0.5, 1};
    bench.frame.hits[0] = {
        1,
        5,
        0.5f,
        -2,
    };   // (0, 0, 0) again
    const glm::dvec3 plain(0.2 + 0.5 * 0.8, 0.1 + 0.25 * 0.8, 0.05 + 0.125 * 0.8);
    check_colour(bench.colour(), plain);
    bench.scene.materials[0].checkered = true;
    check_colour(bench.colour(), plain);   // square (0, -2)
    bench.frame.hits[0].v = -2.001f;       // square (0, -3)
    const glm::vec3 other = bench.colour();
    CHECK(other.r == Approx(0.3).margin(1e-3));
    CHECK(other.b == Approx(0.6).margin(1e-3));
    bench.frame.hits[0].primitive = 2;
    CHECK_THROWS(bench.colour());
}

TEST_CASE("a picture with spheres takes the rays of its own pixels", "[shade]") {
    Scene scene = empty_scene();
    scene.camera = Camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 45};
    scene.spheres = {{{0, 0, 0}, 1, 0}};
    scene.lights = {{{0, 0, 1000}, {1, 1, 1}}};
    scene.materials[0] = Material{"", {1, 1, 1}, 0, 1, 0, 1, 0, 0, 1};
    const FrameSize size{31, 21};
    const PixelRays rays = pixel_rays(*scene.camera, size);
    HitFrame frame{size, std::vector<Hit>(31 * 21)};
    const glm::dvec3 d = glm::normalize(rays.direction(12, 8));
    const double b = -glm::dot(rays.eye, d),
                 depth = b - std::sqrt(1 - glm::dot(rays.eye + b * d, rays.eye + b * d));
    frame.hits[8 * 31 + 12] = {0, static_cast<float>(depth), 0, 0};
    // The light comes along z from far away, so the colour is the normal's z.
    CHECK(shade(scene, frame).pixels[8 * 31 + 12].r == Approx((rays.eye + depth * d).z).epsilon(1e-3));
}
