#pragma once
// The two tests of the reference tracer that all scenes need. One tests a ray against the four boxes of a
// node, the other against the two triangles of a block. Both work in the tracer's own space, in which the
// scene lies within -1..1.
//
// No hit may be lost: if the triangle test accepts a triangle, the box test accepts each box around it.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "model/scene/hit.hpp"
#include "sim/judge/reference/hierarchy.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace rayclock {

typedef double RefDouble2 __attribute__((vector_size(16)));

/// Two triangles: coordinate [vertex][axis], one lane each.
struct RefBlock {
    RefDouble2 vertex[3][3];
    std::uint32_t primitive[ref_block_size];
};

/// The closest hit so far. `depth` is along the unit direction. For a triangle, u and v are the weights of
/// the second and third vertex. For a plane, they count its sides u and v from its point. For a sphere they
/// have no meaning.
struct RefClosest {
    double depth = std::numeric_limits<double>::infinity();
    double u = 0, v = 0;
    std::uint32_t primitive = no_primitive;

    /// Returns true if another hit replaces this one. At equal depth the lower primitive wins.
    bool yields_to(double other, std::uint32_t number) const {
        return other > 0 && (other < depth || (other == depth && number < primitive));
    }
};

/// A ray, and the primitive that it starts on, if any.
struct RefPath {
    glm::dvec3 from{0}, direction{0, 0, 1};   ///< direction: a unit vector
    std::uint32_t left = no_primitive;
    bool is_inside = false;   ///< starts on a sphere and passes through its inside
    double travelled = 0;     ///< length of the path from the eye to `from`
    int holes = 0;            ///< of textures, which the ray has passed since its last bounce
};

