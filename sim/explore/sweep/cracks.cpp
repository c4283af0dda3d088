// Finds rays that slip through a surface, by exact integer geometry.
#include "sim/explore/sweep/cracks.hpp"

#include <algorithm>
#include <atomic>

#include "model/unit/raygen/raygen.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/judge/oracle/surface.hpp"

namespace rayclock::sweep {

namespace {

using oracle::Corners;
using oracle::Int128;

/// Returns true if the ray reaches the plane of `t` beyond the hit or never. It reaches the plane n . (p - a)
/// = 0 at n . (a - o) / n . d. Both values are within the bounds of an ExactHit's, so the products fit.
bool plane_is_farther(const Vec3i& o, const Vec3i& d, const Corners& t, const oracle::ExactHit& hit) {
    const auto n = oracle::normal<Int128>(t);
    Int128 num =
               oracle::volume<Int128>(oracle::way(oracle::triple<Int128>(o), oracle::triple<Int128>(t.a)), n),
           den = oracle::volume<Int128>(oracle::triple<Int128>(d), n);
    if (den < 0) {
        num = -num;
        den = -den;
    }
    return den == 0 || num * hit.den > hit.num * den;
}

bool is_crack(const oracle::Surface& surface, const Vec3i& o, const Vec3i& d, const Closest& answer) {
    const oracle::ExactHit hit = surface.closest(o, d);
    if (hit.primitive == no_primitive || (answer.found && answer.prim == hit.primitive)) return false;
    if (!answer.found) return true;
    const Corners& found = surface.triangles()[answer.prim];
    return !oracle::share_corner(found, surface.triangles()[hit.primitive]) &&
           plane_is_farther(o, d, found, hit);
}

}   // namespace

std::uint64_t count_cracks(const Scene& scene, const Job& job, const std::vector<Closest>& hits,
                           int threads) {
    const oracle::Surface surface(oracle::snapped(scene, job.image.lattice));
    const std::uint32_t width = job.frame.width, height = job.frame.height;
    std::atomic<std::uint64_t> cracks = 0;
    parallel::for_each(height, threads, [&](std::size_t y) {
        std::uint64_t mine = 0;
        for (std::uint32_t x = 0; x < width; ++x)
            mine +=
                is_crack(surface, job.frame.eye, pixel_direction(x, std::uint32_t(y), job.frame, job.config),
                         hits[y * width + x]);
        cracks += mine;
    });
    return cracks;
}

}   // namespace rayclock::sweep
