// Runs a sample and makes its report.
#include "sim/app/run/sample_run.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/sampled.hpp"

namespace rayclock {

namespace {

/// Parses "10s" or "0.5 s" to seconds.
double parse_seconds(const std::string& typed) {
    double value = 0;
    const char* const end = typed.data() + typed.size();
    const auto [rest, error] = std::from_chars(typed.data(), end, value);
    const std::string_view unit(rest, std::size_t(end - rest));
    if (error != std::errc() || (unit != "s" && unit != " s"))
        throw UserError("--within: " + shown(typed) + " is not a number of seconds such as 10s");
    if (!(value > 0 && value <= 1e6))
        throw UserError("--within: " + shown(typed) + " must lie above 0 and not above 1000000 s");
    return value;
}

/// Returns the requested share; 0 is the smallest sample.
double share_of(const SampleChoice& choice) { return choice.share ? parse_share(*choice.share) : 0; }

}   // namespace

double parse_share(const std::string& typed) {
    const double percent = parse_percent("--sample", typed, false);
    if (percent > 100 * sample::max_share)
        throw UserError(
            fmt::format("--sample: {} is more than {:g} %, where simulating the whole frame is "
                        "faster",
                        shown(typed), 100 * sample::max_share));
    return percent / 100;
}

void check_sample(const SampleChoice& choice) {
    if (int(choice.share.has_value()) + int(choice.error.has_value()) + int(choice.within.has_value()) > 1)
        throw UserError("--sample, --error and --within each give the size of the sample; give one of them");
    share_of(choice);
    if (choice.error) parse_percent("--error", *choice.error, false);
    if (choice.within) parse_seconds(*choice.within);
}

namespace {

/// A sample of the film's current frame at all clocks.
struct FrameSample {
    SampledFrame frame;
    std::vector<FrameResult> results;   ///< [clock]
};

class FrameSampler {
public:
    FrameSampler(const Film& film, const std::vector<int>& clocks, Disturbance disturbance, int threads)
        : film_(film), clocks_(clocks), disturbance_(disturbance), threads_(threads) {}

    FrameSample run(const sample::Ask& ask, const Upload& upload, const Frame* before,
                    const Progress& progress) const {
        const Job& job = film_.job();
        FrameSample s;
        s.frame.ask = ask;
        for (const sample::Sampled& sampled :
             sample::run(job, clocks_, ask, disturbance_, threads_, progress, before)) {
            UploadTiming waits;
            if (film_.moves()) waits = sample::upload_timing(job.config, sampled.khz(), disturbance_, upload);
            s.frame.effort = sampled.effort();
            s.results.push_back(sampled.frame(job.config));
            s.results.back().upload = waits;
            s.frame.estimates.emplace_back();
            for (const SampledFigure& figure :
                 sampled_figures(job.config, sampled.khz(), waits.cycles + waits.reset))
                s.frame.estimates.back().push_back(figure.estimate(sampled));
        }
        return s;
    }

private:
    const Film& film_;
    const std::vector<int>& clocks_;
    Disturbance disturbance_;
    int threads_;
};

/// Returns how many times the parts of a small sample are needed, or affordable.
double factor_of(const SampleChoice& choice, const SampledFrame& pilot, double seconds_gone) {
    if (choice.error)
        return 1.2 * std::pow(100 * widest_of(pilot) / parse_percent("--error", *choice.error, false), 2);
    return 0.8 * (parse_seconds(*choice.within) - seconds_gone) / pilot.effort.seconds;
}

std::string shortfall(const SampleChoice& choice, const std::vector<SampledFrame>& frames, double seconds) {
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const double widest = 100 * widest_of(frames[f]);
        if (choice.error && widest > parse_percent("--error", *choice.error, false))
            return fmt::format("--error {}: the interval of the cycles is +-{:.2f} %{}", *choice.error,
                               widest, frames.size() > 1 ? fmt::format(" in frame {}", f + 1) : "");
    }
    if (choice.within && seconds > parse_seconds(*choice.within))
        return fmt::format("--within {}: the sample took {:.2f} s", *choice.within, seconds);
    return {};
}

}   // namespace

