#pragma once
#include "model/base/progress.hpp"
#include "sim/run/engine/engine.hpp"

namespace rayclock::sweep {

/// Pixels whose ray slips through a surface. The exact oracle says that the ray, as quantised, meets triangle
/// T of the snapped scene first; the machine's answer is neither T nor a triangle that has a corner (a
/// lattice point) in common with T, and lies farther along the ray, or is nothing at all. With an exact test
/// there is none.
std::uint64_t count_cracks(const Scene& scene, const Job& job, const std::vector<Closest>& hits, int threads);

}   // namespace rayclock::sweep
