#pragma once
// Every payload of the machine, described once: its C++ members and their widths. rc_pkg.sv comes from these
// descriptions. A field has the name that `fields()` gives it, in the RTL and in messages: nearly always that
// of its member. If a payload contains another one, the RTL's names have a prefix: home_o is home.o, best_num
// is best.num, prim_kind is triangle.kind. memory_payloads.hpp has the payloads of links to memory,
// node_payloads.hpp those of node units.
//
// Symbols: N coord_bits, M dir_bits, F t_frac_bits, R recip_bits, W node_width (core/config.hpp). A distance
// t is in units of 2^-F lattice steps along a direction of length 2^(M-1): t = 2^(M-1+F) * (point - o) / d.
#include <array>
#include <cstdint>
#include <span>

#include "model/core/config.hpp"
#include "model/core/frame.hpp"
#include "model/core/layout.hpp"
#include "model/core/memory_payloads.hpp"
#include "model/core/node_payloads.hpp"

namespace rayclock {

/// dispatch -> sched: a square of 2^tile_bits x 2^tile_bits pixels. Its coordinates count such squares. With
/// a stream: 4^tile_bits rays in sequence; x and y are the lower and upper bits of the number of such a
/// group.
struct Tile {
    std::uint32_t x = 0, y = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("x", x, c.tile_coord_bits());
        v("y", y, c.tile_coord_bits());
    }
};

/// sched -> raygen: a context gets a pixel. With a stream, sched -> stream: a context gets a ray; x and y are
/// the lower and upper bits of its number.
struct Slot {
    std::uint32_t ray = 0;
    std::uint32_t x = 0, y = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("x", x, c.pixel_bits);
        v("y", y, c.pixel_bits);
    }
};

/// The home of a ray, with two levels: the instance from whose triangle the ray starts, or at which a shadow
/// ray ends, and the ray in the space of the instance's mesh. That ray is not computed from o and d, which
/// are rounded: it begins, or ends, exactly in the triangle (docs/machine/motion.md). Camera rays and
/// rays of a stream have no home.
struct Home {
    std::uint32_t line = 0;   ///< Placement::here; 0 without a home
    Vec3i o{}, d{};           ///< as in Ray
    template <class V> void fields(V& v, const Config& c) {
        if (!c.has_homes()) return;
        v("home", line, c.addr_bits);
        v("home_o", o, c.origin_width(), 3);
        v("home_d", d, c.ray_dir_bits(), 3);
    }
    friend bool operator==(const Home&, const Home&) = default;
};

/// shade -> raygen: the next ray of a context. A camera ray comes from its pixel and sample, and uses neither
/// o nor d.
struct Spawn {
    std::uint32_t ray = 0;
    RayKind kind = RayKind::camera;
    std::uint32_t x = 0, y = 0, sample = 0;
    std::uint32_t is_partial = 0, self = 0, is_inside = 0, holes = 0;   ///< as in Ray
    Vec3i o{};                                                          ///< N + B bits, B of them fraction
    Vec3i d{};                                                          ///< N + B + 1 bits
    Home home;                                                          ///< as in Ray
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("kind", kind, ray_kind_bits);
        v("x", x, c.pixel_bits);
        v("y", y, c.pixel_bits);
        v("sample", sample, sample_bits);
        if (c.has_textures()) v("holes", holes, hole_bits);
        if (c.has_partial()) v("is_partial", is_partial, 1);
        if (c.has_self()) v("self", self, c.prim_bits);
        if (c.has_self()) v("is_inside", is_inside, 1);
        home.fields(v, c);
        v("o", o, c.origin_width(), 3);
        v("d", d, c.ray_dir_bits(), 3);
    }
};

/// A direction in the form of the sheared test (model/unit/tri/sheared.hpp). Payloads of the other tests do
/// not carry it.
struct Shear {
    std::uint32_t axis = 0;                ///< z: the axis of the largest |d|
    std::uint32_t neg = 0;                 ///< d_z < 0
    std::uint32_t size = 0;                ///< |d_z|, M bits: 2^(M-1) is possible
    std::array<std::int32_t, 2> slope{};   ///< d_x / d_z, d_y / d_z, with M - 2 fraction bits
    template <class V> void fields(V& v, const Config& c) {
        v("axis", axis, 2);
        v("neg", neg, 1);
        v("size", size, c.dir_bits);
        v("slope", slope, c.dir_bits, 2);
    }
};

