// Textures: mip levels, resampling, wrapping and filtering against values computed by hand, and the scenes
// that carry them.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "model/scene/folded.hpp"
#include "model/scene/texture.hpp"
#include "tests/scene/mesh_measures.hpp"

namespace rayclock::test::texture_test {

using namespace rayclock;

namespace {

using Texel = std::array<std::uint8_t, 4>;

Texel grey(std::uint8_t code, std::uint8_t alpha = 255) { return {code, code, code, alpha}; }

/// A texture of one row whose texels have the grey codes 0, 10, 20, ...
Texture ramp(int width, Wrap wrap) {
    TexelLevel level{width, 1, {}};
    for (int i = 0; i < width; ++i) level.texels.push_back(grey(std::uint8_t(10 * i)));
    Texture made{.name = "ramp", .pyramid = std::make_shared<const Pyramid>(make_pyramid(std::move(level)))};
    made.wrap_s = made.wrap_t = wrap;
    made.nearest = true;
    return made;
}

/// Returns the grey code of the texel under (s, 0.5).
int code_at(const Texture& texture, double s) {
    return int(linear_to_srgb(filtered(texture, {s, 0.5}, 0).g));
}

/// A square of two triangles that shows a ramp of four texels.
Scene painted_square() {
    Scene scene;
    scene.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    scene.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}};
    scene.coordinates = {{{{0, 1}, {1, 1}, {1, 0}}}, {{{0, 1}, {1, 0}, {0, 0}}}};
    scene.materials = {Material{}};
    scene.materials[0].texture = 0;
    scene.textures = {ramp(4, Wrap::repeat)};
    return scene;
}

template <class Change> std::string sentence(const Change& change) {
    Scene scene = painted_square();
    change(scene);
    return refusal([&] { check_scene(scene, "a.obj"); });
}

}   // namespace

TEST_CASE("all sRGB codes survive the way to linear light and back", "[scene][texture]") {
    CHECK(srgb_to_linear(0) == 0);
    CHECK(srgb_to_linear(255) == 1);
    CHECK(srgb_to_linear(10) == Approx(10 / 255.0 / 12.92));
    CHECK(srgb_to_linear(188) == Approx(std::pow((188 / 255.0 + 0.055) / 1.055, 2.4)));
    for (int code = 0; code < 256; ++code) CHECK(linear_to_srgb(srgb_to_linear(std::uint8_t(code))) == code);
    CHECK(linear_to_srgb(std::numeric_limits<double>::quiet_NaN()) == 0);
}

TEST_CASE("a mip level is the mean in linear light, and alpha weights colours where it differs",
          "[scene][texture]") {
    // Half black and half white is 0.5 of the light, whose nearest code is 188.
    const Pyramid opaque = make_pyramid({2, 2, {grey(0), grey(255), grey(255), grey(0)}});
    REQUIRE(opaque.levels.size() == 2);
    CHECK(opaque.levels[1].texels == std::vector<Texel>{grey(188)});
    // Transparent texels have weight 0. The alphas 0, 0, 255, 0 have the mean 63.75.
    const Pyramid holes = make_pyramid({2, 2, {grey(0, 0), grey(9, 0), grey(255, 255), grey(77, 0)}});
    CHECK(holes.levels[1].texels == std::vector<Texel>{grey(255, 64)});
    // If all alphas are 0, the plain mean remains. The mean of 0 and 1, 0.5, rounds up to 1.
    const Pyramid none = make_pyramid({2, 1, {grey(0, 0), grey(255, 0)}});
    CHECK(none.levels[1].texels == std::vector<Texel>{grey(188, 0)});
    const Pyramid half = make_pyramid({2, 1, {grey(50, 0), grey(50, 1)}});
    CHECK(half.levels[1].texels == std::vector<Texel>{grey(50, 1)});
}

