// Textures in memory images: every texel is at the address that unit tex reads, and records hold the scene's
// numbers.
#include <catch2/catch.hpp>

#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/surfaces.hpp"
#include "model/compile/textures.hpp"
#include "model/layout/words.hpp"
#include "model/scene/builtin.hpp"
#include "tests/support/cases/tex_cases.hpp"

namespace rayclock::test::textures_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr std::array wraps{Wrap::repeat, Wrap::mirror, Wrap::clamp};

/// Returns a pyramid of random texels. The levels are unrelated, so a test notices a wrong level.
std::shared_ptr<const Pyramid> random_pyramid(Draw& draw, int width, int height) {
    Pyramid pyramid;
    for (;;) {
        TexelLevel level{width, height, {}};
        level.texels.resize(std::size_t(width) * std::size_t(height));
        for (auto& texel : level.texels)
            for (auto& code : texel) code = std::uint8_t(draw.bits(8));
        pyramid.levels.push_back(std::move(level));
        if (width == 1 && height == 1) break;
        width = std::max(width / 2, 1), height = std::max(height / 2, 1);
    }
    return std::make_shared<const Pyramid>(std::move(pyramid));
}

/// Appends a triangle with a texture of its own to a scene.
void add_textured(Scene& scene, Texture texture, Draw& draw) {
    Material material;
    material.texture = std::uint32_t(scene.textures.size());
    scene.textures.push_back(std::move(texture));
    const auto first = std::uint32_t(scene.vertices.size());
    CornerCoordinates corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto any = [&] { return std::ldexp(double(draw.number(20)), -17); };
        scene.vertices.emplace_back(any(), any(), any());
        corners[k] = {16 * any(), 16 * any()};
    }
    scene.triangles.push_back({{first, first + 1, first + 2}, std::uint32_t(scene.materials.size())});
    scene.materials.push_back(material);
    scene.coordinates.push_back(corners);
}

/// Writes the textures of a scene into an image that has none yet.
std::vector<std::uint32_t> written(const Scene& scene, const Config& config, MemoryImage& image) {
    return write_textures(scene, image.lattice, config, "test", image);
}

/// An image that already holds some lines, so that no texture starts at line 0.
MemoryImage some_image() {
    MemoryImage image;
    image.words.resize(5 * words_per_line, 0xdeadbeef);
    return image;
}

/// Rounds a texel to the codes of the format, and expands it to 8 bits.
std::array<std::uint32_t, 4> shown(const std::array<std::uint8_t, 4>& texel, TexelFormat format) {
    if (format == TexelFormat::rgb888) return {texel[0], texel[1], texel[2], texel[3]};
    const auto five = [](std::uint8_t code) {
        const auto few = std::uint32_t(std::floor(code * 31 / 255.0 + 0.5));
        return 8 * few + few / 4;
    };
    const auto six = std::uint32_t(std::floor(texel[1] * 63 / 255.0 + 0.5));
    return {five(texel[0]), 4 * six + six / 16, five(texel[2]), texel[3] < 128 ? 0u : 255u};
}

Line line_of(const MemoryImage& image, std::uint32_t number) {
    Line line{};
    std::copy_n(image.line(number), line.size(), line.begin());
    return line;
}

/// Requires that texel (x, y) of a level is at the place from texel_place(), with its neighbours to the right
/// and below.
void check_texel(const MemoryImage& image, const Texture& texture, TexRecord record, const Config& config,
                 int level, int x, int y) {
    const TexelLevel& picture = texture.pyramid->levels[std::size_t(level)];
    const auto middle = [](int i, int side) {
        return std::int32_t((2 * std::int64_t(i) + 1) * (1 << (coordinate_frac - 1)) / side);
    };
    record.s.fill(middle(x, picture.width)), record.t.fill(middle(y, picture.height));
    record.density = level * (1 << level_frac);
    TexReq hit;
    hit.path = 1, hit.cosine = 1 << unit_bits;
    const TexelPlace place = texel_place(hit, record, 0, config);
    if (int(place.level) != level || place.weight_x != 0 || place.weight_y != 0)
        FAIL("level " << place.level << ", weights " << place.weight_x << " " << place.weight_y);
    const Line line = line_of(image, place.line);
    const auto next = [&](int i, int side, Wrap wrap) {
        return i + 1 < side ? i + 1 : wrap == Wrap::repeat ? 0 : side - 1;
    };
    for (int down = 0; down < 2; ++down)
        for (int right = 0; right < 2; ++right) {
            const int from_x = right ? next(x, picture.width, texture.wrap_s) : x,
                      from_y = down ? next(y, picture.height, texture.wrap_t) : y;
            const TexelCode read =
                texel_of(line, place.x + std::uint32_t(right), place.y + std::uint32_t(down), config.texels);
            const auto wanted =
                shown(picture.texels[std::size_t(from_y) * std::size_t(picture.width) + std::size_t(from_x)],
                      config.texels);
            if (std::array{read.code[0], read.code[1], read.code[2], read.alpha} != wanted)
                FAIL("texel " << x << " + " << right << ", " << y << " + " << down);
        }
}

