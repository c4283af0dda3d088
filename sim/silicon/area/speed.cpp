// Times the model and the RTL of several variants on one frame.
#include "sim/silicon/area/speed.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/rtl/builder.hpp"

namespace rayclock::area {

namespace {

template <class Work> void best_of(double& best, Work work) {
    const Stopwatch watch;
    work();
    const double seconds = watch.seconds();
    if (best == 0 || seconds < best) best = seconds;
    if (interrupted())
        throw Interrupted("interrupted: no page was written; the same command continues where it stopped");
}

void run_once(const Job& job, Speed& speed) {
    FrameResult rtl;
    std::vector<FrameTiming> model;
    best_of(speed.model_seconds, [&] {
        std::vector<RecordedFrame> fresh;
        model = record_and_replay(job, job.khz, fresh, {}, 1);
    });
    best_of(speed.rtl_seconds, [&] { rtl = run_rtl(job); });
    if (rtl.cycles != model[0].cycles)
        throw std::runtime_error(speed.name + ": model and RTL do not take the same cycles");
    speed.cycles = rtl.cycles;
    speed.rays = rays_of(rtl);
}

}   // namespace

std::vector<Speed> measure(const std::vector<Variant>& variants, const Scene& scene, FrameSize size,
                           const Whitted& settings, int rounds, const Progress& progress) {
    std::vector<Job> jobs;
    std::vector<Speed> speeds;
    for (const Variant& variant : variants) {
        if (progress) progress("building RTL, " + variant.name, speeds.size(), variants.size());
        Speed speed;
        speed.name = variant.name;
        speed.library = std::filesystem::file_size(build_rtl(variant.config).library);
        jobs.push_back(make_job(scene, *scene.camera, size, variant.config, {},
                                variant.config.shading ? settings : Whitted{}));
        speeds.push_back(speed);
    }
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            if (progress)
                progress("speed", std::uint64_t(round) * jobs.size() + i,
                         std::uint64_t(rounds) * jobs.size());
            run_once(jobs[i], speeds[i]);
        }
    return speeds;
}

}   // namespace rayclock::area
