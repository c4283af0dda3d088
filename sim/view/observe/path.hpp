#pragma once
// What the rays of one pixel do, in values: where they go, which boxes and primitives they meet. When they do
// it is the machine's business.
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/core/payloads.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

struct TestValues {
    std::uint32_t half_line = 0;
    std::uint32_t prim = 0;   ///< of the scene; of a test that is not closer: no_primitive
    bool closer = false;      ///< it became the closest hit
    std::uint32_t t = 0;      ///< of that hit
};
struct VisitValues {
    std::uint32_t line = 0;
    int parent = -1;             ///< the visit from which this node was reached; -1: the first
    int children = 0, met = 0;   ///< boxes in the node; those that the ray meets
    std::vector<TestValues> tests;
    std::uint32_t dropped = 0;   ///< groups of siblings that lay behind the hit
};
struct RayValues {
    Ray ray;
    RayPurpose purpose{};
    int parent = -1;   ///< the ray at whose hit this one begins or ends; -1: the pixel
    int depth = 0;     ///< bounces
    Closest hit;
    std::vector<VisitValues> visits;
};

std::vector<RayValues> rays_of_pixel(const MemoryImage& image, const Frame& frame, const Config& config,
                                     std::uint32_t x, std::uint32_t y);

}   // namespace rayclock
