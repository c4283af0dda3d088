#pragma once
// The judge of a single ray's answer.
#include "model/core/payloads.hpp"
#include "sim/judge/oracle/solids.hpp"

namespace rayclock {

class PlacedWorld;

/// The triangles that may have holes, by their numbers in the scene.
class Cutouts {
public:
    virtual ~Cutouts() = default;
    /// True if the primitive is a triangle with a texture and a cut-off.
    virtual bool has_holes(std::uint32_t primitive) const = 0;
    /// True if the light has already passed a hole of such a triangle on its way.
    virtual bool is_passed(std::uint32_t primitive) const = 0;
};

/// Returns the fault of a ray's answer, or null. These are judged exactly: the primitive and its side; t, u
/// and v of triangles and planes, rounded as payloads.hpp states; whether anything other than a hole blocks a
/// shadow ray; whether a sphere is hit. The t of a sphere may exceed the true one by the bound in
/// model/unit/tri/any_primitive.hpp. So the sphere may lose to a primitive that is farther by less than
/// this bound.
///
/// The answer to a ray to or from a light may report any cut-out in its way, not only the nearest. `cutouts`:
/// null if no triangle has holes.
const char* judge_answer(const oracle::Solids& solids, const Config& config, const Ray& ray,
                         const Closest& answer, const Cutouts* cutouts = nullptr);

/// The same with two levels. The ray is rounded for each instance.
const char* judge_answer(const PlacedWorld& world, const Config& config, const Ray& ray,
                         const Closest& answer, const Cutouts* cutouts = nullptr);

/// Converts a ray to the oracle's form.
oracle::SolidRay solid_ray(const Ray& ray, const Config& config);

}   // namespace rayclock
