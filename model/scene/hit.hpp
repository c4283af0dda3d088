#pragma once
#include <cstdint>
#include <vector>

#include "model/scene/camera.hpp"

namespace rayclock {

constexpr std::uint32_t no_primitive = 0xffff'ffffu;

/// What a primary ray found, in the terms of the scene as given; produced by every engine.
struct Hit {
    std::uint32_t primitive = no_primitive;   ///< number in the scene (model/scene/scene.hpp), or
                                              ///< no_primitive
    float depth = 0;                          ///< distance from the eye, scene units
    float u = 0, v = 0;   ///< of a triangle: barycentric weights of the second and third vertex; of a plane:
                          ///< how many of its u and v from its point (of a
                          ///< machine's: of its sides on the lattice, from its point there); of a sphere: 0
    friend bool operator==(const Hit&, const Hit&) = default;
};

/// One hit per pixel, row by row from the top.
struct HitFrame {
    FrameSize size;
    std::vector<Hit> hits;
};

}   // namespace rayclock
