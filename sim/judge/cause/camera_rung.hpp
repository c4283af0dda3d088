#pragma once
// The last rung of the ladder for a picture of camera rays alone: the reference, by its own rules, on the
// machine's ray.
//
// It checks three things in a pixel, and none by a rule of the machine. Does its ray go through
// the pixel, within the bound of camera_ray.hpp? Does the reference, on the scene as the lattice has it, meet
// what the ray met, where t, u and v say? Is the colour at that hit the reference's local light, without
// shadows? Doubles leave ties: a ray moved by next to nothing (tie.hpp) meets what the machine's met, or two
// primitives lie at one depth. In two levels an instance may see another line (seam.hpp). All else is a
// fault.
#include <optional>
#include <string>

#include "model/trace/hits.hpp"
#include "sim/judge/reference/geometry.hpp"
#include "sim/judge/reference/reference.hpp"
#include "model/scene/folded.hpp"
#include "sim/judge/cause/camera_ray.hpp"
#include "sim/judge/cause/seam.hpp"

namespace rayclock {

/// What is found of one pixel.
struct CameraFinding {
    std::string fault;   ///< empty: none
    bool is_tie = false;
};

class CameraRung {
public:
    /// `steps`: the machine's scene in lattice steps, and its tracer. `placed`, `seams`: of two levels, or
    /// null.
    CameraRung(const Asked& asked, const Scene& steps, const Reference& tracer, const PlacedWorld* placed,
               const Seams* seams);

    /// A pixel's ray along d, and the exact answer to it as it is rounded.
    CameraFinding look(int x, int y, const Vec3i& d, const Closest& answer) const;

    /// The colour of a hit on the given scene, by the reference's rules and no line of shade(). Nothing where
    /// a smooth normal points away from the viewer: the two have rules of their own there (docs/shading.md).
    std::optional<glm::dvec3> local_light(const Hit& hit, int x, int y) const;

private:
    PlacedTriangle triangle(const Scene& scene, const std::optional<Unfolder>& unfolder,
                            std::uint32_t i) const;
    bool is_tie(const glm::dvec3& from, const glm::dvec3& d, const Closest& answer, const Hit& own) const;
    /// Where the answer's weights lie on the machine's triangle, its ray is, and it says how far.
    bool holds_point(int x, int y, const Vec3i& d, const Closest& answer) const;
    double instance_error(std::uint32_t place, double t) const;

    const Asked& asked_;
    const Scene& steps_;
    const Reference& tracer_;
    const PlacedWorld* placed_;
    const Seams* seams_;
    PixelRays rays_;
    CameraBound bound_;
    RefGeometry light_space_;   ///< of local_light(): in which space it reckons
    HitScale scale_;
    std::optional<Unfolder> given_unfolder_, steps_unfolder_;
};

}   // namespace rayclock
