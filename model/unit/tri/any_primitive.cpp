// Tests of planes and spheres, and of secondary rays, for a chip that shades.
#include "model/unit/tri/any_primitive.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "model/unit/tri/tri_test.hpp"
#include "model/unit/tri/tri.hpp"

namespace rayclock {

namespace {

/// Returns o - 2^drop a in units of 2^-drop, for an origin with `frac` fraction bits. The lowest `frac -
/// drop` of them are zero.
Vec3l offset(const Vec3i& o, const Vec3i& a, int frac, int drop) {
    Vec3l s;
    for (std::size_t k = 0; k < 3; ++k) s[k] = (o[k] >> (frac - drop)) - a[k] * (std::int64_t(1) << drop);
    return s;
}

/// Returns min(ceil(num 2^shift / det), largest distance), for num, det > 0 and num 2^shift < 2^127. `shift`
/// may be negative.
std::uint32_t distance_of(Int128 num, int shift, Int128 det, const Config& config) {
    if (shift < 0)
        det <<= -shift;
    else
        num <<= shift;
    const Int128 beyond = (Int128(1) << config.t_bits()) - 1;
    if (num > beyond * det) return std::uint32_t(beyond);
    return std::uint32_t((num + det - 1) / det);
}

/// Returns floor(2^bary_bits edge / det) for 0 <= edge <= det. For a plane any edge is allowed, and the
/// result saturates to uv_bits in two's complement.
std::uint32_t coordinate(Int128 edge, Int128 det, const Config& config) {
    const Int128 most = (Int128(1) << (config.uv_bits() - 1)) - 1, unit = Int128(1) << config.bary_bits;
    const Int128 scaled = edge * unit;
    Int128 whole = scaled / det;
    if (scaled < 0 && whole * det != scaled) --whole;
    if (config.planes) whole = std::clamp(whole, -most - 1, most);
    return std::uint32_t(std::uint64_t(whole) & ((std::uint64_t(1) << config.uv_bits()) - 1));
}

/// True for rays whose origin has B fraction bits: bounces, rays away to a light, and camera rays in an
/// instance.
bool leaves_surface(const Ray& ray, const Config& config) {
    return ray.kind == RayKind::bounce || ray.kind == RayKind::away ||
           (config.has_instances() && ray.kind == RayKind::camera);
}

/// True if the ray begins beyond the lattice, and so meets only planes.
bool is_far(const Ray& ray) { return ray.is_partial && !ends_at_any(ray.kind); }

/// Tests any ray against a triangle or plane.
void flat_test(const Ray& ray, const PrimData& prim, const Best& best, const Config& config, TriRsp& out) {
    if (ray.is_partial && ends_at_any(ray.kind) == (prim.kind == PrimKind::plane)) return;
    const bool shadow = ray.kind == RayKind::shadow;
    const int frac = config.origin_frac() - (is_far(ray) ? far_drop : 0),
              scale = leaves_surface(ray, config) ? frac : 0;
    const bool edges_count = prim.kind != PrimKind::plane;
    Edges<Int128> e;
    bool flip = false;
    if (!meet(offset(ray.o, prim.a, frac, scale), {ray.d[0], ray.d[1], ray.d[2]}, prim, scale, edges_count, e,
              flip))
        return;
    assert(e.num >> (config.num_bits() - 1) == 0 && e.det >> (config.edge_bits() - 1) == 0 &&
           "num and det fit their widths");
    if (ends_at_any(ray.kind)) {
        const bool is_in_way = !shadow || e.num * (Int128(1) << frac) < e.det;
        out.cutout = is_in_way && prim.kind == PrimKind::cutout;
        if (!out.cutout) {
            out.closer = is_in_way;
            return;
        }
    } else if (!goes_before(e.num, e.det, prim.prim, best)) {
        return;
    }
    put_hit(e, flip, prim.prim, config, out);
    out.t = distance_of(e.num, config.dir_bits - 1 + config.t_frac_bits, e.det, config);
    out.u = coordinate(e.u, e.det, config);
    out.v = coordinate(e.v, e.det, config);
}

/// A ray and a sphere: d.s, d.d, s.s less the squared radius, and the discriminant. s has `scale` fraction
/// bits.
struct Meeting {
    Int128 along, square, power, disc;
};
Meeting meeting(const Ray& ray, const PrimData& sphere, int scale, const Config& config) {
    const int n = config.coord_bits;
    const Vec3l d{ray.d[0], ray.d[1], ray.d[2]}, s = offset(ray.o, sphere.a, config.origin_frac(), scale);
    Meeting m;
    m.along = dot<Int128>(d, s);
    m.square = dot<Int128>(d, d);
    m.power = dot<Int128>(s, s) - (Int128(radius_squared(sphere, n)) << (2 * scale));
    m.disc = m.along * m.along - m.square * m.power;
    [[maybe_unused]] const auto fits = [](Int128 x, int bits) { return x >> (bits - 1) == (x < 0 ? -1 : 0); };
    [[maybe_unused]] const SphereWidths w = sphere_widths(n, config.dir_bits, config.origin_frac());
    assert(fits(m.along, w.along) && m.square >> w.square == 0 && fits(m.power, w.power) &&
           fits(m.disc, w.disc) && "see SphereWidths");
    return m;
}

/// True if a sphere lies between the light, where the ray begins, and the point.
bool shades(const Ray& ray, const PrimData& sphere, const Config& config) {
    const Meeting m = meeting(ray, sphere, 0, config);
    const bool from_outside = m.power > 0;
    const bool seen_inside = is_seen_inside(sphere);
    if (config.has_self() && sphere.prim == ray.self)
        return seen_inside && ray.is_inside != 0 && from_outside;
    const Int128 unit = Int128(1) << config.origin_frac();
    // |O - c|^2 minus the squared radius.
    const Int128 end = m.square + 2 * m.along * unit + m.power * unit * unit;
    if (!seen_inside && end <= 0) return false;   // the point is inside and sees out
    if (from_outside) return m.along < 0 && m.disc >= 0 && (end < 0 || -m.along * unit < m.square);
    return end > 0 && (m.power < 0 || m.along < 0);
}

void sphere_test(const Ray& ray, const PrimData& sphere, const Best& best, const Config& config,
                 TriRsp& out) {
    if (is_far(ray)) return;
    if (ray.kind == RayKind::shadow) {
        out.closer = shades(ray, sphere, config);
        return;
    }
    const int scale = config.origin_frac();
    const Meeting m = meeting(ray, sphere, scale, config);
    const bool own = config.has_self() && leaves_surface(ray, config) && ray.kind != RayKind::camera &&
                     sphere.prim == ray.self;
    if (own && !ray.is_inside) return;
    const bool outside = m.power > 0, far = own || !outside;
    if (far && !is_seen_inside(sphere)) return;
    if (outside ? m.along >= 0 || m.disc < 0 : m.power < 0 ? m.square == 0 : m.along >= 0) return;
    if (ends_at_any(ray.kind)) {
        out.closer = 1;
        return;
    }

    const Root r = root(WideNatural(m.disc));
    const Int128 way = -m.along + (far ? Int128(r.whole + r.rest) << r.shift : -(Int128(r.whole) << r.shift));
    assert(way > 0 && way >> sphere_widths(config.coord_bits, config.dir_bits, scale).num == 0 &&
           "never below the true distance, see SphereWidths");
    const int units = config.dir_bits - 1 + config.t_frac_bits;
    const std::uint32_t t = distance_of(way, units - scale, m.square, config);
    const Int128 det = Int128(1) << units;
    if (!goes_before(Int128(t), det, sphere.prim, best)) return;
    out.closer = 1;
    out.back = far;
    out.num = t;
    out.det = det;
    out.prim = sphere.prim;
    out.t = t;
}

}   // namespace

Root root(WideNatural square) {
    Root r;
    const auto high = std::uint64_t(square >> 64);
    const int bits = int(high != 0 ? 64 + std::bit_width(high) : std::bit_width(std::uint64_t(square)));
    r.shift = std::max(bits - 2 * root_bits + 1, 0) / 2;
    const auto cut = std::uint64_t(square >> (2 * r.shift));
    // Off by at most one: cut has 56 bits, a double 53.
    std::uint64_t whole = std::uint64_t(std::sqrt(double(cut)));
    while (whole * whole > cut) --whole;
    while ((whole + 1) * (whole + 1) <= cut) ++whole;
    r.whole = std::uint32_t(whole);
    r.rest = WideNatural(whole * whole) << (2 * r.shift) != square;
    return r;
}

void any_primitive_test(const Ray& ray, const PrimData& prim, const Best& best, const Config& config,
                        TriRsp& out) {
    no_hit(out);
    const PrimKind kind = config.has_kinds() ? prim.kind : PrimKind::triangle;
    if (kind == PrimKind::sphere) return sphere_test(ray, prim, best, config, out);
    // Always true, as only camera rays compare with hits of camera rays.
    const bool short_best = !best.found || (best.num | best.det) >> 63 == 0;
    if (kind == PrimKind::plane || ray.kind != RayKind::camera || !short_best || config.has_instances())
        return flat_test(ray, prim, best, config, out);
    Vec3i o;
    for (std::size_t k = 0; k < 3; ++k) o[k] = ray.o[k] >> config.origin_frac();
    tri_test(o, ray.d, prim, best, config, out);   // 64 bits suffice
}

}   // namespace rayclock