TEST_CASE("levels halve each side down to 1", "[scene][texture]") {
    const Pyramid pyramid = make_pyramid({8, 2, std::vector<Texel>(16, grey(90))});
    REQUIRE(pyramid.levels.size() == 4);
    for (const auto& [level, width, height] :
         {std::array{0, 8, 2}, std::array{1, 4, 1}, std::array{2, 2, 1}, std::array{3, 1, 1}}) {
        CHECK(pyramid.levels[std::size_t(level)].width == width);
        CHECK(pyramid.levels[std::size_t(level)].height == height);
        CHECK(pyramid.levels[std::size_t(level)].texels ==
              std::vector<Texel>(std::size_t(width * height), grey(90)));
    }
    CHECK_THROWS_AS(make_pyramid({3, 1, std::vector<Texel>(3)}), std::logic_error);
}

TEST_CASE("sides become the nearest power of two in the logarithm", "[scene][texture]") {
    const std::array<std::pair<int, int>, 12> sides{{{1, 1},
                                                     {2, 2},
                                                     {3, 4},
                                                     {5, 4},
                                                     {6, 8},
                                                     {11, 8},
                                                     {12, 16},
                                                     {256, 256},
                                                     {362, 256},
                                                     {363, 512},
                                                     {4097, 4096},
                                                     {16384, 4096}}};
    for (const auto& [side, power] : sides) CHECK(texture_side(side) == power);
}

TEST_CASE("resampling takes the mean over each new texel's area", "[scene][texture]") {
    // 3 x 5 becomes 4 x 4. Column 0 holds 0, column 1 holds 255, column 2 holds 0; all rows are the same.
    TexelLevel picture{3, 5, {}};
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 3; ++x) picture.texels.push_back(grey(x == 1 ? 255 : 0));
    const TexelLevel made = resampled(picture);
    REQUIRE(made.width == 4);
    REQUIRE(made.height == 4);
    // A new texel is 3/4 of an old one wide: 0..0.75, 0.75..1.5 (2/3 of it in column 1), and mirrored.
    const std::uint8_t mixed = linear_to_srgb(2.0 / 3);
    for (std::size_t y = 0; y < 4; ++y) {
        CHECK(made.texels[4 * y] == grey(0));
        CHECK(made.texels[4 * y + 1] == grey(mixed));
        CHECK(made.texels[4 * y + 2] == grey(mixed));
        CHECK(made.texels[4 * y + 3] == grey(0));
    }
    // Along t a new texel is 5/4 old ones high. Row 1 of the old ones covers 1/5 of the first.
    TexelLevel rows{1, 5, {grey(0), grey(255), grey(0), grey(0), grey(0)}};
    const TexelLevel high = resampled(rows);
    CHECK(high.texels ==
          std::vector<Texel>{grey(linear_to_srgb(0.2)), grey(linear_to_srgb(0.6)), grey(0), grey(0)});
    const TexelLevel fits{2, 1, {grey(7), grey(9)}};
    CHECK(resampled(fits).texels == fits.texels);
}

TEST_CASE("coordinates beyond the border repeat, mirror or clamp", "[scene][texture]") {
    const Texture repeat = ramp(4, Wrap::repeat), mirror = ramp(4, Wrap::mirror),
                  clamp = ramp(4, Wrap::clamp);
    struct Case {
        double s;
        int repeat, mirror, clamp;
    };
    const double before = std::nextafter(1.0, 0.0);
    const auto c = GENERATE_COPY(values<Case>({{0, 0, 0, 0},
                                               {0.25, 10, 10, 10},
                                               {std::nextafter(0.25, 0), 0, 0, 0},
                                               {before, 30, 30, 30},
                                               {1, 0, 30, 30},
                                               {1.25, 10, 20, 30},
                                               {2, 0, 0, 30},
                                               {-0.1, 30, 0, 0},
                                               {-0.25, 30, 0, 0},
                                               {-0.26, 20, 10, 0},
                                               {-1, 0, 30, 0},
                                               {64, 0, 0, 30},
                                               {-64, 0, 0, 0}}));
    CAPTURE(c.s);
    CHECK(code_at(repeat, c.s) == c.repeat);
    CHECK(code_at(mirror, c.s) == c.mirror);
    CHECK(code_at(clamp, c.s) == c.clamp);
}

