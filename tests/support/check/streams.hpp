#pragma once
// Streams of random rays, for tests.
#include <vector>

#include "model/scene/scene.hpp"
#include "model/compile/stream.hpp"

namespace rayclock::test {

/// Returns rays of all kinds in and around a scene: closest hits, any hits, and any hits up to a point. Some
/// have directions along an axis.
std::vector<StreamRay> random_rays(const Scene& scene, std::size_t count, std::uint64_t seed);

}   // namespace rayclock::test