/// Returns twice the area of a triangle, and of its texture in texels of level 0.
std::pair<long double, long double> areas(const Scene& scene, std::size_t i, const glm::dvec3& pitch) {
    const auto corner = [&](std::size_t k) { return scene.vertices[scene.triangles[i].vertex[k]] / pitch; };
    const glm::dvec3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0);
    const long double x = (long double)(e1.y) * e2.z - (long double)(e1.z) * e2.y,
                      y = (long double)(e1.z) * e2.x - (long double)(e1.x) * e2.z,
                      z = (long double)(e1.x) * e2.y - (long double)(e1.y) * e2.x;
    const CornerCoordinates& c = scene.coordinates[i];
    const TexelLevel& level =
        scene.textures[*scene.materials[scene.triangles[i].material].texture].pyramid->levels[0];
    const long double turn = (long double)(c[1].x - c[0].x) * (c[2].y - c[0].y) -
                             (long double)(c[1].y - c[0].y) * (c[2].x - c[0].x);
    return {std::sqrt(x * x + y * y + z * z), std::fabs(turn) * level.width * level.height};
}

const std::vector<std::pair<int, int>> sizes{
    {1, 1},  {2, 1},  {1, 2},   {2, 2},    {4, 2},  {2, 4},  {8, 4},   {4, 8},    {4, 4},   {16, 1},
    {1, 16}, {32, 2}, {64, 64}, {128, 16}, {8, 64}, {1, 64}, {256, 4}, {1, 4096}, {4096, 1}};

}   // namespace

TEST_CASE("every texel of every level is at the address that its hit reads", "[textures]") {
    const TexelFormat format = GENERATE(TexelFormat::rgb888, TexelFormat::rgb565);
    Config config = tex_config("rgb888");
    config.texels = format;
    Draw draw{7};
    Scene scene;
    for (const auto& [width, height] : sizes)
        for (const Wrap wrap_s : wraps)
            for (const Wrap wrap_t : wraps) {
                if (width * height >= 4096 && wrap_s != wraps[std::size_t(draw.below(3))]) continue;
                add_textured(scene,
                             {"", random_pyramid(draw, width, height), wrap_s, wrap_t, draw.coin(), true},
                             draw);
            }
    MemoryImage image = some_image();
    const std::vector<std::uint32_t> records = written(scene, config, image);
    REQUIRE(records.size() == scene.triangles.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Texture& texture = scene.textures[i];
        const TexRecord record = unpack<TexRecord>(image.line(records[i]), config);
        const std::vector<TexelLevel>& levels = texture.pyramid->levels;
        REQUIRE(record.last_level == levels.size() - 1);
        for (int level = 0; level < int(levels.size()); ++level) {
            const TexelLevel& picture = levels[std::size_t(level)];
            INFO(levels[0].width << " x " << levels[0].height << ", level " << level << ", wraps "
                                 << int(texture.wrap_s) << " " << int(texture.wrap_t));
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x)
                    check_texel(image, texture, record, config, level, x, y);
        }
    }
}

