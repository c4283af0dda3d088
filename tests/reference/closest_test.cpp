// The reference tracer finds the closest triangle. It is compared with a long-double loop over all triangles.
// It must also equal, bit by bit, a loop over all triangles with its own triangle test, so the hierarchy
// loses nothing.
#include <catch2/catch.hpp>

#include "sim/judge/reference/ray.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/reference/unit_space.hpp"
#include "tests/reference/meshes.hpp"
#include "tests/reference/oracle.hpp"

using namespace rayclock;

namespace {

struct TestRay {
    glm::dvec3 origin, direction;
};

/// Draws a ray to a vertex, to a point of an edge or anywhere. It starts far around the scene or close by,
/// where the relative margins of the box test are smallest.
TestRay draw_ray(MeshRng& rng, const Scene& scene, double scale, const glm::dvec3& offset) {
    const auto& vertex = scene.triangles[rng() % scene.triangles.size()].vertex;
    const glm::dvec3 targets[] = {
        random_point(rng) * scale + offset, scene.vertices[vertex[rng() % 3]],
        glm::mix(scene.vertices[vertex[0]], scene.vertices[vertex[1]], uniform(rng, 0, 1))};
    const glm::dvec3 target = targets[rng() % 3];
    const bool close_by = rng() % 3 == 0;
    const glm::dvec3 origin =
        close_by ? target + random_direction(rng) * (1e-4 * scale) : random_point(rng, 3) * scale + offset;
    return {origin, target - origin};
}

/// Returns an empty string if `hit` is correct: its triangle is met there, and no triangle that is surely met
/// lies before it. Weights closer to 0 than 1e-7 are neither surely inside nor outside. Rounding the
/// direction to double moves a ray by 2^-53 of its length. This is below 1e-7 of a triangle unless it is far
/// thinner than 1e-8 of that length.
std::string judge(const Scene& scene, const TestRay& ray, const Hit& hit) {
    constexpr long double unsure = 1e-7L;
    long double depth = std::numeric_limits<long double>::infinity();
    if (hit.primitive != no_primitive) {
        const PlaneHit own = plane_hit(scene, hit.primitive, ray.origin, ray.direction);
        if (!own.crosses || own.inside < -unsure) return "hits a triangle that the ray does not meet";
        if (std::abs(own.depth - hit.depth) > 1e-6L * own.depth) return "depth is wrong";
        if (std::abs(own.u - hit.u) > 1e-6L || std::abs(own.v - hit.v) > 1e-6L) return "weights are wrong";
        depth = own.depth;
    }
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const PlaneHit other = plane_hit(scene, i, ray.origin, ray.direction);
        if (other.crosses && other.inside > unsure && other.depth > 0 && other.depth < depth * (1 - 1e-9L))
            return "triangle " + std::to_string(i) + " is closer";
    }
    return "";
}

Hit loop_over_all(const Scene& scene, const TestRay& ray) {
    const RefUnitSpace space(scene);
    const glm::dvec3 size = glm::abs(ray.direction);
    const glm::dvec3 scaled = ray.direction / std::max(size.x, std::max(size.y, size.z));
    const RefRay prepared(space(ray.origin), glm::normalize(scaled));
    RefClosest best;
    // In reverse, so that a tie decided by the order of visits becomes visible.
    for (std::size_t i = scene.triangles.size(); i-- > 0;) {
        RefBlock block{};
        for (int lane = 0; lane < ref_block_size; ++lane) {
            block.primitive[lane] = static_cast<std::uint32_t>(i);
            for (int v = 0; v < 3; ++v)
                for (int k = 0; k < 3; ++k)
                    block.vertex[v][k][lane] = space(scene.vertices[scene.triangles[i].vertex[v]])[k];
        }
        test_block(block, prepared, best);
    }
    if (best.primitive == no_primitive) return {};
    return {best.primitive, static_cast<float>(best.depth / space.scale), static_cast<float>(best.u),
            static_cast<float>(best.v)};
}

}   // namespace

