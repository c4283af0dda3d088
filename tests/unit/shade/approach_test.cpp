// Rays that start on a plane beyond the lattice: where they enter it, and which of them are sent.
#include <cmath>

#include <catch2/catch.hpp>

#include "model/unit/tri/any_primitive.hpp"
#include "model/unit/shade/light/approach.hpp"
#include "model/fixed/rounding.hpp"
#include "model/unit/shade/light/light.hpp"
#include "tests/support/cases/pass_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns the least k > 0 for which the coordinate p + k step has left its slab behind; -1 if it
/// always is.
Int128 steps_to(std::int64_t p, std::int64_t step, std::int64_t end) {
    if (step < 0) p = -p, step = -step;
    if (p >= -end) return 1;
    if (step == 0) return -1;
    return (Int128(-end) - p + step - 1) / step;
}

/// Computes the correct start of the ray by division.
std::optional<Vec3l> entry_of(const Vec3l& p, const Vec3i& d, const Config& c) {
    Int128 most = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const Int128 steps = steps_to(p[k], d[k] * (std::int64_t(1) << c.approach_shift()), lattice_end(c));
        if (steps < 0) return std::nullopt;
        most = std::max(most, steps);
    }
    if (most > 1 << approach_steps) return std::nullopt;
    Vec3l at{};
    for (std::size_t k = 0; k < 3; ++k) {
        at[k] = p[k] + std::int64_t(most) * d[k] * (std::int64_t(1) << c.approach_shift());
        if (std::abs(at[k]) > lattice_end(c)) return std::nullopt;
    }
    return at;
}

Vec3l far_point(Draw& draw, const Config& c) {
    const std::int64_t most = (std::int64_t(1) << (c.point_width() - 1)) - 1;
    Vec3l p{};
    for (auto& x : p)
        x = std::clamp(draw.number(draw.between(c.origin_width() - 2, c.point_width())), -most, most);
    p[std::size_t(draw.below(3))] =
        (draw.coin() ? 1 : -1) *
        std::clamp(lattice_end(c) + std::int64_t(draw.natural(draw.between(1, c.point_width() - 1))),
                   std::int64_t(0), most);
    return p;
}

/// Draws a point of the inner part of the lattice, where finite primitives are.
Vec3l inner_point(Draw& draw, const Config& c) {
    const std::int64_t room = lattice_end(c) / 8 * 7 - (4 << c.origin_bits);
    Vec3l q{};
    for (auto& x : q)
        x = draw.percent(30) ? (draw.coin() ? room : -room)
                             : std::clamp(draw.number(c.origin_width()), -room, room);
    return q;
}

}   // namespace

TEST_CASE("a ray from beyond the lattice enters it at the point that exact division gives", "[approach]") {
    const Config c = shaded_format(GENERATE("all", "narrow", "broad", "short"));
    Draw draw{1};
    int entered = 0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3l p = far_point(draw, c), q = inner_point(draw, c);
        const bool aimed = draw.percent(90);
        Vec3i unit = aimed ? unit_vector({q[0] - p[0], q[1] - p[1], q[2] - p[2]}) : draw_unit(draw);
        if (draw.percent(10)) unit[std::size_t(draw.below(3))] = 0;
        const Vec3i d = direction_of(unit, c);
        CAPTURE(i, p, d);
        const std::optional<Vec3i> at = approach(p, d, c);
        const std::optional<Vec3l> right = entry_of(p, d, c);
        REQUIRE(at.has_value() == right.has_value());
        if (at) REQUIRE((Vec3l{(*at)[0], (*at)[1], (*at)[2]} == *right));
        entered += at.has_value();
    }
    REQUIRE(entered > 30000);
}

