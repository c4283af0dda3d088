// One pass of the unit shade: arrivals, lights, bounces and the end of a sample.
#include "model/unit/shade/pass/pass.hpp"

#include <algorithm>
#include <optional>

#include "model/scene/whitted.hpp"
#include "model/unit/shade/light/approach.hpp"
#include "model/unit/shade/bounce/bounce.hpp"
#include "model/fixed/rounding.hpp"
#include "model/unit/shade/light/light.hpp"
#include "model/unit/shade/surface/surf.hpp"

namespace rayclock {

namespace {

constexpr std::uint32_t full_weight = 1 << unit_bits;
using Colour = std::array<std::uint32_t, 3>;

void add(Colour& colour, const Colour& more) {
    for (std::size_t k = 0; k < 3; ++k) colour[k] = std::min(colour[k] + more[k], full_weight);
}

/// True if the threshold lets a ray pass that is its camera ray's `bounce`th. Rounding of shares and weights
/// lowers a weight by less than 3/2 units of 2^-16 per bounce (docs/machine/shading.md, Numbers). The test
/// allows for this error, so a ray always passes if its exact weight is not below the exact threshold.
bool weighs_enough(std::uint32_t weight, std::uint32_t bounce, const Frame& frame) {
    return 2 * weight + 3 * bounce >= frame.shade.threshold;
}

ShadeEvent after_lights(const ShadeState& s, const Frame& frame, const Config& c) {
    if (s.depth >= frame.shade.depth) return ShadeEvent::pop;
    if (c.refraction && s.transmit > 0) return ShadeEvent::refract;
    return s.mirror > 0 ? ShadeEvent::reflect : ShadeEvent::pop;
}

/// Sets the event after a surface or a light: light number `light`, or the event after the last light.
void next_light(ShadeState& s, std::uint32_t light, const Frame& frame, const Config& c) {
    s.light = light;
    s.next_event = light < frame.shade.lights ? ShadeEvent::light : after_lights(s, frame, c);
}

Spawn spawn_of(const PassIn& in, const ShadeState& s, RayKind kind) {
    Spawn spawn;
    spawn.ray = in.ray;
    spawn.kind = kind;
    spawn.x = s.x, spawn.y = s.y, spawn.sample = s.sample;
    return spawn;
}

/// Adds the background for a ray of this weight that meets nothing, or is not traced because it misses the
/// lattice.
void see_background(ShadeState& s, std::uint32_t weight, const Frame& frame) {
    Colour background{};
    for (std::size_t k = 0; k < 3; ++k)
        background[k] = std::uint32_t(rounded(std::uint64_t(weight) * frame.shade.background[k], unit_bits));
    add(s.colour, background);
}

/// Returns the plane's bit in a cell if it is a pane.
std::uint32_t pane_of(const Surface& surface, const Config& c) {
    if (surface.kind != PrimKind::plane) return 0;
    return std::uint32_t(surface.normal[4]) & ((1u << c.panes) - 1);
}

/// Sends the hit to tex. The texture event handles the answer.
void request_texture(const PassIn& in, const Config& c, PassOut& out) {
    ShadeState& s = out.state;
    s.next_event = ShadeEvent::texture;
    out.leave = PassOut::Leave::texture;
    out.tex = {in.ray, s.record, s.path, s.cosine, in.hit.u, in.hit.v, in.placement.texel_scale};
    if (s.is_round) {
        const auto [u, v] = octahedral(s, c);
        out.tex.u = u, out.tex.v = v;
    }
}

void arrive(const PassIn& in, const Frame& frame, const Config& c, PassOut& out) {
    ShadeState& s = out.state;
    if (s.depth == 0 && s.sample == 0 && s.holes == 0) {
        s.found = in.hit.found, s.prim = in.hit.prim, s.t = in.hit.t, s.u = in.hit.u, s.v = in.hit.v;
    }
    if (in.hit.found) {
        add(s.colour, surf(in, c, s));
        s.across = s.in_cell ^ pane_of(in.surface, c);
        next_light(s, 0, frame, c);
        if (c.has_homes())
            s.next_event = ShadeEvent::transform;
        else if (s.record != 0)
            request_texture(in, c, out);
        return;
    }
    see_background(s, s.weight, frame);
    s.next_event = ShadeEvent::pop;
}

/// Returns the origin of a ray from the surface; empty if the ray misses the lattice.
std::optional<Vec3i> start_of(const ShadeState& s, const Vec3i& d, const Config& c) {
    if (s.is_lost) return std::nullopt;
    if (s.is_far) return approach(s.o, d, c);
    return Vec3i{std::int32_t(s.o[0]), std::int32_t(s.o[1]), std::int32_t(s.o[2])};
}

/// The origin of a bounce. A bounce that misses the lattice may still meet a plane. It then begins at the
/// point itself, without its last far_drop bits, on the side to which it leaves.
struct Origin {
    Vec3i o{};
    bool is_far = false;
};
std::optional<Origin> bounce_start(const ShadeState& s, const Vec3i& d, bool through, const Config& c) {
    if (const std::optional<Vec3i> start = start_of(s, d, c)) return Origin{*start, false};
    if (!c.horizon || s.is_lost) return std::nullopt;
    Origin far{{}, true};
    for (std::size_t k = 0; k < 3; ++k)
        far.o[k] = std::int32_t((s.o[k] >> far_drop) + ((s.n[k] < 0) == through));
    return far;
}

Vec3i light_place(const Frame& frame, std::uint32_t light, const Config& c) {
    Vec3i place{};
    for (std::size_t k = 0; k < 3; ++k) place[k] = frame.shade.place[3 * light + k] * (1 << c.origin_bits);
    return place;
}

/// Sends a ray that tests a light. From a light within the lattice to a point in the lattice it is a shadow
/// ray, and exact (docs/proofs/origins.md). To or from a place beyond the lattice it is a ray without end,
/// clipped to the lattice, which contains all finite primitives. That ray tests planes only if a plane lies
/// between the light and the path. Otherwise no plane hides the light.
void send_shadow(const PassIn& in, const Frame& frame, const Config& c, PassOut& out) {
    ShadeState& s = out.state;
    const LightOut found = light(frame, c, s, in.placement);
    out.light = found.parts;
    const std::uint32_t index = s.light;
    next_light(s, index + 1, frame, c);
    const bool near = frame.shade.near[index] != 0,
               clear = frame.shade.clear[index] != 0 && frame.shade.cell[index] == s.in_cell;
    if (!found.counts || (s.is_far && !clear)) return;
    std::optional<Vec3i> start;
    if (!near)
        start = start_of(s, found.d, c);
    else if (!s.is_lost)
        start = light_place(frame, index, c);
    if (!start) {
        s.pending = Pending::sure;
        return;
    }
    s.pending = Pending::answer;
    out.leave = PassOut::Leave::spawn;
    const bool to_the_point = near && !s.is_far;
    out.spawn = spawn_of(in, s, to_the_point ? RayKind::shadow : RayKind::away);
    out.spawn.self = s.self, out.spawn.is_inside = s.is_inside;
    out.spawn.holes = s.light_holes;
    out.spawn.is_partial = c.planes && !to_the_point && clear;
    out.spawn.o = *start;
    out.spawn.d = found.d;
    out.spawn.home = found.home;
}

void send_bounce(const PassIn& in, const Waiting& ray, PassOut& out) {
    ShadeState& s = out.state;
    s.weight = ray.weight, s.depth = ray.depth, s.in_cell = ray.in_cell, s.path = ray.path;
    s.holes = 0;
    s.next_event = ShadeEvent::arrive;
    out.leave = PassOut::Leave::spawn;
    out.spawn = spawn_of(in, s, RayKind::bounce);
    out.spawn.o = ray.o, out.spawn.d = ray.d;
    out.spawn.self = ray.self, out.spawn.is_inside = ray.is_inside, out.spawn.is_partial = ray.is_partial;
    out.spawn.home = ray.home;
}

Waiting bounced(const ShadeState& s, const Origin& start, const BounceOut& found, bool through) {
    return {start.o,
            found.d,
            found.weight,
            s.depth + 1,
            s.self,
            s.is_inside ^ std::uint32_t(through),
            through ? s.across : s.in_cell,
            start.is_far,
            s.path,
            found.home};
}

/// A reflected ray from a sphere's outside stays outside, and a refracted one enters. From inside it is the
/// other way round.
void send_refracted(const PassIn& in, const Frame& frame, const Config& c, PassOut& out) {
    ShadeState& s = out.state;
    const BounceOut found = refract(c, s, in.placement);
    s.total = found.total;
    s.next_event = ShadeEvent::reflect;
    if (!weighs_enough(found.weight, s.depth + 1, frame)) return;
    out.refracted = true;
    if (!found.goes) return;
    const std::optional<Origin> start = bounce_start(s, found.d, true, c);
    out.passes_by = !start;
    if (!start) return see_background(s, found.weight, frame);
    out.push = true;
    out.pushed = bounced(s, *start, found, true);
    ++s.waiting;
}

void send_reflected(const PassIn& in, const Frame& frame, const Config& c, PassOut& out) {
    ShadeState& s = out.state;
    const BounceOut found = reflect(c, s, in.placement);
    s.next_event = ShadeEvent::pop;
    if (!weighs_enough(found.weight, s.depth + 1, frame) || !found.goes) return;
    const std::optional<Origin> start = bounce_start(s, found.d, false, c);
    out.passes_by = !start;
    if (!start) return see_background(s, found.weight, frame);
    send_bounce(in, bounced(s, *start, found, false), out);
}

/// Handles a texture's colour. If the texture has a hole, the ray continues from the hit point in the same
/// direction (docs/proofs/origins.md, Holes).
void show_texture(const PassIn& in, const Frame& frame, const Config& c, PassOut& out) {
    ShadeState& s = out.state;
    const Colour ambient = apply_texture(in.texel, s);
    static_assert(max_holes == (1 << hole_bits) - 1);
    if (!in.hole || s.holes == max_holes) {
        add(s.colour, ambient);
        return next_light(s, 0, frame, c);
    }
    ++s.holes;
    s.next_event = ShadeEvent::arrive;
    out.refracted = true;
    out.leave = PassOut::Leave::spawn;
    out.spawn = spawn_of(in, s, RayKind::bounce);
    for (std::size_t k = 0; k < 3; ++k) out.spawn.o[k] = std::int32_t(s.o[k]);
    out.spawn.d = in.d;
    out.spawn.self = s.self, out.spawn.is_inside = s.is_inside;
    if (c.has_homes()) out.spawn.home = home_of(s, in.d, in.placement, c);
}

/// Handles a shadow ray that has met a cut-out: requests the cut-out's texture at the level for the
/// path to the surface (docs/machine/shading.md, Light through holes). With two levels an instance's own
/// material replaces the mesh's. It has no texture, so the cut-out has no holes.
void request_cutout(const PassIn& in, PassOut& out) {
    const std::uint32_t record = in.surface.record;
    if (record == 0) return;
    out.state.pending = Pending::texture;
    out.leave = PassOut::Leave::texture;
    out.tex = {in.ray, record, in.state.path, full_weight, in.hit.u, in.hit.v, in.placement.texel_scale};
}

/// Finishes a sample, and starts the next one or ends the pixel.
void finish(const PassIn& in, const Frame& frame, const Config& c, PassOut& out) {
    ShadeState& s = out.state;
    bool same = frame.shade.contrast > 0;
    for (std::size_t k = 0; k < 3; ++k) {
        s.sum[k] += s.colour[k];
        s.least[k] = std::min(s.least[k], s.colour[k]);
        s.most[k] = std::max(s.most[k], s.colour[k]);
        same = same && s.most[k] - s.least[k] <= frame.shade.contrast;
    }
    const std::uint32_t done = s.sample + 1, all = frame.shade.side * frame.shade.side;
    const bool first = done == std::min(first_samples, all) && same;
    if (c.supersampling && done < all && !first) {
        s.sample = done;
        s.colour = {};
        s.weight = full_weight, s.depth = 0, s.in_cell = 0, s.path = 0, s.holes = 0;
        s.next_event = ShadeEvent::arrive;
        out.leave = PassOut::Leave::spawn;
        out.spawn = spawn_of(in, s, RayKind::camera);
        return;
    }
    out.leave = PassOut::Leave::pixel;
    out.pixel.first = {in.ray, s.found, s.prim, s.t, s.u, s.v, 0};
    const std::uint32_t share = done < all ? frame.shade.first_share : frame.shade.share;
    for (std::size_t k = 0; k < 3; ++k)
        out.pixel.colour[k] = c.supersampling
                                  ? std::uint32_t(std::min<std::uint64_t>(
                                        rounded(std::uint64_t(s.sum[k]) * share, unit_bits), full_weight))
                                  : s.colour[k];
}

}   // namespace

bool passes_hole(const PassIn& in) {
    return in.state.pending == Pending::texture && in.hole && in.state.light_holes < max_holes;
}

ShadeEvent event_of(const PassIn& in) { return passes_hole(in) ? ShadeEvent::light : in.state.next_event; }

ShadeState fresh_state(std::uint32_t x, std::uint32_t y) {
    ShadeState s;
    s.x = x, s.y = y;
    s.least = {full_weight, full_weight, full_weight};
    s.weight = full_weight;
    return s;
}

PassOut pass(const PassIn& in, const Frame& frame, const Config& c) {
    PassOut out;
    out.state = in.state;
    ShadeState& s = out.state;
    const Pending pending = s.pending;
    if (pending == Pending::sure || (pending == Pending::answer && !in.hit.found)) add(s.colour, s.share);
    s.pending = Pending::none;
    if (meets_cutout(in)) {
        request_cutout(in, out);
        return out;
    }
    s.light_holes = passes_hole(in) ? s.light_holes + 1 : 0;
    s.light -= passes_hole(in);
    switch (event_of(in)) {
        case ShadeEvent::arrive: arrive(in, frame, c, out); break;
        case ShadeEvent::light: send_shadow(in, frame, c, out); break;
        case ShadeEvent::refract: send_refracted(in, frame, c, out); break;
        case ShadeEvent::reflect: send_reflected(in, frame, c, out); break;
        case ShadeEvent::transform:
            transform_surface(in, c, s);
            next_light(s, 0, frame, c);
            if (s.record != 0) request_texture(in, c, out);
            break;
        case ShadeEvent::texture: show_texture(in, frame, c, out); break;
        case ShadeEvent::pop:
            if (s.waiting > 0) {
                --s.waiting;
                send_bounce(in, in.top, out);
            } else {
                finish(in, frame, c, out);
            }
    }
    return out;
}

}   // namespace rayclock
