// Steps both machines in the same loop and compares them.
#include "sim/run/lockstep/lockstep.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "model/base/stopwatch.hpp"
#include "model/machine/machine.hpp"
#include "model/machine/payload_replay.hpp"
#include "model/machine/stuck_rays.hpp"
#include "sim/run/lockstep/driver.hpp"
#include "sim/run/lockstep/fields.hpp"
#include "sim/run/lockstep/ray_end.hpp"
#include "sim/run/rtl/rtl_machine.hpp"

namespace rayclock {

namespace {

/// Returns "the RTL makes it 1 cycle later".
std::string later_text(const char* who, std::uint64_t cycles, bool same) {
    const std::string when = fmt::format("{} cycle{} later", cycles, cycles == 1 ? "" : "s");
    return same ? fmt::format("{} makes it {}", who, when)
                : fmt::format("{} makes another transfer there, {}", who, when);
}

std::optional<CounterDifference> first_difference(const Accounts& model, const Accounts& rtl) {
    std::optional<CounterDifference> first;
    for (std::size_t u = 0; u < unit_count; ++u)
        for (std::size_t c = 0; c < cause_count; ++c) {
            const std::uint64_t m = model.units[u][c], r = rtl.units[u][c];
            if (m == r) continue;
            const Cause& cause = unit_infos[u].causes[c];
            const char* kind = cause.kind == CauseKind::busy      ? "busy with"
                               : cause.kind == CauseKind::starved ? "starved by"
                                                                  : "stalled by";
            if (first)
                ++first->others;
            else
                first = {unit_infos[u].name,
                         cause.kind == CauseKind::none ? fmt::format("in the unused state {}", c)
                                                       : fmt::format("{} {}", kind, cause.name),
                         m, r, 0};
        }
    return first;
}

class Lockstep {
public:
    using OnFirst = std::function<void(const Divergence&)>;
    Lockstep(const Job& job, const std::vector<RecordedFrame>& frames, Disturbance disturbance, int seed,
             const OnFirst& on_first)
        : job_(job),
          frames_(frames),
          disturbance_(disturbance),
          on_first_(on_first),
          model_(job.config, job.khz, disturbance),
          rtl_(job.image, job.config, job.khz, disturbance, seed),
          image_(job.image),
          payloads_(std::in_place, image_, job.config) {}

    LockstepResult run(const Progress& progress) {
        const Stopwatch watch;
        for (std::size_t f = 0; f < frames_.size(); ++f) {
            frame_ = f;
            upload_frame(f);
            begins_ = model_.cycle();
            run_frame(frames_[f], progress);
            report_first();
            if (diverged_ || interrupted()) break;
        }
        for (FrameResult* run : {&result_.model, &result_.rtl})
            run->seconds = watch.seconds() - report_seconds_;
        return std::move(result_);
    }

private:
    /// Reports the first divergence once, with its frame.
    void report_first() {
        if (reported_ || !result_.first) return;
        reported_ = true;
        result_.first->frame = frame_, result_.first->frame_begins = begins_;
        const Stopwatch watch;
        if (on_first_) on_first_(*result_.first);
        report_seconds_ = watch.seconds();
    }

    /// Performs the host's writes before a frame on both machines.
    void upload_frame(std::size_t f) {
        const Upload& upload = frames_[f].upload;
        if (upload.image_lines > 0) {
            apply(upload, image_);
            payloads_.emplace(image_, job_.config);
            rtl_.change(upload);
        }
        upload_ = prepare_frame(model_, f, std::span(frames_));
        const UploadTiming other = prepare_frame(rtl_, f, std::span(frames_));
        if (upload_.cycles != other.cycles || upload_.reset != other.reset)
            throw std::runtime_error("model and RTL do not take the same time for what the host writes");
    }

