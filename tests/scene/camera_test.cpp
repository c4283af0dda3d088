// The map from pixels to rays, and cameras fitted to scenes without one.
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"
#include "model/scene/camera.hpp"
#include "tests/scene/mesh_measures.hpp"

using namespace rayclock;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(),
                 not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = std::numbers::pi / 180;

double angle(const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(glm::dot(glm::normalize(a), glm::normalize(b)));
}

Scene one_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    Scene scene;
    scene.name = "test";
    scene.vertices = {a, b, c};
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.materials.emplace_back();
    return scene;
}

/// Returns pixel coordinates of a point, by Cramer's rule on corner + x right + y down = s (p - eye). Written
/// independently of the code that makes rays. NaN if the point is not in front of the camera.
glm::dvec2 project(const PixelRays& rays, const glm::dvec3& p) {
    const double size =
        std::max({std::abs(p.x - rays.eye.x), std::abs(p.y - rays.eye.y), std::abs(p.z - rays.eye.z)});
    const glm::dvec3 to = (p - rays.eye) / size, normal = glm::cross(rays.right, rays.down);
    const double along = glm::dot(to, normal), plane = glm::dot(rays.corner, normal);
    if (!(along / plane > 0)) return glm::dvec2(not_a_number);
    const glm::dvec3 in_plane = to * (plane / along) - rays.corner;
    return {glm::dot(in_plane, rays.right) / glm::dot(rays.right, rays.right),
            glm::dot(in_plane, rays.down) / glm::dot(rays.down, rays.down)};
}

/// Returns the largest distance of a used vertex from the picture's centre, 1 at the edges. NaN if one is
/// behind the eye.
double reach(const Scene& scene, const Camera& camera, FrameSize size) {
    const PixelRays rays = pixel_rays(camera, size);
    double farthest = 0;
    for (const Triangle& t : scene.triangles)
        for (const std::uint32_t v : t.vertex) {
            const glm::dvec2 p = project(rays, scene.vertices[v]);
            const double x = std::abs((p.x + 0.5) / size.width * 2 - 1),
                         y = std::abs((p.y + 0.5) / size.height * 2 - 1);
            if (!(std::max(x, y) <= farthest)) farthest = std::max(x, y);
            if (std::isnan(x) || std::isnan(y)) return not_a_number;
        }
    return farthest;
}

}   // namespace

TEST_CASE("the pixel nearest to the middle looks along the view axis", "[scene][camera]") {
    const Camera camera{{1, 2, 3}, {4, -5, 6}, {0.2, 1, 0.1}, 50};
    const PixelRays rays = pixel_rays(camera, {7, 5});
    CHECK(rays.eye == camera.eye);
    const glm::dvec3 forward = glm::normalize(camera.at - camera.eye);
    CHECK(glm::length(rays.direction(3, 2) - forward) < 1e-15);
    for (const double x : {0.0, 6.0})
        for (const double y : {0.0, 4.0})
            CHECK(glm::dot(rays.direction(x, y), forward) == Approx(1).epsilon(1e-14));
}

TEST_CASE("pixel centres follow the formula, row 0 on top", "[scene][camera]") {
    // Looking along -z with y up: pixel (x, y) of a W x H picture has the direction ((2x+1)/W - 1) aspect h,
    // (1 - (2y+1)/H) h, -1.
    const PixelRays rays = pixel_rays({{0, 0, 5}, {0, 0, 0}, {0, 3, 1}, 60}, {8, 4});
    const double h = std::tan(30 * degree);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            const glm::dvec3 expected(((2 * x + 1) / 8.0 - 1) * 2 * h, (1 - (2 * y + 1) / 4.0) * h, -1);
            CHECK(glm::length(rays.direction(x, y) - expected) < 1e-15 * 8);
        }
    CHECK(rays.direction(0, 0).y > 0);
    CHECK(rays.direction(0, 0).x < 0);
}

TEST_CASE("the edges of the picture span the camera's angle", "[scene][camera]") {
    const double fov = GENERATE(0.5, 45.0, 90.0, 179.0);
    const auto size = GENERATE(FrameSize{512, 384}, FrameSize{1, 1}, FrameSize{3, 16384});
    CAPTURE(fov, size.width, size.height);
    const PixelRays rays = pixel_rays({{2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1}, fov}, size);
    const double middle = (size.width - 1) / 2.0;
    const double vertical = angle(rays.direction(middle, -0.5), rays.direction(middle, size.height - 0.5));
    CHECK(vertical == Approx(fov * degree).epsilon(1e-6));
    CHECK(glm::length(rays.right) == Approx(glm::length(rays.down)).epsilon(1e-14));
    CHECK(std::abs(glm::dot(glm::normalize(rays.right), glm::normalize(rays.down))) < 1e-15);
    // Corner pixels: the centre is half a pixel inside both edges.
    const double h = std::tan(fov * degree / 2), v = h * (1 - 1.0 / size.height),
                 u = h * (size.width - 1.0) / size.height;
    CHECK(angle(rays.direction(0, 0), rays.direction(size.width - 1, size.height - 1)) ==
          Approx(2 * std::atan(std::hypot(u, v))).epsilon(1e-6).margin(1e-7));
}

