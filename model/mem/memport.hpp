#pragma once
#include <cstdint>
#include <vector>

#include "model/core/config.hpp"
#include "model/core/ring.hpp"
#include "model/base/rng.hpp"

namespace rayclock {

/// Traffic that tests put on the memory port and on the sinks, on top of their fixed figures. Seeded: two
/// machines that make the same requests in the same cycles see the same traffic.
struct Traffic {
    int jitter = 0;   ///< extra cycles of latency, 0..jitter, drawn per answer: they overtake each other
    int stall_percent = 0;   ///< share of cycles in which no request is accepted
    std::uint64_t seed = 1;
    bool none() const { return jitter == 0 && stall_percent == 0; }
};

/// The ideal memory: a request accepted in cycle c is answered in cycle c + mem_latency, at most one request
/// every mem_interval cycles, at any clock. It keeps only who asked for which address; whoever owns the port
/// reads the memory image. Requests are told apart by id, and one with the same id is made only after the
/// answer. Answers are always taken. The same class lies under the model and under the RTL.
class Memport {
public:
    Memport(const Config& config, int ids);

    struct Answer {
        std::uint32_t id = 0, addr = 0;
    };
    bool ready() const { return now_ >= next_free_; }
    bool valid() const { return !pending_.empty() && pending_.front().due <= now_; }
    Answer answer() const { return pending_.front().what; }
    bool waits() const { return !pending_.empty(); }

    /// One clock edge: the request that was accepted, null if none. An answer on offer goes.
    void clock(const Answer* request);
    /// In the place of a request, before clock(nullptr): a write, which has no answer and is done at once.
    void write() { next_free_ = now_ + interval_; }

    /// The first cycle, in calls of clock(), in which ready() or valid() could change without a request; and
    /// the same as clock(nullptr) `cycles` times up to there.
    std::uint64_t quiet_until() const {
        const std::uint64_t answer = pending_.empty() ? ~std::uint64_t(0) : pending_.front().due;
        return now_ < next_free_ && next_free_ < answer ? next_free_ : answer;
    }
    void skip(std::uint64_t cycles) { now_ += cycles; }

private:
    struct Pending {
        Answer what;
        std::uint64_t due = 0;
    };
    std::uint64_t latency_, interval_, now_ = 0, next_free_ = 0;
    Ring<Pending> pending_;
};

/// Where hits go: always ready, or not in a share of the cycles. Each sink draws from a stream of its own.
class Sink {
public:
    Sink(Traffic traffic, int number)
        : stall_percent_(traffic.stall_percent), rng_(traffic.seed * 16 + 3 + std::uint64_t(number)) {}
    bool ready() const { return ready_; }
    void clock() { ready_ = stall_percent_ == 0 || rng_.below(100) >= stall_percent_; }

private:
    int stall_percent_;
    Rng rng_;
    bool ready_ = true;
};

}   // namespace rayclock
