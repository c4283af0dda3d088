#pragma once
// The exact result of a frame: every pixel's ray against every triangle, in 256-bit integers that detect
// overflow.
//
// It shares with the model only the lattice (the vertices' lattice points) and the camera registers. It
// judges the model, and also the oracle's Surface, which searches and has 128 bits.
#include <cstdint>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "sim/judge/oracle/surface.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock::test {

using Int = boost::multiprecision::checked_int256_t;

struct ExactHit {
    std::uint32_t primitive = no_primitive;
    Int num, den;   ///< the hit is at o + d num / den; den > 0
};

/// Triangles of a scene on a lattice, by primitive number. Those without area are included and never hit.
class ExactScene {
public:
    ExactScene(const Scene& scene, const Lattice& lattice) : triangles_(oracle::snapped(scene, lattice)) {}
    explicit ExactScene(std::vector<oracle::Corners> triangles) : triangles_(std::move(triangles)) {}

    /// Returns the closest triangle along o + t d, t > 0; among equals, the lowest number.
    ExactHit closest(const Vec3i& o, const Vec3i& d) const;

private:
    std::vector<oracle::Corners> triangles_;
};

/// Returns the direction of a pixel's ray from the camera registers, by the rule in model/core/frame.hpp.
Vec3i exact_direction(const Frame& frame, int x, int y, const Config& config);

}   // namespace rayclock::test