TEST_CASE("every ray to a finite primitive enters the lattice before that primitive", "[approach]") {
    const Config c = shaded_format(GENERATE("all", "narrow", "broad", "short"));
    Draw draw{2};
    for (int i = 0; i < 100000; ++i) {
        const Vec3l p = far_point(draw, c), q = inner_point(draw, c);
        const Vec3i d = direction_of(unit_vector({q[0] - p[0], q[1] - p[1], q[2] - p[2]}), c);
        // The line of the rounded direction: its last point that the inner part can contain, by its longest
        // component.
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (std::abs(d[k]) > std::abs(d[axis])) axis = k;
        if (d[axis] == 0) continue;
        const double t = double(q[axis] - p[axis]) / d[axis],
                     room = double(lattice_end(c)) * 7 / 8 - std::ldexp(4, c.origin_bits);
        bool holds = t > 0;
        for (std::size_t k = 0; k < 3; ++k) holds = holds && std::abs(double(p[k]) + t * d[k]) <= room;
        if (!holds) continue;   // the direction's rounding leads past the point
        CAPTURE(i, p, q, d);
        const std::optional<Vec3i> at = approach(p, d, c);
        REQUIRE(at);
        REQUIRE((double((*at)[axis]) - double(p[axis])) / d[axis] <= t);
    }
}

TEST_CASE("a bounce from beyond the lattice starts where it enters the lattice, or tests planes alone",
          "[far]") {
    Config c = shaded_format("all");
    c.horizon = GENERATE(0, 1);
    Draw draw{4};
    int sent[2]{}, shown[2]{}, past[2]{}, light = 0;
    for (int i = 0; i < 40000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        PassIn in;
        in.state = random_state(draw, frame, c);
        ShadeState& s = in.state;
        const bool through = draw.coin();
        s.next_event = through ? ShadeEvent::refract : ShadeEvent::reflect;
        s.pending = Pending::none, s.waiting = 0, s.is_far = 1;
        aim_far(draw, frame, c, s);
        const BounceOut ray = through ? refract(c, s) : reflect(c, s);
        const PassOut out = pass(in, frame, c);
        const bool seen = ray.goes && 2 * ray.weight + 3 * (s.depth + 1) >= frame.shade.threshold;
        const auto entry = s.is_lost ? std::nullopt : entry_of(s.o, ray.d, c);
        const bool goes = seen && !s.is_lost && (entry || c.horizon);
        REQUIRE((through ? out.push : out.leave == PassOut::Leave::spawn) == goes);
        if (goes) {
            const Vec3i& o = through ? out.pushed.o : out.spawn.o;
            REQUIRE((through ? out.pushed.d : out.spawn.d) == ray.d);
            REQUIRE((through ? out.pushed.is_partial : out.spawn.is_partial) == !entry);
            if (entry) REQUIRE(Vec3l{o[0], o[1], o[2]} == *entry);
            // Otherwise these are the nearest points of the coarse lattice, on the side on which the ray
            // leaves.
            for (std::size_t k = 0; k < 3 && !entry; ++k) {
                const std::int64_t off = (std::int64_t(o[k]) << far_drop) - s.o[k];
                REQUIRE(std::abs(off) <= 1 << far_drop);
                REQUIRE((through ? -1 : 1) * Int128(off) * s.n[k] >= 0);
            }
        }
        ++(goes ? (entry ? sent : past)[through] : seen ? shown[through] : light);
        for (std::size_t k = 0; k < 3; ++k) {
            const double more =
                seen && !goes ? ray.weight / 65536.0 * (frame.shade.background[k] / 65536.0) : 0;
            REQUIRE(std::abs(out.state.colour[k] / 65536.0 - std::min(1.0, s.colour[k] / 65536.0 + more)) <=
                    (seen && !goes ? 0.5 / 65536 : 0));
        }
    }
    REQUIRE((sent[0] > 1000 && sent[1] > 500 && light > 1000));
    for (const int through : {0, 1}) {
        REQUIRE(shown[through] > (c.horizon ? 100 : 500));
        REQUIRE((past[through] > 500) == (c.horizon));
    }
}

