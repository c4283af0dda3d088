#pragma once
// The links between units, in the order a ray meets them: one name each for lockstep, reports and tests.
#include <array>
#include <cstdint>
#include <tuple>

#include "model/core/payloads.hpp"

namespace rayclock {

/// Links of one pipeline; then those that all pipelines share.
enum class Channel : std::uint8_t {
    tile,
    slot,
    ray,
    node_req,
    node_miss,
    node_fill,
    box_req,
    box_rsp,
    leaves,
    prim_req,
    prim_miss,
    prim_fill,
    tri_req,
    tri_rsp,
    tested,
    hit,
    closest,
    surf_req,
    surf_miss,
    surf_fill,
    surf_rsp,
    spawn,   // of a chip that shades
    l2_req,
    l2_rsp,
    mem_req,
    mem_rsp,
};
constexpr std::size_t pipeline_channels = 22, channel_count = 26,
                      plain_channels = 16;   // plain: of a pipeline that does not shade

/// Payload of each channel, by its number.
using ChannelPayloads = std::tuple<Tile, Slot, Ray, NodeReq, NodeMiss, NodeFill, BoxReq, BoxRsp, Leaves,
                                   PrimReq, PrimMiss, PrimFill, TriReq, TriRsp, Tested, HitOut, Closest,
                                   SurfReq, SurfMiss, SurfFill, SurfRsp, Spawn, L2Req, L2Rsp, MemReq, MemRsp>;

struct ChannelInfo {
    const char* name;
    const char* from;   ///< unit that offers
    const char* to;     ///< unit that accepts
    bool fires_only;    ///< always accepted: there is no ready
};
constexpr std::array<ChannelInfo, channel_count> channels{{
    {"tile", "dispatch", "sched", true},
    {"slot", "sched", "raygen", false},
    {"ray", "raygen", "trav", false},
    {"node_req", "trav", "node_cache", false},
    {"node_miss", "node_cache", "memport", false},
    {"node_fill", "memport", "node_cache", true},
    {"box_req", "node_cache", "box", false},
    {"box_rsp", "box", "trav", false},
    {"leaves", "trav", "list", true},
    {"prim_req", "list", "prim_cache", false},
    {"prim_miss", "prim_cache", "memport", false},
    {"prim_fill", "memport", "prim_cache", true},
    {"tri_req", "prim_cache", "tri", false},
    {"tri_rsp", "tri", "list", false},
    {"tested", "list", "trav", false},
    {"hit", "sched", "sink", false},
    {"closest", "list", "shade", false},
    {"surf_req", "shade", "surf_cache", false},
    {"surf_miss", "surf_cache", "memport", false},
    {"surf_fill", "memport", "surf_cache", true},
    {"surf_rsp", "surf_cache", "shade", false},
    {"spawn", "shade", "raygen", false},
    {"l2_req", "memport", "l2", false},
    {"l2_rsp", "l2", "memport", true},
    {"mem_req", "memport", "memory", false},
    {"mem_rsp", "memory", "memport", true},
}};
constexpr std::size_t index(Channel c) { return std::size_t(c); }
constexpr std::uint32_t bit(Channel c) { return 1u << index(c); }

}   // namespace rayclock