    void run_frame(const RecordedFrame& frame, const Progress& progress) {
        const std::uint64_t pixels = frame.trace.rays.size(),
                            limit = patience(job_.config, job_.khz, disturbance_);
        const std::uint64_t first = model_.cycle();
        const Accounts accounts = model_.accounts();
        const MemoryStats memory = model_.memory().stats();
        FrameCollector hits(frame.frame, job_.config.has_shade());
        model_.start(frame.frame, frame.trace);
        rtl_.start(frame.frame);
        payloads_->start(frame.frame);
        stopped_.reset();
        while (!diverged_ && !(model_.done() && rtl_.done()) && !interrupted()) {
            cycle(hits);
            report_first();
            if (model_.quiet() > limit)
                throw std::runtime_error(fmt::format("nothing has moved for {} cycles at cycle {}\n{}", limit,
                                                     model_.cycle(), describe_stuck_rays(model_)));
            if (progress && model_.cycle() % (1 << 14) == 0)
                progress("model and rtl", model_.finished_pixels(), pixels);
        }
        if (diverged_)
            run_apart(limit, hits);
        else if (!interrupted())
            check_end();
        report_first();
        if (progress) progress("model and rtl", pixels, pixels);
        result_.model =
            run_of(frame, model_.cycle() - first, model_.finished_pixels(), model_.accounts() - accounts,
                   model_.memory().stats() - memory, frame.trace.hits, frame.trace.colours);
        result_.rtl = run_of(frame, rtl_.cycle() - first, rtl_.finished_pixels(),
                             diverged_ ? Accounts{} : rtl_.accounts(), rtl_.memory().stats() - memory,
                             hits.hits(), hits.colours());
        result_.cycle_gap +=
            model_.cycle() > rtl_.cycle() ? model_.cycle() - rtl_.cycle() : rtl_.cycle() - model_.cycle();
        if (stopped_ && !diverged_)
            result_.cycle_gap += std::max<std::uint64_t>(1, model_.cycle() - *stopped_);
        if (diverged_ && result_.cycle_gap == 0) result_.cycle_gap = 1;
        if (!result_.model.partial)
            for (std::size_t i = 0; i < result_.model.answers.size(); ++i)
                result_.value_mismatches +=
                    !same_answer(result_.model.answers[i], result_.rtl.answers[i]) ||
                    (job_.config.has_shade() && result_.model.colours[i] != result_.rtl.colours[i]);
        result_.runs.push_back(frame_result(frame, result_.model));
        compare_counters();
        report_invalid_value();
    }

    void compare_counters() {
        result_.counters_compared = !diverged_ && !stopped_;
        if (!result_.counters_compared) return;   // the RTL counts only while its frame runs
        auto difference = first_difference(result_.model.accounts, result_.rtl.accounts);
        if (!difference && rtl_.counted_cycles() != result_.model.cycles)
            difference = {"host", "cycles", result_.model.cycles, rtl_.counted_cycles(), 0};
        if (!difference) return;
        ++result_.account_mismatches;
        if (!result_.counter) result_.counter = difference;
    }

    /// Reports an impossible value of the RTL. Lockstep compares payloads, but not those of an RTL that runs
    /// alone.
    void report_invalid_value() {
        if (!rtl_.invalid_value()) return;
        ++result_.value_mismatches;
        if (result_.first) return;
        const RtlMachine::InvalidValue& n = *rtl_.invalid_value();
        result_.first = at(n.cycle, n.pipeline, n.link, last_ray_[index(n.link)]);
        result_.first->expected = "a value in range";
        result_.first->got = n.what;
    }

    /// Records a failed assertion. The RTL does not run on after it.
    void report_assertion(const RtlAssertion& assertion) {
        diverged_ = broken_ = true;
        watched_.reset();
        if (result_.first) return;
        result_.first = {rtl_.cycle(), "rtl", "none", 0, 0, 0, "no assertion fails", assertion.what(), ""};
    }

    /// Compares the chip's signals to the host: `running` and `done`.
    void check_host_signals(std::uint64_t now, bool runs) {
        const auto check_signal = [&](const char* signal, bool wanted, const char* yes, const char* no) {
            if (result_.first) return;
            result_.first = {now, "host", signal, 0, 0, 0, wanted ? yes : no, wanted ? no : yes, ""};
        };
        if (rtl_.running() != runs) {
            check_signal("running", runs, "the frame runs", "the frame does not run");
            if (!stopped_) stopped_ = now;
        }
        if (rtl_.done_signal() == runs)
            check_signal("done", !runs, "the frame is done", "the frame is not done");
    }

    /// Checks the cycle after the frame's last one.
    void check_end() {
        rtl_.settle();
        check_host_signals(model_.cycle(), false);
    }

    void cycle(FrameCollector& hits) {
        rtl_.settle();
        unmatched_.clear();
        const std::uint64_t now = model_.cycle();
        check_host_signals(now, true);
        model_.step([&](const Move& move) {
            last_ray_[index(move.link)] = move.id;
            (*payloads_)(
                move, [&](int pipeline, Link c, const auto& payload) { compare(now, pipeline, c, payload); });
        });
        for (int p = 0; p < job_.config.pipelines && !diverged_; ++p)
            if (const LinkMask differ =
                    (model_.valid_mask(p) ^ rtl_.valid_mask(p)) | (model_.fire_mask(p) ^ rtl_.fire_mask(p)))
                part(now, p, differ, {model_.valid_mask(p), model_.fire_mask(p)},
                     {rtl_.valid_mask(p), rtl_.fire_mask(p)});
        if (const LinkMask differ =
                (model_.shared_valid() ^ rtl_.shared_valid()) | (model_.shared_fire() ^ rtl_.shared_fire());
            differ && !diverged_)
            part(now, 0, differ, {model_.shared_valid(), model_.shared_fire()},
                 {rtl_.shared_valid(), rtl_.shared_fire()});
        try {
            rtl_.clock([&](const HitOut& hit) { hits.add(hit); });
        } catch (const RtlAssertion& assertion) {
            report_assertion(assertion);
        }
    }