TEST_CASE("bilinear filtering mixes the four nearest texels in linear light", "[scene][texture]") {
    Texture texture{.name = "four",
                    .pyramid = std::make_shared<const Pyramid>(
                        make_pyramid({2, 2, {grey(0), grey(255), grey(255), grey(255)}}))};
    CHECK(filtered(texture, {0.25, 0.25}, 0).r == 0);   // the middle of the first texel
    CHECK(filtered(texture, {0.5, 0.25}, 0).r == 0.5);
    CHECK(filtered(texture, {0.5, 0.5}, 0).r == 0.75);
    CHECK(filtered(texture, {0.375, 0.375}, 0).r == Approx(1 - 0.75 * 0.75));
    CHECK(filtered(texture, {0, 0.25}, 0).r == 0.5);   // its neighbour is the last texel
    texture.wrap_s = Wrap::clamp;
    CHECK(filtered(texture, {0, 0.25}, 0).r == 0);
    texture.wrap_s = Wrap::mirror;
    CHECK(filtered(texture, {0, 0.25}, 0).r == 0);
    CHECK(filtered(texture, {1.75, 0.25}, 0).r == 0);
    // The level has one texel, and 3/4 of the light has the code 225.
    CHECK(filtered(texture, {0.25, 0.25}, 1).r == srgb_to_linear(225));
    CHECK(filtered(texture, {0.25, 0.25}, 9).r == srgb_to_linear(225));
    texture.mipmaps = false;
    CHECK(filtered(texture, {0.25, 0.25}, 1).r == 0);
    CHECK(average_of(texture).r == 0.75);
}

TEST_CASE("coordinates shift by whole periods towards 0", "[scene][texture]") {
    const CornerCoordinates far{{{10.25, 7}, {11.25, 7.5}, {10.75, 8}}};
    const CornerCoordinates repeat = near_zero(ramp(4, Wrap::repeat), far);
    CHECK(repeat[0] == glm::dvec2(0.25, 0));   // the middles 10.75 and 7.5 lie in the periods 10 and 7
    CHECK(repeat[2] == glm::dvec2(0.75, 1));
    CHECK(near_zero(ramp(4, Wrap::mirror), far)[0] == glm::dvec2(0.25, 1));   // 10 and 6
    const CornerCoordinates usual{{{0, 0}, {1, 0}, {1, 1}}};
    CHECK(near_zero(ramp(4, Wrap::repeat), usual) == usual);
    CHECK(near_zero(ramp(4, Wrap::clamp), far) == far);
}

TEST_CASE("the level follows distance, angle and density", "[scene][texture]") {
    const Scene scene = painted_square();
    // 4 x 1 texels on 4 x 4 units: half a texel per unit.
    CHECK(texture_detail(scene, 0) == Approx(-1));
    CHECK(texture_detail(scene, 1) == Approx(-1));
    const double spread = sample_spread({.fov_degrees = 90}, {100, 100}, 2);
    CHECK(spread == Approx(0.01));
    CHECK(level_of_detail(-1, 400, spread, 1) == Approx(1));
    CHECK(level_of_detail(-1, 400, spread, -0.25) == Approx(1 + 2 * foreshortening_share));
    CHECK(level_of_detail(-1, 400, spread, 0) == Approx(1 + 16 * foreshortening_share));
    const Texture& texture = scene.textures[0];
    for (const auto& [lod, level] : {std::pair{-3.0, 0}, {0.49, 0}, {0.5, 1}, {1.49, 1}, {1.5, 2}, {99.0, 2}})
        CHECK(level_of(texture, lod) == level);
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK(level_of(texture, infinite) == 2);
    CHECK(level_of(texture, -infinite) == 0);
    Scene flat = scene;
    flat.coordinates[0] = {};
    CHECK(texture_detail(flat, 0) == -infinite);
    flat = scene;
    flat.vertices[2] = flat.vertices[1];
    CHECK(texture_detail(flat, 0) == -infinite);
    Texture single = texture;
    single.mipmaps = false;
    CHECK(level_of(single, 5) == 0);
}

