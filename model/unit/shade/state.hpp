#pragma once
// The state that the unit shade keeps of a context between two passes, and the inputs and outputs of a pass.
#include "model/core/payloads.hpp"

namespace rayclock {

/// The event that a context's next pass handles.
enum class ShadeEvent : std::uint32_t {
    arrive,   ///< a camera ray or bounce is done: its surface, or the background
    light,    ///< the next light
    refract,
    reflect,
    pop,         ///< the next waiting ray, or the sample's end
    transform,   ///< with two levels, after arrive: maps the surface from the mesh's space to the scene's
    texture,     ///< after these, on a textured surface: its colour has arrived
};
constexpr int shade_event_bits = 3;

/// When the next pass adds the contribution of a light at its beginning.
enum class Pending : std::uint32_t {
    none,
    answer,   ///< if the shadow ray met nothing
    sure,
    texture   ///< not at all: the texture of a cut-out decides whether the shadow ray is sent again
};
constexpr int pending_bits = 2;

/// The state of a context. Fractions have unit_bits bits unless stated otherwise.
struct ShadeState {
    ShadeEvent next_event = ShadeEvent::arrive;
    Pending pending = Pending::none;
    // The pixel.
    std::uint32_t x = 0, y = 0, sample = 0;
    std::array<std::uint32_t, 3> sum{}, least{}, most{};      ///< of the finished samples' colours
    std::uint32_t found = 0, prim = 0, t = 0, u = 0, v = 0;   ///< hit of the first sample's camera ray
    // The sample.
    std::array<std::uint32_t, 3> colour{};   ///< so far, 0..1: saturated
    std::uint32_t waiting = 0;               ///< rays on the context's stack
    // The ray in flight, or the last one.
    std::uint32_t weight = 0, depth = 0;
    std::uint32_t in_cell = 0;   ///< a bit for each pane, set if it lies between the ray and the eye
    std::uint32_t across = 0;    ///< the cell on the other side of the surface that was hit
    std::uint32_t path = 0;      ///< with textures: length of the path so far, as in TexReq
    std::uint32_t holes = 0;     ///< with textures: number that the ray has passed; at most max_holes
    // The surface that was hit.
    Vec3l o{};       ///< B fraction bits: a point exactly on it (nearly on it for a sphere or an instance)
    Vec3l inner{};   ///< with two levels: a point exactly on it in the mesh's space, B fraction bits
    /// Normal to the side seen, not unit, 2N + 3 bits; its sign decides. With two levels it is in the mesh's
    /// space.
    Vec3l n{};
    std::array<std::int32_t, 3> normal{}, view{};   ///< unit vectors
    std::uint32_t cosine = 0;                       ///< normal . view, at least 0
    std::uint32_t is_far = 0;                       ///< o lies on a plane and beyond the lattice
    std::uint32_t is_lost = 0;   ///< o cannot represent the point: no ray from there is traced
    std::uint32_t self = 0, is_inside = 0;
    std::array<std::uint32_t, 3> albedo{};   ///< from here on as in Surface
    std::uint32_t diffuse = 0, highlight = 0, mirror = 0, transmit = 0, shine = 0, ratio = 0, schlick = 0,
                  r0 = 0;
    std::uint32_t ambient = 0, record = 0;   ///< with textures
    std::uint32_t is_round = 0;              ///< with textures and spheres: the surface is a sphere
    // The light.
    std::uint32_t light = 0;
    std::array<std::uint32_t, 3> share{};   ///< its contribution if it is not blocked
    /// With textures: number of holes that the light has passed on its way, at most max_holes.
    std::uint32_t light_holes = 0;
    std::uint32_t total = 0;   ///< the refracted ray was totally reflected
    friend bool operator==(const ShadeState&, const ShadeState&) = default;
    /// Fields are in the groups that a chip stores and writes separately
    /// (rtl/unit/shade/pass/rc_contexts.sv): the pixel; the fields that every pass changes; the position and
    /// view of the hit; its sides and colours; a light's share. Optional groups follow: several samples;
    /// refraction; the material, also for refraction and for spheres.
    template <class V> void fields(V& v_, const Config& c) {
        v_("x", x, c.pixel_bits);
        v_("y", y, c.pixel_bits);
        v_("next_event", next_event, shade_event_bits);
        v_("pending", pending, pending_bits);
        v_("found", found, 1);
        v_("prim", prim, c.prim_bits);
        v_("t", t, c.t_bits());
        v_("u", u, c.uv_bits());
        v_("v", v, c.uv_bits());
        v_("colour", colour, unit_bits + 1, 3);
        v_("weight", weight, unit_bits + 1);
        v_("depth", depth, depth_bits);
        v_("light", light, light_number_bits);
        if (c.panes > 0) {
            v_("in_cell", in_cell, c.panes);
            v_("across", across, c.panes);
        }
        if (c.has_textures()) {
            v_("path", path, c.path_bits());
            v_("holes", holes, hole_bits);
            v_("light_holes", light_holes, hole_bits);
        }
        v_("o", o, c.point_width(), 3);
        v_("normal", normal, unit_bits + 2, 3);
        v_("view", view, unit_bits + 2, 3);
        v_("cosine", cosine, unit_bits + 1);
        if (c.has_homes()) v_("inner", inner, c.origin_width(), 3);
        v_("n", n, c.normal_bits(), 3);
        v_("is_far", is_far, 1);
        v_("is_lost", is_lost, 1);
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
        if (c.has_textures()) {
            v_("ambient", ambient, share_bits + 1);
            v_("record", record, c.addr_bits);
            if (c.spheres) v_("is_round", is_round, 1);
        }
        v_("transmit", transmit, unit_bits + 1);
        v_("ratio", ratio, ratio_bits);
        v_("schlick", schlick, 1);
        v_("r0", r0, unit_bits + 1);
        v_("self", self, c.prim_bits);
        v_("is_inside", is_inside, 1);
    }
};

/// The groups of a context's state that a pass has changed. A chip writes only these, and the group that
/// every pass changes.
struct ShadeChanges {
    std::uint32_t point = 0, inner = 0, face = 0, albedo = 0, share = 0;
    template <class V> void fields(V& v, const Config&) {
        v("point", point, 1);
        v("inner", inner, 1);
        v("face", face, 1);
        v("albedo", albedo, 1);
        v("share", share, 1);
    }
};

/// A refracted ray that waits until the reflected ray's tree is done.
struct Waiting {
    Vec3i o{}, d{};   ///< B fraction bits; M bits
    std::uint32_t weight = 0, depth = 0, self = 0, is_inside = 0;
    std::uint32_t in_cell = 0, is_partial = 0;   ///< as in ShadeState and Ray
    std::uint32_t path = 0;                      ///< as in ShadeState
    Home home;                                   ///< its d has M bits here
    template <class V> void fields(V& v, const Config& c) {
        v("o", o, c.origin_width(), 3);
        v("d", d, c.dir_bits, 3);
        v("weight", weight, unit_bits + 1);
        v("depth", depth, depth_bits);
        v("self", self, c.prim_bits);   // of spheres only
        v("is_inside", is_inside, 1);
        if (c.panes > 0) v("in_cell", in_cell, c.panes);
        if (c.horizon) v("is_partial", is_partial, 1);
        if (c.has_textures()) v("path", path, c.path_bits());
        if (!c.has_homes()) return;
        v("home", home.line, c.addr_bits);
        v("home_o", home.o, c.origin_width(), 3);
        v("home_d", home.d, c.dir_bits, 3);
    }
    friend bool operator==(const Waiting&, const Waiting&) = default;
};

/// Returns a context's first state, with a pixel's first camera ray in flight.
ShadeState fresh_state(std::uint32_t x, std::uint32_t y);

struct PassIn {
    std::uint32_t ray = 0;
    ShadeState state;
    Closest hit;       ///< the last ray's answer
    Vec3i o{}, d{};    ///< of the last camera ray or bounce
    Surface surface;   ///< of an arrive event with a hit; if meets_cutout(): of the cut-out
    Waiting top;       ///< of a pop event: the stack's top
    std::array<std::uint32_t, 3> texel{};   ///< of a texture event: TexRsp::colour
    std::uint32_t hole = 0;                 ///< of a texture event: as in TexRsp
    /// With two levels: the instance that was hit last. Only `here`, a, b and texel_scale are used. After a
    /// cut-out has been met, texel_scale is the scale of the cut-out's instance.
    Placement placement{};
};
/// True if a shadow ray has met a cut-out. The pass requests its texture and handles no event.
inline bool meets_cutout(const PassIn& in) {
    return in.state.pending == Pending::answer && in.hit.found && in.hit.cutout;
}
/// Intermediate values of a light's pass, for judges.
struct LightParts {
    Vec3i unit{};               ///< towards the light
    std::uint32_t cosine = 0;   ///< normal . unit, at least 0
    std::uint32_t phong = 0;
};
struct PassOut {
    enum class Leave : std::uint32_t { again, spawn, pixel, texture } leave = Leave::again;
    ShadeState state;
    Spawn spawn;
    Pixel pixel;
    TexReq tex;
    bool push = false;   ///< push `pushed` on the stack; a pop event that spawns removes the top
    Waiting pushed;
    LightParts light;         ///< of a light event
    bool refracted = false;   ///< a refracted ray was called for, even if totally reflected; for counting
    bool passes_by = false;   ///< a bounce misses the lattice and takes the background; for judges
};

}   // namespace rayclock
