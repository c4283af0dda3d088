#pragma once
#include <array>

#include "model/core/ring.hpp"
#include "model/core/units.hpp"

namespace rayclock {

/// A pixel that is done waits here for a cycle, and for as long as sched does not take it. Two places, so
/// that a result can come in every cycle. Mirror of rtl/out/rc_out.sv.
class Out {
public:
    bool ready() const { return !rays_.full(); }
    bool valid() const { return !rays_.empty(); }
    std::uint32_t ray() const { return rays_.front(); }
    bool contains(std::uint32_t ray) const { return rays_.contains(RayNumber(ray)); }

    /// One clock edge: the result that came, and whether the oldest was taken.
    void clock(OnLink result, bool taken) {
        last_ = !valid() ? 1 : taken ? 0 : 2;
        ++cycles_[last_];
        rays_.pop(taken);
        rays_.push(RayNumber(result.ray), result.there);
    }
    /// Cycles like the last.
    void skip(std::uint64_t cycles) { cycles_[last_] += cycles; }
    /// Cycles by the codes of units.hpp.
    std::uint64_t cycles(std::uint32_t code) const { return cycles_[code]; }

private:
    Ring<RayNumber, 2> rays_{2};
    std::uint32_t last_ = 1;
    CauseCounts cycles_{};
};

}   // namespace rayclock