TEST_CASE("wrong textures and coordinates are named", "[scene][check][texture]") {
    CHECK(sentence([](Scene&) {}).empty());
    CHECK(sentence([](Scene& s) { s.coordinates[1][2].x = 64; }).empty());
    CHECK(sentence([](Scene& s) { s.coordinates[1][2].x = -65; }) ==
          "a.obj: triangle 1 (counted from 0) has the texture coordinate -65, which must lie within -64 and "
          "64");
    CHECK(sentence([](Scene& s) { s.coordinates[0][0].y = std::numeric_limits<double>::quiet_NaN(); }) ==
          "a.obj: triangle 0 (counted from 0) has the texture coordinate nan, which must lie within -64 and "
          "64");
    CHECK(sentence([](Scene& s) { s.coordinates.clear(); }) ==
          "a.obj: triangle 0 (counted from 0) has a texture and no coordinates on it");
    CHECK(sentence([](Scene& s) { s.coordinates.pop_back(); }) ==
          "a.obj: there are coordinates of 1 triangles, and there are 2");
    CHECK(sentence([](Scene& s) { s.materials[0].texture = 1; }) ==
          "a.obj: material 0 uses texture 1 (counted from 0), and there are 1");
    CHECK(sentence([](Scene& s) { s.textures[0].pyramid = nullptr; }) ==
          "a.obj: the texture 'ramp' has no picture");
}

TEST_CASE("instances keep their coordinates, and mirror images turn them", "[scene][placed][texture]") {
    PlacedScene scene;
    const Scene square = painted_square();
    scene.own.materials = square.materials, scene.own.textures = square.textures;
    scene.own.camera = Camera{};
    scene.meshes = {{"square", square.vertices, {}, square.triangles, square.coordinates}};
    glm::dmat4 mirror(1);
    mirror[0][0] = -1;
    scene.instances = {{"as it is", 0, glm::dmat4(1), {}}, {"mirrored", 0, mirror, {}}};
    const Scene flat = flattened(scene);
    REQUIRE(flat.coordinates.size() == 4);
    CHECK(flat.coordinates[0] == square.coordinates[0]);
    const CornerCoordinates& own = square.coordinates[1];
    CHECK(flat.coordinates[3] == CornerCoordinates{own[0], own[2], own[1]});
    CHECK_NOTHROW(check_scene(flat, "flat"));
    const Scene folded = keep_instances(scene);
    const InstancedTriangles triangles(*folded.placed);
    for (std::uint32_t i = 0; i < 4; ++i) {
        CHECK(triangles(i).coordinates == flat.coordinates[i]);
        // Equal areas have equal detail.
        CHECK(texture_detail(flat.textures[0], triangles(i).vertices, triangles(i).coordinates) ==
              Approx(-1));
    }
    // A mesh without coordinates takes zeros next to one that has some.
    Scene joined = square;
    joined.coordinates.clear();
    append(joined, square, glm::dmat4(1), std::nullopt, 0);
    REQUIRE(joined.coordinates.size() == 4);
    CHECK(joined.coordinates[1] == CornerCoordinates{});
    CHECK(joined.coordinates[2] == square.coordinates[0]);
}

TEST_CASE("the room has every kind of texture", "[scene][builtin][texture]") {
    const Scene scene = make_builtin("room");
    CHECK_NOTHROW(check_scene(scene, "room"));
    CHECK(scene.coordinates.size() == scene.triangles.size());
    CHECK(scene.lights.size() == 2);
    bool has_mirror = false, has_clamp = false, has_nearest = false, is_oblong = false;
    for (const Texture& texture : scene.textures) {
        has_mirror = has_mirror || texture.wrap_s == Wrap::mirror;
        has_clamp = has_clamp || texture.wrap_s == Wrap::clamp;
        has_nearest = has_nearest || texture.nearest;
        const TexelLevel& picture = texture.pyramid->levels[0];
        is_oblong = is_oblong || (picture.width == 512 && picture.height == 64);
        CHECK(picture.width <= 512);
        CHECK(texture.pyramid->levels.back().texels.size() == 1);
    }
    CHECK((has_mirror && has_clamp && has_nearest && is_oblong));
}

}   // namespace rayclock::test::texture_test
