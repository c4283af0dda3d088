#include "sim/lockstep/lockstep.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "model/machine.hpp"
#include "model/trace/witness.hpp"
#include "model/where.hpp"
#include "sim/rtl/rtl_machine.hpp"

namespace rayclock {

namespace {

/// Lists a payload's fields as (name, value).
class ListVisitor {
public:
    std::vector<std::pair<std::string, std::string>> fields;
    template <class T> void operator()(const char* name, const T& value, int) { fields.emplace_back(name, fmt::format("{}", value)); }
    template <class T, std::size_t n> void operator()(const char* name, const std::array<T, n>& value, int, int count) {
        for (int i = 0; i < count; ++i) fields.emplace_back(fmt::format("{}[{}]", name, i), fmt::format("{}", value[std::size_t(i)]));
    }
};

/// The fields in which two payloads differ, as "name=value" of each side.
template <class P> void describe(P model, P rtl, const Config& config, Divergence& d) {
    ListVisitor a, b;
    model.fields(a, config);
    rtl.fields(b, config);
    for (std::size_t i = 0; i < a.fields.size(); ++i) {
        if (a.fields[i].second == b.fields[i].second) continue;
        d.expected += (d.expected.empty() ? "" : " ") + a.fields[i].first + "=" + a.fields[i].second;
        d.got += (d.got.empty() ? "" : " ") + b.fields[i].first + "=" + b.fields[i].second;
    }
}

template <class P> std::uint32_t id_of(const P& p) {
    if constexpr (requires { p.closest; }) return p.closest.ray;
    else if constexpr (requires { p.ray; }) return p.ray;
    else if constexpr (requires { p.id; }) return p.id;
    else return 0;
}

class Lockstep {
public:
    Lockstep(const Job& job, const std::vector<FrameTrace>& frames, Traffic traffic, int seed)
        : job_(job), frames_(frames), traffic_(traffic), model_(job.config, job.khz, traffic),
          rtl_(job.image, job.config, job.khz, traffic, seed), witness_(job.image, job.config) {}

    LockstepResult run(const Progress& progress) {
        const auto start = std::chrono::steady_clock::now();
        for (const FrameTrace& frame : frames_) {
            run_frame(frame, progress);
            if (parted_ || interrupted()) break;
        }
        for (FrameRun* run : {&result_.model, &result_.rtl})
            run->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return std::move(result_);
    }

private:
    void run_frame(const FrameTrace& frame, const Progress& progress) {
        const std::uint64_t pixels = frame.trace.rays.size(), limit = patience(job_.config, traffic_);
        const std::uint64_t first = model_.cycle();
        const Accounts accounts = model_.accounts();
        const MemoryStats memory = model_.memory().stats();
        FrameCollector hits(frame.frame, job_.config.shading != 0);
        model_.start(frame.frame, frame.trace);
        rtl_.start(frame.frame);
        witness_.start(frame.frame);
        while (!parted_ && !(model_.done() && rtl_.done()) && !interrupted()) {
            cycle(hits);
            if (model_.quiet() > limit)
                throw std::runtime_error(fmt::format("nothing has moved for {} cycles at cycle {}\n{}", limit, model_.cycle(), where_rays_are(model_)));
            if (progress && model_.cycle() % (1 << 14) == 0) progress("model and rtl", model_.hits(), pixels);
        }
        if (parted_) run_apart(limit, hits);
        if (progress) progress("model and rtl", pixels, pixels);
        finish(result_.model, model_.cycle() - first, model_.hits(), model_.accounts() - accounts, model_.memory().stats() - memory, frame.trace.hits, frame.trace.colours, frame);
        finish(result_.rtl, rtl_.cycle() - first, rtl_.hits(), rtl_.accounts(), rtl_.memory().stats() - memory, hits.hits(), hits.colours(), frame);
        result_.cycle_gap += model_.cycle() > rtl_.cycle() ? model_.cycle() - rtl_.cycle() : rtl_.cycle() - model_.cycle();
        if (parted_ && result_.cycle_gap == 0) result_.cycle_gap = 1;
        if (!result_.model.partial)
            for (std::size_t i = 0; i < result_.model.hits.hits.size(); ++i)
                result_.value_mismatches += !(result_.model.hits.hits[i] == result_.rtl.hits.hits[i])
                    || (job_.config.shading && result_.model.colours[i] != result_.rtl.colours[i]);
        result_.account_mismatches += !parted_ && !(result_.model.accounts == result_.rtl.accounts);
    }

    void cycle(FrameCollector& hits) {
        rtl_.settle();
        const std::uint64_t now = model_.cycle();
        model_.step([&](const Move& move) {
            last_ray_[index(move.channel)] = move.id;
            witness_(move, [&](int pipeline, Channel c, const auto& payload) { compare(now, pipeline, c, payload); });
        });
        for (int p = 0; p < job_.config.pipelines && !parted_; ++p)
            if (const std::uint32_t differ = (model_.valid_mask(p) ^ rtl_.valid_mask(p)) | (model_.fire_mask(p) ^ rtl_.fire_mask(p)))
                part(now, p, differ, {model_.valid_mask(p), model_.fire_mask(p)}, {rtl_.valid_mask(p), rtl_.fire_mask(p)});
        if (const std::uint32_t differ = (model_.shared_valid() ^ rtl_.shared_valid()) | (model_.shared_fire() ^ rtl_.shared_fire()); differ && !parted_)
            part(now, 0, differ, {model_.shared_valid(), model_.shared_fire()}, {rtl_.shared_valid(), rtl_.shared_fire()});
        rtl_.clock([&](const HitOut& hit) { hits.add(hit); });
    }

