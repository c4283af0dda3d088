#include "sim/lockstep/lockstep.hpp"

#include <bit>
#include <chrono>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "model/machine.hpp"
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

std::uint32_t ray_of(const HitOut& p) { return p.closest.ray; }
template <class P> std::uint32_t ray_of(const P& p) { return p.ray; }

class Lockstep {
public:
    Lockstep(const Job& job, Traffic traffic, int seed)
        : job_(job), traffic_(traffic), model_(job.image, job.frame, job.config, traffic),
          rtl_(job.image, job.frame, job.config, traffic, seed), model_hits_(job), rtl_hits_(job) {}

    LockstepResult run(const Progress& progress) {
        const auto start = std::chrono::steady_clock::now();
        const std::uint64_t pixels = std::uint64_t(job_.frame.width) * job_.frame.height, limit = patience(job_.config, traffic_);
        for (std::uint64_t quiet = 0; !parted_ && !(model_.done() && rtl_.done());) {
            cycle();
            quiet = model_.fire_mask() ? 0 : quiet + 1;
            if (quiet > limit) throw std::runtime_error(fmt::format("nothing has moved for {} cycles at cycle {}", limit, model_.cycle()));
            if (progress && model_.cycle() % (1 << 14) == 0) progress("model and rtl", model_.hits(), pixels);
        }
        if (parted_) run_apart(limit);
        if (progress) progress("model and rtl", pixels, pixels);
        finish(result_.model, model_, model_hits_);
        finish(result_.rtl, rtl_, rtl_hits_);
        result_.cycle_gap = model_.cycle() > rtl_.cycle() ? model_.cycle() - rtl_.cycle() : rtl_.cycle() - model_.cycle();
        if (parted_ && result_.cycle_gap == 0) result_.cycle_gap = 1;
        for (std::size_t i = 0; parted_ && i < result_.model.hits.hits.size(); ++i)
            result_.value_mismatches += !(result_.model.hits.hits[i] == result_.rtl.hits.hits[i]);
        result_.model.seconds = result_.rtl.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return std::move(result_);
    }

private:
    void cycle() {
        rtl_.settle();
        rtl_fire_ = rtl_.fire_mask();
        const std::uint64_t now = model_.cycle();
        model_.step([&](Channel c, const auto& payload) { compare(now, c, payload); });
        const std::uint32_t differ = (model_.valid_mask() ^ rtl_.valid_mask()) | (model_.fire_mask() ^ rtl_fire_);
        if (differ) part(now, differ);
        if (model_.fire_mask() & bit(Channel::hit)) model_hits_.add(model_.last_hit());
        rtl_.clock();
        if (rtl_fire_ & bit(Channel::hit)) rtl_hits_.add(rtl_.last_hit());
    }

    template <class P> void compare(std::uint64_t now, Channel c, const P& payload) {
        model_ray_[index(c)] = ray_of(payload);
        if (!(rtl_fire_ & bit(c))) return;
        pack(payload, job_.config, words_);
        ++result_.events_compared;
        if (std::memcmp(words_.data(), rtl_.data(c), words_.size() * 4) == 0) return;
        ++result_.value_mismatches;
        if (result_.first) return;
        const P got = unpack<P>(rtl_.data(c), job_.config);
        Divergence d = at(now, c, ray_of(payload));
        describe(payload, got, job_.config, d);
        result_.first = d;
    }

    /// The machines no longer move in step: one of them offers or accepts what the other does not.
    void part(std::uint64_t now, std::uint32_t differ) {
        parted_ = true;
        if (result_.first) return;
        const Channel c = Channel(std::countr_zero(differ));
        const auto tell = [&](std::uint32_t valid, std::uint32_t fire) {
            return fire & bit(c) ? "a transfer" : valid & bit(c) ? "an offer that is not accepted" : "no offer";
        };
        result_.first = at(now, c, rtl_.valid_mask() & bit(c) ? rtl_ray(c) : model_ray_[index(c)]);
        result_.first->expected = tell(model_.valid_mask(), model_.fire_mask());
        result_.first->got = tell(rtl_.valid_mask(), rtl_fire_);
    }

    std::uint32_t rtl_ray(Channel c) const { return ray_in<0>(c); }
    template <std::size_t i> std::uint32_t ray_in(Channel c) const {
        if constexpr (i < channel_count) {
            if (index(c) == i) return ray_of(unpack<std::tuple_element_t<i, ChannelPayloads>>(rtl_.data(c), job_.config));
            return ray_in<i + 1>(c);
        } else {
            return 0;
        }
    }

    Divergence at(std::uint64_t now, Channel c, std::uint32_t ray) const {
        const Slot pixel = ray < std::uint32_t(job_.config.contexts) ? model_.sched().pixel(ray) : Slot{};
        return {now, channels[index(c)].from, channels[index(c)].name, ray, pixel.x, pixel.y, "", ""};
    }

    void run_apart(std::uint64_t limit) {
        std::uint64_t quiet = 0;
        for (; !model_.done() && quiet <= limit; quiet = model_.fire_mask() ? 0 : quiet + 1) {
            model_.step();
            if (model_.fire_mask() & bit(Channel::hit)) model_hits_.add(model_.last_hit());
        }
        const std::uint64_t give_up = 4 * model_.cycle() + limit;
        for (quiet = 0; !rtl_.done() && quiet <= limit && rtl_.cycle() < give_up; quiet = rtl_.fire_mask() ? 0 : quiet + 1) {
            rtl_.step();
            if (rtl_.fire_mask() & bit(Channel::hit)) rtl_hits_.add(rtl_.last_hit());
        }
    }

    template <class AnyMachine> static void finish(FrameRun& run, const AnyMachine& machine, FrameCollector& hits) {
        run.cycles = machine.cycle();
        run.counts = machine.counts();
        run.box_tests = machine.box_tests();
        hits.finish(run);
    }

    const Job& job_;
    Traffic traffic_;
    Machine model_;
    RtlMachine rtl_;
    FrameCollector model_hits_, rtl_hits_;
    std::uint32_t rtl_fire_ = 0;
    std::array<std::uint32_t, channel_count> model_ray_{};   // of the last transfer on each channel
    Words words_;
    bool parted_ = false;
    LockstepResult result_;
};

} // namespace

LockstepResult run_lockstep(const Job& job, Traffic traffic, const Progress& progress, int seed) {
    return Lockstep(job, traffic, seed).run(progress);
}

} // namespace rayclock
