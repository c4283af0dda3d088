#pragma once
// The values of one pixel's rays: their geometry, and the boxes and primitives that they meet. Timing is not
// part of these values.
#include <vector>

#include "model/core/payloads.hpp"
#include "model/layout/memory_image.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// The test of one primitive.
struct TestValues {
    std::uint32_t half_line = 0;
    std::uint32_t prim = 0;   ///< index in the scene; no_primitive if the test found no closer hit
    bool closer = false;      ///< the primitive became the closest hit
    std::uint32_t t = 0;      ///< distance of that hit
};
/// The visit of one node.
struct VisitValues {
    std::uint32_t line = 0;
    int parent = -1;             ///< the visit that led to this node; -1 for the first
    int children = 0, met = 0;   ///< boxes in the node, and boxes that the ray meets
    std::vector<TestValues> tests;
    std::uint32_t dropped = 0;   ///< groups of siblings dropped because they lie behind the hit
};
/// One ray of a pixel.
struct RayValues {
    Ray ray;
    RayPurpose purpose{};
    int parent = -1;   ///< the ray whose hit is an end of this one; -1: the pixel
    int depth = 0;     ///< bounces; a ray through a hole has its parent's
    Closest hit;
    std::vector<VisitValues> visits;
};

/// Returns all rays of pixel (x, y), in the order in which the machine traces them. In a stream, (x, y) is
/// the ray with the number y * width + x.
std::vector<RayValues> rays_of_pixel(const MemoryImage& image, const Frame& frame, const Config& config,
                                     std::uint32_t x, std::uint32_t y);

}   // namespace rayclock
