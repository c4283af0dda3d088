#pragma once
// The unit out in time: a queue of two finished pixels, and cycles by cause.
#include <array>

#include "model/core/ring.hpp"
#include "model/machine/units.hpp"

namespace rayclock {

/// Holds a finished pixel for at least one cycle, until sched accepts it. Two places let a result come in
/// every cycle. Mirror of rtl/unit/out/rc_out.sv.
class Out {
public:
    bool ready() const { return !rays_.full(); }
    bool valid() const { return !rays_.empty(); }
    std::uint32_t ray() const { return rays_.front(); }
    bool contains(std::uint32_t ray) const { return rays_.contains(RayNumber(ray)); }

    /// Runs one clock edge: `result` is the result that came, `taken` whether the oldest was accepted.
    void clock(LinkRay result, bool taken) {
        last_ = !valid() ? 1 : taken ? 0 : 2;
        ++cycles_[last_];
        rays_.pop(taken);
        rays_.push(RayNumber(result.ray), result.valid);
    }
    /// Counts cycles like the last one.
    void skip(std::uint64_t cycles) { cycles_[last_] += cycles; }
    /// Returns the cycles by the codes of units.hpp.
    std::uint64_t cycles(std::uint32_t code) const { return cycles_[code]; }

private:
    Ring<RayNumber, 2> rays_{2};
    std::uint32_t last_ = 1;
    CauseCounts cycles_{};
};

}   // namespace rayclock
