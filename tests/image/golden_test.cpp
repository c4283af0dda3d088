// The golden pictures in tests/golden: the reference tracer still makes them. So does Embree, which shares
// only the scene, the camera and the shading with it. These tests write nothing.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "sim/files/image/golden.hpp"
#include "tests/support/scenes/golden_scenes.hpp"
#include "tests/support/scenes/embree_scene.hpp"

using namespace rayclock;

namespace {

const std::string folder = "tests/golden";

HitFrame embree_frame(const Scene& scene, FrameSize size) {
    const EmbreeScene embree(scene, RTC_SCENE_FLAG_ROBUST);
    const PixelRays rays = pixel_rays(*scene.camera, size);
    HitFrame frame{size, {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            frame.hits.push_back(embree.trace(rays.eye, glm::normalize(rays.direction(x, y))));
    return frame;
}

}   // namespace

TEST_CASE("the reference tracer makes the golden pictures", "[image][golden]") {
    const auto spec = GENERATE(from_range(golden_scenes));
    CAPTURE(spec);
    const Scene scene = golden_scene(spec);
    const GoldenResult result =
        check_golden(folder, spec, shade(scene, Reference(scene).frame(*scene.camera, golden_size)));
    REQUIRE(result.found);
    CHECK(result.within);
    // The arithmetic is the same on any host. Only the mathematical library's last digits may change a byte
    // by one.
    CHECK(result.psnr_db > 70);
    CHECK(result.pixels_beyond == 0);
}

TEST_CASE("Embree's hits, shaded alike, give the golden pictures", "[image][golden]") {
    const auto spec = GENERATE(from_range(golden_scenes));
    CAPTURE(spec);
    const Scene scene = golden_scene(spec);
    const GoldenResult result = check_golden(folder, spec, shade(scene, embree_frame(scene, golden_size)));
    REQUIRE(result.found);
    CHECK(result.within);
    // One pixel in ten thousand may fall to the other side of an edge in single precision.
    CHECK(result.pixels_beyond <= 1);
}

// For tests/setup/release: the demo's pictures are in out/, those of `verify gears:4 --size 128x96` in
// out/golden/.
TEST_CASE("the files of the demo and of a golden scene show what they should", "[.left]") {
    const Picture demo = read_picture("docs/images/gears8.png");   // made on Debian 12
    for (const std::string name : {"reference.png", "model.png", "rtl.png"}) {
        CAPTURE(name);
        CHECK(compare(read_picture("out/" + name), demo).psnr_db > 30);
        const GoldenResult result = check_golden(folder, "gears:4", read_picture("out/golden/" + name));
        REQUIRE(result.found);
        CHECK(result.within);
    }
}

TEST_CASE("golden pictures show something, neither black nor burnt out", "[image][golden]") {
    const auto spec = GENERATE(from_range(golden_scenes));
    CAPTURE(spec);
    const Picture picture = read_picture(golden_path(folder, spec, golden_size));
    int lit = 0, burnt = 0, other = 0;
    for (const glm::vec3& p : picture.pixels) {
        lit += std::max({p.r, p.g, p.b}) > 0.02f;
        burnt += std::max({p.r, p.g, p.b}) >= 0.999f;
        other += glm::length(p - picture.pixels[0]) > 0.02f;
    }
    const int pixels = golden_size.width * golden_size.height;
    CHECK(lit > pixels / 2);
    CHECK(burnt < pixels / 20);
    CHECK(other > pixels / 10);
}
