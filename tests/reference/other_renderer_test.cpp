// Textures of glTF against the picture of another renderer (tests/golden/PROVENANCE.md).
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "sim/files/image/image.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/load/load.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock::test::other_renderer_test {

using namespace rayclock;

namespace {

constexpr FrameSize size{320, 240};
constexpr Whitted settings{.depth = 1, .aa = 4};

Scene sheet() {
    Scene scene = load_scene("tests/golden/texture_sheet.gltf");
    scene.camera = Camera{{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 45};
    return scene;
}

/// Without textures the PSNR is 14 dB. One square that is turned, shifted or wrapped in another way lowers it
/// below 40 dB.
constexpr double least_psnr = 50;

void check_same(const Picture& picture) {
    const PictureDifference difference =
        compare(picture, read_picture("tests/golden/texture_sheet_320x240.png"), 16);
    CHECK(difference.psnr_db > least_psnr);
    CHECK(difference.pixels_beyond < 30);   // at the rims of holes
}

}   // namespace

TEST_CASE("reference and model draw the textures of a glTF file as another renderer does") {
    const Scene scene = sheet();
    check_same(picture_from_reference(Reference(scene).whitted(*scene.camera, size, settings)));
    const Job job = make_job(scene, *scene.camera, size,
                             fitted_config(scene, settings, named_config("default")), {}, settings);
    check_same(picture_from_colours(size, run_model(job).colours));
}

TEST_CASE("another wrap mode of one texture makes the picture differ") {
    for (const std::size_t texture : {1, 2, 3}) {
        INFO(texture);
        Scene scene = sheet();
        REQUIRE(texture < scene.textures.size());
        Texture& changed = scene.textures[texture];
        changed.wrap_s = changed.wrap_s == Wrap::clamp ? Wrap::repeat : Wrap::clamp;
        const Picture picture =
            picture_from_reference(Reference(scene).whitted(*scene.camera, size, settings));
        CHECK(compare(picture, read_picture("tests/golden/texture_sheet_320x240.png")).psnr_db < 40);
    }
}

}   // namespace rayclock::test::other_renderer_test
