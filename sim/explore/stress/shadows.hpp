#pragma once
// Measures how often a scheme of secondary-ray origins errs: false self-shadows and light leaks, judged
// exactly.
#include <cstdint>
#include <string>
#include <vector>

#include "sim/explore/stress/shadow_rays.hpp"
#include "sim/judge/oracle/surface.hpp"

namespace rayclock {

/// The origin of a secondary ray, where P is the exact hit on a triangle.
struct OriginScheme {
    enum class Method {
        surface,    ///< the machine's scheme: model/unit/tri/origin.hpp with `frac_bits`
        excluded,   ///< the lattice point nearest to P; the ray ignores the hit triangle
        pushed,     ///< that point, moved along the normal's main axis until it leaves the triangle's plane
        epsilon,    ///< P moved along the normal by 1e-4 of the lattice's extent, with 16 fraction bits
    };
    Method method = Method::surface;
    int frac_bits = 16;
    std::string name() const;
};

/// Counts of rays from camera hits. A ray goes to a light, or without end along a direction like reflected
/// and refracted rays. It leaves on the side from which the surface was seen, or on the other. The scheme's
/// answer, blocked or free, is compared with the exact answer for the point that it represents. For `surface`
/// that is its point of the surface, for the others the exact hit P.
struct ShadowCounts {
    std::uint64_t rays = 0;
    std::uint64_t false_shadows = 0;   ///< reported as blocked, truly free
    std::uint64_t light_leaks = 0;     ///< reported as free, truly blocked
    std::uint64_t either = 0;          ///< the path touches edges or surfaces, so both answers are right
    /// `surface` only: blocked at its point, as reported, but free at P. A shadow's border, or another
    /// surface, lies between them.
    std::uint64_t moved_shadows = 0;
    std::uint64_t moved_leaks = 0;   ///< the opposite case
    ShadowCounts& operator+=(const ShadowCounts& other);
};

/// A mesh on the lattice of N bits, prepared for ray queries. Directions have N + 2 bits.
class Shadows {
public:
    Shadows(std::vector<oracle::Corners> mesh, int coord_bits);

    /// Shoots camera rays at corners, edges and insides of triangles. Lights lie inside, outside, in or near
    /// the plane of the hit triangle, on corners of the mesh and nearby. Equal seeds give equal rays for
    /// every scheme. Returns fewer rays than requested only if the mesh is hardly ever hit.
    ShadowCounts count(std::uint64_t seed, std::uint64_t rays, const OriginScheme& scheme) const;

    const std::vector<oracle::Corners>& mesh() const { return surface_.triangles(); }
    int coord_bits() const { return coord_bits_; }

private:
    friend class ShadowProbe;
    oracle::Surface surface_;
    int coord_bits_;
    oracle::Extent bounds_;
};

/// Builds a Shadows object and counts once.
ShadowCounts shadow_counts(const std::vector<oracle::Corners>& mesh, int coord_bits, std::uint64_t seed,
                           std::uint64_t rays, const OriginScheme& scheme = {});

}   // namespace rayclock
