// Runs both machines again, or the RTL alone, and records the cycles around a divergence.
#include "sim/view/divergence/capture.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/machine/machine.hpp"
#include "model/machine/payload_replay.hpp"
#include "sim/run/rtl/rtl_machine.hpp"

namespace rayclock {

namespace {

class Capturer {
public:
    Capturer(const Job& job, Disturbance disturbance, int seed, std::uint64_t divergence,
             const std::string& path, bool with_model)
        : job_(job),
          path_(path),
          first_(divergence - std::min(divergence, cycles_before)),
          last_(divergence + cycles_after),
          rtl_(job.image, job.config, job.khz, disturbance, seed, Waves::yes),
          image_(job.image),
          payloads_(std::in_place, image_, job.config) {
        for (int p = 0; p < job.config.pipelines; ++p)
            for (std::size_t c = 0; c < link_count; ++c)
                if (is_there(Link(c), job.config) && (p == 0 || c < pipeline_links))
                    capture_.links.push_back({p, Link(c)});
        capture_.first = first_;
        capture_.has_model = with_model;
        if (with_model) model_.emplace(job.config, job.khz, disturbance);
    }
    ~Capturer() {
        if (writes_) rtl_.module().end_wave();
    }
    Capturer(const Capturer&) = delete;

    Capture run(const std::vector<RecordedFrame>& frames, const Progress& progress) {
        try {
            for (std::size_t f = 0; f < frames.size(); ++f) {
                if (frames[f].upload.image_lines > 0) {
                    apply(frames[f].upload, image_);
                    payloads_.emplace(image_, job_.config);
                    rtl_.change(frames[f].upload);
                }
                if (model_) prepare_frame(*model_, f, std::span(frames));
                prepare_frame(rtl_, f, std::span(frames));
                if (!run_frame(frames[f], progress)) break;
            }
            while (!model_ && rtl_.cycle() <= last_ && !interrupted()) cycle();
        } catch (const RtlAssertion&) {   // the previous run has reported it
        }
        if (std::exchange(writes_, false))
            if (const int error = rtl_.module().end_wave())
                throw UserError(
                    fmt::format("{}: cannot be written: {}", printable(path_), std::strerror(error)));
        return std::move(capture_);
    }

private:
    /// False once enough is seen.
    bool run_frame(const RecordedFrame& frame, const Progress& progress) {
        if (model_) model_->start(frame.frame, frame.trace);
        rtl_.start(frame.frame);
        payloads_->start(frame.frame);
        while (!(rtl_.done() && (!model_ || model_->done()))) {
            if (rtl_.cycle() > last_ || interrupted()) return false;
            cycle();
            if (progress && rtl_.cycle() % (1 << 14) == 0)
                progress("up to the divergence", rtl_.cycle(), last_);
        }
        return true;
    }

    void cycle() {
        const std::uint64_t now = rtl_.cycle();
        const bool shows = now >= first_;
        if (shows && !writes_) {
            rtl_.module().begin_wave(path_);
            writes_ = true;
        }
        rtl_.settle();
        if (shows) {
            rtl_.module().dump_wave(10 * now + 5);
            capture_.cycles.emplace_back(capture_.links.size());
        }
        if (model_)
            model_->step([&](const Move& move) {
                (*payloads_)(move, [&](int pipeline, Link link, const auto& payload) {
                    if (shows) at(pipeline, link).model = pack(payload, job_.config);
                });
            });
        if (shows) note(now);
        rtl_.clock([](const HitOut&) {});
        if (shows) rtl_.module().dump_wave(10 * now + 10);
    }

    LinkCycle& at(int pipeline, Link link) {
        const auto here = [&](const Capture::CapturedLink& w) {
            return w.pipeline == pipeline && w.link == link;
        };
        const auto found = std::find_if(capture_.links.begin(), capture_.links.end(), here);
        return capture_.cycles.back()[std::size_t(found - capture_.links.begin())];
    }

    void note(std::uint64_t now) {
        bool differs = false;
        for (std::size_t i = 0; i < capture_.links.size(); ++i) {
            const auto [pipeline, link] = capture_.links[i];
            const bool shared = index(link) >= pipeline_links;
            const LinkMask bit_of_link = bit(link);
            const auto has = [&](LinkMask own, LinkMask common) {
                return ((shared ? common : own) & bit_of_link) != 0;
            };
            LinkCycle& state = capture_.cycles.back()[i];
            if (model_) {
                state.model_valid = has(model_->valid_mask(pipeline), model_->shared_valid());
                state.model_fires = has(model_->fire_mask(pipeline), model_->shared_fire());
            }
            state.rtl_valid = has(rtl_.valid_mask(pipeline), rtl_.shared_valid());
            state.rtl_fires = has(rtl_.fire_mask(pipeline), rtl_.shared_fire());
            if (state.rtl_valid) {
                const RcPort& port = rtl_.link(pipeline, link);
                state.rtl.assign((port.bytes + 3) / 4, 0);
                std::memcpy(state.rtl.data(), port.data, port.bytes);
            }
            differs = differs || (model_ && state.differs());
        }
        if (differs && !capture_.differs_at) capture_.differs_at = now;
    }

    const Job& job_;
    std::string path_;
    std::uint64_t first_, last_;
    std::optional<Machine> model_;
    RtlMachine rtl_;
    MemoryImage image_;   // of the frame that runs
    std::optional<PayloadReplay> payloads_;
    bool writes_ = false;
    Capture capture_;
};

}   // namespace

bool LinkCycle::differs() const {
    if (model_valid != rtl_valid || model_fires != rtl_fires) return true;
    // Verilator keeps a short payload in a whole word.
    return model_fires && !std::equal(model.begin(), model.end(), rtl.begin(),
                                      rtl.begin() + std::ptrdiff_t(std::min(model.size(), rtl.size())));
}

Capture capture(const Job& job, const std::vector<RecordedFrame>& frames, Disturbance disturbance, int seed,
                std::uint64_t divergence, const std::string& wave_path, bool with_model,
                const Progress& progress) {
    return Capturer(job, disturbance, seed, divergence, wave_path, with_model).run(frames, progress);
}

}   // namespace rayclock
