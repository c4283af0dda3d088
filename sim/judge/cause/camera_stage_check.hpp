#pragma once
// The check of the last stage for a picture of camera rays alone: the reference follows the machine's rays by
// its own rules.
//
// It checks three facts about a pixel, and uses no rule of the machine:
// - The machine's ray goes through the pixel, within the bound of camera_ray.hpp.
// - In the scene on the lattice, the reference meets the same primitive, at the place that t, u and v give.
// - The colour of that hit is the reference's local light, without shadows.
//
// Doubles leave ties: a slightly moved ray (tie.hpp) meets the machine's primitive, or two primitives lie at
// the same depth. With two levels an instance may see another line (seam.hpp). Any other difference is a
// fault.
#include <optional>
#include <string>

#include "model/scene/folded.hpp"
#include "model/trace/hits.hpp"
#include "sim/judge/cause/camera_ray.hpp"
#include "sim/judge/cause/seam.hpp"
#include "sim/judge/reference/geometry.hpp"
#include "sim/judge/reference/reference.hpp"

namespace rayclock {

/// The result for one pixel.
struct CameraFinding {
    std::string fault;   ///< empty: none
    bool is_tie = false;
};

class CameraStageCheck {
public:
    /// `steps`: the machine's scene in lattice steps; `tracer` traces it. `placed` and `seams` are null
    /// unless there are two levels.
    CameraStageCheck(const FrameInputs& inputs, const Scene& steps, const Reference& tracer,
                     const PlacedWorld* placed, const SeamFinder* seams);

    /// Checks a pixel, given its ray's direction d and the exact answer after rounding.
    CameraFinding judge(int x, int y, const Vec3i& d, const Closest& answer) const;

    /// Returns the colour of a hit on the given scene by the reference's rules, without using shade().
    /// Returns nothing in two cases, which are not checked: a smooth normal points away from the viewer, so
    /// that the rules of the two differ (docs/machine/shading.md), or doubles cannot decide which way it
    /// points.
    std::optional<glm::dvec3> local_light(const Hit& hit, int x, int y) const;

private:
    PlacedTriangle triangle(const Scene& scene, const std::optional<InstancedTriangles>& instanced,
                            std::uint32_t i) const;
    bool is_tie(const glm::dvec3& from, const glm::dvec3& d, const Closest& answer, const Hit& own) const;
    /// Returns true if the machine's ray passes through the point that the answer's weights give, at the
    /// answer's distance.
    bool holds_point(int x, int y, const Vec3i& d, const Closest& answer) const;
    double instance_error(std::uint32_t place, double t) const;

    const FrameInputs& inputs_;
    const Scene& steps_;
    const Reference& tracer_;
    const PlacedWorld* placed_;
    const SeamFinder* seams_;
    PixelRays rays_;
    CameraBound bound_;
    RefGeometry light_space_;   ///< the space in which local_light() computes
    HitScale scale_;
    std::optional<InstancedTriangles> given_triangles_, steps_triangles_;
};

}   // namespace rayclock