SampledFilm run_sample(Film& film, const std::vector<int>& clocks, const SampleChoice& choice,
                       std::uint64_t seed, Disturbance disturbance, int threads, const Stopwatch& watch,
                       const Progress& progress) {
    if (choice.within && film.frames() > 1)
        throw UserError("--within gives the time for one frame; for a film give --sample or --error");
    SampledFilm all;
    all.strip.moves = film.moves();
    all.strip.fps = film.times().fps;
    all.strip.times = film.times().times;
    for (const int khz : clocks) all.runs.push_back({khz, {}});
    const FrameSampler sampler(film, clocks, disturbance, threads);
    for (std::size_t f = 0; f < film.frames(); ++f) {
        const Frame previous = film.job().frame;
        film.next();
        Upload upload = film.take_upload();
        const Frame* const before = f > 0 && !upload.resets ? &previous : nullptr;
        const Stopwatch frame_watch;
        const Progress of_film = [&](std::string_view what, std::uint64_t done, std::uint64_t total) {
            progress(what, f * total + done, film.frames() * total);
        };
        sample::Ask ask{share_of(choice), seed + f};
        FrameSample s = sampler.run(ask, upload, before, of_film);
        if (!choice.share) {
            const double factor = factor_of(choice, s.frame, watch.seconds());
            const sample::Effort& pilot = s.frame.effort;
            ask.share = std::min(sample::max_share, 2.0 * pilot.strata / pilot.parts * std::max(1.0, factor));
            s.frame.ask.share = ask.share;
            // A sample of another size draws its parts independently of the first one, whose random error
            // decided the size.
            if (factor > 1 &&
                sample::strata_of(film.job().frame, film.job().config, ask.share) != pilot.strata)
                s = sampler.run(ask, upload, before, of_film);
        }
        s.frame.time = all.strip.times[f];
        for (std::size_t k = 0; k < clocks.size(); ++k) all.runs[k].frames.push_back(std::move(s.results[k]));
        all.frames.push_back(std::move(s.frame));
        upload.lines = {}, upload.words = {};
        all.uploads.push_back({film.job().frame, {}, std::move(upload)});
        all.seconds += frame_watch.seconds();
    }
    all.shortfall = shortfall(choice, all.frames, watch.seconds());
    return all;
}

namespace {

/// A sample does not estimate how late the screen's reads are in the whole frame.
void leave_out_waits(nlohmann::ordered_json& memory) {
    nlohmann::ordered_json& dram = memory["dram"];
    if (!dram.contains("scan_out")) return;
    for (const char* wait : {"backlog", "underruns"})
        if (dram["scan_out"].contains(wait)) dram["scan_out"][wait] = nullptr;
}

}   // namespace

nlohmann::ordered_json sample_json(Film& film, FrameSize size, double pan, const std::vector<int>& clocks,
                                   const SampledFilm& sampled) {
    const Job& job = film.job();
    const Config& config = job.config;
    const FrameResult& frame = sampled.runs[0].last();
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    double cycles = 0, rays = 0;
    for (const FramesAtClock& run : sampled.runs) {
        runs.push_back(clock_json(config, run));
        leave_out_waits(runs.back()["memory"]);
        mark_clock(runs.back(), config, run.khz);
        for (const FrameResult& f : run.frames) cycles += double(f.cycles), rays += rays_of(f);
    }
    nlohmann::ordered_json memory = memory_json(config, clocks[0], frame);
    leave_out_waits(memory);
    nlohmann::ordered_json sampling = sampling_json(config, clocks, sampled.frames, film.moves());
    sampling["shortfall"] =
        sampled.shortfall.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(sampled.shortfall);
    return {{"scene", scene_json(film.request().scene)},
            {"config", config_json_object(config)},
            {"frame", {{"width", size.width}, {"height", size.height}}},
            {"camera", camera_json(film.camera())},
            {"frames", film.frames()},
            {"pan", pan},
            {"film", film_json(config, sampled.runs, sampled.strip, sampled.uploads)},
            {"engine", name_of(Tracer::model)},
            {"partial", false},
            {"sampling", sampling},
            {"compile", compile_json(job.image.report)},
            {"rays", rays_json(frame.rays)},
            {"work", work_json(frame)},
            {"work_by_kind", nullptr},
            {"clocks", runs},
            {"units", units_json(config, frame)},
            {"memory", memory},
            {"error", nullptr},
            {"limits", nullptr},
            {"judge", nullptr},
            {"host",
             {{"seconds", sampled.seconds},
              {"record_seconds", 0},
              {"judge_seconds", 0},
              {"cycles_per_second", cycles / sampled.seconds},
              {"rays_per_second", rays / sampled.seconds}}},
            {"digest", nullptr}};
}

}   // namespace rayclock
