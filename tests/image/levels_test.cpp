// Compares pictures of two levels with the reference, which renders a flat scene in double precision.
#include <catch2/catch.hpp>

#include "sim/judge/reference/reference.hpp"
#include "model/scene/hit_shading.hpp"
#include "tests/support/levels/picture.hpp"
#include "sim/files/image/image.hpp"

using namespace rayclock;

TEST_CASE("the gearbox in two levels looks as the reference says", "[levels]") {
    const Config config;
    const FrameSize size{128, 96};
    const PlacedScene placed = make_placed("gearbox:8");
    const Scene flat = flattened(placed);
    const LevelsImage levels = compile_levels(placed, flat.camera->eye, config);
    const LevelsPicture picture = trace_levels(levels, *flat.camera, size, config);
    const HitFrame truth = Reference(flat).frame(*flat.camera, size);
    const PictureDifference difference = compare(shade(flat, picture.hits), shade(flat, truth), 0);
    std::size_t other = 0;
    for (std::size_t i = 0; i < truth.hits.size(); ++i)
        other += truth.hits[i].primitive != picture.hits.hits[i].primitive;
    CAPTURE(difference.psnr_db, other);
    CHECK(difference.psnr_db >= 45);
    CHECK(other <= truth.hits.size() / 200);
}