/// raygen -> trav, list: a ray with its reciprocal direction.
///
/// For |d| of bit length len: m = |d| << (M - len), recip = floor(2^(M+R-1) / m). A zero component has len 0
/// and recip 1.
///
/// If the chip shades, o has B fraction bits, all zero except for a bounce. d has ray_dir_bits, which only a
/// shadow ray fills. len counts as if all directions were that long: it exceeds the bit length of |d| by
/// ray_dir_bits - M (but is 0 for d = 0).
struct Ray {
    std::uint32_t ray = 0;
    Vec3i o{};                              ///< origin, lattice point, N bits
    Vec3i d{};                              ///< direction, M bits
    std::array<std::uint32_t, 3> recip{};   ///< R + 1 bits
    std::array<std::uint32_t, 3> len{};     ///< 0..M
    Shear shear;                            ///< with the sheared test
    RayKind kind = RayKind::camera;
    std::uint32_t self = 0;        ///< the primitive that a bounce leaves, or at which a shadow ray ends
    std::uint32_t is_inside = 0;   ///< 1: on that sphere's inside
    /// 1: the ray meets only some primitives. A ray to or from a light meets those that have an end. A bounce
    /// meets planes, and begins beyond the lattice, at o 2^far_drop.
    std::uint32_t is_partial = 0;
    /// With textures, for a ray to or from a light: the number of cut-outs in its way that are known to have
    /// a hole there. The ray ignores this many cut-outs, the first ones in the order of the tests.
    std::uint32_t holes = 0;
    Home home;   ///< with instances, if this is not a camera ray
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.is_sheared()) shear.fields(v, c);
        if (c.shading) v("kind", kind, ray_kind_bits);
        if (c.has_textures()) v("holes", holes, hole_bits);
        if (c.has_partial()) v("is_partial", is_partial, 1);
        if (c.has_self()) v("self", self, c.prim_bits);
        if (c.has_self()) v("is_inside", is_inside, 1);
        home.fields(v, c);
        v("o", o, c.origin_width(), 3);
        v("d", d, c.ray_dir_bits(), 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
    }
};

/// A ray starts. It has no hit, and its distance to beat is t_max_of(kind). This event is separate from the
/// ray's transfer to trav, which could carry the same ray with a new direction.
struct Start {
    std::uint32_t ray = 0;
    RayKind kind = RayKind::camera;
    std::uint32_t holes = 0;   ///< as in Ray
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.shading) v("kind", kind, ray_kind_bits);
        if (c.has_textures()) v("holes", holes, hole_bits);
    }
};

/// node_cache -> xform: the ray, and the instance from memory.
struct XformReq {
    std::uint32_t ray = 0;
    Vec3i o{}, d{};
    Placement placement;
    RayKind kind = RayKind::camera;
    Home home{};
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.has_homes()) v("kind", kind, ray_kind_bits);
        home.fields(v, c);
        v("o", o, c.origin_width(), 3);
        v("d", d, c.ray_dir_bits(), 3);
        placement.fields(v, c);
    }
};

/// xform -> trav, list: the ray in the space of an instance's mesh. The ray changes but does not start: it
/// keeps its hit and its distance to beat. Next it visits the mesh's root.
struct Change {
    std::uint32_t ray = 0;
    std::uint32_t root = 0, first = 0, here = 0;   ///< as in Placement
    Vec3i o{}, d{};                                ///< in the mesh's space, as in Ray
    std::array<std::uint32_t, 3> recip{}, len{};   ///< of d
    RayKind kind = RayKind::camera;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.has_homes()) v("kind", kind, ray_kind_bits);
        v("first", first, c.prim_bits);
        v("root", root, c.addr_bits);
        if (c.has_homes()) v("here", here, c.addr_bits);
        v("o", o, c.origin_width(), 3);
        v("d", d, c.ray_dir_bits(), 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
    }
};

__extension__ using Int128 = __int128;