TEST_CASE("sizes that a double can hold do not overflow on the way", "[scene][camera]") {
    const PixelRays huge = pixel_rays({{0, 0, 1e300}, {0, 0, -1e300}, {0, 1e-300, 0}, 45}, {2, 2});
    CHECK(glm::length(huge.direction(0.5, 0.5) - glm::dvec3(0, 0, -1)) < 1e-15);
    const PixelRays tiny = pixel_rays({{0, 0, 1e-310}, {0, 0, 0}, {0, 1e300, 0}, 45}, {2, 2});
    CHECK(glm::length(tiny.direction(0.5, 0.5) - glm::dvec3(0, 0, -1)) < 1e-15);
}

TEST_CASE("cameras that look nowhere are refused", "[scene][camera]") {
    const Camera good{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 45};
    const auto sentence = [](const Camera& camera) { return refusal([&] { pixel_rays(camera, {4, 4}); }); };
    const auto with = [&](auto change) {
        Camera camera = good;
        change(camera);
        return sentence(camera);
    };
    CHECK(sentence(good).empty());
    CHECK(with([](Camera& c) { c.at = c.eye; }) ==
          "camera: the camera's eye and the point it looks at are the same, (0, 0, 5)");
    CHECK(with([](Camera& c) {
              c.up = {0, 0, -2};
          }) == "camera: the camera's up (0, 0, -2) points along its line of sight");
    CHECK(with([](Camera& c) { c.up = {0, 0, 0}; }) == "camera: the camera's up (0, 0, 0) has no direction");
    CHECK(with([](Camera& c) { c.fov_degrees = 0; }) ==
          "camera: the camera's angle must lie between 0 and 180 degrees, not 0");
    CHECK(with([](Camera& c) { c.fov_degrees = 180; }) ==
          "camera: the camera's angle must lie between 0 and 180 degrees, not 180");
    CHECK(with([](Camera& c) { c.fov_degrees = -7.5; }) ==
          "camera: the camera's angle must lie between 0 and 180 degrees, not -7.5");
    CHECK(with([](Camera& c) { c.fov_degrees = not_a_number; }) ==
          "camera: the camera's angle must lie between 0 and 180 degrees, not nan");
    CHECK(with([](Camera& c) { c.eye.x = not_a_number; }) ==
          "camera: the camera's eye (nan, 0, 5) is not a finite point");
    CHECK(with([](Camera& c) { c.at.y = infinite; }) ==
          "camera: the camera looks at (0, inf, 0), which is not a finite point");
    CHECK(with([](Camera& c) { c.up.z = not_a_number; }) ==
          "camera: the camera's up (0, 1, nan) is not a finite direction");
    CHECK(with([](Camera& c) { c.eye.x = 1e308, c.at.x = -1e308; }) ==
          "camera: the camera's eye (1e+308, 0, 5) is too far from (-1e+308, 0, 0)");
}

TEST_CASE("picture sizes are 1 to 16384", "[scene][camera]") {
    for (const FrameSize good : {FrameSize{1, 1}, {16384, 16384}, {1, 16384}})
        CHECK_NOTHROW(check_frame_size(good));
    for (const FrameSize bad :
         {FrameSize{0, 1}, {1, 0}, {16385, 1}, {1, 16385}, {-5, 5}, {5, std::numeric_limits<int>::min()}}) {
        const std::string expected = "a picture must be 1 to 16384 pixels wide and high, not " +
                                     std::to_string(bad.width) + " x " + std::to_string(bad.height);
        CHECK(refusal([&] { check_frame_size(bad); }) == expected);
        CHECK(refusal([&] { pixel_rays({}, bad); }) == expected);
    }
}

TEST_CASE("a fitted camera sees the whole scene and little more", "[scene][camera]") {
    const auto size =
        GENERATE(FrameSize{400, 400}, FrameSize{1600, 100}, FrameSize{100, 1600}, FrameSize{512, 384});
    const auto spec =
        GENERATE(as<std::string>{}, "icosphere:2", "teapot:3", "tree:2", "mount:3", "rings:1", "cornell");
    CAPTURE(spec, size.width, size.height);
    const Scene scene = make_builtin(spec);
    const Camera camera = fit_camera(scene, static_cast<double>(size.width) / size.height);
    const Bounds box = bounds(scene);
    CHECK(camera.fov_degrees == 45);
    CHECK(glm::length(camera.at - (box.lo + box.hi) * 0.5) < 1e-12 * glm::length(box.hi - box.lo));
    const glm::dvec3 from = camera.eye - camera.at;
    CHECK((from.x > 0 && from.y > 0 && from.z > 0));
    const double r = reach(scene, camera, size);
    CHECK(r < 0.96);
    // At least one vertex comes as close to the edge as the margin allows, unless another would come too
    // close to the eye.
    CHECK(r > (size.width > 10 * size.height ? 0.9 : 0.95));
}

