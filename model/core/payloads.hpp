#pragma once
// Every payload of the machine, described once: C++ members, widths, and through them rc_pkg.sv.
//
// Symbols: N coord_bits, M dir_bits, F t_frac_bits, R recip_bits, W node_width (core/config.hpp).
// A distance t is in units of 2^-F lattice steps along a direction of length 2^(M-1): t = 2^(M-1+F) * (point - o) / d.
#include <array>
#include <cstdint>
#include <span>

#include "model/core/config.hpp"
#include "model/core/layout.hpp"

namespace rayclock {

constexpr int max_width = 8;

using Vec3i = std::array<std::int32_t, 3>;
using Vec3l = std::array<std::int64_t, 3>;

/// Registers that the host sets for a frame. direction(x, y) = round((corner + x right + y down) / 2^guard_bits).
struct Frame {
    std::uint32_t width = 0, height = 0;
    std::uint32_t root = 0;          ///< line of the root node
    Vec3i eye{};                     ///< lattice point
    Vec3l corner{}, right{}, down{}; ///< M + guard_bits bits, signed
    template <class V> void fields(V& v, const Config& c) {
        v("width", width, c.pixel_bits + 1);
        v("height", height, c.pixel_bits + 1);
        v("root", root, c.addr_bits);
        v("eye", eye, c.coord_bits, 3);
        v("corner", corner, c.guard_dir_bits(), 3);
        v("right", right, c.guard_dir_bits(), 3);
        v("down", down, c.guard_dir_bits(), 3);
    }
};

/// dispatch -> sched: a square of 2^tile_bits x 2^tile_bits pixels; coordinates in such squares.
struct Tile {
    std::uint32_t x = 0, y = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("x", x, c.tile_coord_bits());
        v("y", y, c.tile_coord_bits());
    }
};

/// sched -> raygen: a context gets a pixel.
struct Slot {
    std::uint32_t ray = 0;
    std::uint32_t x = 0, y = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("x", x, c.pixel_bits);
        v("y", y, c.pixel_bits);
    }
};

/// A direction as the sheared test uses it (model/isect/sheared.hpp). In no payload of the other tests.
struct Shear {
    std::uint32_t axis = 0;             ///< z: of the largest |d|
    std::uint32_t neg = 0;              ///< d_z < 0
    std::uint32_t size = 0;             ///< |d_z|, M bits: 2^(M-1) is possible
    std::array<std::int32_t, 2> slope{};///< d_x / d_z, d_y / d_z, with M - 2 fraction bits
    template <class V> void fields(V& v, const Config& c) {
        v("axis", axis, 2);
        v("neg", neg, 1);
        v("size", size, c.dir_bits);
        v("slope", slope, c.dir_bits, 2);
    }
};

/// raygen -> trav, list: a camera ray with its reciprocal direction.
/// For |d| of bit length len: m = |d| << (M - len), recip = floor(2^(M+R-1) / m). A zero component has len 0, recip 1.
struct Ray {
    std::uint32_t ray = 0;
    Vec3i o{};                              ///< origin, lattice point, N bits
    Vec3i d{};                              ///< direction, M bits
    std::array<std::uint32_t, 3> recip{};   ///< R + 1 bits
    std::array<std::uint32_t, 3> len{};     ///< 0..M
    Shear shear;                            ///< for the sheared test
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.is_sheared()) shear.fields(v, c);
        v("o", o, c.coord_bits, 3);
        v("d", d, c.dir_bits, 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
    }
};

/// A node as it lies in a memory line of 64 bytes (right-aligned): child boxes quantised relative to `org`, plane
/// k is org + (k << exp). kind: 0 empty, 1 inner node, 1 + n a leaf of n triangles. Inner children come first.
/// Block of children at line `base`: one line per inner child in slot order, then the leaves' triangles, 32 bytes each.
struct Node {
    Vec3i org{};
    std::array<std::uint32_t, 3> exp{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    std::array<std::uint32_t, 3 * max_width> lo{}, hi{};   ///< [3 * child + axis]
    template <class V> void fields(V& v, const Config& c) {
        v("org", org, c.coord_bits, 3);
        v("exp", exp, exp_bits, 3);
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
        v("lo", lo, c.box_bits, 3 * c.node_width);
        v("hi", hi, c.box_bits, 3 * c.node_width);
    }
};

/// A triangle as it lies in 32 bytes of memory (right-aligned): corners a, b, c on the lattice and its number.
struct PrimData {
    Vec3i a{}, b{}, c{};
    std::uint32_t prim = 0;
    template <class V> void fields(V& v, const Config& c_) {
        v("a", a, c_.coord_bits, 3);
        v("b", b, c_.coord_bits, 3);
        v("c", c, c_.coord_bits, 3);
        v("prim", prim, c_.prim_bits);
    }
};

/// trav -> node memory; address in lines of 64 bytes.
struct NodeReq {
    std::uint32_t ray = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("addr", addr, c.addr_bits);
    }
};

/// list -> primitive memory; address in half lines of 32 bytes.
struct PrimReq {
    std::uint32_t ray = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("addr", addr, c.addr_bits + 1);
    }
};