/// The closest hit so far, as tri compares it: t = num / det exactly (sheared: t |d_z|). For a sphere, num is
/// t rounded up and det is 2^(M-1+F).
struct Best {
    std::uint32_t found = 0;
    Int128 num = 0, det = 0;
    std::uint32_t prim = 0;
    template <class V> void fields(V& v, const Config& c) {
        v("found", found, 1);
        v("best_num", num, c.num_bits());
        v("best_det", det, c.edge_bits());
        v("best_prim", prim, c.prim_bits);
    }
};

/// list -> tri: ray, triangle and the hit to beat. The ray's fields that tri needs (tri_ray_t in rc_pkg.sv)
/// follow the context's number, as in Ray.
struct TriReq {
    std::uint32_t ray = 0;
    Vec3i o{}, d{};
    PrimData triangle;
    Best best;
    Shear shear{};   ///< replaces d in the sheared test
    RayKind kind = RayKind::camera;
    std::uint32_t self = 0, is_inside = 0, is_partial = 0;   ///< as in Ray
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.is_sheared()) shear.fields(v, c);
        if (c.shading) v("kind", kind, ray_kind_bits);
        if (c.has_partial()) v("is_partial", is_partial, 1);
        if (c.has_self()) v("self", self, c.prim_bits);
        if (c.has_self()) v("is_inside", is_inside, 1);
        v("o", o, c.origin_width(), 3);
        if (!c.is_sheared()) v("d", d, c.ray_dir_bits(), 3);
        triangle.fields(v, c);
        best.fields(v, c);
    }
};

/// tri -> list: 1 in `closer` if this primitive is the closest so far, with the hit; otherwise all zero. For
/// a ray to or from a light `closer` means that the primitive is in the way. The rest is then zero, except
/// for a cut-out.
struct TriRsp {
    std::uint32_t ray = 0;
    std::uint32_t closer = 0;
    Int128 num = 0, det = 0;   ///< as in Best; det > 0
    std::uint32_t prim = 0;
    std::uint32_t t = 0;   ///< ceil(2^(M-1+F) t), saturated
    /// floor(2^bary_bits u / det), the weight of b; v is the weight of c. 2^bary_bits is possible. For a
    /// plane: two's complement of uv_bits, saturated. For a sphere: 0.
    std::uint32_t u = 0, v = 0;
    /// If the chip shades: 1 if seen from inside, or from the side to which (b - a) x (c - a) does not point.
    std::uint32_t back = 0;
    std::uint32_t cutout = 0;   ///< with textures: 1 if a cut-out is in the way to or from a light
    template <class V> void fields(V& v_, const Config& c) {
        v_("ray", ray, c.ray_bits());
        v_("closer", closer, 1);
        if (c.has_textures()) v_("cutout", cutout, 1);
        if (c.shading) v_("back", back, 1);
        v_("num", num, c.num_bits());
        v_("det", det, c.edge_bits());
        v_("prim", prim, c.prim_bits);
        v_("t", t, c.t_bits());
        v_("u", u, c.uv_bits());
        v_("v", v, c.uv_bits());
    }
};

/// list -> trav: the leaves of a node are tested.
struct Tested {
    std::uint32_t ray = 0;
    std::uint32_t stop = 0;     ///< if the chip shades: the way to a light is blocked, so the ray ends
    std::uint32_t t_best = 0;   ///< the distance to beat
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.shading) v("stop", stop, 1);
        v("t_best", t_best, c.t_bits());
    }
};

/// trav -> list: the search for this ray is over; nothing closer exists.
struct Done {
    std::uint32_t ray = 0;
    template <class V> void fields(V& v, const Config& c) { v("ray", ray, c.ray_bits()); }
};

