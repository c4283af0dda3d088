#pragma once
// Counts rays that slip through closed surfaces.
#include "model/base/progress.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock::sweep {

/// Counts the pixels whose ray slips through a surface. The exact oracle finds that the quantised ray meets
/// triangle T of the snapped scene first. The machine's answer is nothing, or a triangle farther along the
/// ray that shares no corner (lattice point) with T. An exact test has no such pixel.
std::uint64_t count_cracks(const Scene& scene, const Job& job, const std::vector<Closest>& hits, int threads);

}   // namespace rayclock::sweep
