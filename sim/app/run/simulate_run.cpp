// Runs a simulation and makes its report.
#include "sim/app/run/simulate_run.hpp"

#include <algorithm>
#include <mutex>

#include "sim/app/run/clock.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock {

namespace {

/// Replays the same trace once per clock, in parallel.
std::vector<FramesAtClock> replay_clocks(const Job& job, const std::vector<int>& clocks,
                                         const std::vector<RecordedFrame>& traces, Disturbance disturbance,
                                         int threads, const Progress& progress) {
    std::vector<FramesAtClock> runs(clocks.size());
    std::mutex mutex;
    std::vector<std::uint64_t> done(clocks.size());
    const std::uint64_t pixels = traces[0].trace.rays.size() * traces.size();
    parallel::for_each(clocks.size(), threads, [&](std::size_t i) {
        const Progress replay_progress =
            !progress ? Progress{} : [&, i](std::string_view what, std::uint64_t n, std::uint64_t) {
                const std::lock_guard lock(mutex);
                done[i] = std::max(done[i], n);
                std::uint64_t sum = 0;
                for (const std::uint64_t d : done) sum += d;
                progress(what, std::min(sum, pixels * clocks.size()), pixels * clocks.size());
            };
        runs[i].khz = clocks[i];
        const std::vector<FrameTiming> timings =
            replay(job.config, clocks[i], traces, disturbance, replay_progress);
        for (std::size_t f = 0; f < timings.size(); ++f)
            runs[i].frames.push_back(frame_result(traces[f], timings[f]));
    });
    return runs;
}

std::vector<FramesAtClock> run_rtl_clocks(const Job& job, const std::vector<int>& clocks,
                                          const std::vector<RecordedFrame>& traces, Disturbance disturbance,
                                          int seed, const Progress& progress) {
    std::vector<FramesAtClock> runs;
    for (const int khz : clocks) {
        runs.push_back({khz, run_rtl(job, khz, traces, disturbance, progress, seed)});
        if (runs.back().partial()) break;
    }
    return runs;
}

}   // namespace

SimulateResult run_simulation(const SimulateSettings& how, const SimulateInput& work,
                              const Progress& progress) {
    SimulateResult s;
    Film& film = work.film;
    s.tracer = how.tracer;
    // A single frame at a single clock replays while it is recorded.
    if (s.is_on_model() && work.clocks.size() == 1 && film.frames() == 1 && !film.moves()) {
        film.next();
        const std::vector<FrameTiming> timings =
            record_and_replay(work.job(), work.clocks[0], s.traces, how.disturbance, how.threads, progress);
        s.runs.push_back({work.clocks[0], {frame_result(s.traces[0], timings[0])}});
    } else {
        s.strip =
            record_film(film, {.threads = how.threads, .folder = how.folder, .compares = how.is_compared},
                        stopping(progress), s.traces);
        s.runs =
            s.is_on_model()
                ? replay_clocks(work.job(), work.clocks, s.traces, how.disturbance, how.threads, progress)
                : run_rtl_clocks(work.job(), work.clocks, s.traces, how.disturbance, int(how.seed), progress);
    }
    s.partial = s.runs.size() < work.clocks.size() ||
                std::any_of(s.runs.begin(), s.runs.end(), [](const FramesAtClock& r) { return r.partial(); });
    return s;
}

void compare_frames(SimulateResult& s, const SimulateSettings& how, const SimulateInput& work,
                    const Progress& progress) {
    s.compared = rayclock::compare(work.request(), work.job(),
                                   {s.traces.back().frame, work.film.camera(), s.answers(), s.colours(),
                                    s.traces.back().trace.signatures},
                                   how.is_judged, how.threads, progress);
}

Totals totals_of(const SimulateResult& s) {
    Totals t;
    for (const FramesAtClock& run : s.runs)
        for (const FrameResult& frame : run.frames) {
            t.cycles += frame.cycles;
            t.machine_seconds += frame.seconds;
            t.digest.add(frame.digest);
        }
    for (const RecordedFrame& trace : s.traces) t.record_seconds += trace.trace.seconds;
    // A single replay runs in parallel with the recording, so its time includes both.
    t.all_seconds =
        t.machine_seconds + (s.is_on_model() && s.traces.size() * s.runs.size() > 1 ? t.record_seconds : 0);
    return t;
}

Picture last_frame_picture(const SimulateInput& work, const SimulateResult& s) {
    if (s.compared) return s.compared->picture;
    return work.request().finished
               ? picture_from_colours(work.size, s.colours())
               : shade(work.request().scene, scaled(work.job(), s.traces.back().frame, s.answers()));
}

nlohmann::ordered_json simulation_json(const SimulateSettings& how, const SimulateInput& work,
                                       const SimulateResult& s, const Limits& limits, const Totals& t) {
    const Config& config = work.request().config;
    const FrameResult& frame = s.runs[0].last();
    nlohmann::ordered_json clocks = nlohmann::ordered_json::array();
    for (const FramesAtClock& run : s.runs) {
        clocks.push_back(clock_json(config, run));
        mark_clock(clocks.back(), config, run.khz);
    }
    return {{"scene", scene_json(work.request().scene)},
            {"config", config_json_object(config)},
            {"frame", {{"width", work.size.width}, {"height", work.size.height}}},
            {"camera", camera_json(work.film.camera())},
            {"frames", work.film.frames()},
            {"pan", how.pan},
            {"film", film_json(config, s.runs, s.strip, s.traces)},
            {"engine", name_of(how.tracer)},
            {"partial", s.partial},
            {"sampling", nullptr},
            {"compile", compile_json(work.job().image.report)},
            {"rays", rays_json(frame.rays)},
            {"work", work_json(frame)},
            {"work_by_kind", nullptr},
            {"clocks", clocks},
            {"units", units_json(config, frame)},
            {"memory", memory_json(config, s.runs[0].khz, frame)},
            {"error", error_json(s.error(), s.judgement())},
            {"limits", limits_json(limits, s.errors())},
            {"judge", judge_json(s.judgement())},
            {"host",
             {{"seconds", t.all_seconds},
              {"record_seconds", s.is_on_model() ? t.record_seconds : 0},
              {"judge_seconds", s.judgement() ? s.judgement()->seconds : 0},
              {"cycles_per_second", double(t.cycles) / t.all_seconds},
              {"rays_per_second",
               rays_of(frame) * double(s.runs.size() * s.runs[0].frames.size()) / t.all_seconds}}},
            {"digest", digest_text(t.digest.value())}};
}

}   // namespace rayclock
