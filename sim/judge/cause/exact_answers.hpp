#pragma once
// The correct answer of a machine for each pixel of a frame, from exact arithmetic.
//
// It shares with the machine only the host's data: the lattice, with the points to which the vertices were
// snapped, and the camera registers. Directions, t, u and v are rounded as payloads.hpp states (Frame,
// TriRsp), with independent formulas.
#include "model/core/payloads.hpp"
#include "sim/judge/oracle/surface.hpp"
#include "sim/judge/paths/camera.hpp"
#include "sim/judge/paths/placed.hpp"

namespace rayclock {

/// A pixel's unrounded hit at o + d num / den, with weights u / den and v / den of the triangle's second and
/// third corner. Without a hit den is 1 and all other numbers are 0.
struct ExactPixel {
    std::uint32_t primitive = no_primitive;
    oracle::Int128 num = 0, den = 1, u = 0, v = 0;
};

/// Returns a camera ray of a chip that does not shade.
Ray camera_ray(const Vec3i& eye, const Vec3i& direction);

class ExactAnswers {
public:
    ExactAnswers(const Scene& scene, const Lattice& lattice, const Config& config)
        : surface_(oracle::snapped(scene, lattice)), config_(config) {}
    /// For two levels, where the direction is rounded separately for each instance.
    ExactAnswers(const PlacedWorld& placed, const Config& config)
        : surface_(std::vector<oracle::Corners>{}), placed_(&placed), config_(config) {}

    ExactPixel pixel(const Frame& frame, int x, int y) const;

    /// Returns the only correct answer: t rounded up and saturated, u and v rounded down. The context's
    /// number is left out.
    Closest answer(const ExactPixel& pixel) const;

private:
    ExactPixel placed_pixel(const Ray& ray) const;

    oracle::Surface surface_;
    const PlacedWorld* placed_ = nullptr;
    Config config_;
};

}   // namespace rayclock
