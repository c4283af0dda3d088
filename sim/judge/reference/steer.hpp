#pragma once
// Guides the tracer of finished pictures along the rays of another tracer of the same scene.
//
// A machine rounds directions, points and materials. Each rounding moves its rays a little, and the paths of
// two tracers separate at the next edge. A RefSteer hands the tracer the other one's rays, one by one. So the
// tracer judges every step of the same path by its own rules: the hit, the lights that count, their blockers,
// and the bounces. The guide in sim/judge/cause/guide.hpp follows a machine.
//
// All vectors are in the tracer's space (RefUnitSpace), and directions are unit vectors.
#include <array>

#include "model/scene/scene.hpp"
#include "sim/judge/reference/ray.hpp"

namespace rayclock {

/// The surface at a hit.
struct RefSurface {
    glm::dvec3 position{0};
    glm::dvec3 flat{0};     ///< unit, geometric, on the side that the ray came from
    glm::dvec3 normal{0};   ///< unit, shading normal, on the same side
    glm::dvec3 colour{0};
    const Material* material = nullptr;
    std::uint32_t primitive = no_primitive;
    bool is_inside = false;   ///< the ray came from the inside
    double travelled = 0;     ///< length of the path from the eye
    bool is_hole = false;     ///< the texture has a hole there
};

/// The picture of a textured surface at a hit.
struct RefTexel {
    glm::dvec2 st{0};
    double detail = 0;     ///< texture_detail() of the surface
    double distance = 0;   ///< length of the path from the eye, in scene units
    double spread = 0;     ///< sample_spread() of the picture
    double cosine = 1;     ///< between the reversed ray and the shading normal
    glm::dvec3 colour{0};
    bool is_hole = false;   ///< the picture's alpha is below the material's cut-off
};

/// A bounce that the tracer would send.
struct RefBounce {
    enum class Interaction { reflected, refracted, passed } interaction = Interaction::reflected;
    const RefSurface& surface;
    glm::dvec3 direction{0};
    double weight = 0;
    bool weighs_enough = true;   ///< not below the threshold
    double cosine = 0;           ///< between the normal and the reversed ray
    double ratio = 1;            ///< refracted: index on the ray's side divided by that on the other side
};

/// The callbacks. Each receives the tracer's own result and returns the one to continue with.
class RefSteer {
public:
    virtual ~RefSteer() = default;

    /// Begins a sample of the pixel, and may replace its camera ray.
    virtual void begin_sample(std::uint32_t sample, RefPath& path) = 0;
    /// Returns true if the pixel takes no more samples. `difference` is the largest difference between two of
    /// its samples in one channel. `own` is the tracer's own decision.
    virtual bool ends_sampling(std::uint32_t samples, double difference, bool own) = 0;

    /// Returns the hit of a path.
    virtual RefClosest choose_hit(const RefPath& path, const RefClosest& own) = 0;
    /// Replaces the normals of a smooth triangle's corners and the weights that interpolate them. The normals
    /// point outwards. `is_open`: their sum lies so near the triangle's plane that doubles cannot decide
    /// whether it points outwards.
    virtual void round_corners(RefClosest& hit, std::array<glm::dvec3, 3>& normals, bool is_open) = 0;
    /// Returns a plane's colour at the hit.
    virtual glm::dvec3 plane_colour(const RefClosest& hit, const Material& material,
                                    const glm::dvec3& own) = 0;
    /// Replaces the picture's colour at a hit of a textured surface, and the flag for a hole. `surface` has
    /// the colour without the picture, and normals that point outwards.
    virtual void texel(const RefClosest& hit, const RefSurface& surface, RefTexel& own) = 0;
    /// Replaces the point from which rays leave.
    virtual void move_ray_origin(RefSurface& surface) = 0;

    /// Returns true if a light counts, before the shadow ray. `side` is the cosine with the flat normal,
    /// `lambert` that with the shading normal.
    virtual bool light_counts(std::size_t light, double side, double lambert) = 0;
    /// Returns true if something blocks the path from the surface to a light that counts.
    virtual bool is_blocked(std::size_t light, const RefPath& path, double distance, bool own) = 0;

    /// Returns true if refraction becomes total reflection.
    virtual bool is_total(const RefSurface& surface, double ratio, double cosine, bool own) = 0;
    /// Returns true if the tracer sends a bounce. Then choose_hit() follows for it, between enter() and
    /// leave().
    virtual bool accept_bounce(RefBounce& bounce) = 0;
    virtual void enter(RefBounce::Interaction interaction) = 0;
    virtual void leave() = 0;
};

}   // namespace rayclock
