// Builds shapes and places them on a lattice.
#include "sim/explore/stress/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/scene/generate/generate.hpp"

namespace rayclock::stress {

namespace {

using Face = std::array<std::uint32_t, 3>;

/// Creates each point of a grid once, identified by its position in the grid.
class Grid {
public:
    explicit Grid(Shape& shape) : shape_(shape) {}
    std::uint32_t at(const std::array<int, 3>& place, const glm::dvec3& point) {
        const auto [found, fresh] = numbers_.try_emplace(place, std::uint32_t(shape_.points.size()));
        if (fresh) shape_.points.push_back(point);
        return found->second;
    }

private:
    Shape& shape_;
    std::map<std::array<int, 3>, std::uint32_t> numbers_;
};

double unit_random(Rng& rng) { return double(rng.next() >> 11) * 0x1p-53; }

}   // namespace

Shape sphere(int level) {
    const Scene scene = make_icosphere(level);
    Shape shape{scene.vertices, {}};
    for (const Triangle& t : scene.triangles) shape.faces.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
    return shape;
}

Shape bipyramid(int sides, double radius) {
    Shape shape{{{0, 0, -1}, {0, 0, 1}}, {}};
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        shape.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
        const auto here = std::uint32_t(2 + i), next = std::uint32_t(2 + (i + 1) % sides);
        shape.faces.push_back({1, here, next});
        shape.faces.push_back({0, next, here});
    }
    return shape;
}

Shape cube(int n) {
    Shape shape;
    Grid grid(shape);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int u, int v) {
                        std::array<int, 3> p{};
                        p[axis] = side;
                        p[(axis + 1) % 3] = i + u;
                        p[(axis + 2) % 3] = j + v;
                        return grid.at(p, {2.0 * p[0] / n - 1, 2.0 * p[1] / n - 1, 2.0 * p[2] / n - 1});
                    };
                    const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                                        d = corner(0, 1);
                    const bool outwards = side == n;
                    shape.faces.push_back(outwards ? Face{a, b, c} : Face{a, c, b});
                    shape.faces.push_back(outwards ? Face{a, c, d} : Face{a, d, c});
                }
    return shape;
}

Shape cog(int teeth) {
    Shape shape;
    const int n = 2 * teeth;
    for (const double z : {-0.5, 0.5}) {
        for (int i = 0; i < n; ++i) {
            const double angle = std::numbers::pi * i / teeth, radius = i % 2 ? 0.4 : 1;
            shape.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
        }
        shape.points.push_back({0, 0, z});
    }
    const auto low_hub = std::uint32_t(n), top = std::uint32_t(n + 1), top_hub = std::uint32_t(2 * n + 1);
    for (int i = 0; i < n; ++i) {
        const auto a = std::uint32_t(i), b = std::uint32_t((i + 1) % n);
        shape.faces.push_back({low_hub, b, a});
        shape.faces.push_back({top_hub, top + a, top + b});
        shape.faces.push_back({a, b, top + b});
        shape.faces.push_back({a, top + b, top + a});
    }
    return shape;
}

Shape plate(int n, bool other_diagonal) {
    Shape shape;
    Grid grid(shape);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const auto corner = [&](int u, int v) {
                return grid.at({i + u, j + v, 0}, {2.0 * (i + u) / n - 1, 2.0 * (j + v) / n - 1, 0});
            };
            const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
            shape.faces.push_back(other_diagonal ? Face{a, b, d} : Face{a, b, c});
            shape.faces.push_back(other_diagonal ? Face{b, c, d} : Face{a, c, d});
        }
    return shape;
}

Shape turned(const Shape& shape, Rng& rng) {
    // A random unit quaternion (Shoemake 1992), as three columns.
    const double u = unit_random(rng), v = 2 * std::numbers::pi * unit_random(rng),
                 w = 2 * std::numbers::pi * unit_random(rng);
    const double x = std::sqrt(1 - u) * std::sin(v), y = std::sqrt(1 - u) * std::cos(v),
                 z = std::sqrt(u) * std::sin(w), s = std::sqrt(u) * std::cos(w);
    const glm::dvec3 i{1 - 2 * (y * y + z * z), 2 * (x * y + s * z), 2 * (x * z - s * y)},
        j{2 * (x * y - s * z), 1 - 2 * (x * x + z * z), 2 * (y * z + s * x)};
    const glm::dvec3 k = glm::cross(i, j);
    Shape result = shape;
    for (glm::dvec3& p : result.points) p = p.x * i + p.y * j + p.z * k;
    return result;
}

void Mesh::add(const Shape& shape, double scale, const glm::dvec3& centre) {
    std::vector<Vec3i> points;
    for (const glm::dvec3& p : shape.points) {
        const glm::dvec3 q = p * scale + centre;
        points.push_back({int(std::lround(q.x)), int(std::lround(q.y)), int(std::lround(q.z))});
    }
    for (const Face& f : shape.faces) {
        const oracle::Corners t{points[f[0]], points[f[1]], points[f[2]]};
        if (triangles.empty()) lo = hi = t.a;
        triangles.push_back(t);
        for (const Vec3i& p : {t.a, t.b, t.c}) add(p);
    }
}

bool Mesh::closed() const {
    std::map<std::pair<Vec3i, Vec3i>, int> balance;   // by position: coincident corners count as one
    for (const oracle::Corners& t : triangles)
        for (const auto& [p, q] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
            if (p < q)
                ++balance[{p, q}];
            else if (q < p)
                --balance[{q, p}];
        }
    return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

void cut_edges(Mesh& mesh, int count, bool slivers, Rng& rng) {
    const int first = int(mesh.triangles.size());
    for (int tries = 0; tries < 20 * count && count > 0; ++tries) {
        const std::size_t which = std::size_t(rng.below(first));
        const oracle::Corners t = mesh.triangles[which];
        Vec3i middle{};
        bool on_lattice = true, long_enough = false;
        for (std::size_t k = 0; k < 3; ++k) {
            on_lattice = on_lattice && (t.a[k] + t.b[k]) % 2 == 0;
            long_enough = long_enough || std::abs(t.a[k] - t.b[k]) > 8;
            middle[k] = (t.a[k] + t.b[k]) / 2;
        }
        if (!on_lattice || !long_enough) continue;
        if (!slivers) {
            // Move towards the third corner, so that a gap opens.
            std::size_t axis = 0;
            for (std::size_t k = 1; k < 3; ++k)
                if (std::abs(t.c[k] - middle[k]) > std::abs(t.c[axis] - middle[axis])) axis = k;
            middle[axis] += t.c[axis] > middle[axis] ? 1 : -1;
        }
        mesh.triangles[which] = {t.a, middle, t.c};
        mesh.triangles.push_back({middle, t.b, t.c});
        if (slivers) mesh.triangles.push_back({t.a, t.b, middle});
        --count;
    }
}

}   // namespace rayclock::stress