/// float_below() returns the largest float not above x, float_above() the smallest one not below.
inline float float_below(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
inline float float_above(double x) { return -float_below(-x); }

/// Returns bit i set if lane i of the comparison holds.
template <typename Mask> int lanes(Mask mask) {
#if defined(__SSE2__)
    if constexpr (sizeof(mask[0]) == 4)
        return _mm_movemask_ps(std::bit_cast<__m128>(mask));
    else
        return _mm_movemask_pd(std::bit_cast<__m128d>(mask));
#else
    int bits = 0;
    for (std::size_t i = 0; i < sizeof(mask) / sizeof(mask[0]); ++i) bits |= (mask[i] != 0) << i;
    return bits;
#endif
}

/// A ray, prepared for both tests. `direction` must be a unit vector.
struct RefRay {
    // For the triangle test: the axes with the direction's largest component last, and the shear that turns
    // the direction to (0, 0, 1).
    int axis[3];
    RefDouble2 origin[3];
    RefDouble2 shear_x, shear_y;
    double scale_z;
    // For the box test.
    int near_plane[3], far_plane[3];
    RefFloat4 near_origin[3], far_origin[3], inverse[3];

    RefRay(const glm::dvec3& from, const glm::dvec3& direction);
};

// The relative error of one computed slab distance fl(fl(p - o) * fl(1/d)) is at most 3 roundings of 2^-24.
// So near and far together are within 6 (Ize 2013, "Robust BVH ray traversal", section 3); 8 leaves room.
constexpr float slab_margin = 1.0f + 4.0f * std::numeric_limits<float>::epsilon();

// Translation and shear move each vertex by at most about 5 roundings of 2^-53 of its distance from the
// origin. Boxes are widened by 16, at the distance of the far corner of the scene.
constexpr double vertex_margin = 8.0 * std::numeric_limits<double>::epsilon();

inline RefRay::RefRay(const glm::dvec3& from, const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    axis[0] = (z + 1) % 3;
    axis[1] = (z + 2) % 3;
    axis[2] = z;
    for (int i = 0; i < 3; ++i) origin[i] = RefDouble2{} + from[axis[i]];
    shear_x = RefDouble2{} + direction[axis[0]] / direction[z];
    shear_y = RefDouble2{} + direction[axis[1]] / direction[z];
    scale_z = 1.0 / direction[z];

    const glm::dvec3 reach = glm::abs(from);
    const double margin = vertex_margin * (1.0 + std::max(reach.x, std::max(reach.y, reach.z)));
    for (int a = 0; a < 3; ++a) {
        // Use the sign bit: 1 / -0 is -infinity, and the planes must be swapped with it.
        const bool down = std::signbit(direction[a]);
        near_plane[a] = 2 * a + (down ? 1 : 0);
        far_plane[a] = 2 * a + (down ? 0 : 1);
        // Round the origin away from the near plane's side and towards the far plane's. So the float box can
        // only become larger.
        const float above = float_above(from[a] + margin), below = float_below(from[a] - margin);
        near_origin[a] = RefFloat4{} + (down ? below : above);
        far_origin[a] = RefFloat4{} + (down ? above : below);
        inverse[a] = RefFloat4{} + static_cast<float>(1.0 / direction[a]);
    }
}

/// Returns the lanes of the boxes that the ray enters at a distance of at most `limit`. `near` receives their
/// entry distances.
///
/// Slab test (Kay, Kajiya 1986). A zero direction component makes the distances infinite. The origin's margin
/// keeps the ray off the plane itself, where they would be 0 * infinity. For a ray beyond the range of float
/// they may be NaN. Then the comparisons keep their second operand, so that the plane excludes nothing.
inline int boxes_entered(const RefNode& node, const RefRay& ray, float limit, RefFloat4& near) {
    const auto larger = [](RefFloat4 a, RefFloat4 b) { return a > b ? a : b; };
    const auto smaller = [](RefFloat4 a, RefFloat4 b) { return a < b ? a : b; };
    near = RefFloat4{};
    RefFloat4 far = RefFloat4{} + std::numeric_limits<float>::infinity();
    for (int a = 0; a < 3; ++a) {
        near = larger((node.plane[ray.near_plane[a]] - ray.near_origin[a]) * ray.inverse[a], near);
        far = smaller((node.plane[ray.far_plane[a]] - ray.far_origin[a]) * ray.inverse[a], far);
    }
    far = smaller(far * slab_margin, RefFloat4{} + limit);
    return lanes(near <= far);
}

/// Updates `closest` by the block's hits with depth > 0; at equal depth the lower primitive wins. A ray does
/// not hit the triangle that it starts on.
///
/// Watertight test (Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection") in double precision. It
/// translates and shears so that the ray runs along z from the origin. Then it tests on which side of each
/// edge the origin lies. A vertex has the same image in all of its triangles. A computed edge function never
/// has the wrong sign, because rounding is monotonic: fl(p) > fl(q) only if p > q. It can only be 0 for a
/// tiny value. Zero counts as inside for both neighbours, so no ray slips through the edges of a closed
/// surface.
///
/// Both sides are hit. A triangle whose image has no area is not hit. A triangle without area of its own may
/// get some by the rounding of its image. Then it is needed, because the images of its neighbours have moved
/// apart by as much.
inline void test_block(const RefBlock& block, const RefRay& ray, RefClosest& closest,
                       std::uint32_t start = no_primitive) {
    RefDouble2 x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
        z[i] = block.vertex[i][ray.axis[2]] - ray.origin[2];
        x[i] = block.vertex[i][ray.axis[0]] - ray.origin[0] - ray.shear_x * z[i];
        y[i] = block.vertex[i][ray.axis[1]] - ray.origin[1] - ray.shear_y * z[i];
    }
    const RefDouble2 e0 = x[2] * y[1] - y[2] * x[1];
    const RefDouble2 e1 = x[0] * y[2] - y[0] * x[2];
    const RefDouble2 e2 = x[1] * y[0] - y[1] * x[0];
    const auto left = (e0 < 0.0) | (e1 < 0.0) | (e2 < 0.0);
    const auto right = (e0 > 0.0) | (e1 > 0.0) | (e2 > 0.0);
    const RefDouble2 det = e0 + e1 + e2;
    const int inside = ~lanes(left & right) & lanes(det != 0.0);
    for (int i = 0; i < ref_block_size; ++i) {
        if ((inside >> i & 1) == 0) continue;
        const double depth = (e0[i] * z[0][i] + e1[i] * z[1][i] + e2[i] * z[2][i]) / det[i] * ray.scale_z;
        const bool closer =
            depth < closest.depth || (depth == closest.depth && block.primitive[i] < closest.primitive);
        if (depth > 0 && closer && block.primitive[i] != start)
            closest = {depth, e1[i] / det[i], e2[i] / det[i], block.primitive[i]};
    }
}

}   // namespace rayclock
