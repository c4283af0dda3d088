// Colours as 8-bit sRGB, the distance of two pictures, and golden pictures.
#include <cmath>
#include <limits>

#include "sim/files/image/golden.hpp"
#include "sim/files/image/srgb.hpp"
#include "tests/image/pictures.hpp"
#include "tests/support/files/complaint.hpp"
#include "tests/support/files/test_folder.hpp"

using namespace rayclock;

TEST_CASE("every sRGB byte is the one nearest to the encoded value", "[image]") {
    for (int i = 0; i < 256; ++i) REQUIRE(srgb_byte(linear_from_srgb(i / 255.0)) == i);
    // Just below and above the middle between two bytes.
    for (int i = 0; i < 255; ++i) {
        const double middle = linear_from_srgb((i + 0.5) / 255);
        REQUIRE(srgb_byte(middle * (1 - 1e-9)) == i);
        REQUIRE(srgb_byte(middle * (1 + 1e-9)) == i + 1);
    }
}

TEST_CASE("the sRGB curve has the standard's values", "[image]") {
    CHECK(srgb_from_linear(0) == 0);
    CHECK(srgb_from_linear(1) == Approx(1).epsilon(1e-15));
    CHECK(srgb_from_linear(0.0031308) == Approx(0.04045).epsilon(1e-4));
    CHECK(srgb_from_linear(0.18) == Approx(0.461356).epsilon(1e-5));
    CHECK(srgb_byte(0.5) == 188);
    CHECK(srgb_byte(0.2140) == 127);
}

TEST_CASE("values out of range are clamped", "[image]") {
    CHECK(srgb_byte(-1) == 0);
    CHECK(srgb_byte(17) == 255);
    CHECK(srgb_byte(std::numeric_limits<double>::quiet_NaN()) == 0);
    CHECK(srgb_byte(std::numeric_limits<double>::infinity()) == 255);
}

TEST_CASE("psnr is 10 log10(255^2 / mean square) over all channels", "[image]") {
    Picture a = grey_picture({2, 2}, 0), b = a;
    CHECK(std::isinf(compare(a, b).psnr_db));
    // Bytes 0 against 3, 4 and 12 in single channels: squares 9 + 16 + 144 = 169 over 12 channels.
    const auto light = [](int byte) { return static_cast<float>(linear_from_srgb(byte / 255.0)); };
    b.pixels[0].r = light(3);
    b.pixels[0].b = light(4);
    b.pixels[3].g = light(12);
    const PictureDifference d = compare(a, b, 4);
    CHECK(d.psnr_db == Approx(10 * std::log10(65025.0 * 12 / 169)).epsilon(1e-12));
    CHECK(d.psnr_db == Approx(36.643768).epsilon(1e-6));
    CHECK(d.largest == 12);
    CHECK(d.pixels_beyond == 1);
    CHECK(compare(a, b, 3).pixels_beyond == 2);
    CHECK(compare(a, b).pixels_beyond == 2);
    CHECK(compare(b, a).psnr_db == d.psnr_db);
    CHECK(compare(grey_picture({3, 3}, 0), grey_picture({3, 3}, 1)).psnr_db == Approx(0).margin(1e-12));
}

TEST_CASE("pictures of different sizes are refused", "[image]") {
    const Picture a = grey_picture({2, 3}, 0), b = grey_picture({3, 2}, 0);
    CHECK(test::complaint([&] { compare(a, b); }) != "");
}

TEST_CASE("golden pictures are found by scene and size, and hold within their bounds", "[image]") {
    const test::TestFolder folder;
    const FrameSize size{40, 30};
    const Picture picture = grey_picture(size, 0.5f);
    CHECK(golden_path("g", "gears:4", {128, 96}) == "g/gears_4_128x96.png");
    CHECK(golden_path("g", "../x/a.obj", {1, 2}) == "g/.._x_a.obj_1x2.png");
    CHECK_FALSE(check_golden(folder.path().string(), "gears:4", picture).found);
    write_picture(golden_path(folder.path().string(), "gears:4", size), picture, no_hits(size));
    const auto check = [&](const Picture& p) { return check_golden(folder.path().string(), "gears:4", p); };

    const GoldenResult same = check(picture);
    CHECK(same.found);
    CHECK(same.within);
    CHECK(std::isinf(same.psnr_db));
    CHECK(same.pixels_beyond == 0);
    CHECK_FALSE(check_golden(folder.path().string(), "gears:4", grey_picture({30, 40}, 0.5f)).found);

    Picture pixel_off = picture;
    pixel_off.pixels[7] = glm::vec3(0.3f);   // one of 1200, like at a silhouette
    CHECK(check(pixel_off).pixels_beyond == 1);
    CHECK(check(pixel_off).within);
    // 188 against 187 everywhere: 48 dB. Against 183: 34 dB, although no pixel exceeds the tolerance.
    CHECK(check(grey_picture(size, 0.4959f)).within);
    const GoldenResult paler = check(grey_picture(size, 0.47f));
    CHECK(paler.pixels_beyond == 0);
    CHECK_FALSE(paler.within);
    // Seven pixels of 1200 are more than 0.5 %, even with small errors.
    Picture spots = picture;
    for (int i = 0; i < 7; ++i) spots.pixels[i] = glm::vec3(0.44f);
    CHECK(check(spots).psnr_db > golden_min_psnr_db);
    CHECK(check(spots).pixels_beyond == 7);
    CHECK_FALSE(check(spots).within);
    CHECK(folder.files() == 1);
}

TEST_CASE("golden bounds widen by 3 dB and twice the pixels for each bit below sixteen", "[golden]") {
    CHECK(golden_bounds(20).min_psnr_db == golden_min_psnr_db);
    CHECK(golden_bounds(16).max_beyond == golden_max_beyond);
    CHECK(golden_bounds(15).min_psnr_db == Approx(golden_min_psnr_db - 3.0103));
    CHECK(golden_bounds(12).max_beyond == Approx(16 * golden_max_beyond));
}
