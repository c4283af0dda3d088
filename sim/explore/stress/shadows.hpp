#pragma once
// How often a scheme of secondary-ray origins is wrong: false self-shadows and leaks of light, judged
// exactly.
#include <cstdint>
#include <string>
#include <vector>

#include "sim/judge/oracle/surface.hpp"
#include "sim/explore/stress/shadow_rays.hpp"

namespace rayclock {

/// Where a secondary ray begins, P being the exact hit on a triangle.
struct OriginScheme {
    enum class Kind {
        surface,    ///< model/unit/isect/origin.hpp, with `frac_bits`: what the machine does
        excluded,   ///< the lattice point nearest to P; the triangle that was hit is left out
        pushed,     ///< that point, moved along the normal's main axis until it lies off the triangle's plane
        epsilon,    ///< P moved by 1e-4 of the lattice's extent along the normal, kept with 16 fraction bits
    };
    Kind kind = Kind::surface;
    int frac_bits = 16;
    std::string name() const;
};

/// A ray goes from where a camera ray hit to a light, or without end along a direction, as reflected and
/// refracted ones do; it leaves on the side from which the surface was seen, or on the other. The scheme's
/// answer, blocked or free, is compared with the truth about the point that it stands for: for `surface` its
/// point of the surface, for the others the exact hit P.
struct ShadowCounts {
    std::uint64_t rays = 0;
    std::uint64_t false_shadows = 0;   ///< said to be blocked, truly free
    std::uint64_t light_leaks = 0;     ///< said to be free, truly blocked
    std::uint64_t either = 0;          ///< the way touches edges or surfaces so that both answers are right
    std::uint64_t moved_shadows = 0;   ///< `surface` only: blocked at its point, as said, but free at P: a
                                       ///< shadow's border, or another surface, lies between
    std::uint64_t moved_leaks = 0;     ///< the other way round
    ShadowCounts& operator+=(const ShadowCounts& other);
};

/// A mesh on the lattice of N bits, ready to be asked. Directions have N + 2 bits.
class Shadows {
public:
    Shadows(std::vector<oracle::Corners> mesh, int coord_bits);

    /// Camera rays aimed at corners, edges and insides of triangles; lights inside, outside, in or near the
    /// plane of the surface hit, on corners of the mesh and close by. The same seed gives the same rays for
    /// every scheme. Fewer rays than asked for only if the mesh is hardly ever hit.
    ShadowCounts count(std::uint64_t seed, std::uint64_t rays, const OriginScheme& scheme) const;

    const std::vector<oracle::Corners>& mesh() const { return surface_.triangles(); }
    int coord_bits() const { return coord_bits_; }

private:
    friend class ShadowProbe;
    oracle::Surface surface_;
    int coord_bits_;
    oracle::Extent bounds_;
};

/// The same in one call.
ShadowCounts shadow_counts(const std::vector<oracle::Corners>& mesh, int coord_bits, std::uint64_t seed,
                           std::uint64_t rays, const OriginScheme& scheme = {});

}   // namespace rayclock
