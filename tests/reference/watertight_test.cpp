// A closed surface lets no ray out. Rays from inside aim at vertices, at edges and anywhere, at several
// scales. Rays from outside aim at the vertices and edges that face them. Every miss is a leak, and none is
// allowed.
#include <catch2/catch.hpp>

#include "sim/judge/reference/reference.hpp"
#include "tests/reference/meshes.hpp"

using namespace rayclock;

namespace {

/// Returns targets on the surface: every vertex, and two points of each triangle's edges, rounded and so
/// slightly off the edge.
std::vector<glm::dvec3> seams(const Scene& scene, MeshRng& rng) {
    std::vector<glm::dvec3> points = scene.vertices;
    for (const Triangle& t : scene.triangles) {
        points.push_back(0.5 * (scene.vertices[t.vertex[0]] + scene.vertices[t.vertex[1]]));
        points.push_back(
            glm::mix(scene.vertices[t.vertex[1]], scene.vertices[t.vertex[2]], uniform(rng, 0, 1)));
    }
    return points;
}

}   // namespace

TEST_CASE("no ray leaves a closed sphere", "[reference][watertight]") {
    struct Case {
        int level;
        double radius;
        glm::dvec3 centre;
    };
    const auto& [level, radius, centre] = GENERATE(
        Case{0, 1, glm::dvec3(0)}, Case{2, 1, glm::dvec3(0)}, Case{4, 1, glm::dvec3(0)},
        Case{4, 1e-6, glm::dvec3(0)}, Case{4, 1e6, glm::dvec3(0)}, Case{4, 0.3, glm::dvec3(1e4, -1e5, 17)});
    CAPTURE(level, radius, centre.x);
    const Scene scene = sphere(level, radius, centre);
    const Reference reference(scene);
    MeshRng rng(4711);
    int leaks = 0, rays = 0;
    const std::vector<glm::dvec3> targets = seams(scene, rng);
    const auto shoot = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        ++rays;
        leaks += reference.trace(origin, direction).primitive == no_primitive;
    };
    for (const glm::dvec3& target : targets) {
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 origin = centre + random_point(rng, 0.3) * radius;
            shoot(origin, target - origin);
        }
        shoot(centre, target - centre);
        const glm::dvec3 outward = glm::normalize(target - centre);
        const glm::dvec3 outside = target + (outward + random_point(rng, 0.5)) * (3 * radius);
        shoot(outside, target - outside);
    }
    for (int i = 0; i < 20000; ++i) shoot(centre + random_point(rng, 0.3) * radius, random_direction(rng));
    CHECK(rays > 20000);
    CHECK(leaks == 0);
}

TEST_CASE("no ray leaves a closed box with faces on lattice planes", "[reference][watertight]") {
    const Scene scene = box({-1, -1, -1}, {1, 1, 1});
    const Reference reference(scene);
    int leaks = 0;
    // Lattice origins and directions: most rays run exactly along diagonals, edges and corners.
    for (int o = 0; o < 27; ++o)
        for (int d = 0; d < 125; ++d) {
            const glm::dvec3 origin = glm::dvec3(o % 3 - 1, o / 3 % 3 - 1, o / 9 - 1) * 0.5;
            const glm::dvec3 direction(d % 5 - 2, d / 5 % 5 - 2, d / 25 - 2);
            if (direction == glm::dvec3(0)) continue;
            leaks += reference.trace(origin, direction).primitive == no_primitive;
        }
    CHECK(leaks == 0);
}
