#pragma once
// Configurations of shading chips, and random passes of the unit shade with every event and every kind of
// surface.
#include "model/scene/whitted.hpp"
#include "model/unit/shade/bounce/bounce.hpp"
#include "model/engine/check.hpp"
#include "model/unit/shade/pass/pass.hpp"
#include "model/fixed/unit_vector.hpp"
#include "tests/support/cases/chip_name.hpp"
#include "tests/support/cases/placement_cases.hpp"

namespace rayclock::test {

/// `every2:` makes a pass every two cycles, `levels:` has instances, `textured:` has textures.
inline constexpr FormatPrefix shaded_prefixes[] = {
    {"every", "248", [](Config& c, int cycles) { c.shade_interval = cycles; }},
    {"fast", "", [](Config& c, int) { make_fast(c); }},
    {"levels", "", [](Config& c, int) { c.levels = 2; }},
    {"textured", "", [](Config& c, int) { c.textures = 1; }},
};

/// `all` has every unit of default, `plain` only shading, `mirror` all but refraction. `narrow` and `broad`
/// are at the ends of the lattice. `short` has directions shorter than a unit vector's components.
inline Config shaded_base(const std::string& name) {
    check_base(name, {"all", "plain", "mirror", "narrow", "broad", "short"});
    Config c;
    c.name = name;
    c.shading = 1;
    if (name == "plain") return c;
    c.spheres = c.planes = c.smooth = c.refraction = c.supersampling = 1;
    c.lights = 3;
    if (name == "mirror") c.refraction = 0;
    if (name == "narrow")
        c.coord_bits = 12, c.dir_bits = 24, c.recip_bits = 15, c.origin_bits = 16, c.lights = 1,
        c.bounces = 15;
    if (name == "broad")
        c.coord_bits = 20, c.dir_bits = 22, c.recip_bits = 18, c.origin_bits = 10, c.bary_bits = 10,
        c.lights = 5;
    if (name == "short") c.coord_bits = 14, c.dir_bits = 14, c.origin_bits = 6;
    c.panes = !c.refraction ? 0 : name == "all" ? 2 : name == "broad" ? max_panes : 1;
    c.horizon = c.origin_bits >= far_drop && name != "narrow";
    return c;
}

/// Returns the configuration of a shading chip, with prefixes of `shaded_prefixes`. Throws
/// std::invalid_argument for a name that is unknown.
inline Config shaded_format(const std::string& name) {
    Config c = read_format(name, shaded_prefixes, shaded_base);
    c.name = name;
    check_config(c, name);
    return c;
}

inline std::uint32_t share_up_to(Draw& draw, int bits) {   // 0..2^bits
    return draw.percent(20) ? (draw.coin() ? 1u << bits : 0) : std::uint32_t(draw.natural(bits));
}
inline std::array<std::uint32_t, 3> shares_up_to(Draw& draw, int bits) {
    return {share_up_to(draw, bits), share_up_to(draw, bits), share_up_to(draw, bits)};
}

inline Vec3i draw_unit(Draw& draw) {
    Vec3l v{};
    for (auto& x : v) x = draw.number(draw.between(2, 40));
    return unit_vector(v);
}

/// Draws the sides of panes. Mostly none is crossed, so a light's sides often equal the path's.
inline std::uint32_t random_cell(Draw& draw, const Config& c) {
    return c.panes == 0 || draw.coin() ? 0 : std::uint32_t(draw.natural(c.panes));
}

inline Frame random_shade_frame(Draw& draw, const Config& c) {
    Frame frame;
    ShadeFrame& s = frame.shade;
    s.depth = std::uint32_t(draw.below(16));
    s.threshold = draw.coin() ? 0 : share_up_to(draw, unit_bits + 1) >> draw.below(18);
    if (draw.percent(30))
        // A threshold that no weight reaches after this many bounces.
        s.threshold = 3 * std::uint32_t(draw.between(1, 15));
    s.side = c.supersampling ? std::uint32_t(draw.between(1, 8)) : 1;
    s.contrast = draw.coin() ? 0 : share_up_to(draw, unit_bits);
    s.share = share_up_to(draw, unit_bits), s.first_share = share_up_to(draw, unit_bits);
    s.background = shares_up_to(draw, unit_bits);
    s.lights = std::uint32_t(draw.between(draw.percent(10) ? 0 : 1, c.lights));
    for (std::size_t i = 0; i < std::size_t(c.lights); ++i) {
        s.near[i] = draw.coin(), s.clear[i] = draw.percent(80);
        s.cell[i] = random_cell(draw, c);
        for (std::size_t k = 0; k < 3; ++k) {
            s.place[3 * i + k] = std::int32_t(draw.number(s.near[i] ? c.coord_bits : c.light_bits()));
            s.colour[3 * i + k] = std::uint32_t(draw.natural(strength_bits));
        }
    }
    return frame;
}

inline Vec3i draw_place(Draw& draw, const Config& c) {   // a point that o can represent
    Vec3i o{};
    for (auto& x : o)
        x = std::int32_t(
            std::max(draw.number(c.origin_width()), 1 - (std::int64_t(1) << (c.origin_width() - 1))));
    return o;
}

inline Surface random_surface(Draw& draw, const Config& c) {
    Surface s;
    s.kind = PrimKind(draw.below(3));
    if ((s.kind == PrimKind::plane && !c.planes) || (s.kind == PrimKind::sphere && !c.spheres))
        s.kind = PrimKind::triangle;
    s.a = draw.vector(c.coord_bits), s.b = draw.vector(c.coord_bits), s.c = draw.vector(c.coord_bits);
    // Lattice::snap leaves out the least coordinate.
    for (Vec3i* corner : {&s.a, &s.b, &s.c})
        for (auto& x : *corner) x = std::max(x, 1 - (1 << (c.coord_bits - 1)));
    if (s.kind == PrimKind::triangle) {   // edges of whole 2^fine steps
        s.fine = std::uint32_t(draw.below(std::clamp(c.bary_bits - c.origin_bits, 0, max_fine) + 1));
        const std::int32_t step = 1 << s.fine;
        for (Vec3i* corner : {&s.b, &s.c})
            for (std::size_t k = 0; k < 3; ++k) (*corner)[k] = s.a[k] + ((*corner)[k] - s.a[k]) / step * step;
    }
    s.smooth = c.smooth && s.kind == PrimKind::triangle && draw.coin();
    for (auto& x : s.normal) x = s.smooth ? std::max(std::int32_t(draw.number(corner_bits)), -1023) : 0;
    if (s.kind == PrimKind::plane) {
        for (std::size_t side = 0; side < 2; ++side)
            s.normal[side] = std::int32_t(draw.number(corner_bits)),
            s.normal[2 + side] = draw.between(-1, c.bary_bits + corner_bits - 1);
        s.normal[4] = draw.coin() && c.panes > 0 ? 1 << draw.below(c.panes) : 0;
    }
    s.checkered = draw.coin(), s.schlick = draw.coin();
    s.colour = shares_up_to(draw, share_bits), s.other = shares_up_to(draw, share_bits);
    for (auto* x : {&s.ambient, &s.diffuse, &s.highlight}) *x = share_up_to(draw, share_bits);
    for (auto* x : {&s.mirror, &s.transmit, &s.r0}) *x = share_up_to(draw, unit_bits);
    s.shine = std::uint32_t(draw.natural(shine_bits));
    s.enter = std::uint32_t(draw.natural(ratio_bits)), s.leave = std::uint32_t(draw.natural(ratio_bits));
    if (c.has_textures() && draw.coin())
        s.record = std::uint32_t(std::max<std::uint64_t>(draw.natural(c.addr_bits), 1));
    return s;
}

inline Closest random_closest(Draw& draw, const Config& c, const Surface& surface) {
    Closest hit;
    if (!(hit.found = draw.percent(75))) return hit;
    hit.back = draw.coin();
    hit.prim = std::uint32_t(draw.natural(c.prim_bits));
    hit.t = std::uint32_t(draw.natural(draw.between(1, c.t_bits())));
    if (surface.kind == PrimKind::plane) {
        const std::uint32_t mask = (1u << c.uv_bits()) - 1;
        hit.u = std::uint32_t(draw.number(draw.between(2, c.uv_bits()))) & mask,
        hit.v = std::uint32_t(draw.number(draw.between(2, c.uv_bits()))) & mask;
        if (draw.percent(30)) hit.t = (1u << c.t_bits()) - 1;   // too far away for t
    } else if (surface.kind == PrimKind::triangle) {
        const std::uint32_t one = 1u << c.bary_bits;
        hit.u = std::uint32_t(draw.percent(10) ? one : draw.natural(c.bary_bits));
        hit.v = std::min(std::uint32_t(draw.percent(20) ? one : draw.natural(c.bary_bits)), one - hit.u);
    }
    return hit;
}

/// Moves a point beyond the lattice so that the ray from it passes near a point of the lattice. The ray
/// starts now, or later towards a light beyond the lattice.
inline void aim_far(Draw& draw, const Frame& frame, const Config& c, ShadeState& s) {
    const Vec3i within = draw_place(draw, c);
    const bool is_light = s.next_event == ShadeEvent::light;
    const Vec3i d = s.next_event == ShadeEvent::refract ? refract(c, s).d : reflect(c, s).d;
    const int further = draw.between(1, 6);
    const std::int64_t most = (std::int64_t(1) << (c.point_width() - 1)) - 1,
                       steps = std::int64_t(draw.natural(approach_steps)) << c.approach_shift();
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t to_light =
            (std::int64_t(frame.shade.place[3 * s.light + k]) << c.origin_bits) - within[k];
        s.o[k] = std::clamp(within[k] - (is_light ? to_light >> further : d[k] * steps), -most, most);
    }
}