TEST_CASE("a texture of 4096 x 4096 texels is at the addresses that its hits read", "[textures]") {
    Config config = tex_config("rgb888");
    Draw draw{8};
    Scene scene;
    add_textured(scene, {"", random_pyramid(draw, 4096, 4096), Wrap::repeat, Wrap::clamp, false, true}, draw);
    MemoryImage image = some_image();
    const std::vector<std::uint32_t> records = written(scene, config, image);
    const TexRecord record = unpack<TexRecord>(image.line(records[0]), config);
    for (int level = 0; level <= 12; ++level)
        for (int i = 0; i < 2000; ++i) {
            const auto any = [&] {
                const int side = 4096 >> level, corners[] = {0, side - 1, draw.below(side)};
                return corners[draw.below(3)];
            };
            const int x = any(), y = any();
            check_texel(image, scene.textures[0], record, config, level, x, y);
        }
}

TEST_CASE("levels of a texture do not overlap, and end where the texture does", "[textures]") {
    const TexelFormat format = GENERATE(TexelFormat::rgb888, TexelFormat::rgb565);
    const WantedTile tile = wanted_tile(format);
    for (std::uint32_t log_width = 0; log_width <= max_side_log; ++log_width)
        for (std::uint32_t log_height = 0; log_height <= max_side_log; ++log_height) {
            TexRecord record;
            record.log_width = log_width, record.log_height = log_height;
            record.last_level = std::max(log_width, log_height);
            std::vector<std::pair<std::uint32_t, std::uint32_t>> lines;   // first, beyond the last
            for (std::uint32_t level = 0; level <= record.last_level; ++level) {
                const auto count =
                    std::uint32_t(tiles_on(std::max((1 << log_width) >> level, 1), tile.width) *
                                  tiles_on(std::max((1 << log_height) >> level, 1), tile.height));
                const std::uint32_t first = level_offset(record, level, format);
                lines.emplace_back(first, first + count);
            }
            INFO(log_width << " " << log_height);
            REQUIRE(lines[0].first == 0);
            std::ranges::sort(lines);
            for (std::size_t i = 1; i < lines.size(); ++i) REQUIRE(lines[i - 1].second <= lines[i].first);
            REQUIRE(texture_lines(record, format) == lines.back().second);
            // A texture takes at most 1.5 times the lines of its first level, plus three.
            const std::uint32_t all = lines.back().second, level_0 = lines[0].second;
            REQUIRE(all <= 2 * level_0 + 3);
        }
}

TEST_CASE("textures share texels exactly if their picture and wrap modes are the same", "[textures]") {
    const Config config = tex_config("rgb888");
    Draw draw{9};
    Scene scene;
    const auto picture = random_pyramid(draw, 16, 8), other = random_pyramid(draw, 16, 8);
    add_textured(scene, {"", picture, Wrap::repeat, Wrap::repeat, false, true}, draw);
    add_textured(scene, {"", picture, Wrap::repeat, Wrap::repeat, true, false}, draw);
    add_textured(scene, {"", picture, Wrap::repeat, Wrap::clamp, false, true}, draw);
    add_textured(scene, {"", picture, Wrap::clamp, Wrap::repeat, false, true}, draw);
    add_textured(scene, {"", other, Wrap::repeat, Wrap::repeat, false, true}, draw);
    // A triangle without a texture, and one more with the first.
    scene.materials.emplace_back();
    scene.triangles.push_back({{0, 1, 2}, 5});
    scene.triangles.push_back({{3, 4, 5}, 0});
    scene.coordinates.resize(7);
    MemoryImage image = some_image();
    const std::vector<std::uint32_t> records = written(scene, config, image);
    REQUIRE(records.size() == 7);
    CHECK(records[5] == 0);
    std::vector<TexRecord> read;
    for (const std::uint32_t line : records) read.push_back(unpack<TexRecord>(image.line(line), config));
    CHECK(read[0].base == read[1].base);
    CHECK(read[6].base == read[0].base);
    std::set<std::uint32_t> bases, lines(records.begin(), records.end());
    for (const std::size_t i : {0, 2, 3, 4}) bases.insert(read[i].base);
    CHECK(bases.size() == 4);
    CHECK(lines.size() == 7);
    CHECK(*bases.begin() == 5);
    CHECK(*std::next(lines.begin()) > *bases.rbegin());
    CHECK(image.lines() == *lines.rbegin() + 1);
    CHECK((read[0].nearest == 0 && read[1].nearest == 1));
    CHECK((read[0].last_level == 4 && read[1].last_level == 0));   // without mip levels
    CHECK((read[2].wrap_t == WrapMode::clamp && read[2].wrap_s == WrapMode::repeat));
    for (std::size_t i = 0; i < 5; ++i) CHECK(image.words[16 * i] == 0xdeadbeef);
}

