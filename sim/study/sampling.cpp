// Measures samples against whole frames.
#include "sim/study/sampling.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "sim/files/process/parallel.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/files/table.hpp"
#include "sim/run/sample/sample.hpp"
#include "sim/view/report/sampled.hpp"

namespace rayclock::sampling {

namespace {

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// The figures of one seed.
struct Seed {
    std::vector<sample::Estimate> estimates;
    sample::Effort effort;
    double seconds = 0;
};

FrameRows measure_frame(const Study& study, const FrameSpec& spec, std::size_t number,
                        const Progress& progress) {
    Finish finish;
    if (spec.depth > 0) finish.depth = spec.depth;
    const Request request = request_of(spec.scene, spec.config, finish, 1, spec.size, {}, {});
    const Job job =
        make_job(request.scene, *request.scene.camera, spec.size, request.config, {}, request.settings);
    FrameRows result{spec, {}, 0, 0, 0, 0};
    const double start = thread_seconds();
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame, 1));
    const double walked = frames[0].trace.seconds;   // in a separate thread
    const FrameResult whole = frame_result(frames[0], replay(job.config, study.khz, frames)[0]);
    result.whole_seconds = thread_seconds() - start + walked;
    frames.clear();

    const std::vector<SampledFigure> figures = sampled_figures(job.config, study.khz);
    std::vector<Seed> seeds(std::size_t(study.seeds));
    std::atomic<std::size_t> done = 0;
    parallel::for_each(seeds.size(), study.threads, [&](std::size_t s) {
        stop_if_interrupted();
        const double begin = thread_seconds();
        const sample::Sampled sampled = sample::run(job, {study.khz}, {study.share, s + 1}, {}, 1)[0];
        seeds[s].seconds = thread_seconds() - begin;
        seeds[s].effort = sampled.effort();
        for (const SampledFigure& figure : figures) seeds[s].estimates.push_back(figure.estimate(sampled));
        if (progress) progress("samples", number * seeds.size() + ++done, study.frames.size() * seeds.size());
    });
    const double n = double(seeds.size());
    for (const Seed& seed : seeds) {
        result.sample_seconds += seed.seconds / n;
        result.measured += double(seed.effort.measured_pixels) / double(seed.effort.pixels) / n;
        result.replayed += double(seed.effort.replayed_pixels) / double(seed.effort.pixels) / n;
    }
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const double exact = figures[i].exact(whole);
        if (exact == 0) continue;
        Row row{figures[i].key, exact, 0, 0, 0, 0};
        std::vector<double> widths;
        double squares = 0;
        for (const Seed& seed : seeds) {
            const sample::Estimate& e = seed.estimates[i];
            const double error = e.value / exact - 1;
            row.covered += double(std::fabs(e.value - exact) <= e.half_width) / n;
            row.bias += error / n;
            squares += error * error / n;
            widths.push_back(e.half_width / exact);
        }
        std::nth_element(widths.begin(), widths.begin() + std::ptrdiff_t(widths.size() / 2), widths.end());
        row.half_width = widths[widths.size() / 2];
        row.deviation = std::sqrt(std::max(0.0, squares - row.bias * row.bias));
        result.rows.push_back(row);
    }
    return result;
}

std::string name_of(const FrameSpec& spec) {
    std::string text = fmt::format("`{}` {}x{}", spec.scene, spec.size.width, spec.size.height);
    if (spec.depth > 0) text += fmt::format(", depth {}", spec.depth);
    text += ", " + spec.config.name;
    for (const std::string& item : spec.config.set) text += ", " + item;
    return text;
}

std::string percent(double share, int digits) { return fmt::format("{:.{}f} %", 100 * share, digits); }

}   // namespace

std::vector<FrameSpec> usual_frames() {
    const auto with = [](std::vector<std::string> set, const char* name = "default") {
        ConfigChoice choice;
        choice.name = name;
        choice.set = std::move(set);
        return choice;
    };
    return {{"gears:8", {512, 384}, with({}), 0},
            {"balls:4", {320, 256}, with({}), 4},
            {"teapot:12", {512, 384}, with({}), 0},
            {"tree:8", {512, 384}, with({}), 0},
            {"mount:8", {512, 384}, with({}), 0},
            {"rings:4", {320, 256}, with({}), 0},
            {"gears:8", {512, 384}, with({"structure=kd"}), 0},
            {"gears:4", {384, 256}, with({"structure=bsp"}), 0},
            {"gearbox:8", {512, 384}, with({"levels=2"}), 0},
            {"spheres", {320, 256}, with({}), 3},
            {"gears:4", {384, 256}, with({"dram=sdr"}, "small"), 0},
            {"gears:8", {640, 512}, with({}, "wide"), 0}};
}

