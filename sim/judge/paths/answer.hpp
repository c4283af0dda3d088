#pragma once
#include "model/core/payloads.hpp"
#include "sim/judge/oracle/solids.hpp"

namespace rayclock {

class PlacedWorld;

/// What is wrong with a ray's answer, or null. Exact: which primitive is met, from which side, t, u and v of
/// triangles and planes as payloads.hpp promises their rounding; whether a shadow ray is blocked. A sphere is
/// met or not exactly; its t lies between the true one and the bound of model/unit/isect/any.hpp above it,
/// and what is closer by less than that may win.
const char* judge_answer(const oracle::Solids& solids, const Config& config, const Ray& ray,
                         const Closest& answer);

/// The same in two levels: which instance's primitive, seen by the ray as it was rounded for each.
const char* judge_answer(const PlacedWorld& world, const Config& config, const Ray& ray,
                         const Closest& answer);

/// The ray as the oracle takes it.
oracle::SolidRay solid_ray(const Ray& ray, const Config& config);

}   // namespace rayclock
