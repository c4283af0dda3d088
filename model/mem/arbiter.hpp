#pragma once
// The arbiter of the memory port.
#include <bit>
#include <cstdint>

namespace rayclock {

/// Round-robin arbiter of many valid/ready sources on one link. It searches from the source after the one
/// served last. An offer that was not accepted stays. Mirror of rtl/mem/rc_arbiter.sv.
class Arbiter {
public:
    explicit Arbiter(int sources)
        : mask_(sources < 64 ? (std::uint64_t(1) << sources) - 1 : ~std::uint64_t(0)) {}

    /// Returns the source on offer, among those set in `valid` (not 0).
    int choose(std::uint64_t valid) const {
        if (held_) return chosen_;
        const std::uint64_t after = valid & ~((std::uint64_t(2) << last_) - 1) & mask_;
        return std::countr_zero(after ? after : valid);
    }
    void clock(std::uint64_t valid, int chosen, bool taken) {
        held_ = valid != 0 && !taken;
        chosen_ = chosen;
        if (taken) last_ = std::uint32_t(chosen);
    }

private:
    std::uint64_t mask_;
    std::uint32_t last_ = 0;
    bool held_ = false;
    int chosen_ = 0;
};

}   // namespace rayclock