TEST_CASE("a fitted camera sees flat, thin, tiny, huge and point-like meshes", "[scene][camera]") {
    const glm::dvec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1),
        towards = glm::normalize(glm::dvec3(0.6, 0.5, 1));
    const auto scale = GENERATE(1.0, 1e-100, 1e-300, 1e100, 1e300);
    const auto scene = GENERATE_COPY(values<Scene>(
        {one_triangle(o, x, y), one_triangle(o, y, z), one_triangle(o, z, x), one_triangle(x, y, z),
         // Lines; one of them is seen end on.
         one_triangle(o, x, 2.0 * x), one_triangle(o, y, y), one_triangle(-towards, o, towards),
         one_triangle(o, o, o), one_triangle(x, x, x), one_triangle(-0.25 * z, -0.25 * z, -0.25 * z),
         one_triangle(x, x + 1e-15 * y, x + 1e-15 * z),
         one_triangle(1e3 * x, 1e3 * x + 1e-3 * y, 1e3 * x + 1e-3 * z),
         one_triangle(x, x * (1 + 1e-16), x)}));
    Scene scaled = scene;
    for (glm::dvec3& v : scaled.vertices) v *= scale;
    CAPTURE(scale, scene.vertices[0].x, scene.vertices[1].x, scene.vertices[1].y, scene.vertices[1].z);
    for (const FrameSize size : {FrameSize{64, 64}, FrameSize{640, 10}, FrameSize{10, 640}}) {
        const Camera camera = fit_camera(scaled, static_cast<double>(size.width) / size.height);
        CHECK(reach(scaled, camera, size) < 0.96);
    }
}

TEST_CASE("vertices that no triangle uses do not move the fitted camera", "[scene][camera]") {
    Scene scene = one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Camera before = fit_camera(scene, 1);
    scene.vertices.emplace_back(1000, 0, 0);
    CHECK(fit_camera(scene, 1).eye == before.eye);
    CHECK(bounds(scene).hi == glm::dvec3(1, 1, 0));
}

TEST_CASE("scenes and aspects that no camera can fit are refused", "[scene][camera]") {
    const Scene huge = one_triangle({-8e307, 0, 0}, {8e307, 0, 0}, {0, 8e307, 0});
    CHECK_NOTHROW(check_scene(huge, "huge"));
    CHECK(refusal([&] { fit_camera(huge, 1); }) ==
          "test: the scene reaches from (-8e+307, 0, 0) to (8e+307, 8e+307, 0), too large to be seen whole");
    const Scene scene = one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    CHECK(refusal([&] { fit_camera(scene, 0); }) == "a picture cannot have the aspect 0");
    CHECK(refusal([&] { fit_camera(scene, -1.5); }) == "a picture cannot have the aspect -1.5");
    CHECK(refusal([&] { fit_camera(scene, not_a_number); }) == "a picture cannot have the aspect nan");
    CHECK(refusal([&] { fit_camera(scene, infinite); }) == "a picture cannot have the aspect inf");
}

TEST_CASE("the camera of every built-in scene has the scene in its picture", "[scene][camera]") {
    for (const Builtin& b : builtins()) {
        CAPTURE(b.name);
        const Scene scene = b.make(1);
        const PixelRays rays = pixel_rays(*scene.camera, {100, 100});
        const Bounds box = bounds(scene);
        const glm::dvec3& eye = scene.camera->eye;
        const bool in_a_room = b.name == "mirrors";
        if (in_a_room) {   // the walls are all around the camera
            for (int k = 0; k < 3; ++k) CHECK((box.lo[k] < eye[k] && eye[k] < box.hi[k]));
            continue;
        }
        std::size_t inside = 0;
        for (const glm::dvec3& v : scene.vertices) {
            const glm::dvec2 p = project(rays, v);
            inside += p.x > 0 && p.x < 99 && p.y > 0 && p.y < 99;
        }
        for (const Sphere& s : scene.spheres) {
            const glm::dvec2 p = project(rays, s.centre);
            inside += p.x > 0 && p.x < 99 && p.y > 0 && p.y < 99;
        }
        const std::size_t parts = scene.vertices.size() + scene.spheres.size();
        // Its published camera sees one corner of the grid.
        const std::size_t least = b.name == "wknd" ? 5 : 3;
        if (parts > 0)
            CHECK(least * inside > parts);
        else
            CHECK(rays.direction(50, 99).y < -0.1);   // a plane: down to the ground
    }
}
