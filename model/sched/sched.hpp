#pragma once
#include "model/core/payloads.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// Gives pixels, row by row, to free contexts, and puts the pixel to the hit when its ray is done.
/// A fresh machine uses contexts 0..T-1 first; after that the one that has been free longest.
/// Mirror of rtl/sched/rc_sched.sv.
class Sched {
public:
    Sched(const Frame& frame, const Config& config);

    bool slot_valid() const { return more_ && (started_ < contexts_ || !free_.empty()); }
    Slot slot() const { return {started_ < contexts_ ? started_ : free_.front(), x_, y_}; }
    HitOut hit(const Closest& closest) const { return {pixels_[closest.ray].x, pixels_[closest.ray].y, closest}; }

    /// One clock edge: whether the slot was taken, and the context whose hit left, if one did.
    void clock(bool slot_taken, const std::uint32_t* freed);

    bool all_issued() const { return !more_; }
    Slot pixel(std::uint32_t ray) const { return pixels_[ray]; }

private:
    std::uint32_t width_, height_, contexts_;
    std::uint32_t x_ = 0, y_ = 0, started_ = 0;
    bool more_ = true;
    Ring<std::uint32_t> free_;
    std::vector<Slot> pixels_;
};

} // namespace rayclock
