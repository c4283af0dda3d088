#pragma once
// Leads the finished picture's tracer along the rays of another tracer of the same scene.
//
// A machine rounds: directions, points, materials. Each rounding moves its rays a little, and the paths of
// two tracers part at the next edge. A RefSteer hands the tracer the other one's rays, one by one, so that
// the tracer judges every step of the same path by its own rules: what the ray meets, which lights count,
// what is in their way, which bounces leave and where. sim/judge/cause/guide.hpp is the one that follows a
// machine.
//
// All vectors are in the tracer's space (RefUnitSpace), directions are unit vectors.
#include <array>

#include "sim/judge/reference/ray.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Where a ray met something.
struct RefSurface {
    glm::dvec3 position{0};
    glm::dvec3 flat{0};     ///< unit, geometric, on the side that the ray came from
    glm::dvec3 normal{0};   ///< unit, as it is shaded, on the same side
    glm::dvec3 colour{0};
    const Material* material = nullptr;
    std::uint32_t primitive = no_primitive;
    bool is_inside = false;   ///< the ray came from the inside
};

/// A bounce as the tracer would send it.
struct RefBounce {
    enum class Kind { reflected, refracted } kind = Kind::reflected;
    const RefSurface& surface;
    glm::dvec3 direction{0};
    double weight = 0;
    bool weighs_enough = true;   ///< not below the threshold
    double cosine = 0;           ///< between the normal and the way back
    double ratio = 1;            ///< refracted: index on the ray's side over that on the other
};

/// Each function is told what the tracer found by itself, and says how it is to go on.
class RefSteer {
public:
    virtual ~RefSteer() = default;

    /// A sample of the pixel begins with a camera ray.
    virtual void begin_sample(std::uint32_t sample, RefPath& path) = 0;
    /// The samples of the pixel end here. `difference`: the largest of a channel among them; `own`: the
    /// tracer would end them.
    virtual bool ends(std::uint32_t samples, double difference, bool own) = 0;

    virtual RefClosest met(const RefPath& path, const RefClosest& own) = 0;
    /// Normals of a smooth triangle's corners, and the weights by which they are interpolated.
    virtual void round_corners(RefClosest& hit, std::array<glm::dvec3, 3>& normals) = 0;
    /// A plane's colour at the hit.
    virtual glm::dvec3 square(const RefClosest& hit, const Material& material, const glm::dvec3& own) = 0;
    /// The point from which rays leave.
    virtual void place(RefSurface& surface) = 0;

    /// Whether a light counts before anything is asked. `side`: of the flat normal; `lambert`: of the normal.
    virtual bool counts(std::size_t light, double side, double lambert) = 0;
    /// Whether something is in the way from the surface to a light that counts.
    virtual bool is_blocked(std::size_t light, const RefPath& path, double distance, bool own) = 0;

    virtual bool is_total(const RefSurface& surface, double ratio, double cosine, bool own) = 0;
    /// Whether a bounce goes; then what it meets is asked next, between enter() and leave().
    virtual bool goes(RefBounce& bounce) = 0;
    virtual void enter(RefBounce::Kind kind) = 0;
    virtual void leave() = 0;
};

}   // namespace rayclock
