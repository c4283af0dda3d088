#pragma once
// The links between units, in the order a ray meets them: one name each for lockstep, counters, reports and tests.
#include <array>
#include <cstdint>
#include <tuple>

#include "model/core/payloads.hpp"

namespace rayclock {

enum class Channel : std::uint8_t { slot, ray, node_req, box_req, box_rsp, prim_req, tri_req, tri_rsp, step, hit };
constexpr std::size_t channel_count = 10;

/// Payload of each channel, by its number.
using ChannelPayloads = std::tuple<Slot, Ray, NodeReq, BoxReq, BoxRsp, PrimReq, TriReq, TriRsp, Step, HitOut>;

struct ChannelInfo {
    const char* name;
    const char* from;   ///< unit that offers
    const char* to;     ///< unit that accepts
};
constexpr std::array<ChannelInfo, channel_count> channels{{
    {"slot", "sched", "raygen"},
    {"ray", "raygen", "trav"},
    {"node_req", "trav", "memport"},
    {"box_req", "memport", "box"},
    {"box_rsp", "box", "list"},
    {"prim_req", "list", "memport"},
    {"tri_req", "memport", "tri"},
    {"tri_rsp", "tri", "list"},
    {"step", "list", "trav"},
    {"hit", "sched", "sink"},
}};
constexpr std::size_t index(Channel c) { return std::size_t(c); }
constexpr std::uint32_t bit(Channel c) { return 1u << index(c); }

/// Cycles in which a link moved something, and in which it offered something that was not accepted. In the remaining
/// cycles of a run it had nothing to offer: the three sum to the run's cycles by construction of valid and ready.
struct ChannelCount {
    std::uint64_t moved = 0, refused = 0;
    friend bool operator==(const ChannelCount&, const ChannelCount&) = default;
};
using ChannelCounts = std::array<ChannelCount, channel_count>;

/// Adds up valid and fire masks of cycles without a branch per channel.
class ChannelCounter {
public:
    void add(std::uint32_t valid, std::uint32_t fire) {
        ++moved_[fire];
        ++refused_[valid & ~fire];
    }
    ChannelCounts counts() const {
        ChannelCounts sums{};
        for (std::uint32_t mask = 0; mask < moved_.size(); ++mask)
            for (std::size_t c = 0; c < channel_count; ++c)
                if (mask >> c & 1) {
                    sums[c].moved += moved_[mask];
                    sums[c].refused += refused_[mask];
                }
        return sums;
    }

private:
    std::array<std::uint64_t, 1u << channel_count> moved_{}, refused_{};
};

} // namespace rayclock