TEST_CASE("what a path sees through a pane lies in another cell, until it comes back through it", "[far]") {
    const Config c = shaded_format("broad");
    Draw draw{6};
    int through_panes = 0;
    for (int i = 0; i < 20000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        PassIn in = random_pass(draw, frame, c);
        in.hit.found = 1, in.state.next_event = ShadeEvent::arrive;
        const bool is_plane = in.surface.kind == PrimKind::plane;
        const std::uint32_t pane = is_plane ? std::uint32_t(in.surface.normal[4]) : 0;
        PassOut out = pass(in, frame, c);
        REQUIRE(out.state.in_cell == in.state.in_cell);
        REQUIRE(out.state.across == (in.state.in_cell ^ pane));

        in.state = out.state, in.state.next_event = ShadeEvent::refract;
        out = pass(in, frame, c);
        REQUIRE(out.state.in_cell == in.state.in_cell);   // the reflected ray comes next
        if (!out.push) continue;
        REQUIRE(out.pushed.in_cell == (in.state.in_cell ^ pane));
        through_panes += pane != 0;
        in.state = out.state, in.state.next_event = ShadeEvent::pop, in.state.waiting = 1;
        in.top = out.pushed;
        REQUIRE(pass(in, frame, c).state.in_cell == out.pushed.in_cell);
    }
    REQUIRE(through_panes > 500);
}

TEST_CASE("shadow rays of points beyond the lattice test finite primitives unless a plane blocks them",
          "[far]") {
    const Config c = shaded_format("all");
    Draw draw{5};
    int from_light = 0, to_light = 0, dark = 0, free = 0;
    for (int i = 0; i < 60000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        if (frame.shade.lights == 0) continue;
        PassIn in;
        in.state = random_state(draw, frame, c);
        ShadeState& s = in.state;
        s.next_event = ShadeEvent::light, s.pending = Pending::none, s.is_far = 1;
        aim_far(draw, frame, c, s);
        ShadeState judged = s;
        const LightOut found = light(frame, c, judged);
        const PassOut out = pass(in, frame, c);
        const bool near = frame.shade.near[s.light] != 0,
                   clear = frame.shade.clear[s.light] != 0 && frame.shade.cell[s.light] == s.in_cell;
        const auto entry = s.is_lost ? std::nullopt : entry_of(s.o, found.d, c);
        if (!found.counts || !clear) {
            REQUIRE((out.leave == PassOut::Leave::again && out.state.pending == Pending::none));
            ++dark;
        } else if (near ? s.is_lost : !entry) {
            REQUIRE((out.leave == PassOut::Leave::again && out.state.pending == Pending::sure));
            ++free;
        } else {
            REQUIRE((out.leave == PassOut::Leave::spawn && out.state.pending == Pending::answer));
            REQUIRE((out.spawn.kind == RayKind::away && out.spawn.is_partial == 1));
            double along = 0,
                   length = 0;   // towards the point from a light that is near, else towards the light
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t place = std::int64_t(frame.shade.place[3 * s.light + k]) << c.origin_bits;
                REQUIRE(out.spawn.o[k] == (near ? place : (*entry)[k]));
                along += out.spawn.d[k] * double(near ? s.o[k] - place : place - s.o[k]);
                length += std::pow(double(place - s.o[k]), 2);
            }
            REQUIRE(along > 0.9999 * std::ldexp(std::sqrt(length), c.dir_bits - 2));
            ++(near ? from_light : to_light);
        }
    }
    REQUIRE((from_light > 1000 && to_light > 100 && dark > 1000 && free > 100));
}

TEST_CASE("a ray that tests finite primitives only hits no plane", "[far]") {
    const Config c = shaded_format("all");
    PrimData prim;
    prim.a = {0, 0, 0}, prim.b = {100, 0, 0}, prim.c = {0, 100, 0};
    Ray ray;
    ray.o = {10 << c.origin_bits, 10 << c.origin_bits, 50 << c.origin_bits},
    ray.d = {0, 0, -(100 << c.origin_bits)};
    for (const PrimKind kind : {PrimKind::triangle, PrimKind::plane})
        for (const RayKind of : {RayKind::shadow, RayKind::away})
            for (const std::uint32_t finite : {0u, 1u}) {
                prim.kind = kind, ray.kind = of, ray.is_partial = finite;
                TriRsp out;
                any_primitive_test(ray, prim, {}, c, out);
                CHECK(out.closer == !(finite && kind == PrimKind::plane));
            }
}
