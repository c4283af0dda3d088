// Camera registers: the directions of pixels and samples that make_frame() gives, and refused cameras.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/layout/memory_image.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "tests/support/scenes/hard_meshes.hpp"

using namespace rayclock;

namespace {

Config with_dir_bits(int bits) {
    Config config;
    config.dir_bits = bits;
    return config;
}

/// A pixel's direction: its largest component and that of the sum from which it was made, and the power of
/// two between them. `error` is its deviation from the double direction times the scale and that power.
struct Seen {
    std::int64_t largest = 0, sum = 0;
    double power = 1, error = 0;
};
Seen measure(const PixelRays& rays, const Frame& frame, double scale, int x, int y, const Config& config) {
    const Vec3i d = pixel_direction(std::uint32_t(x), std::uint32_t(y), frame, config);
    const glm::dvec3 wanted = scale * rays.direction(x, y), made{d[0], d[1], d[2]};
    Seen pixel;
    pixel.power = std::exp2(std::round(std::log2(glm::length(made) / glm::length(wanted))));
    for (int k = 0; k < 3; ++k) {
        const auto a = std::size_t(k);
        pixel.sum = std::max(pixel.sum, std::abs(frame.corner[a] + x * frame.right[a] + y * frame.down[a]));
        pixel.largest = std::max(pixel.largest, std::abs(std::int64_t(d[a])));
        pixel.error = std::max(pixel.error, std::abs(made[k] - pixel.power * wanted[k]));
    }
    return pixel;
}

/// Converts the pixel map to lattice steps.
PixelRays in_steps(PixelRays rays, const Lattice& lattice) {
    for (glm::dvec3* const part : {&rays.corner, &rays.right, &rays.down}) *part /= lattice.pitch;
    return rays;
}

bool fits(const Vec3l& v, int bits) {
    return std::all_of(v.begin(), v.end(),
                       [bits](std::int64_t x) { return std::abs(x) < std::int64_t(1) << (bits - 1); });
}

}   // namespace

TEST_CASE("every pixel's direction fits and points where the camera does") {
    const int bits = GENERATE(12, 16, 18, 20, 24);
    const double fov = GENERATE(1.0, 45.0, 120.0, 179.0);
    const FrameSize size = GENERATE(FrameSize{1, 1}, FrameSize{2, 1}, FrameSize{1, 2}, FrameSize{2, 2},
                                    FrameSize{3, 5}, FrameSize{512, 384}, FrameSize{641, 359},
                                    FrameSize{16384, 1}, FrameSize{1, 16384}, FrameSize{16384, 16384});
    if (size.width == 16384 && size.height == 1 && fov > 1) return;   // refused, see below
    const Config config = with_dir_bits(bits);
    const Camera camera{{3, 4, 5}, {-1, 0.5, 0.25}, {0.1, 1, 0.2}, fov};
    Lattice lattice;
    lattice.pitch = {0.01, 0.02, 0.015};
    const Frame frame = make_frame(camera, size, lattice, config);
    INFO(bits << " bits, " << fov << " degrees, " << size.width << "x" << size.height);

    CHECK(frame.root == 0);
    CHECK(frame.width == std::uint32_t(size.width));
    CHECK(frame.height == std::uint32_t(size.height));
    CHECK(frame.eye == lattice.snap(camera.eye));
    for (const Vec3l& v : {frame.corner, frame.right, frame.down}) CHECK(fits(v, config.guard_dir_bits()));

    // The scale that make_frame chose, from its longest register, to within half a unit of it.
    const PixelRays rays = in_steps(pixel_rays(camera, size), lattice);
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(rays.corner[k]) > std::abs(rays.corner[axis])) axis = k;
    const double scale = double(frame.corner[std::size_t(axis)]) / rays.corner[axis] / (1 << guard_bits);
    // The bound: half from raygen's rounding, or one if the result would be too large. Then (1 + x + y) / 2
    // guard units from the registers' rounding, before they are shifted up. The same again for the error of
    // the scale above, at pixels up to m / |corner| times as long.
    const double off = 2.0 * (size.width + size.height) / (1 << guard_bits);

    std::mt19937 draw{std::uint32_t(bits)};
    std::int64_t longest = 0, shortest = std::int64_t(1) << 62;
    bool is_near = true;
    for (int i = 0; i < 1000; ++i) {
        const int x = i < 4 ? (i & 1) * (size.width - 1) : int(draw() % std::uint32_t(size.width));
        const int y = i < 4 ? (i >> 1) * (size.height - 1) : int(draw() % std::uint32_t(size.height));
        const Seen pixel = measure(rays, frame, scale, x, y, config);
        longest = std::max(longest, pixel.sum);
        shortest = std::min(shortest, pixel.largest);
        is_near =
            is_near && pixel.error <= (pixel.largest == (1 << (bits - 1)) - 1 ? 1 : 0.5) + pixel.power * off;
    }
    CHECK(longest < std::int64_t(1) << (config.guard_dir_bits() - 1));
    CHECK(is_near);
    CHECK(shortest >= 1 << (bits - 2));
}