/// True for the events that may follow a light.
inline bool follows_light(ShadeEvent event) {
    return event != ShadeEvent::arrive && event != ShadeEvent::transform && event != ShadeEvent::texture;
}

/// Draws a state after a light, often one whose shadow ray has met a cut-out.
inline void draw_light_of_holes(Draw& draw, const Frame& frame, ShadeState& s) {
    const int lights = int(frame.shade.lights);
    if (lights == 0 || !follows_light(s.next_event) || draw.percent(40)) return;
    if (s.next_event == ShadeEvent::light) {
        if (lights == 1) return;
        s.light = std::uint32_t(draw.between(1, lights - 1));
    } else {
        s.light = std::uint32_t(lights);
    }
    s.pending = draw.coin() ? Pending::texture : Pending::answer;
    s.light_holes = std::uint32_t(draw.percent(40)   ? 0
                                  : draw.percent(30) ? max_holes
                                  : draw.percent(30) ? max_holes - 1
                                                     : int(draw.natural(hole_bits)));
}

inline ShadeState random_state(Draw& draw, const Frame& frame, const Config& c) {
    ShadeState s;
    s.next_event = ShadeEvent(draw.below(c.has_homes() ? 6 : 5));
    if (c.has_textures()) {
        if (draw.percent(15)) s.next_event = ShadeEvent::texture;
        s.path = std::uint32_t(draw.natural(draw.between(1, c.path_bits())));
        s.ambient = share_up_to(draw, share_bits);
        s.record = draw.coin() ? 0 : std::uint32_t(draw.natural(c.addr_bits));
        s.is_round = c.spheres && draw.coin();
        s.holes = std::uint32_t(draw.coin()        ? 0
                                : draw.percent(40) ? max_holes
                                : draw.percent(40) ? max_holes - 1
                                                   : int(draw.natural(hole_bits)));
    }
    // Rays continue only through triangles, whose points lie in the lattice.
    const bool is_textured = s.next_event == ShadeEvent::texture;
    if (s.next_event == ShadeEvent::light && frame.shade.lights == 0) s.next_event = ShadeEvent::arrive;
    if (s.next_event == ShadeEvent::refract && !c.refraction) s.next_event = ShadeEvent::reflect;
    s.pending = Pending(draw.below(3));
    s.x = std::uint32_t(draw.natural(c.pixel_bits)), s.y = std::uint32_t(draw.natural(c.pixel_bits));
    if (c.supersampling) {
        s.sample = std::uint32_t(draw.below(int(frame.shade.side * frame.shade.side)));
        if (draw.percent(25) && frame.shade.side > 1) s.sample = 3;
        for (std::size_t k = 0; k < 3; ++k) {
            s.sum[k] = s.sample << unit_bits;   // the maximum: all samples were white
            if (draw.below(4) != 0) s.sum[k] = std::uint32_t(draw.below(int(s.sum[k] + 1)));
            s.least[k] = share_up_to(draw, unit_bits), s.most[k] = share_up_to(draw, unit_bits);
        }
    }
    s.found = draw.coin(), s.prim = std::uint32_t(draw.natural(c.prim_bits)),
    s.t = std::uint32_t(draw.natural(c.t_bits()));
    s.u = std::uint32_t(draw.natural(c.uv_bits())), s.v = std::uint32_t(draw.natural(c.uv_bits()));
    s.colour = shares_up_to(draw, unit_bits), s.share = shares_up_to(draw, unit_bits);
    if (c.supersampling && draw.coin()) s.least = s.most = s.colour;   // samples that agree
    s.waiting = c.refraction && draw.coin() ? std::uint32_t(draw.between(1, c.bounces)) : 0;
    s.weight = share_up_to(draw, unit_bits);
    s.depth = std::uint32_t(draw.below(15));
    for (std::size_t k = 0; const std::int32_t x : draw_place(draw, c)) s.o[k++] = x;
    s.is_far = c.planes && !is_textured && draw.percent(30), s.is_lost = s.is_far && draw.percent(20);
    if (s.is_far)
        for (auto& x : s.o) x = draw.number(draw.between(c.origin_width(), c.point_width() - 1));
    for (auto& x : s.n) x = draw.percent(5) ? 0 : draw.number(c.normal_bits() - 1);
    if (draw.percent(5)) s.n = {};   // so that a direction lies in the plane
    s.normal = draw_unit(draw), s.view = draw_unit(draw);
    s.cosine = share_up_to(draw, unit_bits);
    s.self = std::uint32_t(draw.natural(c.prim_bits)), s.is_inside = draw.coin();
    s.albedo = shares_up_to(draw, share_bits);
    for (auto* x : {&s.diffuse, &s.highlight}) *x = share_up_to(draw, share_bits);
    for (auto* x : {&s.mirror, &s.transmit, &s.r0}) *x = share_up_to(draw, unit_bits);
    s.shine = std::uint32_t(draw.natural(draw.between(1, shine_bits)));
    s.ratio = std::uint32_t(draw.percent(70) ? draw.between(2000, 8000) : int(draw.natural(ratio_bits)));
    s.schlick = draw.coin();
    s.in_cell = random_cell(draw, c), s.across = random_cell(draw, c);
    const bool has_light = frame.shade.lights > 0 && !is_textured;   // before its lights, the number is 0
    s.light = has_light ? std::uint32_t(draw.below(int(frame.shade.lights))) : 0;
    s.total = c.refraction && draw.coin();
    if (c.has_textures()) draw_light_of_holes(draw, frame, s);
    if (s.is_far && draw.percent(70)) aim_far(draw, frame, c, s);
    if (c.has_homes()) {
        const Vec3i within = draw_place(draw, c);
        for (std::size_t k = 0; k < 3; ++k) s.inner[k] = s.is_far ? s.o[k] : within[k];
    }
    return s;
}

