// Simulates the machine at all clocks, memories and numbers of pipelines.
#include "sim/study/gigahertz/measure_gigahertz.hpp"

#include <mutex>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/compile/surfaces.hpp"
#include "model/engine/check.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/load/load.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock::gigahertz {

namespace {

constexpr int depth = 4;

Frame frame_of(const Config& config, int mhz, const std::vector<RecordedFrame>& frames) {
    const int khz = 1000 * mhz;
    const FrameResult run = frame_result(frames[0], replay(config, khz, frames)[0]);
    if (run.partial) throw Interrupted("interrupted: no page was written");
    Frame frame{run.cycles,
                rays_of(run),
                per_second(run, khz),
                double(bytes_read(run)),
                bound_of(config, khz, run),
                0,
                0};
    for (const UnitAccount& account : unit_accounts(config, run))
        if (account.unit == "memory") {
            frame.busy = double(account.busy) / double(run.cycles);
            frame.waits = double(account.stalled) / double(run.cycles);
        }
    return frame;
}

std::vector<Point> camera_points() {
    std::vector<Point> points;
    for (std::size_t m = 0; m < memories().size(); ++m) {
        for (const int mhz : clocks())
            for (const int p : pipelines())
                if (mhz == clocks().back() || p == pipelines().front() || p == pipelines().back())
                    points.emplace_back(m, mhz, p, Remedy::none);
        for (const Remedy remedy : {Remedy::contexts, Remedy::cache})
            points.emplace_back(m, clocks().back(), pipelines().back(), remedy);
    }
    return points;
}

std::vector<Point> finished_points() {
    std::vector<Point> points;
    for (std::size_t m = 0; m < memories().size(); ++m)
        for (const int mhz : {clocks().front(), clocks().back()})
            for (const int p : {pipelines().front(), pipelines().back()})
                points.emplace_back(m, mhz, p, Remedy::none);
    return points;
}

/// Times all points on one recorded frame, in parallel.
std::map<Point, Frame> run_all(const Job& job, const std::vector<Point>& points, const char* what,
                               int threads, const Progress& progress) {
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame, threads, progress));
    std::vector<Frame> done(points.size());
    std::mutex mutex;
    std::size_t finished = 0;
    parallel::for_each(points.size(), threads, [&](std::size_t i) {
        done[i] = frame_of(config_of(job.config, points[i]), std::get<1>(points[i]), frames);
        const std::lock_guard lock(mutex);
        if (progress) progress(what, ++finished, points.size());
    });
    std::map<Point, Frame> all;
    for (std::size_t i = 0; i < points.size(); ++i) all[points[i]] = done[i];
    return all;
}

}   // namespace

const std::vector<MemoryChoice>& memories() {
    static const std::vector<MemoryChoice> all{
        {"rpu", "rpu", 1},   {"sdr", "sdr", 1},       {"ddr3", "ddr3", 1},     {"lpddr4 x 2", "lpddr4", 2},
        {"ddr4", "ddr4", 1}, {"ddr4 x 2", "ddr4", 2}, {"hbm2 x 4", "hbm2", 4}, {"ideal", "ideal", 1}};
    return all;
}
const std::vector<int>& clocks() {
    static const std::vector<int> all{66, 133, 266, 533, 1066, 2133, 4000};
    return all;
}
const std::vector<int>& pipelines() {
    static const std::vector<int> all{1, 2, 4, 8, 16};
    return all;
}

Config config_of(const Config& base, const Point& point) {
    const auto& [memory, mhz, pipelines, remedy] = point;
    Config config = base;
    set_parameter(config, "dram", memories()[memory].dram, "gigahertz");
    config.dram_channels = memories()[memory].channels;
    config.pipelines = pipelines;
    if (remedy == Remedy::contexts) config.contexts = 4 * base.contexts;
    if (remedy == Remedy::cache) {   // 1 MB
        config.l2_sets = 4096;
        config.l2_mshrs = 64;
    }
    check_config(config, "gigahertz");
    return config;
}

Figures measure(const Study& study, const Progress& progress) {
    Figures figures;
    const Scene scene = ready_scene(study.scene, study.size, progress);
    figures.triangles = scene.triangles.size();
    const Job job = make_job(scene, *scene.camera, study.size, study.base, progress);
    figures.camera = run_all(job, camera_points(), "camera rays", study.threads, progress);

    const FrameSize half{study.size.width / 2, study.size.height / 2};
    Scene native = load_scene(study.finished_scene, progress, Primitives::native);
    if (!native.camera) native.camera = fit_camera(native, double(half.width) / half.height);
    const Whitted settings{.depth = depth};
    const Job finished = make_job(native, *native.camera, half, fitted_config(native, settings, study.base),
                                  progress, settings);
    figures.finished = run_all(finished, finished_points(), "finished pictures", study.threads, progress);
    figures.finished_rays_per_pixel =
        figures.finished.begin()->second.rays / (double(half.width) * half.height);
    return figures;
}

}   // namespace rayclock::gigahertz