/// node memory -> trav.
struct NodeRsp {
    std::uint32_t ray = 0;
    Node node;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        node.fields(v, c);
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

/// What memory gives in one answer: 64 bytes.
using Line = std::array<std::uint32_t, 16>;

/// A cache -> memory: a word of a line that is not there. `id` tells the requests under way apart; see model/mem/cache.hpp.
template <int (Config::*id_bits)() const> struct LineReq {
    std::uint32_t id = 0, addr = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("id", id, (c.*id_bits)());
        v("addr", addr, c.addr_bits);
    }
};
/// Memory -> a cache.
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
using L2Req = LineReq<&Config::client_id_bits>;   ///< arbiter -> shared cache, or memory if there is none
using L2Rsp = LineRsp<&Config::client_id_bits>;
using MemReq = LineReq<&Config::mem_id_bits>;     ///< chip -> DRAM
using MemRsp = LineRsp<&Config::mem_id_bits>;

/// trav -> box: the ray and the node that came from memory.
struct BoxReq {
    std::uint32_t ray = 0;
    Vec3i o{};
    std::array<std::uint32_t, 3> neg{}, recip{}, len{};
    Node node;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("o", o, c.coord_bits, 3);
        v("neg", neg, 1, 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
        node.fields(v, c);
    }
};

/// box -> list: the children that the ray's line meets in front of its origin. Inner children first, then leaves, each
/// sorted by (t_near, offset); entries beyond are zero. `count` is 0 for inner children.
struct BoxRsp {
    std::uint32_t ray = 0;
    std::uint32_t base = 0;
    std::uint32_t inner = 0, leaves = 0;                 ///< how many of each
    std::array<std::uint32_t, max_width> t_near{};       ///< rounded down
    std::array<std::uint32_t, max_width> offset{};       ///< from base, in half lines
    std::array<std::uint32_t, max_width> count{};
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("base", base, c.addr_bits);
        v("inner", inner, c.group_bits());
        v("leaves", leaves, c.group_bits());
        v("t_near", t_near, c.t_bits(), c.node_width);
        v("offset", offset, offset_bits, c.node_width);
        v("count", count, count_bits, c.node_width);
    }
};

/// The closest hit so far, as tri compares it: t = num / det exactly (sheared: t |d_z|).
struct Best {
    std::uint32_t found = 0;
    std::int64_t num = 0, det = 0;
    std::uint32_t prim = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("found", found, 1);
        v("best_num", num, c.num_bits());
        v("best_det", det, c.edge_bits());
        v("best_prim", prim, c.prim_bits);
    }
};

/// list -> tri: ray, triangle and the hit to beat. What tri needs of a ray, tri_ray_bits, follows the number as it does in Ray.
struct TriReq {
    std::uint32_t ray = 0;
    Vec3i o{}, d{};
    PrimData triangle;
    Best best;
    Shear shear{};   ///< takes the place of d for the sheared test
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.is_sheared()) shear.fields(v, c);
        v("o", o, c.coord_bits, 3);
        if (!c.is_sheared()) v("d", d, c.dir_bits, 3);
        triangle.fields(v, c);
        best.fields(v, c);
    }
};

/// tri -> list: whether this triangle is the closest so far, and if so where. All zero otherwise.
struct TriRsp {
    std::uint32_t ray = 0;
    std::uint32_t closer = 0;
    std::int64_t num = 0, det = 0;   ///< as in Best; det > 0
    std::uint32_t prim = 0;
    std::uint32_t t = 0;             ///< ceil(2^(M-1+F) t), saturated
    std::uint32_t u = 0, v = 0;      ///< floor(2^bary_bits u / det), weight of b and of c; 2^bary_bits is possible
    template <class V> void fields(V& v_, const Config& c) {
        v_("ray", ray, c.ray_bits());
        v_("closer", closer, 1);
        v_("num", num, c.num_bits());
        v_("det", det, c.edge_bits());
        v_("prim", prim, c.prim_bits);
        v_("t", t, c.t_bits());
        v_("u", u, c.bary_bits + 1);
        v_("v", v, c.bary_bits + 1);
    }
};

/// list -> trav: the leaves of a node are done; here are its inner children and the distance to beat.
struct Step {
    std::uint32_t ray = 0;
    std::uint32_t t_best = 0;
    std::uint32_t base = 0;
    std::uint32_t inner = 0;
    std::array<std::uint32_t, max_width> t_near{};
    std::array<std::uint32_t, max_width> slot{};     ///< line from base
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("t_best", t_best, c.t_bits());
        v("base", base, c.addr_bits);
        v("inner", inner, c.group_bits());
        v("t_near", t_near, c.t_bits(), c.node_width);
        v("slot", slot, c.slot_bits(), c.node_width);
    }
};

/// trav -> list: nothing closer can be found for this ray.
struct Done {
    std::uint32_t ray = 0;
    template <class V> void fields(V& v, const Config& c) { v("ray", ray, c.ray_bits()); }
};

/// list -> sched: the closest hit of a finished ray.
struct Closest {
    std::uint32_t ray = 0;
    std::uint32_t found = 0;
    std::uint32_t prim = 0, t = 0, u = 0, v = 0;   ///< zero if not found
    template <class V> void fields(V& v_, const Config& c) {
        v_("ray", ray, c.ray_bits());
        v_("found", found, 1);
        v_("prim", prim, c.prim_bits);
        v_("t", t, c.t_bits());
        v_("u", u, c.bary_bits + 1);
        v_("v", v, c.bary_bits + 1);
    }
};

/// sched -> outside: what the pixel's ray hit.
struct HitOut {
    std::uint32_t x = 0, y = 0;
    Closest closest;
    template <class V> void fields(V& v, const Config& c) {
        v("x", x, c.pixel_bits);
        v("y", y, c.pixel_bits);
        closest.fields(v, c);
    }
};

} // namespace rayclock