/// A plane or a sphere never belongs to a transformed instance.
inline Placement pass_placement(Draw& draw, const Config& c, const ShadeState& state) {
    Placement p = random_placement(draw, c);
    if (!state.is_far && !state.is_round && draw.percent(70)) return p;
    p.is_same = 1, p.a = {}, p.b = {};
    for (std::size_t k = 0; k < 3; ++k) p.a[4 * k] = 1 << c.map_frac();
    return p;
}

inline PassIn random_pass(Draw& draw, const Frame& frame, const Config& c) {
    PassIn in;
    in.ray = std::uint32_t(draw.bits(c.ray_bits()));
    in.state = random_state(draw, frame, c);
    in.surface = random_surface(draw, c);
    in.hit = random_closest(draw, c, in.surface);
    in.hit.ray = in.ray;
    if (c.has_textures() && follows_light(in.state.next_event) && draw.coin()) in.hit.cutout = in.hit.found;
    in.o = draw_place(draw, c);
    in.d = draw.vector(c.dir_bits);
    // With two levels raygen adds one to a component of -2^(M-1) (docs/machine/motion.md).
    if (c.has_homes())
        for (auto& x : in.d) x = std::max(x, 1 - (1 << (c.dir_bits - 1)));
    if (c.refraction) {
        in.top.o = draw_place(draw, c), in.top.d = draw.vector(c.dir_bits);
        in.top.weight = share_up_to(draw, unit_bits), in.top.depth = std::uint32_t(draw.below(16));
        in.top.self = std::uint32_t(draw.natural(c.prim_bits)), in.top.is_inside = draw.coin();
        in.top.in_cell = random_cell(draw, c), in.top.is_partial = c.horizon && draw.coin();
        if (c.has_textures()) in.top.path = std::uint32_t(draw.natural(c.path_bits()));
    }
    if (c.has_textures()) in.texel = shares_up_to(draw, share_bits), in.hole = draw.coin();
    if (c.has_homes()) {
        in.placement = pass_placement(draw, c, in.state);
        if (c.has_textures()) in.placement.texel_scale = std::int32_t(draw.number(level_bits));
        if (c.refraction)
            in.top.home = {std::uint32_t(draw.natural(c.addr_bits)), draw_place(draw, c),
                           draw.vector(c.dir_bits)};
    }
    return in;
}

/// Returns the same pass, but without a cut-out in the way to the last light.
inline PassIn without_cutout(PassIn in) {
    if (in.state.pending == Pending::texture) in.state.pending = Pending::none;
    in.hit.cutout = 0;
    return in;
}

}   // namespace rayclock::test
