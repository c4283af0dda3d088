#pragma once
// Converts rays from any program to records in the chip's memory: docs/guide/streams.md.
#include <limits>
#include <optional>
#include <span>

#include "model/core/frame.hpp"
#include "model/layout/memory_image.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// A ray in scene units: the points origin + t * direction with t_min <= t <= t_max.
struct StreamRay {
    /// Each coordinate of the origin is at most max_size. The direction's largest component lies in
    /// least_size ... max_size.
    glm::dvec3 origin{0}, direction{0};
    static constexpr double least_size = 0x1p-500, max_size = 0x1p500;
    double t_min = 0, t_max = std::numeric_limits<double>::infinity();
    bool any_hit = false;   ///< requests any hit, not the closest
};

/// A ray on the lattice. A closest hit at record.o + s * record.d has t = begin + scale * s on the given ray.
/// The record's origin is the given ray's point at t = begin, rounded to 2^-B lattice steps. Its direction is
/// multiplied by a power of two, so that its largest component lies in 2^(M-2) ... 2^(M-1) - 1, and rounded
/// to nearest. A direction of whole numbers in that range does not change.
///
/// A request for any hit up to a t_max within the lattice becomes a ray in the opposite direction. It begins
/// at the lattice point nearest to the segment's end. Like a shadow ray (docs/proofs/origins.md), it leads
/// exactly to the rounded origin. Vertices do not reach the border of the lattice. So a segment that ends
/// beyond them needs no end, and a segment that lies beyond them meets nothing.
///
/// Planes reach beyond the lattice. So in a chip with planes, such a segment requests the closest hit, and
/// the host compares its t with t_max.
struct LatticeRay {
    RayRecord record;
    double begin = 0, scale = 1;
    bool is_clipped = false;   ///< the ray begins outside the lattice, and that part is left out
};
/// Returns the ray on the lattice, or nothing if it misses the lattice. Only planes lie outside the lattice
/// (meets_plane_outside()), so the ray begins where it enters.
std::optional<LatticeRay> on_lattice(const StreamRay& ray, const Lattice& lattice, const Config& config);
/// Returns the record of a ray that meets nothing. It replaces a ray that misses the lattice.
RayRecord ray_to_nowhere(const Config& config);

/// Returns true if a ray meets a plane of the scene before it enters the lattice, or without entering it.
/// `begin`: where it enters; nothing if it misses the lattice.
bool meets_plane_outside(const Scene& scene, const StreamRay& ray, std::optional<double> begin);

/// Puts the rays of a stream behind the scene, two in a line. Throws UserError if the memory has too few
/// lines, or the chip cannot number the rays. The lines behind the rays are for their hits, if the chip
/// writes them; check_capacity() checks these.
void place_rays(MemoryImage& image, std::span<const RayRecord> rays, const Config& config);

/// Returns the registers of a frame that traces the image's stream of rays.
Frame make_stream_frame(const MemoryImage& image, std::size_t rays, const Config& config);

}   // namespace rayclock
