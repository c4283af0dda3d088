// Textures in the reference's picture and in host shading: colours by hand, and the level along a path.
#include <cmath>

#include <catch2/catch.hpp>

#include "model/scene/folded.hpp"
#include "model/scene/hit_shading.hpp"
#include "sim/judge/reference/reference.hpp"
#include "tests/reference/meshes.hpp"

namespace rayclock::test::reference_texture_test {

using namespace rayclock;

namespace {

/// A wall of 2^n x 2^n units in the plane z = 0. Its picture has one texel per unit. Level i of the picture
/// has the grey greys[i], so the colour identifies the level.
struct PaintedWall {
    static constexpr int side = 64;
    static constexpr std::array<std::uint8_t, 7> greys{250, 210, 170, 130, 90, 50, 10};
    Scene scene = empty_scene();

    PaintedWall() {
        Pyramid pyramid = make_pyramid(
            {side, side, std::vector<std::array<std::uint8_t, 4>>(side * side, {250, 250, 250, 255})});
        for (std::size_t level = 0; level < pyramid.levels.size(); ++level)
            for (auto& texel : pyramid.levels[level].texels)
                texel = {greys[level], greys[level], greys[level], 255};
        scene.textures = {{.name = "levels", .pyramid = std::make_shared<const Pyramid>(std::move(pyramid))}};
        scene.materials = {Material{"wall", {1, 0.5, 1}, 1, 0, 0, 1, 0, 0, 1}};
        scene.materials[0].texture = 0;
        scene.background = glm::dvec3(0);
        add_triangle(scene, {-32, -32, 0}, {32, -32, 0}, {32, 32, 0});
        add_triangle(scene, {-32, -32, 0}, {32, 32, 0}, {-32, 32, 0});
        scene.coordinates = {{{{0, 1}, {1, 1}, {1, 0}}}, {{{0, 1}, {1, 0}, {0, 0}}}};
        for (Triangle& triangle : scene.triangles) triangle.material = 0;
    }

    /// Looks straight at the wall, slightly off its centre. A pixel is one unit wide at the distance 1.
    void look_from(double distance) { scene.camera = Camera{{3, 1, distance}, {3, 1, 0}, {0, 1, 0}, 90}; }

    glm::dvec3 colour(int level) const {
        const double light = srgb_to_linear(greys[std::size_t(level)]);
        return {light, 0.5 * light, light};
    }
};

void check_colour(const glm::dvec3& is, const glm::dvec3& wanted) {
    for (int k = 0; k < 3; ++k) CHECK(is[k] == Approx(wanted[k]).margin(1e-6));
}

}   // namespace

TEST_CASE("the level follows from the distance, in the reference and in host shading",
          "[reference][shade][texture]") {
    PaintedWall wall;
    const FrameSize size{2, 2};   // a pixel of 1 unit at the distance 1
    for (const auto& [distance, level] :
         {std::pair{1.0, 0}, {1.4, 0}, {1.45, 1}, {2.0, 1}, {4.0, 2}, {8.0, 3}, {11.0, 3}, {11.5, 4}}) {
        CAPTURE(distance);
        wall.look_from(distance);
        const Reference reference(wall.scene);
        // The centre of the picture lies between pixels, so the rays are slightly longer and slanted.
        const double slant = std::sqrt(1.5),
                     lod = std::log2(distance * slant) + foreshortening_share * std::log2(slant);
        const int wanted = int(std::floor(lod + 0.5));
        CHECK(std::abs(wanted - level) <= 1);
        const WhittedFrame frame = reference.whitted(*wall.scene.camera, size, {.depth = 0});
        for (const glm::dvec3& pixel : frame.pixels) check_colour(pixel, wall.colour(wanted));
        const Picture shaded = shade(wall.scene, reference.frame(*wall.scene.camera, size));
        for (const glm::vec3& pixel : shaded.pixels) check_colour(glm::dvec3(pixel), wall.colour(wanted));
        // Each of 2 x 2 samples is half as wide.
        const WhittedFrame finer = reference.whitted(*wall.scene.camera, size, {.depth = 0, .aa = 2});
        CHECK(finer.pixels[0].r >= frame.pixels[0].r);
    }
}

TEST_CASE("mirrors lengthen the path", "[reference][texture]") {
    PaintedWall wall;
    // The eye looks away from the wall at a mirror behind it: 2 units there, 4 units back.
    wall.scene.materials.push_back(Material{"mirror", {0, 0, 0}, 0, 0, 0, 1, 1, 0, 1});
    add_triangle(wall.scene, {-40, -40, 4}, {0, 80, 4}, {80, -40, 4});
    wall.scene.triangles.back().material = 1;
    wall.scene.coordinates.emplace_back();
    wall.scene.camera = Camera{{3, 1, 2}, {3, 1, 4}, {0, 1, 0}, 10};
    const Reference reference(wall.scene);
    // The spread of one row of 10 degrees.
    const double lod = std::log2(6 * sample_spread({.fov_degrees = 10}, {1, 1}, 1));
    const int wanted = std::max(0, int(std::floor(lod + 0.5)));
    check_colour(reference.whitted(*wall.scene.camera, {1, 1}, {.depth = 1}).pixels[0], wall.colour(wanted));
    wall.scene.camera->fov_degrees = 90;   // 12 units wide: log2 12 = 3.6
    check_colour(reference.whitted(*wall.scene.camera, {1, 1}, {.depth = 1}).pixels[0], wall.colour(4));
}

TEST_CASE("a folded scene shows the same picture as the flat one", "[shade][texture]") {
    PaintedWall wall;
    wall.look_from(3);
    PlacedScene placed;
    placed.own.materials = wall.scene.materials, placed.own.textures = wall.scene.textures;
    placed.own.camera = wall.scene.camera, placed.own.background = wall.scene.background;
    placed.meshes = {{"wall", wall.scene.vertices, {}, wall.scene.triangles, wall.scene.coordinates}};
    glm::dmat4 larger(2);
    larger[3][3] = 1;
    placed.instances = {{"larger", 0, larger, {}}};
    const Scene flat = flattened(placed), folded = keep_instances(placed);
    const FrameSize size{8, 8};
    const Picture of_flat = shade(flat, Reference(flat).frame(*flat.camera, size)),
                  of_folded = shade(folded, Reference(folded).frame(*folded.camera, size));
    CHECK(of_flat.pixels == of_folded.pixels);
}

}   // namespace rayclock::test::reference_texture_test