TEST_CASE("a record holds the nearest numbers to a triangle's coordinates and density", "[textures]") {
    const Config config = tex_config(GENERATE("rgb888", "rgb565"));
    Draw draw{11};
    Scene scene;
    for (int i = 0; i < 300; ++i)
        add_textured(
            scene,
            {"", random_pyramid(draw, 1 << draw.below(5), 1 << draw.below(5)),
             wraps[std::size_t(draw.below(3))], wraps[std::size_t(draw.below(3))], draw.coin(), draw.coin()},
            draw);
    // Coordinates at the ends, and areas of 0.
    for (std::size_t k = 0; k < 3; ++k) {
        scene.coordinates[0][k] = {-max_coordinate, max_coordinate};
        scene.vertices[3 + k] = scene.vertices[3];
    }
    Lattice lattice;
    lattice.pitch = glm::dvec3(std::exp2(-9.3));
    const double most = (1 << (level_bits - 1)) - 1;
    int inside = 0;
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const TexRecord record = record_of(scene, lattice, config, i, 77);
        const Texture& texture = scene.textures[i];
        INFO("triangle " << i);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 st = scene.coordinates[i][k];
            REQUIRE(std::abs(record.s[k] - std::ldexp(st.x, coordinate_frac)) <= 0.5);
            REQUIRE(std::abs(record.t[k] - std::ldexp(st.y, coordinate_frac)) <= 0.5);
        }
        REQUIRE(record.base == 77);
        REQUIRE(1 << record.log_width == texture.pyramid->levels[0].width);
        REQUIRE(1 << record.log_height == texture.pyramid->levels[0].height);
        REQUIRE((record.nearest != 0) == texture.nearest);
        REQUIRE(record.last_level == (texture.mipmaps ? texture.pyramid->levels.size() - 1 : 0));
        const auto mode = [](Wrap wrap) {
            return wrap == Wrap::repeat   ? WrapMode::repeat
                   : wrap == Wrap::mirror ? WrapMode::mirror
                                          : WrapMode::clamp;
        };
        REQUIRE(record.wrap_s == mode(texture.wrap_s));
        REQUIRE(record.wrap_t == mode(texture.wrap_t));
        const auto [area, texels] = areas(scene, i, lattice.pitch);
        const long double exact =
            area > 0 && texels > 0 ? 64 * (std::log2(texels / area) / 2 - config.t_frac_bits) : -most;
        REQUIRE(std::fabs(record.density - std::clamp<long double>(exact, -most, most)) <= 0.5L + 1e-6L);
        inside += area > 0 && texels > 0;
    }
    CHECK(inside >= 250);
    CHECK(record_of(scene, lattice, config, 0, 0).density == -8191);
    CHECK(record_of(scene, lattice, config, 1, 0).density == -8191);
}

