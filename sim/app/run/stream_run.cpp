// Runs a stream of rays and makes its report.
#include "sim/app/run/stream_run.hpp"

#include <algorithm>

#include "model/base/error.hpp"
#include "model/core/settled.hpp"
#include "model/trace/hits.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/request/ineffective.hpp"
#include "sim/run/request/request.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock {

Primitives stream_primitives(const ConfigChoice& choice) {
    return widened(load_config({choice.name, {}}), choice.set).spheres ? Primitives::native
                                                                       : Primitives::triangles;
}

Config stream_config(const ConfigChoice& choice, const Scene& scene, std::vector<std::string>& notes) {
    const Config named = load_config({choice.name, {}});
    Config fitted = settled(streaming(widened(named, choice.set), scene));
    // As for pictures, so that the longer pipeline of tri does not close its credit gate.
    if (fitted.spheres) fitted.tri_queue = std::max(fitted.tri_queue, 64);
    const Config config = with_settings(fitted, choice.set, named.name);
    if (!config.is_stream()) throw UserError("--rays needs source=stream; leave out --set source=camera");
    for (std::string& note : ineffective_settings(config, choice.set)) notes.push_back(std::move(note));
    return config;
}

Config rays_config(const ConfigChoice& choice, const Scene& scene, std::vector<std::string>& notes) {
    // Only a chip for streams may have spheres=1 without shading=1.
    return stream_primitives(choice) == Primitives::native ? stream_config(choice, scene, notes)
                                                           : load_config(choice);
}

StreamResult run_stream(const StreamJob& stream, const std::vector<int>& clocks, Disturbance disturbance,
                        bool is_judged, int threads, const Progress& progress) {
    const Progress stop = stopping(progress);
    const Job& job = stream.job;
    StreamResult run;
    run.frames.push_back(record_frame(job, job.frame, threads, stop));
    for (const int khz : clocks) {
        const std::vector<FrameTiming> timings = replay(job.config, khz, run.frames, disturbance, progress);
        run.runs.push_back({khz, {frame_result(run.frame(), timings[0])}});
        if (run.partial()) return run;
    }
    if (is_judged) run.judged = judge_stream(stream, run.answers(), threads, stop);
    return run;
}

namespace {

nlohmann::ordered_json judgement_json(const std::optional<StreamJudgement>& judged) {
    if (!judged) return nullptr;
    return {{"rays", judged->rays},
            {"wrong", judged->wrong},
            {"first", judged->first},
            {"seconds", judged->seconds}};
}

}   // namespace

nlohmann::ordered_json stream_json(const StreamJob& s) {
    return {{"file", s.rays.name()}, {"rays", s.rays.size()}, {"closest", s.closest},
            {"any", s.any},          {"clipped", s.clipped},  {"missing", s.missing}};
}

nlohmann::ordered_json stream_run_json(const StreamJob& s, const std::vector<Closest>& answers,
                                       const std::vector<FramesAtClock>& runs, bool partial,
                                       const std::optional<StreamJudgement>& judged) {
    const Config& config = s.job.config;
    const FrameResult& first = runs[0].last();
    std::size_t hits = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) hits += hit_of(s, i, answers[i]).hit;
    nlohmann::ordered_json stream = stream_json(s);
    stream["hits"] = hits;
    nlohmann::ordered_json clocks = nlohmann::ordered_json::array();
    for (const FramesAtClock& run : runs) {
        clocks.push_back(clock_json(config, run));
        mark_clock(clocks.back(), config, run.khz);
    }
    return {{"scene", scene_json(s.scene)},
            {"stream", stream},
            {"config", config_json_object(config)},
            {"partial", partial},
            {"compile", compile_json(s.job.image.report)},
            {"rays", rays_json(first.rays)},
            {"work", work_json(first)},
            {"clocks", clocks},
            {"units", units_json(config, first)},
            {"memory", memory_json(config, runs[0].khz, first)},
            {"judge", judgement_json(judged)}};
}

nlohmann::ordered_json simulated_stream_json(const StreamJob& stream, const StreamResult& run, bool partial,
                                             double seconds) {
    nlohmann::ordered_json json = stream_run_json(stream, run.answers(), run.runs, partial, run.judged);
    Digest digest;
    std::uint64_t cycles = 0;
    for (const FramesAtClock& at : run.runs) digest.add(at.last().digest), cycles += at.last().cycles;
    json["host"] = {{"seconds", seconds}, {"cycles_per_second", double(cycles) / seconds}};
    json["digest"] = digest_text(digest.value());
    return json;
}

}   // namespace rayclock
