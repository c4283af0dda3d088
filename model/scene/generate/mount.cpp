// Haines' "mount": a fractal mountain and four glass spheres.
//
// The published recursion evaluates the noise of every inner edge twice. Here a grid of heights is refined
// level by level, with the same sums, so the heights have the same bits. The terrain is flat-shaded. Since
// the spheres are smooth, the terrain's triangles have their own vertices, bitwise equal where they meet.
#include "model/scene/generate/generate.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

/// Returns b * 2^exponent, or 0 for a negative exponent, where the original shifts by a negative number of
/// bits.
std::uint32_t seed_part(std::uint32_t b, int exponent) { return exponent < 0 ? 0 : b << exponent; }

/// Returns normally distributed noise that depends only on the grid point (polar method, Marsaglia and Bray
/// 1964).
double noise(int size, std::uint32_t a, std::uint32_t b) {
    std::uint32_t seed =
        21 + (seed_part(a, 23 - size) + seed_part(b, 15 - size) + seed_part(a, 7 - size)) % 65536;
    const auto draw = [&] {
        seed = (28411 + 8121 * seed) % 134456;
        return 2.0 * seed / 134456 - 1;
    };
    for (;;) {
        const double v1 = draw(), v2 = draw();
        const double q = v1 * v1 + v2 * v2;
        if (q < 1) return v1 * std::sqrt(-2 * std::log(q) / q);
    }
}

/// Heights at the (2^size + 1)^2 grid points.
class Terrain {
public:
    explicit Terrain(int size)
        : size_(size), side_(std::uint32_t{1} << size), heights_(std::size_t{side_ + 1} * (side_ + 1)) {
        for (std::uint32_t width = side_; width > 1; width /= 2) refine(width);
    }

    std::uint32_t side() const { return side_; }
    glm::dvec3 point(std::uint32_t x, std::uint32_t y) const {
        return {-1 + 2.0 * x / side_, -1 + 2.0 * y / side_, heights_[index(x, y)]};
    }

private:
    std::size_t index(std::uint32_t x, std::uint32_t y) const { return std::size_t{y} * (side_ + 1) + x; }
    double& height(std::uint32_t x, std::uint32_t y) { return heights_[index(x, y)]; }

    /// Cuts squares of `width` in four: first the middles of all edges, then the middles of all squares.
    void refine(std::uint32_t width) {
        static const double roughness = std::sqrt(std::cbrt(2.0) - 1);   // fractal dimension 2.2
        const std::uint32_t h = width / 2;
        const double amplitude = roughness * 2 * h / side_;
        for (std::uint32_t y = 0; y <= side_; y += width)
            for (std::uint32_t x = 0; x < side_; x += width) {
                height(x + h, y) =
                    (height(x, y) + height(x + width, y)) / 2 + amplitude * noise(size_, x + h, y);
                height(y, x + h) =
                    (height(y, x) + height(y, x + width)) / 2 + amplitude * noise(size_, y, x + h);
            }
        for (std::uint32_t y = 0; y < side_; y += width)
            for (std::uint32_t x = 0; x < side_; x += width) {
                const double sum =
                    height(x, y) + height(x + width, y) + height(x + width, y + width) + height(x, y + width);
                height(x + h, y + h) = sum / 4 + 1.4142136 * amplitude * noise(size_, x + h, y + h);
            }
    }

    int size_;
    std::uint32_t side_;
    std::vector<double> heights_;
};

void glass_spheres(MeshWriter& mesh) {
    const glm::dvec3 centre(-0.8, 0.8, 1);
    const double r = 0.17, h = r * std::sqrt(1.5);
    mesh.sphere(centre + glm::dvec3(0, 0, h), r);
    for (int i = 0; i < 3; ++i) {
        const double c = std::cos(2 * std::numbers::pi / 3 * i), s = std::sin(2 * std::numbers::pi / 3 * i);
        const double x = 2 * h / 3, y = -2 * h / 3;
        mesh.sphere(centre + glm::dvec3(x * c - y * s, x * s + y * c, -h / 3), r);
    }
}

/// Writes the squares in the order of the published recursion, which visits the quarters counter-clockwise.
void rock(MeshWriter& mesh, const Terrain& terrain, std::uint32_t width, std::uint32_t x, std::uint32_t y) {
    if (width == 1) {
        const glm::dvec3 a = terrain.point(x, y), b = terrain.point(x + 1, y);
        const glm::dvec3 c = terrain.point(x + 1, y + 1), d = terrain.point(x, y + 1);
        mesh.flat({a, b, c});
        mesh.flat({c, d, a});
        return;
    }
    const std::uint32_t h = width / 2;
    rock(mesh, terrain, h, x, y);
    rock(mesh, terrain, h, x + h, y);
    rock(mesh, terrain, h, x + h, y + h);
    rock(mesh, terrain, h, x, y + h);
}

}   // namespace

PrimitiveCounts mount_counts(int size, Primitives primitives) {
    const std::uint64_t rock_triangles = std::uint64_t{2} << 2 * size;
    if (primitives == Primitives::native) return {.triangles = rock_triangles, .spheres = 4};
    return {.triangles = rock_triangles + 4 * sphere_triangles};
}

Scene make_mount(int size, Primitives primitives) {
    const bool is_cut = primitives == Primitives::triangles;
    Scene scene;
    scene.camera = Camera{{-1.6, 1.6, 1.7}, {0, 0, 0}, {0, 0, 1}, 45};
    scene.lights = white_lights({{-100, -100, 100}});
    MeshWriter mesh(scene, primitives);
    const std::uint64_t rock_corners = 3 * mount_counts(size, Primitives::native).triangles;
    mesh.reserve(rock_corners + (is_cut ? 4 * sphere_vertices : 0), mount_counts(size, primitives), is_cut);
    mesh.material({.name = "glass",
                   .colour{1, 1, 1},
                   .ambient = 0.2,
                   .diffuse = 0.1,
                   .highlight = 0.4,
                   .shine = shine_of(6.7),
                   .mirror = 0.1,
                   .transmit = 0.9,
                   .index = 1.5});
    glass_spheres(mesh);
    mesh.material({.name = "rock", .colour{0.5, 0.45, 0.35}, .ambient = 0.15, .diffuse = 1});
    const Terrain terrain(size);
    rock(mesh, terrain, terrain.side(), 0, 0);
    return scene;
}

}   // namespace rayclock
