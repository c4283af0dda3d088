#pragma once
// A ray in the form of the slab test, which engines of boxes and of planes take.
#include "model/core/payloads.hpp"

namespace rayclock {

/// The part of a ray that the slab test uses; computed once per ray.
struct BoxRay {
    Vec3i o{};   ///< with B fraction bits if the chip shades
    std::array<std::uint32_t, 3> neg{}, recip{}, len{};
};
template <class Moving> BoxRay box_ray(const Moving& ray) {   ///< a Ray or a Change
    return {ray.o, {ray.d[0] < 0, ray.d[1] < 0, ray.d[2] < 0}, ray.recip, ray.len};
}

}   // namespace rayclock
