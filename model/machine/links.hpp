#pragma once
// The links between units, one row each, in the order in which a ray meets them. These rows give the names in
// lockstep and reports, the masks, and the payloads' structs in rc_pkg.sv. They also give the signals that
// lockstep reads in the RTL, and the table in rtl/README.md. A payload describes its own fields
// (payloads.hpp).
#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

#include "model/core/payloads.hpp"
#include "model/machine/units.hpp"

namespace rayclock {

// Columns: name, payload, source, destination, flow, and when the link exists. With flow `handshake` (valid
// and ready) the destination may stall; with `fires` it must accept. Links of a pipeline come first, and
// among these the shading ones come last: the bits of lockstep's masks follow this order.
#define RAYCLOCK_NODE_LINKS(LINK, structure, unit, Engine)                    \
    LINK(unit##_req, Engine::Request, node_cache, unit, handshake, structure) \
    LINK(unit##_rsp, NodeAnswer, unit, trav, handshake, structure)
#define RAYCLOCK_LINKS(LINK)                                           \
    LINK(tile, Tile, dispatch, sched, fires, always)                   \
    LINK(slot, Slot, sched, raygen, handshake, always)                 \
    LINK(ray, Ray, raygen, trav, handshake, always)                    \
    LINK(node_req, NodeReq, trav, node_cache, handshake, nodes)        \
    LINK(node_miss, NodeMiss, node_cache, memport, handshake, nodes)   \
    LINK(node_fill, NodeFill, memport, node_cache, fires, nodes)       \
    RAYCLOCK_ENGINES(RAYCLOCK_NODE_LINKS, LINK)                        \
    LINK(xform_req, XformReq, node_cache, xform, handshake, instances) \
    LINK(change, Change, xform, trav, fires, instances)                \
    LINK(leaves, Leaves, trav, list, fires, always)                    \
    LINK(prim_req, PrimReq, list, prim_cache, handshake, always)       \
    LINK(prim_miss, PrimMiss, prim_cache, memport, handshake, always)  \
    LINK(prim_fill, PrimFill, memport, prim_cache, fires, always)      \
    LINK(tri_req, TriReq, prim_cache, tri, handshake, always)          \
    LINK(tri_rsp, TriRsp, tri, list, handshake, always)                \
    LINK(tested, Tested, list, trav, handshake, always)                \
    LINK(hit, HitOut, sched, sink, handshake, always)                  \
    LINK(closest, Closest, list, shade, handshake, shade)              \
    LINK(surf_req, SurfReq, shade, surf_cache, handshake, shade)       \
    LINK(surf_miss, SurfMiss, surf_cache, memport, handshake, shade)   \
    LINK(surf_fill, SurfFill, memport, surf_cache, fires, shade)       \
    LINK(surf_rsp, SurfRsp, surf_cache, shade, handshake, shade)       \
    LINK(spawn, Spawn, shade, raygen, handshake, shade)                \
    LINK(tex_req, TexReq, shade, tex, handshake, textures)             \
    LINK(texel_req, TexelReq, tex, tex_cache, handshake, textures)     \
    LINK(tex_miss, TexMiss, tex_cache, memport, handshake, textures)   \
    LINK(tex_fill, TexFill, memport, tex_cache, fires, textures)       \
    LINK(texel_rsp, TexelRsp, tex_cache, tex, handshake, textures)     \
    LINK(tex_rsp, TexRsp, tex, shade, fires, textures)                 \
    LINK(stream_miss, StreamMiss, stream, memport, handshake, stream)  \
    LINK(stream_fill, StreamFill, memport, stream, fires, stream)      \
    LINK(record, StreamRsp, stream, raygen, handshake, stream)         \
    LINK(l2_req, L2Req, memport, l2, handshake, shared_cache)          \
    LINK(l2_rsp, L2Rsp, l2, memport, fires, shared_cache)              \
    LINK(mem_req, MemReq, memport, memory, handshake, always)          \
    LINK(mem_rsp, MemRsp, memory, memport, fires, always)

#define RAYCLOCK_NAME(name, ...) name,
enum class Link : std::uint8_t { RAYCLOCK_LINKS(RAYCLOCK_NAME) };
#undef RAYCLOCK_NAME

/// Flow control: `handshake` may stall, `fires` must be accepted.
enum class Flow : std::uint8_t { handshake, fires };

struct LinkInfo {
    const char* name;
    const char* from;   ///< unit that drives it
    const char* to;     ///< unit that accepts it
    Flow flow;
    Presence when;
    bool carries_ray;   ///< its payload names a context
    constexpr bool of_pipeline() const { return is_of_pipeline(from) || is_of_pipeline(to); }
    /// True if the link lies within the engine that walks a ray. No other unit sees it.
    constexpr bool of_engine() const {
        return place_of(from) == UnitPlace::engine || place_of(to) == UnitPlace::engine;
    }
};
template <class Payload> constexpr bool names_ray = requires(Payload p) { p.ray; }
|| requires(Payload p) { p.closest.ray; };
#define RAYCLOCK_INFO(name, payload, from, to, flow, when) \
    LinkInfo{#name, #from, #to, Flow::flow, Presence::when, names_ray<payload>},
constexpr std::array link_infos{RAYCLOCK_LINKS(RAYCLOCK_INFO)};
#undef RAYCLOCK_INFO

/// The payload of each link, by its number.
#define RAYCLOCK_PAYLOAD(name, payload, ...) , std::declval<std::tuple<payload>>()
using LinkPayloads = decltype(std::tuple_cat(std::tuple<>() RAYCLOCK_LINKS(RAYCLOCK_PAYLOAD)));
#undef RAYCLOCK_PAYLOAD
#undef RAYCLOCK_LINKS
#undef RAYCLOCK_NODE_LINKS

/// A node unit, which decides which children of a node a ray meets, and its links.
struct NodeUnit {
    Unit unit;
    Link req, rsp;
};
/// All node units, in the order of the engines.
#define RAYCLOCK_NODE_UNIT(with, structure, unit, Engine) \
    NodeUnit{Unit::unit, Link::unit##_req, Link::unit##_rsp},
constexpr std::array node_units{RAYCLOCK_ENGINES(RAYCLOCK_NODE_UNIT, )};
#undef RAYCLOCK_NODE_UNIT
constexpr bool is_node_unit(Unit unit) {
    for (const NodeUnit& u : node_units)
        if (u.unit == unit) return true;
    return false;
}
/// True if the unit receives what node_cache has read.
constexpr bool takes_lines(Unit unit) { return is_node_unit(unit) || unit == Unit::xform; }
/// True if the causes of two units have the same codes.
constexpr bool same_causes(Unit a, Unit b) {
    for (std::size_t code = 0; code < cause_count; ++code) {
        const Cause &one = unit_infos[index(a)].causes[code], &other = unit_infos[index(b)].causes[code];
        if (one.kind != other.kind || std::string_view(one.name) != other.name) return false;
    }
    return true;
}
static_assert(std::ranges::all_of(node_units, [](const NodeUnit& u) {
    return same_causes(u.unit, node_units[0].unit);   // the same wiring drives them: rtl/engine/rc_tree.sv
}));
constexpr bool is_node_request(Link link) {
    for (const NodeUnit& u : node_units)
        if (u.req == link) return true;
    return false;
}
constexpr bool is_node_answer(Link link) {
    for (const NodeUnit& u : node_units)
        if (u.rsp == link) return true;
    return false;
}
/// Returns the node unit of an engine. Without nodes it is the unit of bvh, whose links are then idle.
constexpr NodeUnit node_unit(Structure engine) {
    switch (engine) {
#define RAYCLOCK_CASE(with, structure, unit, Engine) \
    case Structure::structure: return {Unit::unit, Link::unit##_req, Link::unit##_rsp};
        RAYCLOCK_ENGINES(RAYCLOCK_CASE, )
#undef RAYCLOCK_CASE
        default: return node_units[0];
    }
}
constexpr const char* unit_name(Unit unit) { return unit_infos[index(unit)].name; }
constexpr const char* unit_name(Structure engine) { return unit_name(node_unit(engine).unit); }
constexpr std::size_t link_count = link_infos.size();
constexpr std::size_t pipeline_links = [] {   // the others are shared by all pipelines
    std::size_t n = 0;
    while (link_infos[n].of_pipeline()) ++n;
    for (std::size_t i = n; i < link_count; ++i)
        if (link_infos[i].of_pipeline()) throw "links of a pipeline come first";
    return n;
}();
constexpr std::size_t index(Link c) { return std::size_t(c); }
using LinkMask = std::uint64_t;   ///< one bit per link
constexpr LinkMask bit(Link c) { return LinkMask(1) << index(c); }
static_assert(link_count <= 64);

/// True if a chip of this configuration has the link.
constexpr bool is_there(Link c, const Config& config) { return is_there(link_infos[index(c)].when, config); }

}   // namespace rayclock