std::vector<FrameRows> measure(const Study& study, const Progress& progress) {
    std::vector<FrameRows> frames;
    for (const FrameSpec& spec : study.frames)
        frames.push_back(measure_frame(study, spec, frames.size(), progress));
    return frames;
}

double coverage(const std::vector<FrameRows>& frames) {
    double sum = 0;
    for (const FrameRows& frame : frames) sum += frame.cycles().covered;
    return sum / double(frames.size());
}

std::string page(const std::vector<FrameRows>& frames, const Study& study, const std::string& command) {
    std::string text = fmt::format(
        "# Samples against whole frames\n\nMade by `{}`. Do not edit. [sampling.md](../guide/sampling.md) "
        "explains the design.\n\nEach row has {} samples of a frame, with the seeds 1 to {}. The clock is "
        "{:g} MHz, and the share is {:g} %. In a small frame the smallest sample exceeds this share. "
        "Coverage is the share of the 95 % intervals that contain the figure of the whole frame. Bias is the "
        "mean error of the estimates, and deviation is their standard deviation. Half-widths are medians. "
        "Time is processor time without scene compilation.\n\n## Cycles\n\n",
        command, study.seeds, study.seeds, study.khz / 1e3, 100 * study.share);
    Table cycles({"frame", "cycles", "measured", "replayed", "coverage", "half-width", "bias", "deviation",
                  "speed-up"});
    for (const FrameRows& f : frames) {
        const Row& row = f.cycles();
        cycles.add({name_of(f.spec), grouped(std::uint64_t(row.exact)), percent(f.measured, 1),
                    percent(f.replayed, 1), percent(row.covered, 1), percent(row.half_width, 2),
                    percent(row.bias, 2), percent(row.deviation, 2),
                    fmt::format("{:.1f} times", f.whole_seconds / f.sample_seconds)});
    }
    text += cycles.markdown() +
            fmt::format("\nOver all {} samples, {} of the intervals contain the cycles.\n",
                        frames.size() * std::size_t(study.seeds), percent(coverage(frames), 1));
    text += "\n## All figures\n\nEach row is the mean over the frames that have the figure.\n\n";
    std::vector<std::string> keys;
    for (const FrameRows& f : frames)
        for (const Row& row : f.rows)
            if (std::find(keys.begin(), keys.end(), row.key) == keys.end()) keys.push_back(row.key);
    Table all({"figure", "frames", "coverage", "half-width", "bias"});
    for (const std::string& key : keys) {
        double covered = 0, width = 0, bias = 0, n = 0;
        for (const FrameRows& f : frames)
            for (const Row& row : f.rows)
                if (row.key == key) covered += row.covered, width += row.half_width, bias += row.bias, ++n;
        all.add({"`" + key + "`", fmt::format("{}", n), percent(covered / n, 1), percent(width / n, 2),
                 percent(bias / n, 2)});
    }
    return text + all.markdown();
}

nlohmann::ordered_json rows_json(const std::vector<FrameRows>& frames) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const FrameRows& f : frames) {
        nlohmann::ordered_json figures = nlohmann::ordered_json::object();
        for (const Row& r : f.rows)
            figures[r.key] = {{"exact", r.exact},
                              {"coverage", r.covered},
                              {"half_width", r.half_width},
                              {"bias", r.bias},
                              {"deviation", r.deviation}};
        all.push_back({{"scene", f.spec.scene},
                       {"width", f.spec.size.width},
                       {"height", f.spec.size.height},
                       {"config", f.spec.config.name},
                       {"set", f.spec.config.set},
                       {"depth", f.spec.depth},
                       {"measured", f.measured},
                       {"replayed", f.replayed},
                       {"whole_seconds", f.whole_seconds},
                       {"sample_seconds", f.sample_seconds},
                       {"figures", figures}});
    }
    return {{"coverage", coverage(frames)}, {"frames", all}};
}

}   // namespace rayclock::sampling
