#pragma once
// One interface for a unit's model and RTL, so that one test body runs on both: links with offer and ready,
// eval() before the clock edge, commit() for the edge.
#include <cstring>
#include <deque>
#include <optional>
#include <utility>

#include "model/engine/engines.hpp"
#include "model/core/ring.hpp"
#include "model/engine/check.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/engine/bvh/box.hpp"
#include "model/engine/bsp/slant.hpp"
#include "model/engine/spheres/globe.hpp"
#include "model/engine/kd/treelet.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "tests/support/dut/format.hpp"

namespace rayclock::test {

/// A link in one cycle. On an input the test sets `offer` and eval() sets `ready`; on an output the reverse.
template <class P> struct Wire {
    std::optional<P> offer;
    bool ready = false;
    bool fires() const { return offer && ready; }
};

/// A link delayed by some cycles: the units of a fast chip process it that much later.
template <class P> class DelayedLink {
public:
    explicit DelayedLink(int cycles) : kept_(std::size_t(cycles)) {}
    const std::optional<P>& out(const std::optional<P>& in) const {
        return kept_.empty() ? in : kept_.front();
    }
    void clock(const std::optional<P>& in) {
        if (kept_.empty()) return;
        kept_.pop_front();
        kept_.push_back(in);
    }

private:
    std::deque<std::optional<P>> kept_;
};

/// Returns the ray of a payload, if there is one.
template <class P> LinkRay ray_of(const std::optional<P>& payload) {
    return {payload.has_value(), payload ? payload->ray : 0};
}
template <class P> LinkRay ray_of(const Wire<P>& link) {
    return link.fires() ? ray_of(link.offer) : LinkRay{};
}

template <class P> bool same(const P& a, const P& b, const Config& config) {
    return pack(a, config) == pack(b, config);
}
template <class P> bool same(const std::optional<P>& a, const std::optional<P>& b, const Config& config) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b, config));
}
template <class P> bool same(const Wire<P>& a, const Wire<P>& b, const Config& config) {
    return a.ready == b.ready && same(a.offer, b.offer, config);
}

// ---- Units that are a pure function behind a credit counter.

struct RaygenUnit {
    using Req = Slot;
    using Rsp = Ray;
    static constexpr const char *name = "rc_raygen", *in = "slot", *out = "ray";
    static constexpr bool has_frame = true;
    static int latency(const Config& c) { return c.raygen_latency(); }
    static int queue(const Config& c) { return c.raygen_queue; }
    static int interval(const Config& c) { return c.raygen_interval; }
    static Ray answer(const Slot& slot, const Frame& frame, const Config& c) {
        return raygen(slot, frame, c);
    }
};
/// The node unit of an engine; its name and its answer follow.
template <class Engine> struct NodeUnitOf {
    using Req = typename Engine::Request;
    using Rsp = NodeAnswer;
    static constexpr const char *in = "req", *out = "rsp";
    static constexpr bool has_frame = false;
    static int latency(const Config& c) { return Engine::latency(c); }
    static int queue(const Config& c) { return c.box_queue; }
};
struct BoxUnit : NodeUnitOf<bvh::Engine> {
    static constexpr const char* name = "rc_box";
    static int interval(const Config& c) { return c.box_interval(); }
    static NodeAnswer answer(const BoxReq& req, const Frame&, const Config& c) { return box(req, c); }
};
struct TreeletUnit : NodeUnitOf<kd::Engine> {
    static constexpr const char* name = "rc_treelet";
    static NodeAnswer answer(const TreeletReq& req, const Frame&, const Config& c) { return treelet(req, c); }
};
struct GlobeUnit : NodeUnitOf<spheres::Engine> {
    static constexpr const char* name = "rc_globe";
    static NodeAnswer answer(const GlobeReq& req, const Frame&, const Config& c) { return globe(req, c); }
};
struct SlantUnit : NodeUnitOf<bsp::Engine> {
    static constexpr const char* name = "rc_slant";
    static NodeAnswer answer(const SlantReq& req, const Frame&, const Config& c) { return slant(req, c); }
};
struct TriUnit {
    using Req = TriReq;
    using Rsp = TriRsp;
    static constexpr const char *name = "rc_tri", *in = "req", *out = "rsp";
    static constexpr bool has_frame = false;
    static int latency(const Config& c) { return c.tri_latency(); }
    static int queue(const Config& c) { return c.tri_queue; }
    static int interval(const Config& c) { return c.tri_interval; }
    static TriRsp answer(const TriReq& req, const Frame&, const Config& c) { return tri(req, c); }
};

/// Returns the least number of cycles between two requests to a unit.
template <class U> int interval_of(const Config& config) {
    if constexpr (requires { U::interval(config); })
        return U::interval(config);
    else
        return 1;
}

