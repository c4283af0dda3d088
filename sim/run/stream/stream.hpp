#pragma once
// A stream of rays in place of a camera: its job, its answers in scene units, and their judge.
#include <limits>

#include "model/compile/stream.hpp"
#include "model/scene/placed.hpp"
#include "sim/load/rays/rays.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock {

/// The treatment of a ray that begins outside the lattice: clip its part outside, or refuse the ray. No
/// surface lies outside the lattice.
enum class Outside { clip, refuse };

/// A scene, compiled for a chip whose rays come from memory, with the rays behind it.
struct StreamJob {
    const Scene& scene;
    const Rays& rays;
    Job job;
    std::size_t closest = 0, any = 0;       ///< rays by request: the closest hit, any hit
    std::size_t clipped = 0, missing = 0;   ///< rays that begin outside the lattice, and rays that miss it
};
/// Puts the rays on the scene's lattice. If all rays begin at one point, at most four diagonals of the scene
/// from its middle, this point is a lattice point. Otherwise the middle is one, and the lattice has a margin
/// around spheres (sphere_margin). Throws UserError, which names the ray, if `outside` is refuse and a ray
/// begins outside the lattice, or if a ray meets a plane there.
StreamJob make_stream_job(const Scene& scene, const Rays& rays, const Config& config, Outside outside,
                          const Progress& progress = {});

/// Does the same with a scene that is compiled already.
StreamJob make_stream_job(const Scene& scene, const Rays& rays, const Config& config, MemoryImage image,
                          Outside outside);

/// The configuration with exactly the units that a stream of rays through this scene needs.
Config streaming(Config config, const Scene& scene);

/// The answer to a ray. t, u and v are NaN unless it requests the closest hit and has one.
struct StreamHit {
    bool hit = false, back = false;
    std::uint32_t primitive = no_primitive;   ///< no_primitive without a hit, or if the ray requests any hit
    std::uint32_t instance = InstanceNumbers::none;                      ///< see name_instances()
    double t = std::numeric_limits<double>::quiet_NaN(), u = t, v = t;   ///< t on the given ray
};
/// Returns the answer to a ray in scene units. A closest hit beyond t_max counts as a miss.
StreamHit hit_of(const StreamJob& stream, std::size_t ray, const Closest& answer);
/// Sets `instance` of each hit from its primitive.
void name_instances(const Scene& scene, std::vector<StreamHit>& hits);
/// Returns the answers to all rays in scene units.
std::vector<StreamHit> hits_of(const StreamJob& stream, const std::vector<Closest>& answers);

/// Returns every ray's hit as a structured .npy file: hit (u1), back (u1), primitive (u4), instance (u4),
/// t, u, v (f8), cycle (u8). `cycles`: when each ray's answer left the chip; empty without timing, and every
/// cycle is then 0.
std::string hits_npy(const std::vector<StreamHit>& hits, const std::vector<std::uint64_t>& cycles);

/// Replays a stream, and returns the cycle in which each ray's answer left the chip, from the frame's first
/// cycle on. `cycles`: those of the stream's replay; for progress.
std::vector<std::uint64_t> retirements(const Config& config, int khz, const RecordedFrame& frame,
                                       Disturbance disturbance, std::uint64_t cycles,
                                       const Progress& progress = {});

/// The exact judge's verdict on every answer.
struct StreamJudgement {
    std::size_t rays = 0, wrong = 0;
    std::string first;   ///< the first fault: its ray and what is wrong
    double seconds = 0;
};
/// Judges every ray against all primitives of the scene, in exact arithmetic (judge_answer()). With two
/// levels the rays are rounded for each instance, and a wrong map in memory makes every answer wrong.
StreamJudgement judge_stream(const StreamJob& stream, const std::vector<Closest>& answers, int threads = 0,
                             const Progress& progress = {});

}   // namespace rayclock
