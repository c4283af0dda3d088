// The box test alone. It never rejects a ray that touches the box or misses it by a few roundings of double
// precision. The triangle test may see a vertex there. It rejects rays that miss by more.
#include <catch2/catch.hpp>

#include "sim/judge/reference/ray.hpp"
#include "tests/reference/meshes.hpp"

using namespace rayclock;

namespace {

constexpr float far_away = std::numeric_limits<float>::infinity();

/// A box within -1..1 in lane 2 of a node; the other lanes are absent children. Sometimes it is flat along an
/// axis, or has a plane next to 0. Floats are so dense there that no rounding to float hides a missing
/// margin.
struct OneBox {
    glm::dvec3 lo, hi;
    RefNode node{};

    explicit OneBox(MeshRng& rng) {
        glm::dvec3 a = random_point(rng);
        const glm::dvec3 b = random_point(rng);
        for (int k = 0; k < 3; ++k) {
            if (rng() % 4 == 0) a[k] = (static_cast<double>(rng() % 9) - 4) * 0x1p-53;
            lo[k] = static_cast<float>(std::min(a[k], b[k]));
            hi[k] = rng() % 4 == 0 ? lo[k] : static_cast<float>(std::max(a[k], b[k]));
            node.plane[2 * k] = RefFloat4{} + far_away;
            node.plane[2 * k + 1] = RefFloat4{} - far_away;
            node.plane[2 * k][2] = static_cast<float>(lo[k]);
            node.plane[2 * k + 1][2] = static_cast<float>(hi[k]);
        }
    }
    bool entered(const glm::dvec3& origin, const glm::dvec3& direction, float limit = far_away) const {
        RefFloat4 near;
        const int lanes = boxes_entered(node, RefRay(origin, direction), limit, near);
        REQUIRE((lanes == 0 || lanes == 4));
        return lanes != 0;
    }
};

/// Draws a point of the surface, on a face, an edge or a corner. Sets `outward` for the faces that contain
/// it.
glm::dvec3 surface_point(MeshRng& rng, const OneBox& box, glm::dvec3& outward) {
    glm::dvec3 p;
    outward = glm::dvec3(0);
    const auto forced = rng() % 3;
    for (unsigned k = 0; k < 3; ++k) {
        const auto choice = k == forced ? rng() % 2 : rng() % 4;
        p[k] = choice == 0 ? box.lo[k] : choice == 1 ? box.hi[k] : uniform(rng, box.lo[k], box.hi[k]);
        if (choice < 2) outward[k] = choice == 0 ? -1 : 1;
    }
    return p;
}

}   // namespace

TEST_CASE("rays that touch a box, or pass it by a few roundings, enter it", "[reference]") {
    MeshRng rng(11);
    for (int i = 0; i < 200000; ++i) {
        const OneBox box(rng);
        glm::dvec3 outward;
        const glm::dvec3 target = surface_point(rng, box, outward);
        // Parallel to the faces of the target, so that a small miss stays a miss.
        glm::dvec3 direction = random_direction(rng);
        for (int k = 0; k < 3; ++k)
            if (outward[k] != 0 && rng() % 4 != 0) direction[k] = rng() % 2 ? 0.0 : -0.0;
        if (direction == glm::dvec3(0)) continue;
        direction = glm::normalize(direction);
        const double distance = rng() % 8 == 0 ? 0.0 : uniform(rng, 0, 4);
        const double reach = 1 + distance;
        const double passing = static_cast<double>(rng() % 6) * 0x1p-53 * reach;
        const glm::dvec3 origin = target - distance * direction + passing * outward;
        CAPTURE(i, distance, passing, direction.x, direction.y, direction.z);
        REQUIRE(box.entered(origin, direction));
    }
}

TEST_CASE("rays that pass a box, point away from it or end before it are turned away", "[reference]") {
    MeshRng rng(12);
    for (int i = 0; i < 20000; ++i) {
        const OneBox box(rng);
        glm::dvec3 outward;
        const glm::dvec3 target = surface_point(rng, box, outward);
        glm::dvec3 along = random_direction(rng);
        const glm::dvec3 off = target + 1e-5 * outward;
        // Outward or parallel in every relevant component: the ray never meets the box again.
        for (int k = 0; k < 3; ++k)
            if (outward[k] != 0) along[k] = rng() % 2 ? 0.0 : std::abs(along[k]) * outward[k];
        if (glm::length(along) < 1e-3) continue;
        along = glm::normalize(along);
        CAPTURE(i);
        REQUIRE_FALSE(box.entered(off, along));
        const glm::dvec3 outside = target + 2.0 * outward;
        const glm::dvec3 inward = glm::normalize(target - outside);
        REQUIRE(box.entered(outside, inward, 2 * static_cast<float>(glm::length(outward))));
        REQUIRE_FALSE(box.entered(outside, inward, 1.99f * static_cast<float>(glm::length(outward))));
    }
}
