#pragma once
// Hits of primary rays, in the terms of the scene as given.
#include <cstdint>
#include <vector>

#include "model/scene/camera.hpp"

namespace rayclock {

constexpr std::uint32_t no_primitive = 0xffff'ffffu;

/// The hit of a primary ray, in the terms of the scene as given. Every engine produces it.
struct Hit {
    /// Number in the scene (model/scene/scene.hpp), or no_primitive.
    std::uint32_t primitive = no_primitive;
    float depth = 0;   ///< distance from the eye, scene units
    /// For a triangle: barycentric weights of the second and third vertex. For a plane: multiples of its u
    /// and v from its point; a machine counts the plane's sides on the lattice, from its point there. For a
    /// sphere: 0.
    float u = 0, v = 0;
    friend bool operator==(const Hit&, const Hit&) = default;
};

/// One hit per pixel, row by row from the top.
struct HitFrame {
    FrameSize size;
    std::vector<Hit> hits;
};

}   // namespace rayclock
