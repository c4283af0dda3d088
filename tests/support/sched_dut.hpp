#pragma once
#include "model/sched/sched.hpp"
#include "tests/support/dut.hpp"

namespace rayclock::test {

/// What both machines of sched show. A finished ray's hit passes through in the same cycle.
struct SchedLinks {
    Link<Slot> slot;
    Link<Closest> closest;
    Link<HitOut> hit;
};

class SchedModel : public SchedLinks {
public:
    SchedModel(const Frame& frame, const Config& config, int = 1) : sched_(frame, config) {}
    void eval() {
        slot.offer.reset();
        if (sched_.slot_valid()) slot.offer = sched_.slot();
        closest.ready = hit.ready;
        hit.offer.reset();
        if (closest.offer) hit.offer = sched_.hit(*closest.offer);
    }
    void commit() { sched_.clock(slot.fires(), hit.fires() ? &closest.offer->ray : nullptr); }

private:
    Sched sched_;
};

class SchedRtl : public SchedLinks {
public:
    SchedRtl(const Frame& frame, const Config& config, int seed = 1) : links_(config, "rc_sched", seed) {
        links_.fix("frame", frame);
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_out("slot", slot);
        links_.read_in("closest", closest);
        links_.read_out("hit", hit);
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_out("slot", slot);
        links_.drive_in("closest", closest);
        links_.drive_out("hit", hit);
    }
    RtlLinks links_;
};

} // namespace rayclock::test