    bool rtl_fires(int pipeline, Channel c) const {
        return (index(c) < pipeline_channels ? rtl_.fire_mask(pipeline) : rtl_.shared_fire()) & bit(c);
    }

    template <class P> void compare(std::uint64_t now, int pipeline, Channel c, const P& payload) {
        if (!rtl_fires(pipeline, c)) return;
        pack(payload, job_.config, words_);
        ++result_.events_compared;
        const RcPort& port = rtl_.link(pipeline, c);
        if (std::memcmp(words_.data(), port.data, std::min<std::size_t>(words_.size() * 4, port.bytes)) == 0) return;
        ++result_.value_mismatches;
        if (result_.first) return;
        const P got = get_data<P>(port, job_.config);
        Divergence d = at(now, pipeline, c, id_of(payload));
        describe(payload, got, job_.config, d);
        result_.first = d;
    }

    struct Masks {
        std::uint32_t valid, fire;
    };
    /// The machines no longer move in step: one of them offers or accepts what the other does not.
    void part(std::uint64_t now, int pipeline, std::uint32_t differ, Masks model, Masks rtl) {
        parted_ = true;
        if (result_.first) return;
        const Channel c = Channel(std::countr_zero(differ));
        const auto tell = [&](const Masks& m) {
            return m.fire & bit(c) ? "a transfer" : m.valid & bit(c) ? "an offer that is not accepted" : "no offer";
        };
        result_.first = at(now, pipeline, c, rtl.valid & bit(c) ? rtl_id<0>(pipeline, c) : last_ray_[index(c)]);
        result_.first->expected = tell(model);
        result_.first->got = tell(rtl);
    }

    template <std::size_t i> std::uint32_t rtl_id(int pipeline, Channel c) const {
        if constexpr (i < channel_count) {
            if (index(c) == i) return id_of(get_data<std::tuple_element_t<i, ChannelPayloads>>(rtl_.link(pipeline, c), job_.config));
            return rtl_id<i + 1>(pipeline, c);
        } else {
            return 0;
        }
    }

    Divergence at(std::uint64_t now, int pipeline, Channel c, std::uint32_t id) const {
        const bool is_ray = index(c) < pipeline_channels && !channels[index(c)].fires_only && c != Channel::node_miss && c != Channel::prim_miss && c != Channel::surf_miss;
        const Slot pixel = is_ray && id < std::uint32_t(job_.config.contexts) ? model_.pixel(pipeline, id) : Slot{};
        const bool several = job_.config.pipelines > 1 && index(c) < pipeline_channels;
        const std::string unit = channels[index(c)].from;
        return {now, several ? fmt::format("{}[{}]", unit, pipeline) : unit, channels[index(c)].name, id, pixel.x, pixel.y, "", ""};
    }

    void run_apart(std::uint64_t limit, FrameCollector& hits) {
        while (!model_.done() && model_.quiet() <= limit) model_.step();
        const std::uint64_t give_up = 4 * model_.cycle() + limit;
        for (std::uint64_t quiet = 0; !rtl_.done() && quiet <= limit && rtl_.cycle() < give_up; quiet = rtl_.moved() ? 0 : quiet + 1)
            rtl_.step([&](const HitOut& hit) { hits.add(hit); });
    }

    void finish(FrameRun& run, std::uint64_t cycles, std::uint64_t pixels, const Accounts& accounts, const MemoryStats& memory,
                const std::vector<Closest>& hits, const Colours& colours, const FrameTrace& frame) const {
        static_cast<FrameTiming&>(run) = {cycles, pixels, accounts, memory, 0, pixels < frame.trace.rays.size() && !parted_};
        run.hits = scaled(job_, frame.frame, hits);
        run.answers = hits;
        run.colours = colours;
        run.rays = frame.trace.counts;
        run.finished_picture = job_.config.shading != 0;
        run.visits = frame.trace.visits;
        run.box_tests = frame.trace.box_tests;
        run.triangle_tests = frame.trace.triangle_tests;
        run.digest = digest_of(hits, cycles, colours);
    }

    const Job& job_;
    const std::vector<FrameTrace>& frames_;
    Traffic traffic_;
    Machine model_;
    RtlMachine rtl_;
    Witness witness_;
    std::array<std::uint32_t, channel_count> last_ray_{};   // of the model's last transfer on each channel
    Words words_;
    bool parted_ = false;
    LockstepResult result_;
};

} // namespace

LockstepResult run_lockstep(const Job& job, const std::vector<FrameTrace>& frames, Traffic traffic, const Progress& progress, int seed) {
    return Lockstep(job, frames, traffic, seed).run(progress);
}

LockstepResult run_lockstep(const Job& job, Traffic traffic, const Progress& progress, int seed) {
    std::vector<FrameTrace> frames;
    frames.push_back(record_frame(job, job.frame));
    return run_lockstep(job, frames, traffic, progress, seed);
}

} // namespace rayclock
