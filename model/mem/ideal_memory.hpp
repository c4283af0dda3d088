#pragma once
// The ideal memory, and the disturbance that tests add to memory and sinks.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/base/rng.hpp"
#include "model/core/config.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// The disturbance that tests add to the memory port and the sinks, on top of their fixed figures. It is
/// seeded: two machines that make the same requests in the same cycles see the same disturbance.
struct Disturbance {
    /// Extra cycles of latency, 0..jitter, drawn per answer, so that answers overtake each other.
    int jitter = 0;
    int stall_percent = 0;   ///< percentage of cycles in which memory, or a sink, accepts nothing
    std::uint64_t seed = 1;
    bool none() const { return jitter == 0 && stall_percent == 0; }
};

/// The ideal memory, at any clock. A request accepted in cycle c is answered in cycle c + mem_latency, with
/// at most one request every mem_interval cycles. It holds ids and addresses only; the port's owner reads the
/// memory image. An id may be used again only after its answer. Answers must be accepted. The same class
/// serves the model and the RTL.
class IdealMemory {
public:
    IdealMemory(const Config& config, int ids);

    struct Answer {
        std::uint32_t id = 0, addr = 0;
        bool is_write = false;   // of a request
    };
    bool ready() const { return now_ >= next_free_; }
    bool valid() const { return !pending_.empty() && pending_.front().due <= now_; }
    Answer answer() const { return pending_.front().what; }
    bool waits() const { return !pending_.empty(); }

    /// One clock edge, with the accepted request or null. An answer on offer leaves.
    void clock(const Answer* request);
    /// Performs a write, which has no answer and ends immediately. Call it before clock(nullptr), in place of
    /// a request.
    void write() { next_free_ = now_ + interval_; }

    /// Returns the first cycle, in calls of clock(), in which ready() or valid() could change without a
    /// request. skip() has the effect of `cycles` calls of clock(nullptr), up to that cycle.
    std::uint64_t quiet_until() const {
        const std::uint64_t answer = pending_.empty() ? ~std::uint64_t(0) : pending_.front().due;
        return now_ < next_free_ && next_free_ < answer ? next_free_ : answer;
    }
    void skip(std::uint64_t cycles) { now_ += cycles; }
    std::uint64_t now() const { return now_; }

    /// Returns the number of cycles whose answers are known, from the current one on.
    std::uint64_t known() const { return latency_; }
    /// Calls `f(cycle, id)` for the answers of the next `cycles` cycles, at most known().
    template <class F> void each_known(std::uint64_t cycles, F&& f) const {
        std::uint64_t at = now_;   // at most one answer in a cycle
        for (std::size_t i = 0; i < pending_.size(); ++i, ++at) {
            at = std::max(at, pending_.at(i).due);
            if (at >= now_ + cycles) return;
            f(std::size_t(at - now_), pending_.at(i).what.id);
        }
    }

private:
    struct Pending {
        Answer what;
        std::uint64_t due = 0;
    };
    std::uint64_t latency_, interval_, now_ = 0, next_free_ = 0;
    Ring<Pending> pending_;
};

/// The receiver of hits: always ready, or stalled in a share of the cycles. Each sink draws from its own
/// random stream.
class Sink {
public:
    Sink(Disturbance disturbance, int number)
        : stall_percent_(disturbance.stall_percent),
          rng_(disturbance.seed * 16 + 3 + std::uint64_t(number)) {}
    bool ready() const { return ready_ & is_open_; }
    /// Opens or closes it, in addition to the stalls. It is open at first.
    void open(bool is_open) { is_open_ = is_open; }
    void clock() { ready_ = stall_percent_ == 0 || rng_.below(100) >= stall_percent_; }

private:
    int stall_percent_;
    Rng rng_;
    bool ready_ = true, is_open_ = true;
};

}   // namespace rayclock
