#pragma once
// raygen's model and RTL, with the same links.
#include <algorithm>

#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// The links of raygen's model and RTL, if the chip shades: shade's rays and new pixels share one entrance.
struct RaygenLinks {
    Wire<Spawn> spawn;
    Wire<Slot> slot;
    Wire<Ray> ray;
};

class RaygenModel : public RaygenLinks {
public:
    RaygenModel(const Frame& frame, const Config& config, int = 1)
        : config_(config), frame_(frame), pipe_(config.raygen_latency(), config.raygen_queue) {}
    void eval() {
        second_ = merge_.second(spawn.offer.has_value());
        const bool begins = pipe_.ready() && hold_left_ == 0;
        spawn.ready = begins && !second_;
        slot.ready = begins && second_;
        ray.offer.reset();
        if (pipe_.valid(now_)) ray.offer = pipe_.front();
    }
    void commit() {
        merge_.clock(spawn.offer || slot.offer, spawn.fires() || slot.fires(), second_);
        Ray made;
        if (spawn.fires()) made = spawn_ray(*spawn.offer, frame_, config_);
        if (slot.fires()) made = raygen(*slot.offer, frame_, config_);
        const bool begun = spawn.fires() || slot.fires();
        pipe_.clock(now_++, ray.fires(), begun, made);
        hold_left_ = begun ? config_.raygen_interval - 1 : std::max(hold_left_ - 1, 0);
    }

private:
    Config config_;
    Frame frame_;
    Merge merge_;
    bool second_ = false;
    int hold_left_ = 0;   // cycles left in which it starts no ray
    Pipe<Ray> pipe_;
    std::uint64_t now_ = 0;
};

class RaygenRtl : public RaygenLinks {
public:
    RaygenRtl(const Frame& frame, const Config& config, int seed = 1) : links_(config, "rc_raygen", seed) {
        links_.fix("frame", frame);
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_in("spawn", spawn);
        links_.read_in("slot", slot);
        links_.read_out("ray", ray);
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_in("spawn", spawn);
        links_.drive_in("slot", slot);
        links_.drive_out("ray", ray);
    }
    RtlLinks links_;
};

}   // namespace rayclock::test