    template <class P> void compare(std::uint64_t now, int pipeline, Link c, const P& payload) {
        if (!rtl_.fires(pipeline, c)) {
            unmatched_.push_back({pipeline, c, pack(payload, job_.config)});
            return;
        }
        pack(payload, job_.config, words_);
        ++result_.events_compared;
        const RcPort& port = rtl_.link(pipeline, c);
        if (std::memcmp(words_.data(), port.data, std::min<std::size_t>(words_.size() * 4, port.bytes)) == 0)
            return;
        ++result_.value_mismatches;
        if (result_.first) return;
        const P got = get_data<P>(port, job_.config);
        Divergence d = at(now, pipeline, c, id_of(payload));
        describe(payload, got, job_.config, d);
        d.unit = located(driver_of(c, d.field, job_.config, ray_end(rtl_, pipeline, payload, job_.config)),
                         pipeline, c, job_.config);
        result_.first = d;
    }

    struct Masks {
        LinkMask valid, fire;
    };
    /// Records that the machines no longer move in step: one offers or accepts a transfer that the other does
    /// not.
    void part(std::uint64_t now, int pipeline, LinkMask differ, Masks model, Masks rtl) {
        diverged_ = true;
        if (result_.first) return;
        // Prefer a link whose valid signal differs: valid comes from registers, but ready may depend on
        // another link's valid in the same cycle.
        const LinkMask offers = differ & (model.valid ^ rtl.valid);
        const Link c = Link(std::countr_zero(offers ? offers : differ));
        const auto offer_text = [&](const Masks& m) {
            return m.fire & bit(c)    ? "a transfer"
                   : m.valid & bit(c) ? "an offer that is not accepted"
                                      : "no offer";
        };
        result_.first =
            at(now, pipeline, c, rtl.valid & bit(c) ? rtl_id<0>(pipeline, c) : last_ray_[index(c)]);
        const bool offered = model.valid & bit(c);   // true: only the model offers; false: only the RTL does
        const RayEnd end{bool(*rtl_.done_port(pipeline).valid) == offered,
                         bool(*rtl_.pixel_port(pipeline).valid) == offered};
        result_.first->unit = located(offers ? driver_of(c, {}, job_.config, end) : link_infos[index(c)].to,
                                      pipeline, c, job_.config);
        result_.first->expected = offer_text(model);
        result_.first->got = offer_text(rtl);
        watch(now, pipeline, c, rtl.fire & bit(c), model.fire & bit(c));
    }

    /// Starts to wait for the transfer that only one of the machines made.
    void watch(std::uint64_t now, int pipeline, Link c, bool by_rtl, bool by_model) {
        if (by_rtl == by_model) return;
        watched_ = Watched{now, pipeline, c, by_rtl, {}};
        if (by_rtl) {
            const RcPort& port = rtl_.link(pipeline, c);
            watched_->words.assign((port.bytes + 3) / 4, 0);
            std::memcpy(watched_->words.data(), port.data, port.bytes);
        } else {
            for (const Unmatched& u : unmatched_)
                if (u.pipeline == pipeline && u.link == c) watched_->words = u.words;
        }
    }

    void seen(std::uint64_t now, const std::uint32_t* words, std::size_t bytes) {
        const bool same =
            std::memcmp(watched_->words.data(), words, std::min(bytes, watched_->words.size() * 4)) == 0;
        result_.first->later =
            later_text(watched_->by_rtl ? "the model" : "the RTL", now - watched_->cycle, same);
        watched_.reset();
    }

    template <std::size_t i> std::uint32_t rtl_id(int pipeline, Link c) const {
        if constexpr (i < link_count) {
            if (index(c) == i)
                return id_of(
                    get_data<std::tuple_element_t<i, LinkPayloads>>(rtl_.link(pipeline, c), job_.config));
            return rtl_id<i + 1>(pipeline, c);
        } else {
            return 0;
        }
    }

