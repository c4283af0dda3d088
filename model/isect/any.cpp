#include "model/isect/any.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "model/isect/tri.hpp"
#include "model/isect/vectors.hpp"

namespace rayclock {

namespace {

Wide dot(const Vec3l& a, const Vec3l& b) { return Wide(a[0]) * b[0] + Wide(a[1]) * b[1] + Wide(a[2]) * b[2]; }
Vec3l negative(const Vec3l& a) { return {-a[0], -a[1], -a[2]}; }

/// o - 2^drop a in units of 2^-drop for an origin with `frac` bits of fraction, of which `frac - drop` are
/// zero.
Vec3l offset(const Vec3i& o, const Vec3i& a, int frac, int drop) {
    Vec3l s;
    for (std::size_t k = 0; k < 3; ++k) s[k] = (o[k] >> (frac - drop)) - a[k] * (std::int64_t(1) << drop);
    return s;
}

/// The edge function is positive, a zero being decided as in tri_test; `flip` turns all signs.
bool inside(Wide edge, const Vec3l& gradient, bool flip) {
    const Wide decides = edge != 0          ? edge
                         : gradient[0] != 0 ? gradient[0]
                         : gradient[1] != 0 ? gradient[1]
                                            : gradient[2];
    return flip ? decides < 0 : decides > 0;
}

/// one * other for factors below 2^96, in two parts.
struct Product {
    WideNatural high;
    std::uint64_t low;
    Product(Wide one, Wide other) {
        assert(one >= 0 && other >= 0 && one >> 96 == 0 && other >> 96 == 0 &&
               "parts of a hit are positive and below 2^96");
        const auto low_of = [](Wide x) { return std::uint64_t(x); };
        const auto high_of = [](Wide x) { return std::uint64_t(x >> 64); };
        const WideNatural bottom = WideNatural(low_of(one)) * low_of(other);
        low = std::uint64_t(bottom);
        high = (bottom >> 64) + WideNatural(low_of(one)) * high_of(other) +
               WideNatural(high_of(one)) * low_of(other) + (WideNatural(high_of(one)) * high_of(other) << 64);
    }
    bool operator<(const Product& p) const { return high != p.high ? high < p.high : low < p.low; }
};

/// num / det goes before the hit to beat: nearer, or as near and of no higher number.
bool goes_before(Wide num, Wide det, std::uint32_t prim, const Best& best) {
    if (!best.found) return true;
    const Product mine{num, best.det}, theirs{best.num, det};
    if (mine < theirs) return true;
    return !(theirs < mine) && prim <= best.prim;
}

/// min(ceil(num 2^shift / det), largest distance), for num, det > 0 and num 2^shift < 2^127; shift may be
/// negative.
std::uint32_t distance_of(Wide num, int shift, Wide det, const Config& config) {
    if (shift < 0)
        det <<= -shift;
    else
        num <<= shift;
    const Wide beyond = (Wide(1) << config.t_bits()) - 1;
    if (num > beyond * det) return std::uint32_t(beyond);
    return std::uint32_t((num + det - 1) / det);
}

/// floor(2^bary_bits edge / det) of 0 <= edge <= det; of a plane any edge, saturated to uv_bits in two's
/// complement.
std::uint32_t coordinate(Wide edge, Wide det, const Config& config) {
    const Wide most = (Wide(1) << (config.uv_bits() - 1)) - 1, unit = Wide(1) << config.bary_bits;
    const Wide scaled = edge * unit;
    Wide whole = scaled / det;
    if (scaled < 0 && whole * det != scaled) --whole;
    if (config.planes) whole = std::clamp(whole, -most - 1, most);
    return std::uint32_t(std::uint64_t(whole) & ((std::uint64_t(1) << config.uv_bits()) - 1));
}

/// Bounces, and rays away to a light: their origin has B fraction bits.
bool leaves_surface(const Ray& ray) {
    return RayKind(ray.kind) == RayKind::bounce || RayKind(ray.kind) == RayKind::away;
}

/// Triangles and planes, whatever the ray.
void flat_test(const Ray& ray, const PrimData& prim, const Best& best, const Config& config, TriRsp& out) {
    if (ray.finite && ends_at_any(ray.kind) && PrimKind(prim.kind) == PrimKind::plane) return;
    const bool shadow = RayKind(ray.kind) == RayKind::shadow;
    const int frac = config.origin_frac(), scale = leaves_surface(ray) ? frac : 0;
    const Vec3l d{ray.d[0], ray.d[1], ray.d[2]};
    const Vec3l e1 = minus(prim.b, prim.a), e2 = minus(prim.c, prim.a),
                s = offset(ray.o, prim.a, frac, scale);
    const Vec3l p1 = cross(d, e1), p2 = cross(d, e2);
    const Wide det = dot(p2, e1);
    if (det == 0) return;
    const bool flip = det < 0;
    const Wide u = dot(p2, s), v = -dot(p1, s), w = det * (Wide(1) << scale) - u - v;
    if (PrimKind(prim.kind) == PrimKind::triangle &&
        (!inside(u, p2, flip) || !inside(v, negative(p1), flip) ||
         !inside(w, {p1[0] - p2[0], p1[1] - p2[1], p1[2] - p2[2]}, flip)))
        return;

    const Wide num_raw = dot(cross(e1, e2), s);
    const Wide num = flip ? -num_raw : num_raw, size = (flip ? -det : det) * (Wide(1) << scale);
    assert(num >> (config.num_bits() - 1) == (num < 0 ? -1 : 0) && size >> (config.edge_bits() - 1) == 0 &&
           "num and det fit their widths");
    if (num <= 0) return;
    if (shadow) {
        out.closer = num * (Wide(1) << frac) < size;
        return;
    }
    if (ends_at_any(ray.kind)) {
        out.closer = 1;
        return;
    }
    if (!goes_before(num, size, prim.prim, best)) return;
    out.closer = 1;
    out.back = flip;
    out.num = num;
    out.det = size;
    out.prim = prim.prim;
    out.t = distance_of(num, config.dir_bits - 1 + config.t_frac_bits, size, config);
    out.u = coordinate(flip ? -u : u, size, config);
    out.v = coordinate(flip ? -v : v, size, config);
}

/// A ray and a sphere: d.s, d.d, s.s less the square of the radius, and the discriminant, s having `scale`
/// bits of fraction.
struct Meeting {
    Wide along, square, power, disc;
};
Meeting meeting(const Ray& ray, const PrimData& sphere, int scale, const Config& config) {
    const int n = config.coord_bits;
    const Vec3l d{ray.d[0], ray.d[1], ray.d[2]}, s = offset(ray.o, sphere.a, config.origin_frac(), scale);
    Meeting m;
    m.along = dot(d, s);
    m.square = dot(d, d);
    m.power = dot(s, s) - (Wide(radius_squared(sphere, n)) << (2 * scale));
    m.disc = m.along * m.along - m.square * m.power;
    [[maybe_unused]] const auto fits = [](Wide x, int bits) { return x >> (bits - 1) == (x < 0 ? -1 : 0); };
    [[maybe_unused]] const SphereWidths w = sphere_widths(n, config.dir_bits, config.origin_frac());
    assert(fits(m.along, w.along) && m.square >> w.square == 0 && fits(m.power, w.power) &&
           fits(m.disc, w.disc) && "see SphereWidths");
    return m;
}

/// Whether a sphere stands between the light, from which the ray comes, and the point.
bool shades(const Ray& ray, const PrimData& sphere, const Config& config) {
    const Meeting m = meeting(ray, sphere, 0, config);
    const bool from_outside = m.power > 0;
    if (sphere.prim == ray.self) return ray.inside != 0 && from_outside;
    const Wide unit = Wide(1) << config.origin_frac();
    const Wide end = m.square + 2 * m.along * unit + m.power * unit * unit;   // |O - c|^2 less the square of
                                                                              // the radius
    if (from_outside) return m.along < 0 && m.disc >= 0 && (end < 0 || -m.along * unit < m.square);
    return end > 0 && (m.power < 0 || m.along < 0);
}

void sphere_test(const Ray& ray, const PrimData& sphere, const Best& best, const Config& config,
                 TriRsp& out) {
    if (RayKind(ray.kind) == RayKind::shadow) {
        out.closer = shades(ray, sphere, config);
        return;
    }
    const int scale = config.origin_frac();
    const Meeting m = meeting(ray, sphere, scale, config);
    const bool own = leaves_surface(ray) && sphere.prim == ray.self;
    if (own && !ray.inside) return;
    const bool outside = m.power > 0, far = own || !outside;
    if (outside ? m.along >= 0 || m.disc < 0 : m.power < 0 ? m.square == 0 : m.along >= 0) return;
    if (ends_at_any(ray.kind)) {
        out.closer = 1;
        return;
    }

    const Root r = root(WideNatural(m.disc));
    const Wide way = -m.along + (far ? Wide(r.whole + r.rest) << r.shift : -(Wide(r.whole) << r.shift));
    assert(way > 0 && way >> sphere_widths(config.coord_bits, config.dir_bits, scale).num == 0 &&
           "never below the true distance, see SphereWidths");
    const int units = config.dir_bits - 1 + config.t_frac_bits;
    const std::uint32_t t = distance_of(way, units - scale, m.square, config);
    const Wide det = Wide(1) << units;
    if (!goes_before(t, det, sphere.prim, best)) return;
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
    std::uint64_t whole = std::uint64_t(std::sqrt(double(cut)));   // right to within one: cut has 56 bits, a
                                                                   // double 53
    while (whole * whole > cut) --whole;
    while ((whole + 1) * (whole + 1) <= cut) ++whole;
    r.whole = std::uint32_t(whole);
    r.rest = WideNatural(whole * whole) << (2 * r.shift) != square;
    return r;
}

void any_test(const Ray& ray, const PrimData& prim, const Best& best, const Config& config, TriRsp& out) {
    out.closer = out.back = 0;
    out.num = out.det = 0;
    out.prim = out.t = out.u = out.v = 0;
    const PrimKind kind = config.has_kinds() ? PrimKind(prim.kind) : PrimKind::triangle;
    if (kind == PrimKind::sphere) return sphere_test(ray, prim, best, config, out);
    const bool short_best = !best.found || (best.num | best.det) >> 63 == 0;   // always, as only camera rays
                                                                               // compare with camera rays'
                                                                               // hits
    if (kind == PrimKind::plane || RayKind(ray.kind) != RayKind::camera || !short_best)
        return flat_test(ray, prim, best, config, out);
    Vec3i o;
    for (std::size_t k = 0; k < 3; ++k) o[k] = ray.o[k] >> config.origin_frac();
    tri_test(o, ray.d, prim, best, config, out);   // 64 bits do
}

}   // namespace rayclock
