#pragma once
// The unit hits: gathers the answers to a stream's rays into lines of memory.
#include <array>
#include <utility>

#include "model/core/payloads.hpp"

namespace rayclock {

/// Accepts the answers of all pipelines, one in a cycle: in cycle c of a frame only pipeline c mod P may send
/// one. It packs each into a record. A line that is full, or has the frame's last record, is offered to
/// memory. Until memory accepts it, the unit accepts no answer. Mirror of rtl/unit/hits/rc_hits.sv.
class Hits {
public:
    /// The unit's causes: model/machine/unit_codes.hpp checks them.
    static constexpr std::uint8_t busy = 0, starved_by_sched = 1, stalled_by_memory = 2;

    explicit Hits(const Config& config)
        : pipelines_(std::uint32_t(config.pipelines)), room_(std::uint32_t(hits_of_line(config))) {}

    void start(const Frame& frame) {
        addr_ = frame.first_hit_line;
        left_ = frame.ray_count;
        records_ = turn_ = 0;
        full_ = false;
    }
    /// True if a pipeline may send an answer in this cycle.
    bool accepts(std::size_t pipeline) const { return !full_ & (turn_ == pipeline); }
    /// True if a line is on offer to memory, at addr().
    bool full() const { return full_; }
    std::uint32_t addr() const { return addr_; }
    /// Returns the number of records in the line.
    std::uint32_t records() const { return records_; }

    /// One clock edge. `hit`: an answer was accepted; `written`: the line was. Returns the number of records
    /// that were written.
    std::uint32_t clock(bool hit, bool written) {
        ++causes_[(hit | written) ? busy : full_ ? stalled_by_memory : starved_by_sched];
        turn_ = (turn_ + 1) % pipelines_;
        if (hit) {
            ++records_;
            --left_;
            full_ = records_ == room_ || left_ == 0;
        }
        if (!written) return 0;
        ++addr_;
        full_ = false;
        return std::exchange(records_, 0);
    }
    /// Has the effect of that many calls of clock(false, false). Requires that full() is false.
    void skip(std::uint64_t cycles) {
        causes_[starved_by_sched] += cycles;
        turn_ = std::uint32_t((turn_ + cycles) % pipelines_);
    }
    /// Cycles by cause.
    const std::array<std::uint64_t, 8>& causes() const { return causes_; }

private:
    std::uint32_t pipelines_, room_, turn_ = 0, addr_ = 0, records_ = 0;
    std::uint32_t left_ = 0;   // answers that have not come
    bool full_ = false;
    std::array<std::uint64_t, 8> causes_{};
};

}   // namespace rayclock