TEST_CASE("a camera that is too wide is refused, and all others are accepted") {
    const auto make = [](double fov, FrameSize size, int bits) {
        make_frame({{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, fov}, size, Lattice{}, with_dir_bits(bits));
    };
    for (const int bits : {12, 20, 24})
        for (const double fov : {1.0, 110.0, 140.0, 160.0, 175.0})
            for (const FrameSize size : {FrameSize{512, 384}, FrameSize{384, 512}, FrameSize{1920, 240},
                                         FrameSize{60, 1920}, FrameSize{1, 1}})
                CHECK_NOTHROW(make(fov, size, bits));
    CHECK_NOTHROW(make(179.9, {512, 384}, 20));
    // Straight ahead z is 1. At the picture's side x is w / h tan(fov / 2), which may be 2^16: 22.9 x 2862.
    CHECK_NOTHROW(make(90, {16384, 1}, 20));
    CHECK_NOTHROW(make(175, {2800, 1}, 20));
    CHECK_THROWS_WITH(make(175, {2900, 1}, 20), Catch::Contains("175 degrees") &&
                                                    Catch::Contains("2900 x 1") &&
                                                    Catch::Contains("dir_bits"));
    CHECK_THROWS_WITH(make(160, {16384, 1}, 20), Catch::Contains("160 degrees"));
    CHECK_THROWS_WITH(make(179.999, {512, 384}, 20), Catch::Contains("179.999 degrees"));
}

TEST_CASE("small pictures are right in every pixel") {
    const FrameSize size{37, 23};
    const Config config = with_dir_bits(GENERATE(12, 20));
    const Camera camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, GENERATE(1.0, 90.0, 179.0)};
    const Frame frame = make_frame(camera, size, Lattice{}, config);
    const PixelRays rays = pixel_rays(camera, size);
    const double scale = double(frame.corner[2]) / rays.corner[2] / (1 << guard_bits);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Seen pixel = measure(rays, frame, scale, x, y, config);
            REQUIRE(pixel.largest <= 1 << (config.dir_bits - 1));
            REQUIRE(pixel.largest >= 1 << (config.dir_bits - 2));
            REQUIRE(pixel.error < 1 + pixel.power * 60 / (1 << guard_bits));
        }
}

TEST_CASE("every sample's direction fits, half a pixel around the outer pixels' middles") {
    const double fov = GENERATE(1.0, 120.0, 179.0);
    const FrameSize size = GENERATE(FrameSize{1, 1}, FrameSize{2, 1}, FrameSize{1, 2}, FrameSize{3, 5},
                                    FrameSize{512, 384}, FrameSize{16384, 16384});
    Config config = with_dir_bits(GENERATE(12, 20, 24));
    config.shading = config.supersampling = 1;
    const Frame frame = make_frame({{3, 4, 5}, {-1, 0.5, 0.25}, {0.1, 1, 0.2}, fov}, size, Lattice{}, config);
    INFO(config.dir_bits << " bits, " << fov << " degrees, " << size.width << "x" << size.height);
    for (const Vec3l& v : {frame.corner, frame.right, frame.down}) CHECK(fits(v, config.guard_dir_bits()));
    const std::int64_t most = (std::int64_t(1) << (config.dir_bits - 1)) - 1;
    std::int64_t largest = 0;
    for (const std::int64_t x : {-128, 256 * size.width - 129})   // in 1/256 of a pixel
        for (const std::int64_t y : {-128, 256 * size.height - 129})
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t sum = 256 * frame.corner[k] + x * frame.right[k] + y * frame.down[k];
                largest = std::max(
                    largest, std::abs((sum + (std::int64_t(1) << (guard_bits + 7))) >> (guard_bits + 8)));
            }
    CHECK(largest <= most);
    if (size.width > 2 && size.height > 2) CHECK(double(largest) > 0.98 * double(most));
}

TEST_CASE("a scene that exceeds the configuration's addresses or numbers is refused in a sentence") {
    const Scene scene = sheet(10);
    const glm::dvec3 eye{0, 0, 5};
    Config config;
    const MemoryImage image = compile_scene(scene, eye, config);
    const auto refuses = [&](int Config::*member, int enough, const char* word) {
        INFO(word << " of " << enough);
        Config narrow = config;
        narrow.*member = enough;
        REQUIRE_NOTHROW(compile_scene(scene, eye, narrow));
        narrow.*member = enough - 1;
        CHECK_THROWS_WITH(compile_scene(scene, eye, narrow),
                          Catch::Contains(word) && Catch::Contains("--set " + std::string(word) + "="));
    };
    refuses(&Config::addr_bits, std::bit_width(image.lines() - 1), "addr_bits");
    refuses(&Config::prim_bits, int(std::bit_width(scene.triangles.size() - 1)), "prim_bits");

    Camera camera;
    camera.eye = eye;
    config.pixel_bits = 8;
    CHECK_NOTHROW(make_frame(camera, {256, 3}, image.lattice, config));
    CHECK_THROWS_WITH(make_frame(camera, {3, 257}, image.lattice, config),
                      Catch::Contains("--set pixel_bits=9"));
}
