// Runs the model, then the RTL under its judges.
#include "sim/run/elastic/elastic.hpp"

#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "model/base/stopwatch.hpp"
#include "model/machine/machine.hpp"
#include "model/machine/stuck_rays.hpp"
#include "sim/run/elastic/line_judge.hpp"
#include "sim/run/elastic/ray_judge.hpp"
#include "sim/run/elastic/steady_offers.hpp"
#include "sim/run/gen/registers.hpp"
#include "sim/run/lockstep/ray_end.hpp"
#include "sim/run/rtl/rtl_machine.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t cycles_between_progress = 1 << 14;

class Elastic {
public:
    Elastic(const Job& job, const std::vector<RecordedFrame>& frames, const FreeUnits& free,
            Disturbance disturbance, int seed)
        : job_(job),
          frames_(frames),
          limit_(patience(job.config, job.khz, disturbance)),
          model_(job.config, job.khz, disturbance),
          rtl_(job.image, job.config, job.khz, disturbance, seed),
          image_(job.image),
          rays_(job_.config, rtl_, free, findings_),
          lines_(job_.config, rtl_, findings_),
          offers_(job_.config, rtl_, findings_) {
        lines_.start(image_, true);
        rtl_.watch([this] { judge(rtl_.cycle()); });
    }

    ElasticResult run(const Progress& progress) {
        for (std::size_t f = 0; f < frames_.size() && !interrupted(); ++f) {
            run_frame(f, progress);
            if (broken_) break;
        }
        result_.model.partial = result_.model.partial || result_.rtl.partial ||
                                (interrupted() && result_.rtl_runs.size() < frames_.size());
        result_.events_compared = findings_.events_compared;
        result_.value_mismatches = findings_.value_mismatches;
        result_.first = std::move(findings_.first);
        return std::move(result_);
    }

private:
    /// Calls work() unless the RTL is broken. A failed assertion is reported as a difference. After it, the
    /// RTL does not run again.
    template <class Work> void guarded(Work&& work) {
        if (broken_) return;
        try {
            work();
        } catch (const RtlAssertion& assertion) {
            broken_ = true;
            findings_.add([&] {
                return difference(rtl_.cycle(), "rtl", "none", "no assertion fails", assertion.what());
            });
        }
    }

    void run_frame(std::size_t f, const Progress& progress) {
        const RecordedFrame& frame = frames_[f];
        const Upload& upload = frame.upload;
        if (upload.image_lines > 0) {
            apply(upload, image_);
            rtl_.change(upload);
        }
        Script script(frame.frame);
        run_model_frame(f, script, progress);
        run_rtl_frame(f, std::move(script), progress);
        if (!findings_.first || reported_) return;
        reported_ = true;
        findings_.first->frame = f, findings_.first->frame_begins = begins_;
    }

    void run_model_frame(std::size_t f, Script& script, const Progress& progress) {
        const RecordedFrame& frame = frames_[f];
        const Stopwatch watch;
        const UploadTiming upload = prepare_frame(model_, f, std::span(frames_));
        const std::uint64_t first = model_.cycle();
        const Accounts accounts = model_.accounts();
        const MemoryStats memory = model_.memory().stats();
        model_.start(frame.frame, frame.trace);
        while (!model_.done() && !interrupted()) {
            model_.step([&](const Move& move) { script.add(move); });
            if (model_.quiet() > limit_)
                throw std::runtime_error(fmt::format("nothing has moved for {} cycles at cycle {}\n{}",
                                                     limit_, model_.cycle(), describe_stuck_rays(model_)));
            if (progress && model_.cycle() % cycles_between_progress == 0)
                progress("model", model_.finished_pixels(), script.size());
        }
        result_.model =
            frame_result(job_, frame.frame,
                         {model_.cycle() - first, model_.finished_pixels(), model_.accounts() - accounts,
                          model_.memory().stats() - memory, watch.seconds(), !model_.done(), upload},
                         work(frame), frame.trace.hits, frame.trace.colours);
        result_.runs.push_back(frame_result(frame, result_.model));
    }

