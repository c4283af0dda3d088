// Streams of random rays, for tests.
#include "tests/support/check/streams.hpp"

#include <cmath>

#include "model/base/rng.hpp"

namespace rayclock::test {

std::vector<StreamRay> random_rays(const Scene& scene, std::size_t count, std::uint64_t seed) {
    glm::dvec3 low{1e300}, high{-1e300};
    for (const auto& p : scene.vertices)
        low = glm::min(low, glm::dvec3(p)), high = glm::max(high, glm::dvec3(p));
    if (!scene.spheres.empty() || !scene.planes.empty()) low = bounds(scene).lo, high = bounds(scene).hi;
    Rng dice(seed);
    const auto unit = [&] { return double(dice.next() >> 11) * 0x1p-53; };
    const auto point = [&] { return low + glm::dvec3(unit(), unit(), unit()) * (high - low); };
    std::vector<StreamRay> rays;
    for (std::size_t i = 0; i < count; ++i) {
        StreamRay ray;
        ray.origin = point();
        ray.direction = point() - ray.origin;
        const int axis = dice.below(6);
        if (axis < 3) {
            ray.direction = {};
            ray.direction[axis] = i % 2 ? 1 : -1;
        }
        ray.any_hit = dice.below(2);
        if (dice.below(2)) ray.t_max = unit();
        rays.push_back(ray);
    }
    return rays;
}

}   // namespace rayclock::test
