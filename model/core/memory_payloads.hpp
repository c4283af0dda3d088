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

/// tex -> texture memory: a texture record, or the texels of a hit. The address counts lines.
struct TexelReq {
    std::uint32_t ray = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("addr", addr, c.addr_bits);
    }
};

/// texture memory -> tex.
struct TexelRsp {
    std::uint32_t ray = 0;
    Line line{};
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("line", line, 32, 16);
    }
};

/// stream -> raygen: a ray from memory. Its request is the context's Slot, which holds the ray's number.
struct StreamRsp {
    std::uint32_t ray = 0;
    RayRecord record;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        record.fields(v, c);
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
using StreamMiss = LineReq<&Config::stream_miss_bits>;
using StreamFill = LineRsp<&Config::stream_miss_bits>;
using TexMiss = LineReq<&Config::tex_miss_bits>;
using TexFill = LineRsp<&Config::tex_miss_bits>;
using L2Req = LineReq<&Config::client_id_bits>;   ///< arbiter -> shared cache, or memory if there is none
using L2Rsp = LineRsp<&Config::client_id_bits>;
using L2Miss = LineReq<&Config::mem_id_bits>;   ///< shared cache -> memory port
/// chip -> DRAM: a read, or in a chip that writes hits also a write of a line. A write has no answer. In a
/// read, `line` has no meaning: it shows the line that the unit hits is filling.
struct MemReq {
    std::uint32_t id = 0, addr = 0;   ///< a write's id is 0
    std::uint32_t is_write = 0;
    Line line{};
    template <class V> void fields(V& v, const Config& c) {
        if (c.writes_hits()) v("line", line, 32, 16);
        if (c.writes_hits()) v("is_write", is_write, 1);
        v("id", id, c.mem_id_bits());
        v("addr", addr, c.addr_bits);
    }
};
using MemRsp = LineRsp<&Config::mem_id_bits>;

}   // namespace rayclock