template <class U> class Model {
public:
    using Unit = U;
    using Rsp = typename U::Rsp;
    Wire<typename U::Req> in;
    Wire<Rsp> out;

    explicit Model(const Config& config, const Frame& frame = {}, int = 1)
        : config_(config), frame_(frame), pipe_(U::latency(config), U::queue(config)) {}
    void eval() {
        in.ready = pipe_.ready() && now_ >= opens_;
        out.offer.reset();
        if (pipe_.valid(now_)) out.offer = pipe_.front();
    }
    void commit() {
        const bool accepted = in.fires();
        if (accepted) opens_ = now_ + std::uint64_t(interval_of<U>(config_));
        pipe_.clock(now_++, out.fires(), accepted, accepted ? U::answer(*in.offer, frame_, config_) : Rsp{});
    }

private:
    Config config_;
    Frame frame_;
    Pipe<Rsp> pipe_;
    std::uint64_t now_ = 0, opens_ = 0;
};

/// The links of a verilated unit.
class RtlLinks {
public:
    RtlLinks(const Config& config, const char* module, int seed)
        : config_(config), rtl_(config, module, seed) {}

    template <class P> void fix(const char* name, const P& value) {
        set_data(rtl_.port(name), value, config_);
    }
    template <class P> void drive_in(const char* name, const Wire<P>& link) {
        const RcPort& port = rtl_.port(name);
        *port.valid = link.offer.has_value();
        // Drives other data when invalid, because no unit may read stale data.
        set_data(port, link.offer ? *link.offer : P{}, config_);
    }
    template <class P> void drive_listen(const char* name, const std::optional<P>& seen) {
        const RcPort& port = rtl_.port(name);
        *port.valid = seen.has_value();
        set_data(port, seen ? *seen : P{}, config_);
    }
    template <class P> void drive_out(const char* name, const Wire<P>& link) {
        *rtl_.port(name).ready = link.ready;
    }
    template <class P> void read_in(const char* name, Wire<P>& link) const {
        link.ready = *rtl_.port(name).ready != 0;
    }
    template <class P> void read_out(const char* name, Wire<P>& link) const { read_told(name, link.offer); }
    /// Reads an output that is always accepted.
    template <class P> void read_told(const char* name, std::optional<P>& told) const {
        const RcPort& port = rtl_.port(name);
        told.reset();
        if (!*port.valid) return;
        Words words((port.bytes + 3) / 4);   // a narrow port is smaller than a word and unaligned
        std::memcpy(words.data(), port.data, port.bytes);
        told = unpack<P>(words.data(), config_);
    }
    /// Reads a plain output of at most 32 bits.
    std::uint32_t plain(const char* name) const {
        const RcPort& port = rtl_.port(name);
        std::uint32_t value = 0;
        std::memcpy(&value, port.data, port.bytes);
        return value;
    }
    void reset() { rtl_.reset(); }
    void settle() { rtl_.settle(); }
    void clock() { rtl_.clock(); }

    /// Delays the edge until the offers of the following cycle are known, because a fast chip receives them
    /// one cycle early.
    void clock_later() { is_due_ = true; }
    /// Runs the delayed edge before anything else is driven; `tell` drives the early inputs.
    template <class Tell> void pass_edge(const Tell& tell) {
        if (!std::exchange(is_due_, false)) return;
        tell();
        settle();
        clock();
    }
    /// Drives the ray that the edge brings to the head of a queue.
    template <class P> void drive_next(const char* name, const Wire<P>& link) {
        drive_listen(name, link.offer ? std::optional(Done{link.offer->ray}) : std::nullopt);
    }

    // ---- Signals without a valid.
    void drive_plain(const char* name, std::uint32_t value) {
        const RcPort& port = rtl_.port(name);
        std::memcpy(port.data, &value, port.bytes);
    }
    template <class P> P payload(const char* name) const { return get_data<P>(rtl_.port(name), config_); }

private:
    Config config_;
    RtlModule rtl_;
    bool is_due_ = false;
};

template <class U> class Rtl {
public:
    using Unit = U;
    Wire<typename U::Req> in;
    Wire<typename U::Rsp> out;

    explicit Rtl(const Config& config, const Frame& frame = {}, int seed = 1)
        : links_(config, U::name, seed) {
        if constexpr (U::has_frame) links_.fix("frame", frame);
        links_.drive_in(U::in, in);
        links_.drive_out(U::out, out);
        links_.reset();
    }
    void eval() {
        links_.drive_in(U::in, in);
        links_.drive_out(U::out, out);
        links_.settle();
        links_.read_in(U::in, in);
        links_.read_out(U::out, out);
    }
    void commit() { links_.clock(); }

private:
    RtlLinks links_;
};

}   // namespace rayclock::test
