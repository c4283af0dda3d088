#pragma once
// Rays of any program as records in the chip's memory: docs/streams.md.
#include <limits>
#include <optional>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// A ray in scene units: the points origin + t * direction with t_min <= t <= t_max.
struct StreamRay {
    glm::dvec3 origin{0}, direction{0};   ///< the direction may have any length but 0
    double t_min = 0, t_max = std::numeric_limits<double>::infinity();
    bool any_hit = false;   ///< asks only whether there is a hit, not for the closest
};

/// A ray on the lattice, and the way back: t = begin + scale * s for the point record.o + s * record.d of a
/// closest hit. The record's origin is the point of t = begin, rounded to 2^-B lattice steps. Its direction
/// is multiplied by a power of two, so that its largest component lies in 2^(M-2) ... 2^(M-1) - 1, and
/// rounded to nearest. So a direction of such whole numbers stays as it is.
///
/// Any hit up to a t_max within the scene is found by a ray in the other direction: it begins at the lattice
/// point nearest to the segment's end, and its direction leads exactly to the rounded origin, as that of a
/// shadow ray (docs/origins.md).
struct LatticeRay {
    RayRecord record;
    double begin = 0, scale = 1;
    bool is_clipped = false;   ///< the part before the lattice is left out
};
/// Returns the ray on the lattice, or nothing if no point of it lies within the lattice. The part of the ray
/// outside the lattice, where no surface is, is left out.
std::optional<LatticeRay> on_lattice(const StreamRay& ray, const Lattice& lattice, const Config& config);
/// Returns a record that meets nothing, for a ray that misses the lattice.
RayRecord ray_to_nowhere(const Config& config);

}   // namespace rayclock