TEST_CASE("a plane's record follows the coordinates of its squares, or shows the last level", "[textures]") {
    const Config config = tex_config("planes");
    Draw draw{17};
    Lattice lattice;
    lattice.coord_bits = config.coord_bits, lattice.pitch = glm::dvec3(std::exp2(-10));   // it reaches 128
    int kept = 0, averaged = 0;
    for (int i = 0; i < 400; ++i) {
        Scene scene;
        const Wrap wrap = wraps[std::size_t(draw.below(3))];
        scene.textures.push_back({"", random_pyramid(draw, 16, 4), wrap, wrap, false, draw.coin()});
        scene.materials.emplace_back().texture = 0;
        Plane plane;
        const double size = std::exp2(draw.between(-9, 9));
        plane.point = {draw.between(-100, 100), draw.between(-5, 5), draw.between(-100, 100)};
        plane.u *= size, plane.v *= size;
        if (draw.coin()) plane.coordinates = {{{0.5, 0.25}, {2.5, 0.25}, {0.5, 4.25}}};
        scene.planes.push_back(plane);
        const TexRecord record = record_of(scene, lattice, config, 0, 5);
        const Surface surface = surface_of(scene, lattice, config, 0);
        INFO("plane " << i << ", squares of " << size);
        // The coordinates of a corner of the surface. x counts squares along u, and -z along v.
        const auto at = [&](const Vec3i& corner) {
            const double u = (corner[0] * lattice.pitch.x - plane.point.x) / size,
                         v = (plane.point.z - corner[2] * lattice.pitch.z) / size;
            const auto& c = plane.coordinates;
            return c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
        };
        const std::array<glm::dvec2, 3> corners{at(surface.a), at(surface.b), at(surface.c)};
        const double longest =
                         std::max(glm::length(corners[1] - corners[0]), glm::length(corners[2] - corners[0])),
                     first = std::max(std::abs(corners[0].x), std::abs(corners[0].y));
        const bool fits = longest <= 60 && (wrap != Wrap::clamp || first + longest <= 60);
        if (longest > 130 || (wrap == Wrap::clamp && first > 70 + longest)) {
            REQUIRE((record.s == std::array<std::int32_t, 3>{} && record.t == record.s));
            REQUIRE((record.density == 8191 && record.last_level == 4));
            ++averaged;
        } else if (fits) {
            const double period = wrap == Wrap::repeat ? 1 : 2;
            for (int axis = 0; axis < 2; ++axis) {
                const auto& held = axis == 0 ? record.s : record.t;
                double shift = corners[0][axis] - std::ldexp(held[0], -coordinate_frac);
                if (wrap != Wrap::clamp) shift -= period * std::round(shift / period);
                REQUIRE(std::abs(shift) < 1e-6);
                for (std::size_t k = 1; k < 3; ++k)
                    REQUIRE(std::abs(std::ldexp(held[k] - held[0], -coordinate_frac) -
                                     (corners[k][axis] - corners[0][axis])) < 1e-6);
            }
            REQUIRE(record.last_level == (scene.textures[0].mipmaps ? 4 : 0));
            ++kept;
        }
    }
    CAPTURE(kept, averaged);
    CHECK((kept > 150 && averaged > 50));
}

TEST_CASE("the register for the spread of samples holds the nearest number", "[textures]") {
    for (const double degrees : {1.0, 20.0, 45.0, 90.0, 150.0, 179.0})
        for (const std::uint32_t height : {1u, 36u, 600u, 16384u})
            for (const int side : {1, 2, 8}) {
                Camera camera;
                camera.fov_degrees = degrees;
                const double width =
                    2 * std::tan(degrees * 3.14159265358979323846 / 360) / double(height) / double(side);
                INFO(degrees << " " << height << " " << side);
                CHECK(std::abs(spread_of(camera, height, side) - 64 * (std::log2(width) - 0.057)) <=
                      0.5 + 1e-9);
            }
}

TEST_CASE("the surfaces of a scene name the records of its textured triangles", "[textures]") {
    const Scene scene = make_builtin("room");
    Config config = fitted_config(scene, {}, tex_config(GENERATE("rgb888", "rgb565")));
    config.stack_depth = 64;
    const MemoryImage image = compile_scene(scene, scene.camera->eye, config);
    std::size_t textured = 0;
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        INFO("triangle " << i);
        const Surface surface = unpack<Surface>(image.line(image.first_surface_line + i), config);
        const bool has_texture = scene.materials[scene.triangles[i].material].texture.has_value();
        REQUIRE((surface.record != 0) == has_texture);
        if (!has_texture) continue;
        ++textured;
        const TexRecord record = unpack<TexRecord>(image.line(surface.record), config);
        REQUIRE(record == record_of(scene, image.lattice, config, i, record.base));
        REQUIRE(record.base + texture_lines(record, config.texels) <= image.lines());
    }
    CHECK(textured > 10);
    CHECK(textured < scene.triangles.size());
}

TEST_CASE("textures beyond the address range are refused", "[textures]") {
    Config config = tex_config("rgb888");
    config.addr_bits = 10;
    Draw draw{12};
    Scene scene;
    add_textured(scene, {"", random_pyramid(draw, 128, 64), Wrap::repeat, Wrap::repeat, false, true}, draw);
    MemoryImage image = some_image();
    CHECK_THROWS_AS(written(scene, config, image), UserError);
    Scene none;
    none.triangles.emplace_back();
    MemoryImage empty = some_image();
    CHECK(written(none, config, empty).empty());
    CHECK(empty.lines() == 5);
}

}   // namespace rayclock::test::textures_test