    void run_rtl_frame(std::size_t f, Script script, const Progress& progress) {
        const RecordedFrame& frame = frames_[f];
        const Stopwatch watch;
        const std::uint64_t pixels = script.size();
        UploadTiming upload;
        offers_.forget();   // the cycles between two frames are not watched
        guarded([&] { upload = prepare_frame(rtl_, f, std::span(frames_)); });
        const std::uint64_t first = rtl_.cycle();
        begins_ = first;
        const MemoryStats memory = rtl_.memory().stats();
        FrameCollector hits(frame.frame, job_.config.has_shade());
        lines_.start(image_, upload.reset > 0);
        host_signals_reported_ = false;
        bool hangs = false;
        guarded([&] {
            rtl_.start(frame.frame);
            rays_.start(frame.frame, image_, std::move(script));
            has_begun_ = true;
            hangs = !clock_rtl(pixels, hits, progress);
        });
        const std::uint64_t cycles = rtl_.cycle() - first;
        Accounts accounts;
        const bool is_done = !hangs && !broken_ && !interrupted();
        guarded([&] {
            check_end(hangs);
            if (is_done) check_counters(cycles);
            accounts = rtl_.accounts();
        });
        result_.rtl = frame_result(job_, frame.frame,
                                   {cycles, rtl_.finished_pixels(), accounts, rtl_.memory().stats() - memory,
                                    watch.seconds(), interrupted() && !rtl_.done(), upload},
                                   work(frame), hits.hits(), hits.colours());
        if (is_done && f + 1 == frames_.size()) guarded([&] { drain(); });
        report_invalid_value();
        broken_ = broken_ || hangs;
        result_.rtl_runs.push_back(frame_result(frame, result_.rtl));
        compare_pixels();
    }

    /// Clocks the RTL until its frame is done. Returns false if no ray moves any more, or if the RTL takes
    /// far longer than the model after its first difference.
    bool clock_rtl(std::size_t pixels, FrameCollector& hits, const Progress& progress) {
        std::uint64_t give_up = 0;
        while (!rtl_.done() && !interrupted()) {
            const std::uint64_t now = rtl_.cycle();
            rtl_.settle();
            judge(now);
            check_host_signals(now, true);
            if (findings_.first && give_up == 0) give_up = now + 4 * result_.model.cycles + limit_;
            if (now - rays_.moved_at() > limit_ || (give_up > 0 && now > give_up)) return false;
            rtl_.clock([&](const HitOut& hit) { hits.add(hit); });
            if (progress && now % cycles_between_progress == 0)
                progress("rtl", rtl_.finished_pixels(), pixels);
        }
        return true;
    }

    void judge(std::uint64_t now) {
        if (interrupted()) return;   // the frame ends early
        if (has_begun_) rays_.cycle(now);
        lines_.cycle(now);
        offers_.cycle(now);
    }

    /// Clocks the RTL on after the last frame: nothing may follow a frame's last pixel.
    void drain() {
        for (std::uint64_t i = 0; i < limit_ && !findings_.first && !interrupted(); ++i) {
            rtl_.settle();
            judge(rtl_.cycle());
            rtl_.clock([](const HitOut&) {});
        }
    }

    /// Checks the chip's signals `running` and `done`, after RtlMachine::settle(). Reports at most one
    /// difference in each frame.
    void check_host_signals(std::uint64_t now, bool runs) {
        if (host_signals_reported_ || (rtl_.running() == runs && rtl_.done_signal() == !runs)) return;
        host_signals_reported_ = true;
        const bool is_done = rtl_.running() == runs;   // the signal that differs
        const char* const texts[2][2] = {{"the frame does not run", "the frame runs"},
                                         {"the frame is done", "the frame is not done"}};
        findings_.add([&] {
            return difference(now, "host", is_done ? "done" : "running", texts[is_done][runs],
                              texts[is_done][!runs]);
        });
    }

    /// Checks that the chip counted every cycle of the frame, and in each unit one cause for every cycle.
    void check_counters(std::uint64_t cycles) {
        const auto demand = [&](std::string unit, const char* counter, std::uint64_t wanted,
                                std::uint64_t got) {
            if (wanted != got)
                findings_.add([&] {
                    return difference(rtl_.cycle(), std::move(unit), counter,
                                      fmt::format("{} cycles", wanted), fmt::format("{} cycles", got));
                });
        };
        demand("host", "cycles", cycles, rtl_.counted_cycles());
        for (std::size_t u = 0; u < pipeline_units + shared_units; ++u) {
            if (!is_there(Unit(u), job_.config)) continue;
            const CauseCounts& causes = rtl_.accounts().units[u];
            const std::uint64_t copies = u < pipeline_units ? std::uint64_t(job_.config.pipelines) : 1;
            demand(unit_infos[u].name, "counters", cycles * copies,
                   std::accumulate(causes.begin(), causes.end(), std::uint64_t(0)));
        }
    }

