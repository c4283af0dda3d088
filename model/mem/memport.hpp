#pragma once
#include <cstdint>
#include <vector>

#include "model/core/config.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// Traffic that tests put on a memory port or a sink, on top of its fixed figures. Seeded: two machines that make the same
/// requests in the same cycles see the same traffic.
struct Traffic {
    int jitter = 0;           ///< extra cycles of latency, 0..jitter, drawn per request: answers overtake each other
    int stall_percent = 0;    ///< share of cycles in which no request is accepted
    std::uint64_t seed = 1;
};

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
class Rng {
public:
    explicit Rng(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    int below(int n) { return int(next() % std::uint64_t(n)); }

private:
    std::uint64_t state_;
};

/// A memory port with a stated latency and bandwidth: a request accepted in cycle c is answered in cycle c + mem_latency
/// (plus jitter), at most one request every mem_interval cycles. It keeps only who asked for which address; whoever owns the
/// port reads the memory image. At most one request per ray context may be under way. The same class lies under the model
/// and under the RTL.
class Memport {
public:
    Memport(const Config& config, Traffic traffic);

    struct Answer {
        std::uint32_t ray = 0, addr = 0;
    };
    bool ready() const { return ready_; }
    bool valid() const { return valid_; }
    Answer answer() const { return answer_; }

    /// One clock edge: the request that was accepted (null if none) and whether the answer was taken.
    void clock(const Answer* request, bool taken);

private:
    struct Pending {
        Answer what;
        std::uint64_t due = 0;
    };
    void offer();

    std::uint64_t latency_, interval_;
    Traffic traffic_;
    Rng rng_;
    Ring<Pending> in_order_;            // without jitter
    std::vector<Pending> overtaking_;   // with it; oldest first
    std::uint64_t now_ = 0, next_free_ = 0;
    bool ready_ = true, valid_ = false;
    Answer answer_{};
};

/// Each port draws from a stream of its own.
inline Traffic node_traffic(Traffic t) { t.seed = t.seed * 4 + 1; return t; }
inline Traffic prim_traffic(Traffic t) { t.seed = t.seed * 4 + 2; return t; }

/// Where hits go: always ready, or not in a share of the cycles.
class Sink {
public:
    explicit Sink(Traffic traffic) : stall_percent_(traffic.stall_percent), rng_(traffic.seed * 4 + 3) {}
    bool ready() const { return ready_; }
    void clock() { ready_ = stall_percent_ == 0 || rng_.below(100) >= stall_percent_; }

private:
    int stall_percent_;
    Rng rng_;
    bool ready_ = true;
};

} // namespace rayclock
