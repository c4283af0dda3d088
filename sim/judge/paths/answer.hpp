#pragma once
// The judge of a single ray's answer.
#include "model/core/payloads.hpp"
#include "sim/judge/oracle/solids.hpp"

namespace rayclock {

class PlacedWorld;

/// Returns the fault of a ray's answer, or null. These are judged exactly: the primitive and its side; t, u
/// and v of triangles and planes, rounded as payloads.hpp states; whether a shadow ray is blocked; whether a
/// sphere is hit. The t of a sphere may exceed the true one by the bound in model/unit/isect/any.hpp. So the
/// sphere may lose to a primitive that is farther by less than this bound.
const char* judge_answer(const oracle::Solids& solids, const Config& config, const Ray& ray,
                         const Closest& answer);

/// The same with two levels. The ray is rounded for each instance.
const char* judge_answer(const PlacedWorld& world, const Config& config, const Ray& ray,
                         const Closest& answer);

/// Converts a ray to the oracle's form.
oracle::SolidRay solid_ray(const Ray& ray, const Config& config);

}   // namespace rayclock
