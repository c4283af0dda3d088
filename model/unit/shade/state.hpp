#pragma once
// What the unit shade keeps of a context between two passes, and what a pass takes and gives.
#include "model/core/payloads.hpp"

namespace rayclock {

/// What a context's next pass is for.
enum class ShadeEvent : std::uint32_t {
    arrive,   ///< a camera ray or bounce is done: its surface, or the background
    light,    ///< the next light
    refract,
    reflect,
    pop,    ///< the next ray that waits, or the sample's end
    turn,   ///< with two levels, after arrive: what was found in the mesh's space is turned into the scene's
};

/// Whether the contribution of a light is added at the beginning of the next pass.
enum class Pending : std::uint32_t { none, answer /**< if the shadow ray met nothing */, sure };

/// unit_bits of fraction unless said otherwise.
struct ShadeState {
    std::uint32_t event = 0, pending = 0;
    // The pixel.
    std::uint32_t x = 0, y = 0, sample = 0;
    std::array<std::uint32_t, 3> sum{}, least{}, most{};      ///< of the finished samples' colours
    std::uint32_t found = 0, prim = 0, t = 0, u = 0, v = 0;   ///< what the first sample's camera ray hit
    // The sample.
    std::array<std::uint32_t, 3> colour{};   ///< so far, 0..1: saturated
    std::uint32_t waiting = 0;               ///< rays on the context's stack
    // The ray under way, or the last one.
    std::uint32_t weight = 0, depth = 0;
    std::uint32_t cell = 0;     ///< a bit for each pane: it lies between the ray and the eye
    std::uint32_t across = 0;   ///< the cell on the other side of the surface that it hit
    // The surface that it hit.
    Vec3l o{};       ///< B fraction bits: a point exactly on it (a sphere's, an instance's: nearly)
    Vec3l inner{};   ///< with two levels: likewise, exactly on it in the mesh's space
    Vec3l n{};       ///< normal to the side seen, not unit, 2N + 3 bits; its sign decides. With two levels in
                     ///< the mesh's space
    std::array<std::int32_t, 3> normal{}, view{};   ///< unit vectors
    std::uint32_t cosine = 0;                       ///< normal . view, at least 0
    std::uint32_t far = 0;                          ///< o lies on a plane and beyond the lattice
    std::uint32_t lost = 0;   ///< and further than o can say: no ray from there is traced
    std::uint32_t self = 0, inside = 0;
    std::array<std::uint32_t, 3> albedo{};   ///< from here on as in Surface
    std::uint32_t diffuse = 0, highlight = 0, mirror = 0, transmit = 0, shine = 0, ratio = 0, schlick = 0,
                  r0 = 0;
    // The light.
    std::uint32_t light = 0;
    std::array<std::uint32_t, 3> share{};   ///< what it adds if nothing is in its way
    std::uint32_t total = 0;                ///< the refracted ray was totally reflected
    friend bool operator==(const ShadeState&, const ShadeState&) = default;
    /// In the groups that a chip keeps and writes apart (rtl/unit/shade/rc_contexts.sv): the pixel; what
    /// every pass changes; where a surface was hit and is seen; its sides and colours; a light's share; then
    /// what only some chips need: of several samples, of refraction; the material, also for refraction and
    /// for spheres.
    template <class V> void fields(V& v_, const Config& c) {
        v_("x", x, c.pixel_bits);
        v_("y", y, c.pixel_bits);
        v_("purpose", event, 3);
        v_("pending", pending, 2);
        v_("found", found, 1);
        v_("prim", prim, c.prim_bits);
        v_("t", t, c.t_bits());
        v_("u", u, c.uv_bits());
        v_("v", v, c.uv_bits());
        v_("colour", colour, unit_bits + 1, 3);
        v_("weight", weight, unit_bits + 1);
        v_("depth", depth, depth_bits);
        v_("light", light, 7);
        if (c.panes > 0) {
            v_("in_cell", cell, c.panes);
            v_("across", across, c.panes);
        }
        v_("o", o, c.point_width(), 3);
        v_("normal", normal, unit_bits + 2, 3);
        v_("view", view, unit_bits + 2, 3);
        v_("cosine", cosine, unit_bits + 1);
        if (c.has_homes()) v_("inner", inner, c.origin_width(), 3);
        v_("n", n, c.normal_bits(), 3);
        v_("is_far", far, 1);
        v_("is_lost", lost, 1);
        v_("albedo", albedo, share_bits + 1, 3);
        v_("share", share, unit_bits + 1, 3);
        v_("sample", sample, sample_bits);
        v_("sum", sum, unit_bits + 1 + sample_bits, 3);
        v_("least", least, unit_bits + 1, 3);
        v_("most", most, unit_bits + 1, 3);
        v_("waiting", waiting, depth_bits);
        v_("total", total, 1);
        v_("diffuse", diffuse, share_bits + 1);
        v_("highlight", highlight, share_bits + 1);
        v_("mirror", mirror, unit_bits + 1);
        v_("shine", shine, shine_bits);
        v_("transmit", transmit, unit_bits + 1);
        v_("ratio", ratio, ratio_bits);
        v_("schlick", schlick, 1);
        v_("r0", r0, unit_bits + 1);
        v_("self", self, c.prim_bits);
        v_("is_inside", inside, 1);
    }
    /// Of the material, from diffuse on.
    static int look_bits(const Config& c) {
        return 2 * (share_bits + 1) + 3 * (unit_bits + 1) + shine_bits + ratio_bits + 1 + c.prim_bits + 1;
    }
};

/// A refracted ray that waits until the reflected one's tree is done.
struct Waiting {
    Vec3i o{}, d{};   ///< B fraction bits; M bits
    std::uint32_t weight = 0, depth = 0, self = 0, inside = 0;
    std::uint32_t cell = 0, partial = 0;   ///< as in ShadeState and Ray
    Home home;                             ///< its d has M bits here
    template <class V> void fields(V& v, const Config& c) {
        v("o", o, c.origin_width(), 3);
        v("d", d, c.dir_bits, 3);
        v("weight", weight, unit_bits + 1);
        v("depth", depth, depth_bits);
        v("self", self, c.prim_bits);   // of spheres only
        v("is_inside", inside, 1);
        if (c.panes > 0) v("in_cell", cell, c.panes);
        if (c.horizon) v("is_partial", partial, 1);
        if (!c.has_homes()) return;
        v("home", home.line, c.addr_bits);
        v("home_o", home.o, c.origin_width(), 3);
        v("home_d", home.d, c.dir_bits, 3);
    }
    friend bool operator==(const Waiting&, const Waiting&) = default;
};

/// A context's first state: a pixel's first camera ray is under way.
ShadeState fresh_state(std::uint32_t x, std::uint32_t y);

struct PassIn {
    std::uint32_t ray = 0;
    ShadeState state;
    Closest hit;       ///< the last ray's answer
    Vec3i o{}, d{};    ///< of the last camera ray or bounce
    Surface surface;   ///< of an arrive event that found something
    Waiting top;       ///< of a pop event, the stack's top
    /// With two levels: the instance that was hit last. Of it `here`, a and b count.
    Placement placement{};
};
/// What a light's pass works out on the way to its contribution; for whoever judges it.
struct LightParts {
    Vec3i unit{};               ///< towards the light
    std::uint32_t cosine = 0;   ///< normal . unit, at least 0
    std::uint32_t phong = 0;
};
struct PassOut {
    enum class Leave : std::uint32_t { again, spawn, pixel } leave = Leave::again;
    ShadeState state;
    Spawn spawn;
    Pixel pixel;
    bool push = false;   ///< `pushed` goes on the stack; a pop event that spawns takes the top off
    Waiting pushed;
    LightParts light;         ///< of a light event
    bool refracted = false;   ///< a refracted ray was called for, if only to be totally reflected: for
                              ///< counting
    bool passes_by = false;   ///< a bounce passes by the lattice and takes the background; for whoever judges
                              ///< it
};

}   // namespace rayclock
