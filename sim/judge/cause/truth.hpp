#pragma once
// What a machine must answer for each pixel of a frame, from exact arithmetic.
//
// Shares with the machine what the host gives it: the lattice (which points the vertices went to) and the
// camera registers. The rounding of a direction, of t, u and v follows the promises in payloads.hpp (Frame,
// TriRsp), in formulas of its own.
#include "model/core/payloads.hpp"
#include "sim/judge/oracle/surface.hpp"
#include "sim/judge/paths/camera.hpp"
#include "sim/judge/paths/placed.hpp"

namespace rayclock {

/// A pixel's hit before anything is rounded: at o + d num / den, with weights u / den and v / den of the
/// triangle's second and third corner. den = 1 and all else 0 if nothing is hit.
struct ExactPixel {
    std::uint32_t primitive = no_primitive;
    oracle::Int128 num = 0, den = 1, u = 0, v = 0;
};

/// From the eye, of a chip that does not shade.
Ray camera_ray(const Vec3i& eye, const Vec3i& direction);

class Truth {
public:
    Truth(const Scene& scene, const Lattice& lattice, const Config& config)
        : surface_(oracle::snapped(scene, lattice)), config_(config) {}
    /// Of two levels, where every instance sees the direction as it is rounded for it.
    Truth(const PlacedWorld& placed, const Config& config)
        : surface_(std::vector<oracle::Corners>{}), placed_(&placed), config_(config) {}

    ExactPixel pixel(const Frame& frame, int x, int y) const;

    /// The only right answer: t rounded up and saturated, u and v rounded down. The context that did the work
    /// is left out.
    Closest answer(const ExactPixel& pixel) const;

private:
    ExactPixel placed_pixel(const Ray& ray) const;

    oracle::Surface surface_;
    const PlacedWorld* placed_ = nullptr;
    Config config_;
};

}   // namespace rayclock