TEST_CASE("closest hit in a soup equals a long-double loop over all triangles", "[reference]") {
    struct Case {
        int triangles;
        double size, scale;
        glm::dvec3 offset;
    };
    const auto& [triangles, size, scale, offset] =
        GENERATE(Case{1, 1, 1, glm::dvec3(0)}, Case{2, 1, 1, glm::dvec3(0)}, Case{3, 1, 1, glm::dvec3(0)},
                 Case{9, 0.5, 1, glm::dvec3(0)}, Case{300, 0.2, 1, glm::dvec3(0)},
                 Case{1500, 0.05, 1, glm::dvec3(0)}, Case{300, 0.2, 1e-6, glm::dvec3(0)},
                 Case{300, 0.2, 1e6, glm::dvec3(0)}, Case{300, 0.2, 1e-30, glm::dvec3(0)},
                 Case{300, 0.2, 1e30, glm::dvec3(0)}, Case{300, 0.2, 1, glm::dvec3(1e6, -3e5, 7e5)});
    CAPTURE(triangles, size, scale, offset.x);
    MeshRng rng(20261121);
    const Scene scene = soup(rng, triangles, size, scale, offset);
    const Reference reference(scene);
    int hits = 0;
    for (int i = 0; i < 1500; ++i) {
        const TestRay ray = draw_ray(rng, scene, scale, offset);
        const Hit hit = reference.trace(ray.origin, ray.direction);
        hits += hit.primitive != no_primitive;
        CAPTURE(i, hit.primitive, hit.depth);
        REQUIRE(judge(scene, ray, hit) == "");
        REQUIRE(hit == loop_over_all(scene, ray));
    }
    CHECK(hits > 200);
}

TEST_CASE("triangles without area hide nothing", "[reference]") {
    MeshRng rng(7);
    Scene scene = soup(rng, 200, 0.2);
    const auto sound = static_cast<std::uint32_t>(scene.triangles.size());
    for (std::uint32_t i = 0; i < sound; ++i) {
        const auto v = scene.triangles[i].vertex;
        scene.triangles.push_back({{v[0], v[0], v[0]}, 0});   // a point
        scene.triangles.push_back({{v[0], v[1], v[0]}, 0});   // a segment
    }
    const auto repeated = static_cast<std::uint32_t>(scene.triangles.size());
    // Collinear in exactly representable coordinates. Their rounded images need not be collinear.
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 a(rng() % 8, rng() % 8, rng() % 8), step(rng() % 4, rng() % 4, 1);
        add_triangle(scene, a / 8.0, (a + step) / 8.0, (a + 2.0 * step) / 8.0);
    }
    const Reference reference(scene);
    for (int i = 0; i < 5000; ++i) {
        const TestRay ray = draw_ray(rng, scene, 1, glm::dvec3(0));
        const Hit hit = reference.trace(ray.origin, ray.direction);
        CAPTURE(i, hit.primitive);
        REQUIRE((hit.primitive < sound || hit.primitive >= repeated));
        if (hit.primitive < sound || hit.primitive == no_primitive)
            REQUIRE(judge(scene, ray, hit) == "");
        else
            REQUIRE(distance_to_edges(scene, hit.primitive, ray.origin, ray.direction) < 1e-14L);
    }
}

TEST_CASE("of equally deep triangles the lowest number is hit, wherever it lies in the hierarchy",
          "[reference]") {
    MeshRng rng(99);
    Scene scene = soup(rng, 40, 0.4);
    std::vector<Triangle> copies;
    for (int i = 0; i < 25; ++i) copies.insert(copies.end(), scene.triangles.begin(), scene.triangles.end());
    for (std::size_t i = copies.size(); i > 1; --i) std::swap(copies[i - 1], copies[rng() % i]);
    scene.triangles = copies;
    const Reference reference(scene);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const TestRay ray = draw_ray(rng, scene, 1, glm::dvec3(0));
        const Hit hit = reference.trace(ray.origin, ray.direction);
        REQUIRE(hit == loop_over_all(scene, ray));
        if (hit.primitive == no_primitive) continue;
        ++hits;
        const auto first = std::find_if(copies.begin(), copies.end(), [&](const Triangle& t) {
            return t.vertex == copies[hit.primitive].vertex;
        });
        REQUIRE(hit.primitive == first - copies.begin());
    }
    CHECK(hits > 500);
}