    /// Reports what is missing at the end of a frame, and the chip's signals if they are wrong.
    void check_end(bool hangs) {
        if (interrupted()) return;
        const std::uint64_t now = rtl_.cycle();
        if (rays_.unfinished() > 0) {
            findings_.add([&] {
                if (const auto line = lines_.missing(now); hangs && line) return *line;
                return rays_.missing(now);
            });
            return;
        }
        if (hangs) return;
        rtl_.settle();
        check_host_signals(now, false);
    }

    void report_invalid_value() {
        if (!rtl_.invalid_value() || findings_.first) return;
        const RtlMachine::InvalidValue& n = *rtl_.invalid_value();
        findings_.add([&] {
            Divergence d =
                difference(n.cycle, located(link_infos[index(n.link)].from, n.pipeline, n.link, job_.config),
                           n.pipeline, n.link);
            d.expected = "a value in range";
            d.got = n.what;
            return d;
        });
    }

    void compare_pixels() {
        if (result_.model.partial || result_.rtl.partial) return;
        for (std::size_t i = 0; i < result_.model.answers.size(); ++i) {
            findings_.value_mismatches +=
                !same_answer(result_.model.answers[i], result_.rtl.answers[i]) ||
                (job_.config.has_shade() && result_.model.colours[i] != result_.rtl.colours[i]);
        }
    }

    static RayWork work(const RecordedFrame& frame) {
        return {frame.trace.counts, frame.trace.visits, frame.trace.box_tests, frame.trace.triangle_tests};
    }

    const Job& job_;
    const std::vector<RecordedFrame>& frames_;
    std::uint64_t limit_;
    Machine model_;
    RtlMachine rtl_;
    MemoryImage image_;   // of the current frame
    Findings findings_;
    RayJudge rays_;
    LineJudge lines_;
    SteadyOffers offers_;
    std::uint64_t begins_ = 0;
    bool broken_ = false, reported_ = false;   // broken_: the RTL cannot run another frame
    bool host_signals_reported_ = false;       // a wrong signal was reported in this frame
    bool has_begun_ = false;                   // the first frame
    ElasticResult result_;
};

}   // namespace

ElasticResult run_elastic(const Job& job, const std::vector<RecordedFrame>& frames, const FreeUnits& free,
                          Disturbance disturbance, const Progress& progress, int seed) {
    return Elastic(job, frames, free, disturbance, seed).run(progress);
}

ElasticResult run_elastic(const Job& job, Disturbance disturbance, const Progress& progress, int seed) {
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame));
    return run_elastic(job, frames, parse_free_units("all", job.config), disturbance, progress, seed);
}

std::string unit_names(const Config& config) {
    std::string text;
    for (const UnitInfo& unit : unit_infos)
        if (is_there(unit.when, config) && unit.place != UnitPlace::outside)
            text += (text.empty() ? "" : ", ") + std::string(unit.name);
    return text;
}

FreeUnits parse_free_units(const std::string& text, const Config& config) {
    FreeUnits free{};
    for (const std::string& word : split(text, ',')) {
        if (word.empty())
            throw UserError(fmt::format("--elastic {}: a unit is missing in the list", shown(text)));
        if (word == "all") {
            free.fill(true);
            continue;
        }
        const std::optional<Unit> unit = unit_called(word);
        if (!unit || unit_infos[index(*unit)].place == UnitPlace::outside)
            throw UserError(fmt::format("--elastic {}: no unit is called {}; this chip has {}",
                                        printable(text), shown(word), unit_names(config)));
        if (!is_there(*unit, config))
            throw UserError(fmt::format("--elastic {}: the chip '{}' has no unit {}", printable(text),
                                        printable(config.name), word));
        free[index(*unit)] = true;
    }
    return free;
}

}   // namespace rayclock