    Divergence at(std::uint64_t now, int pipeline, Link c, std::uint32_t id) const {
        const bool is_ray = link_infos[index(c)].carries_ray;
        const Slot pixel =
            is_ray && id < std::uint32_t(job_.config.contexts) ? model_.pixel(pipeline, id) : Slot{};
        return {now,
                located(link_infos[index(c)].from, pipeline, c, job_.config),
                link_infos[index(c)].name,
                id,
                pixel.x,
                pixel.y,
                "",
                "",
                "",
                pipeline,
                c};
    }

    void run_apart(std::uint64_t limit, FrameCollector& hits) {
        while (!model_.done() && model_.quiet() <= limit) step_model();
        const std::uint64_t give_up = 4 * model_.cycle() + limit;
        try {
            for (std::uint64_t quiet = 0;
                 !broken_ && !rtl_.done() && quiet <= limit && rtl_.cycle() < give_up;
                 quiet = rtl_.moved() ? 0 : quiet + 1)
                step_rtl(hits);
        } catch (const RtlAssertion& assertion) {
            report_assertion(assertion);
        }
        if (watched_)
            result_.first->later =
                fmt::format("{} makes no further transfer there", watched_->by_rtl ? "the model" : "the RTL");
    }

    void step_model() {
        const std::uint64_t now = model_.cycle();
        if (!watched_ || !watched_->by_rtl) return model_.step();
        model_.step([&](const Move& move) {
            (*payloads_)(move, [&](int pipeline, Link c, const auto& payload) {
                if (!watched_ || pipeline != watched_->pipeline || c != watched_->link) return;
                pack(payload, job_.config, words_);
                seen(now, words_.data(), words_.size() * 4);
            });
        });
    }

    void step_rtl(FrameCollector& hits) {
        rtl_.settle();
        if (watched_ && !watched_->by_rtl && rtl_.fires(watched_->pipeline, watched_->link)) {
            const RcPort& port = rtl_.link(watched_->pipeline, watched_->link);
            if (port.bytes >= 4)
                seen(rtl_.cycle(), port.data, port.bytes);
            else {
                std::uint32_t word = 0;   // a port of up to 16 bits is shorter than a word
                std::memcpy(&word, port.data, port.bytes);
                seen(rtl_.cycle(), &word, 4);
            }
        }
        rtl_.clock([&](const HitOut& hit) { hits.add(hit); });
    }

    /// Returns the frame as one of the machines made it.
    FrameResult run_of(const RecordedFrame& frame, std::uint64_t cycles, std::uint64_t pixels,
                       const Accounts& accounts, const MemoryStats& memory, const std::vector<Closest>& hits,
                       const Colours& colours) const {
        const bool partial = pixels < frame.trace.rays.size() && !diverged_;
        const RayWork work{frame.trace.counts, frame.trace.visits, frame.trace.box_tests,
                           frame.trace.triangle_tests};
        return frame_result(job_, frame.frame, {cycles, pixels, accounts, memory, 0, partial, upload_}, work,
                            hits, colours);
    }

    const Job& job_;
    const std::vector<RecordedFrame>& frames_;
    Disturbance disturbance_;
    const OnFirst& on_first_;
    bool reported_ = false;
    double report_seconds_ = 0;   // spent in on_first_, on the host
    std::size_t frame_ = 0;       // the current frame, and the cycle in which it begins
    std::uint64_t begins_ = 0;
    Machine model_;
    RtlMachine rtl_;
    MemoryImage image_;   // of the current frame
    std::optional<PayloadReplay> payloads_;
    UploadTiming upload_;                                // before the frame
    std::array<std::uint32_t, link_count> last_ray_{};   // of the model's last transfer on each link
    Words words_;
    bool diverged_ = false, broken_ = false;
    // The first cycle in which the RTL's `running` differs from the model's.
    std::optional<std::uint64_t> stopped_;
    struct Unmatched {
        int pipeline;
        Link link;
        Words words;
    };
    std::vector<Unmatched> unmatched_;   // transfers of this cycle that only the model made
    struct Watched {
        std::uint64_t cycle;
        int pipeline;
        Link link;
        bool by_rtl;   // the RTL made the transfer, and the model is watched
        Words words;
    };
    std::optional<Watched> watched_;
    LockstepResult result_;
};

}   // namespace

LockstepResult run_lockstep(const Job& job, const std::vector<RecordedFrame>& frames, Disturbance disturbance,
                            const Progress& progress, int seed,
                            const std::function<void(const Divergence&)>& on_first) {
    return Lockstep(job, frames, disturbance, seed, on_first).run(progress);
}

LockstepResult run_lockstep(const Job& job, Disturbance disturbance, const Progress& progress, int seed) {
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame));
    return run_lockstep(job, frames, disturbance, progress, seed);
}

}   // namespace rayclock
