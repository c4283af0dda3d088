#include "sim/sweep/cracks.hpp"

#include <algorithm>
#include <atomic>

#include "model/oracle/surface.hpp"
#include "model/raygen/raygen.hpp"
#include "sim/jobs/threads.hpp"

namespace rayclock::sweep {

namespace {

using oracle::Corners;
using oracle::Int128;

bool touch(const Corners& s, const Corners& t) {
    for (const Vec3i& p : {s.a, s.b, s.c})
        if (p == t.a || p == t.b || p == t.c) return true;
    return false;
}

/// Whether the ray reaches the plane of `t` after the hit, or never. The plane n . (p - a) = 0 is reached at
/// n . (a - o) / n . d; both have the bounds of an ExactHit's, so the products fit.
bool plane_is_farther(const Vec3i& o, const Vec3i& d, const Corners& t, const oracle::ExactHit& hit) {
    std::array<Int128, 3> ab{}, ac{}, n{};
    for (std::size_t k = 0; k < 3; ++k) {
        ab[k] = std::int64_t(t.b[k]) - t.a[k];
        ac[k] = std::int64_t(t.c[k]) - t.a[k];
    }
    for (std::size_t k = 0; k < 3; ++k)
        n[k] = ab[(k + 1) % 3] * ac[(k + 2) % 3] - ab[(k + 2) % 3] * ac[(k + 1) % 3];
    Int128 num = 0, den = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        num += n[k] * (std::int64_t(t.a[k]) - o[k]);
        den += n[k] * d[k];
    }
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
    return !touch(found, surface.triangles()[hit.primitive]) && plane_is_farther(o, d, found, hit);
}

}   // namespace

std::uint64_t count_cracks(const Scene& scene, const Job& job, const std::vector<Closest>& hits,
                           int threads) {
    const oracle::Surface surface(oracle::snapped(scene, job.image.lattice));
    const std::uint32_t width = job.frame.width, height = job.frame.height;
    std::atomic<std::uint64_t> cracks = 0;
    jobs::for_each(height, threads, [&](std::size_t y) {
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
