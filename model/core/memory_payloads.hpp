#pragma once
// The payloads of links to and from memory: requests of trav, list and shade, the answers of their caches,
// and lines between caches and the DRAM. payloads.hpp explains the symbols.
#include <algorithm>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/layout.hpp"
#include "model/core/lines.hpp"

namespace rayclock {

/// trav -> node memory. The address counts lines of 64 bytes.
struct NodeReq {
    std::uint32_t ray = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("addr", addr, c.addr_bits);
    }
};

/// list -> primitive memory. The address counts half lines of 32 bytes.
struct PrimReq {
    std::uint32_t ray = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("addr", addr, c.addr_bits + 1);
    }
};

/// node memory -> trav or xform.
struct NodeRsp {
    std::uint32_t ray = 0;
    std::uint32_t what = 0;   ///< LineKind, if there are instances
    /// Bit by bit: the bits of an instance, or of a mesh's node, beyond the width of a node of the scene's
    /// tree. The node follows.
    std::array<std::uint32_t, line_bits> beyond{};
    Node node;
    Treelet treelet;    ///< replaces `node` in a kd-tree
    GlobeNode globes;   ///< replaces `node` in a hierarchy of bounding spheres
    Slant slant;        ///< replaces `node` in a tree of planes in any direction
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.has_instances()) {
            v("what", what, line_kind_bits);
            const int most = std::max(bits_of<Placement>(c), node_bits(c, c.lower_engine()));
            const int more = most - node_bits(c, c.engine());
            if (more > 0) v("beyond", beyond, 1, more);
        }
        switch (c.engine()) {
            case Structure::kd: return treelet.fields(v, c);
            case Structure::spheres: return globes.fields(v, c);
            case Structure::bsp: return slant.fields(v, c);
            default: return node.fields(v, c);
        }
    }
};

/// primitive memory -> list.
struct PrimRsp {
    std::uint32_t ray = 0;
    PrimData triangle;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        triangle.fields(v, c);
    }
};

/// shade -> surface memory. The address counts lines.
struct SurfReq {
    std::uint32_t ray = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("addr", addr, c.addr_bits);
    }
};

/// surface memory -> shade.
struct SurfRsp {
    std::uint32_t ray = 0;
    Surface surface;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        surface.fields(v, c);
    }
};

/// cache -> memory: a request for one word of a missing line. `id` distinguishes the requests in flight; see
/// model/mem/cache.hpp.
template <int (Config::*id_bits)() const> struct LineReq {
    std::uint32_t id = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("id", id, (c.*id_bits)());
        v("addr", addr, c.addr_bits);
    }
};
/// memory -> cache: the word requested with this `id`.
template <int (Config::*id_bits)() const> struct LineRsp {
    std::uint32_t id = 0;
    Line line{};
    template <class V> void fields(V& v, const Config& c) {
        v("id", id, (c.*id_bits)());
        v("line", line, 32, 16);
    }
};
using NodeMiss = LineReq<&Config::node_miss_bits>;
using NodeFill = LineRsp<&Config::node_miss_bits>;
using PrimMiss = LineReq<&Config::prim_miss_bits>;
using PrimFill = LineRsp<&Config::prim_miss_bits>;
using SurfMiss = LineReq<&Config::surf_miss_bits>;
using SurfFill = LineRsp<&Config::surf_miss_bits>;
using L2Req = LineReq<&Config::client_id_bits>;   ///< arbiter -> shared cache, or memory if there is none
using L2Rsp = LineRsp<&Config::client_id_bits>;
using MemReq = LineReq<&Config::mem_id_bits>;   ///< chip -> DRAM
using MemRsp = LineRsp<&Config::mem_id_bits>;

}   // namespace rayclock
