#pragma once
// Hits in scene units, and digests.
#include <cstdint>

#include "model/core/payloads.hpp"
#include "model/layout/memory_image.hpp"
#include "model/scene/hit.hpp"

namespace rayclock {

/// Converts the chip's answers to scene units: depth = t / 2^(M-1+F) * |d * pitch|, weights u, v /
/// 2^bary_bits.
class HitScale {
public:
    HitScale(const Frame& frame, const Lattice& lattice, const Config& config);
    Hit operator()(const HitOut& out) const;

private:
    Frame frame_;
    Config config_;
    glm::dvec3 shape_;   ///< pitches, in units of the coarsest
    double depth_, weight_;
};

/// Returns the depth of a hit on a plane beyond the range of t, from u and v. It is infinite where these
/// saturate as well.
float depth_on_plane(const Closest& hit, const Surface& plane, const Vec3i& eye, const Lattice& lattice,
                     const Config& config);

/// 64-bit digest of a sequence of numbers: one multiplication and one fold per number, after FNV-1a and
/// SplitMix64. It is the same on every machine.
class Digest {
public:
    void add(std::uint64_t value) {
        state_ = (state_ ^ value) * 0x9e3779b97f4a7c15u;
        state_ ^= state_ >> 29;
    }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xcbf29ce484222325u;
};

}   // namespace rayclock
