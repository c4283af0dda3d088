// Builds meshes that are difficult for secondary-ray origins.
#include "sim/explore/stress/shadow_scenes.hpp"

#include <cmath>
#include <numbers>

#include "model/base/rng.hpp"
#include "model/scene/generate/generate.hpp"

namespace rayclock {

namespace {

using oracle::Corners;
using Mesh = std::vector<Corners>;

constexpr double pi = std::numbers::pi;

/// Returns nine tenths of the largest coordinate.
int reach(int bits) { return int(0.9 * double(1 << (bits - 1))); }
Vec3i snapped(double x, double y, double z) {
    return {int(std::lround(x)), int(std::lround(y)), int(std::lround(z))};
}

void quad(Mesh& mesh, const Vec3i& a, const Vec3i& b, const Vec3i& c, const Vec3i& d) {
    mesh.push_back({a, b, c});
    mesh.push_back({a, c, d});
}
void box(Mesh& mesh, const Vec3i& lo, const Vec3i& hi) {
    const auto p = [&](int which) {
        return Vec3i{which & 1 ? hi[0] : lo[0], which & 2 ? hi[1] : lo[1], which & 4 ? hi[2] : lo[2]};
    };
    quad(mesh, p(0), p(2), p(3), p(1));
    quad(mesh, p(4), p(5), p(7), p(6));
    quad(mesh, p(0), p(1), p(5), p(4));
    quad(mesh, p(2), p(6), p(7), p(3));
    quad(mesh, p(0), p(4), p(6), p(2));
    quad(mesh, p(1), p(3), p(7), p(5));
}
void octahedron(Mesh& mesh, int r) {
    for (int octant = 0; octant < 8; ++octant) {
        const int x = octant & 1 ? r : -r, y = octant & 2 ? r : -r, z = octant & 4 ? r : -r;
        mesh.push_back({{x, 0, 0}, {0, y, 0}, {0, 0, z}});
    }
}
void ball(Mesh& mesh, int size, double radius, const Vec3i& at) {
    const Scene scene = make_icosphere(size);
    for (const Triangle& t : scene.triangles) {
        const auto corner = [&](std::size_t k) {
            const glm::dvec3 p = scene.vertices[t.vertex[k]] * radius;
            return snapped(p.x + at[0], p.y + at[1], p.z + at[2]);
        };
        mesh.push_back({corner(0), corner(1), corner(2)});
    }
}
/// Adds a grid that is closed in both directions.
template <class At> void closed_grid(Mesh& mesh, int around, int along, const At& at) {
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j)
            quad(mesh, at(i, j), at((i + 1) % around, j), at((i + 1) % around, (j + 1) % along),
                 at(i, (j + 1) % along));
}

Mesh shells(int bits, bool slanted) {
    Mesh mesh;
    const int r = reach(bits);
    // The shells are 1, 2 and 3 steps apart; faces of octahedra are 0.58 times as far apart.
    for (const int inwards : {0, 1, 3, 6}) {
        const int q = r - inwards;
        if (slanted)
            octahedron(mesh, q);
        else
            box(mesh, {-q, -q, -q}, {q, q, q});
    }
    return mesh;
}
Mesh round_shells(int bits) {
    Mesh mesh;
    for (const int inwards : {0, 1, 3, 6}) ball(mesh, 3, reach(bits) - inwards, {0, 0, 0});
    return mesh;
}
Mesh touching(int bits) {
    Mesh mesh;
    const int r = reach(bits), h = r / 3;
    box(mesh, {-r, -r, -r}, {h, 0, r});   // two boxes that share a part of a face,
    box(mesh, {-h, 0, -h}, {r, r, h});
    box(mesh, {-r, 0, -r}, {-h, h, -h});   // a box that touches both along edges,
    octahedron(mesh, h / 2);               // and an octahedron that intersects all of them
    return mesh;
}
/// A gear wheel with concave edges and corners all around.
Mesh cog(int bits) {
    Mesh mesh;
    const int teeth = 24, points = 4 * teeth;
    const double r = reach(bits);
    const auto at = [&](int i, double y) {
        const double radius = (i / 2) % 2 == 0 ? r : 0.7 * r, angle = 2 * pi * i / points;
        return snapped(radius * std::cos(angle), y, radius * std::sin(angle));
    };
    for (int i = 0; i < points; ++i) {
        const int next = (i + 1) % points;
        quad(mesh, at(i, -r / 4), at(i, r / 4), at(next, r / 4), at(next, -r / 4));
        // The caps are lower in the middle.
        mesh.push_back({at(i, r / 4), {0, int(r / 8), 0}, at(next, r / 4)});
        mesh.push_back({at(i, -r / 4), at(next, -r / 4), {0, -int(r / 8), 0}});
    }
    return mesh;
}
Mesh torus(int bits) {
    Mesh mesh;
    const int around = 48, along = 24;
    const double r = reach(bits);
    closed_grid(mesh, around, along, [&](int i, int j) {
        const double u = 2 * pi * i / around, v = 2 * pi * j / along, ring = r * (0.65 + 0.35 * std::cos(v));
        return snapped(ring * std::cos(u), 0.35 * r * std::sin(v), ring * std::sin(u));
    });
    return mesh;
}
/// A ball of long slices: needles that meet at the poles.
Mesh needles(int bits) {
    Mesh mesh;
    const int slices = 400;
    const double r = reach(bits);
    const auto at = [&](int i, double angle) {
        const double u = 2 * pi * (i % slices) / slices;
        return snapped(r * std::cos(angle) * std::cos(u), r * std::sin(angle),
                       r * std::cos(angle) * std::sin(u));
    };
    const Vec3i top = snapped(0, r, 0), bottom = snapped(0, -r, 0);
    for (int i = 0; i < slices; ++i) {
        mesh.push_back({top, at(i + 1, 0.5), at(i, 0.5)});
        quad(mesh, at(i, 0.5), at(i + 1, 0.5), at(i + 1, -0.5), at(i, -0.5));
        mesh.push_back({bottom, at(i, -0.5), at(i + 1, -0.5)});
    }
    return mesh;
}
/// Two triangles as large as the lattice, with small objects on them.
Mesh floor(int bits) {
    Mesh mesh;
    const int r = reach(bits);
    quad(mesh, {-r, 0, -r}, {-r, 0, r}, {r, 0, r}, {r, 0, -r});
    Rng rng(7);
    const auto below = [&](int n) { return rng.below(n); };
    for (int i = 0; i < 150; ++i) {
        const int size = 2 + below(40), x = below(2 * r - 100) - r, z = below(2 * r - 100) - r;
        if (i % 3 == 2)
            ball(mesh, 1, size, {x, size, z});   // touches the floor with its lowest point
        else
            // On the floor, or one step above.
            box(mesh, {x, i % 3, z}, {x + size, 1 + below(60), z + 1 + below(50)});
    }
    return mesh;
}
Mesh small_ball(int bits) {
    Mesh mesh;
    ball(mesh, 3, 60, {reach(bits) / 2, -reach(bits) / 3, 11});
    ball(mesh, 2, 20, {reach(bits) / 2 + 90, -reach(bits) / 3, 11});
    return mesh;
}

}   // namespace

const std::vector<ShadowScene>& shadow_scenes() {
    static const std::vector<ShadowScene> scenes{
        {"ball", "icosphere of 5,120 triangles",
         [](int bits) {
             Mesh m;
             ball(m, 4, reach(bits), {0, 0, 0});
             return m;
         }},
        {"small balls", "radius 60 and 20 steps, triangles of a few steps", small_ball},
        {"box shells", "cubes 1, 2 and 3 steps inside each other",
         [](int bits) { return shells(bits, false); }},
        {"slanted shells", "octahedra 0.58, 1.2 and 1.7 steps inside each other",
         [](int bits) { return shells(bits, true); }},
        {"round shells", "icospheres of radius 1, 2 and 3 steps less; snapped, they touch and cross",
         round_shells},
        {"touching", "boxes that share parts of faces and edges, an octahedron through all", touching},
        {"cog", "gear wheel with concave edges and corners", cog},
        {"torus", "2,304 triangles", torus},
        {"needles", "ball of 400 slices", needles},
        {"floor", "two triangles as large as the lattice, 150 things of 2 to 60 steps on it", floor},
    };
    return scenes;
}

}   // namespace rayclock
