#include "model/sched/sched.hpp"

namespace rayclock {

Sched::Sched(const Frame& frame, const Config& config)
    : width_(frame.width), height_(frame.height), contexts_(std::uint32_t(config.contexts)), free_(config.contexts),
      pixels_(std::size_t(config.contexts)) {}

void Sched::clock(bool slot_taken, const std::uint32_t* freed) {
    if (slot_taken) {
        const Slot given = slot();
        pixels_[given.ray] = given;
        if (started_ < contexts_) ++started_;
        else free_.pop();
        if (++x_ == width_) {
            x_ = 0;
            if (++y_ == height_) more_ = false;
        }
    }
    if (freed) free_.push(*freed);
}

} // namespace rayclock
