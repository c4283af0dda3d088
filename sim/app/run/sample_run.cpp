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

sample::Estimate cycles_of(const sample::Sampled& sampled) {
    return sampled.total([](const FrameTiming& t) { return double(t.cycles); });
}

/// Returns the widest relative interval of the cycles.
double widest_of(const std::vector<sample::Sampled>& clocks) {
    double widest = 0;
    for (const sample::Sampled& s : clocks) widest = std::max(widest, cycles_of(s).relative());
    return widest;
}

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

std::vector<sample::Sampled> run_sample(const Job& job, const std::vector<int>& clocks,
                                        const SampleChoice& choice, double seconds_gone, sample::Ask& ask,
                                        Traffic traffic, int threads, const Progress& progress) {
    const Stopwatch watch;
    ask.share = share_of(choice);
    std::vector<sample::Sampled> sampled = sample::run(job, clocks, ask, traffic, threads, progress);
    if (choice.share) return sampled;
    const sample::Effort& pilot = sampled[0].effort();
    double factor = 1;
    if (choice.error) {
        factor = 1.2 * std::pow(100 * widest_of(sampled) / parse_percent("--error", *choice.error, false), 2);
    } else {
        factor = 0.8 * (parse_seconds(*choice.within) - seconds_gone - watch.seconds()) / pilot.seconds;
    }
    ask.share = std::min(sample::max_share, 2.0 * pilot.strata / pilot.parts * std::max(1.0, factor));
    if (factor <= 1 || sample::strata_of(job.frame, job.config, ask.share) == pilot.strata) return sampled;
    // A sample of another size draws its parts independently of the first one, whose random error decided the
    // size.
    return sample::run(job, clocks, ask, traffic, threads, progress);
}

std::string shortfall(const SampleChoice& choice, const std::vector<sample::Sampled>& clocks,
                      double seconds) {
    if (choice.error && 100 * widest_of(clocks) > parse_percent("--error", *choice.error, false))
        return fmt::format("--error {}: the interval of the cycles is +-{:.2f} %", *choice.error,
                           100 * widest_of(clocks));
    if (choice.within && seconds > parse_seconds(*choice.within))
        return fmt::format("--within {}: the sample took {:.2f} s", *choice.within, seconds);
    return {};
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

nlohmann::ordered_json sample_json(const Request& request, const Job& job, FrameSize size,
                                   const Camera& camera, const sample::Ask& ask,
                                   const std::vector<sample::Sampled>& sampled) {
    const Config& config = request.config;
    nlohmann::ordered_json clocks = nlohmann::ordered_json::array();
    FrameResult first;
    double cycles = 0;
    for (const sample::Sampled& s : sampled) {
        FramesAtClock run{s.khz(), {s.frame(config)}};
        clocks.push_back(clock_json(config, run));
        leave_out_waits(clocks.back()["memory"]);
        mark_clock(clocks.back(), config, run.khz);
        cycles += double(run.last().cycles);
        if (clocks.size() == 1) first = run.last();
    }
    nlohmann::ordered_json memory = memory_json(config, sampled[0].khz(), first);
    leave_out_waits(memory);
    const double seconds = sampled[0].effort().seconds;
    return {{"scene", scene_json(request.scene)},
            {"config", config_json_object(config)},
            {"frame", {{"width", size.width}, {"height", size.height}}},
            {"camera", camera_json(camera)},
            {"frames", 1},
            {"pan", 0},
            {"film", nullptr},
            {"engine", "model"},
            {"partial", false},
            {"sampling", sampling_json(config, ask, sampled)},
            {"compile", compile_json(job.image.report)},
            {"rays", rays_json(first.rays)},
            {"work", work_json(first)},
            {"work_by_kind", nullptr},
            {"clocks", clocks},
            {"units", units_json(config, first)},
            {"memory", memory},
            {"error", nullptr},
            {"limits", nullptr},
            {"judge", nullptr},
            {"host",
             {{"seconds", seconds},
              {"record_seconds", 0},
              {"judge_seconds", 0},
              {"cycles_per_second", cycles / seconds},
              {"rays_per_second", rays_of(first) * double(sampled.size()) / seconds}}},
            {"digest", nullptr}};
}

}   // namespace rayclock