/// list -> sched or shade: the closest hit of a finished ray. For a ray to or from a light: 1 in `found` if
/// something is in its way, and zeros. If it is a cut-out, the other fields describe its hit.
struct Closest {
    std::uint32_t ray = 0;
    std::uint32_t found = 0;
    std::uint32_t prim = 0, t = 0, u = 0, v = 0;   ///< zero if not found
    std::uint32_t back = 0;                        ///< if the chip shades; as in TriRsp
    /// Field `place`, if the chip also has instances: line of the instance hit; 0 in a pixel.
    std::uint32_t instance_line = 0;
    std::uint32_t cutout = 0;   ///< with textures, as in TriRsp; 0 in a pixel
    template <class V> void fields(V& v_, const Config& c) {
        v_("ray", ray, c.ray_bits());
        if (c.has_homes()) v_("place", instance_line, c.addr_bits);
        if (c.has_textures()) v_("cutout", cutout, 1);
        v_("found", found, 1);
        if (c.shading) v_("back", back, 1);
        v_("prim", prim, c.prim_bits);
        v_("t", t, c.t_bits());
        v_("u", u, c.uv_bits());
        v_("v", v, c.uv_bits());
    }
};
/// True if the answers are equal except for context and instance, which are not part of a pixel.
inline bool same_answer(const Closest& a, const Closest& b) {
    return a.found == b.found && a.prim == b.prim && a.t == b.t && a.u == b.u && a.v == b.v &&
           a.back == b.back;
}

/// shade -> tex: the hit of a surface with a texture. If the surface is a cut-out in the way to a light, path
/// ends at the surface that the light falls on, and cosine is 1.
struct TexReq {
    std::uint32_t ray = 0;
    std::uint32_t record = 0;   ///< as in Surface
    /// Approximate length of the path from the eye to the hit: units of 2^-F lattice steps, saturated. 0
    /// selects level 0.
    std::uint32_t path = 0;
    std::uint32_t cosine = 0;   ///< between view and normal, 0..1, unit_bits fraction bits
    /// Of the hit, as in Closest. For a sphere: the place of the normal in the octahedral picture, see
    /// octahedral().
    std::uint32_t u = 0, v = 0;
    std::int32_t scale = 0;   ///< with two levels: Placement::texel_scale
    template <class V> void fields(V& v_, const Config& c) {
        v_("ray", ray, c.ray_bits());
        v_("record", record, c.addr_bits);
        if (c.has_homes()) v_("scale", scale, level_bits);
        v_("path", path, c.path_bits());
        v_("cosine", cosine, unit_bits + 1);
        v_("u", u, c.uv_bits());
        v_("v", v, c.uv_bits());
    }
};

/// tex -> shade: the texture's colour at the hit, linear.
struct TexRsp {
    std::uint32_t ray = 0;
    std::uint32_t hole = 0;                  ///< 1: alpha is below the cut-off, and the ray continues
    std::array<std::uint32_t, 3> colour{};   ///< 0..1, share_bits fraction bits
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("hole", hole, 1);
        v("colour", colour, share_bits + 1, 3);
    }
};

/// shade -> sched: a finished pixel, with the hit of its first camera ray and its colour.
struct Pixel {
    Closest first;
    std::array<std::uint32_t, 3> colour{};   ///< unit_bits fraction bits, 0..1
    template <class V> void fields(V& v, const Config& c) {
        first.fields(v, c);
        if (c.has_shade()) v("colour", colour, unit_bits + 1, 3);
    }
};

/// sched -> outside: the hit of the pixel's ray, and the pixel's colour if the chip shades.
struct HitOut {
    std::uint32_t x = 0, y = 0;
    Closest closest;
    std::array<std::uint32_t, 3> colour{};
    template <class V> void fields(V& v, const Config& c) {
        v("x", x, c.pixel_bits);
        v("y", y, c.pixel_bits);
        closest.fields(v, c);
        if (c.has_shade()) v("colour", colour, unit_bits + 1, 3);
    }
};

/// The answer to a ray of a stream, as the unit hits writes it into memory.
struct HitRecord {
    std::uint32_t valid = 0;   ///< 1 in a record; behind the last one, the rest of its line is 0
    HitOut hit;
    template <class V> void fields(V& v, const Config& c) {
        v("valid", valid, 1);
        hit.fields(v, c);
    }
};
/// Returns how many records a line of memory holds: four of 16 bytes if their fields fit, else two.
inline int hits_of_line(const Config& c) { return bits_of<HitRecord>(c) <= line_bits / 4 ? 4 : 2; }

}   // namespace rayclock
