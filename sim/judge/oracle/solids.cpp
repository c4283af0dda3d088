// The tests of single primitives, and the searches through the tree.
#include "sim/judge/oracle/solids.hpp"

#include <cmath>
#include <limits>

#include "model/base/axes.hpp"

namespace rayclock::oracle {

namespace {

using Short = std::int64_t;

int sign_of(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Returns the vector from the origin to a lattice point, in units of 2^-frac.
Triple<Short> from_origin(const SolidRay& ray, const Vec3i& p) {
    return by_axis([&](std::size_t k) { return Short(p[k]) * (Short(1) << ray.frac) - ray.origin[k]; });
}

/// The plane through three points, at num / den directions from the origin, times 2^frac. If den < 0, the ray
/// comes from the side to which the normal points.
struct Height {
    Int128 num, den;
};
Height height(const SolidRay& ray, const Corners& t) {
    const Triple<Short> n = normal<Short>(t);
    return {volume<Int128>(from_origin(ray, t.a), n), volume<Int128>(triple<Short>(ray.direction), n)};
}

/// The direction, the corners relative to the origin, and the volumes of the direction with pairs of corners.
struct Seen {
    Triple<Short> d, a, b, c;
    Int128 bc, ca, ab;
    Seen(const SolidRay& ray, const Corners& t)
        : d(triple<Short>(ray.direction)),
          a(from_origin(ray, t.a)),
          b(from_origin(ray, t.b)),
          c(from_origin(ray, t.c)),
          bc(volume<Int128>(d, area(b, c))),
          ca(volume<Int128>(d, area(c, a))),
          ab(volume<Int128>(d, area(a, b))) {}
    /// Returns true if the moved ray's line passes between the edges.
    bool within_edges() const {
        if ((bc > 0 && ca < 0) || (bc < 0 && ca > 0)) return false;   // most calls end here
        const int first = side(bc, d, b, c);
        return first != 0 && side(ca, d, c, a) == first && side(ab, d, a, b) == first;
    }
};

/// Returns the crossing at t > 0.
std::optional<FlatHit> cross_flat(const SolidRay& ray, const Solid& solid, std::uint32_t number) {
    const Seen v(ray, solid.corners);
    if (solid.shape == Solid::Shape::triangle && !v.within_edges()) return std::nullopt;
    const Height h = height(ray, solid.corners);
    if (h.den == 0 || h.num == 0 || (h.num > 0) != (h.den > 0)) return std::nullopt;
    const int turn = sign_of(h.den);
    const Int128 total = (v.bc + v.ca + v.ab) * turn;
    return FlatHit{number, h.num * turn, h.den * turn * (Int128(1) << ray.frac), v.ca * turn, v.ab * turn,
                   total,  h.den > 0};
}

/// Returns true if a flat hit precedes another one.
bool before(const FlatHit& one, const FlatHit& other) {
    if (other.primitive == no_primitive) return true;
    const int order = compare_fractions(one.num, one.den, other.num, other.den);
    return order < 0 || (order == 0 && one.primitive < other.primitive);
}

bool is_self(const SolidRay& ray, std::uint32_t number) { return ray.self == number; }

/// Returns true if the sphere blocks the ray, which comes from the light, before its end at t = 1.
///
/// For a ray that ends on this very sphere: from outside, the sphere does not block, since the light is on
/// the same side. From inside it blocks if the light is outside. An opaque sphere is met only from outside;
/// one that holds the end point does not block it.
bool sphere_blocks(const SolidRay& ray, const Solid& sphere, bool own, int frac_end) {
    const Ball b = ball_of(ray, sphere);
    if (own) return sphere.is_glass && ray.inside && b.start > 0;
    // The end of the segment, its middle (the point nearest to the centre) and its beginning decide.
    const Int128 unit = Int128(1) << frac_end;
    const Int128 last = b.start * unit * unit + 2 * b.along * unit + b.square;
    if (!sphere.is_glass && last <= 0) return false;
    if ((b.start < 0 && last > 0) || (b.start > 0 && last < 0)) return true;
    const Int128 middle = -b.along * unit;   // in units of square / 2^frac_end
    if (b.start > 0) return middle > 0 && middle < b.square && b.disc() >= 0;
    return b.start == 0 && middle > 0 && 2 * middle < b.square;
}

std::vector<Extent> boxes_of(const std::vector<Solid>& solids, std::vector<std::uint32_t>& planes,
                             std::vector<std::uint32_t>& bounded) {
    std::vector<Extent> boxes;
    for (std::uint32_t i = 0; i < solids.size(); ++i) {
        const Solid& s = solids[i];
        if (s.is_second) continue;
        if (s.shape == Solid::Shape::plane) {
            planes.push_back(i);
            continue;
        }
        Extent box = extent(s.corners);
        if (s.shape == Solid::Shape::sphere) {
            const auto radius =
                std::int32_t(std::min(std::sqrt(double(s.radius_squared)) + 1, double(1 << 21)));
            for (std::size_t k = 0; k < 3; ++k)
                box.lo[k] = s.centre[k] - radius, box.hi[k] = s.centre[k] + radius;
        }
        bounded.push_back(i);
        boxes.push_back(box);
    }
    return boxes;
}

}   // namespace

int compare_fractions(Int128 num1, Int128 den1, Int128 num2, Int128 den2) {
    // Most pairs are far apart: quotients of two 128-bit numbers, each exact to 2^-63, decide.
    const long double one = (long double)num1 / (long double)den1,
                      other = (long double)num2 / (long double)den2;
    constexpr long double slack = 0x1p-58L;
    if (one < other * (1 - slack)) return -1;
    if (one > other * (1 + slack)) return 1;
    for (int turn = 1;; turn = -turn) {
        const Int128 whole1 = num1 / den1, whole2 = num2 / den2;
        if (whole1 != whole2) return whole1 < whole2 ? -turn : turn;
        num1 %= den1, num2 %= den2;
        if (num1 == 0 || num2 == 0) return num1 == num2 ? 0 : num1 == 0 ? -turn : turn;
        std::swap(num1, den1), std::swap(num2, den2);   // reciprocals have the opposite order
    }
}

Ball ball_of(const SolidRay& ray, const Solid& sphere) {
    Ball b{-(Int128(sphere.radius_squared) << (2 * ray.frac)), 0, 0};
    const Triple<Short> to_centre = from_origin(ray, sphere.centre);
    for (std::size_t k = 0; k < 3; ++k) {
        b.start += Int128(to_centre[k]) * to_centre[k];
        b.along -= Int128(to_centre[k]) * ray.direction[k];
        b.square += Int128(ray.direction[k]) * ray.direction[k];
    }
    return b;
}

SphereRoot meets_sphere(const SolidRay& ray, const Solid& sphere, bool is_self) {
    const Ball b = ball_of(ray, sphere);
    if (b.square == 0 || sphere.radius_squared == 0 || (is_self && !ray.inside)) return SphereRoot::none;
    const bool ahead = b.along < 0;   // the point nearest to the centre
    if (!sphere.is_glass)             // opaque: the ray enters from outside, or misses
        return !is_self && b.start > 0 && ahead && b.disc() >= 0 ? SphereRoot::near : SphereRoot::none;
    SphereRoot found = SphereRoot::far;
    if (b.start > 0) found = ahead && b.disc() >= 0 ? SphereRoot::near : SphereRoot::none;
    if (b.start == 0) found = ahead ? SphereRoot::far : SphereRoot::none;
    // The ray starts on the sphere, up to rounding.
    return is_self && found != SphereRoot::none ? SphereRoot::far : found;
}

double sphere_distance(const SolidRay& ray, const Solid& sphere, SphereRoot which) {
    // The product of the roots is start / square. Compute the root whose terms do not cancel, and derive the
    // other one from the product.
    const Ball b = ball_of(ray, sphere);
    const long double root = std::sqrt((long double)b.disc()), along = (long double)b.along,
                      square = (long double)b.square;
    const bool far = which == SphereRoot::far;
    const long double sum = far ? root - along : -root - along;   // times square
    const long double scaled = (far ? along <= 0 : along >= 0)
                                   ? sum / square
                                   : (long double)b.start / (far ? -root - along : root - along);
    return double(std::ldexp(scaled, -ray.frac));
}

bool reaches_sphere(const SolidRay& ray, const Solid& sphere, SphereRoot which, std::int64_t ticks,
                    int tick_bits) {
    const Triple<Short> to_centre = from_origin(ray, sphere.centre);
    Int128 outside = -(Int128(sphere.radius_squared) << (2 * tick_bits)), along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Int128 at = Int128(ticks) * ray.direction[k] - (Int128(to_centre[k]) << (tick_bits - ray.frac));
        outside += at * at;
        along += at * ray.direction[k];   // at least 0: past the point nearest to the centre
    }
    return which == SphereRoot::near ? along >= 0 || outside <= 0 : along >= 0 && outside >= 0;
}

Solids::Solids(std::vector<Solid> solids)
    : solids_(std::move(solids)), tree_(boxes_of(solids_, planes_, bounded_), 1) {}

std::optional<FlatHit> Solids::flat_hit(const SolidRay& ray, std::uint32_t number) const {
    return cross_flat(ray, solids_[number], number);
}

Nearest Solids::nearest(const SolidRay& ray) const {
    Nearest found;
    // In directions; not less than the best hit's distance.
    double limit = std::numeric_limits<double>::infinity();
    const auto flat = [&](std::uint32_t number) {
        const auto hit = cross_flat(ray, solids_[number], number);
        if (!hit || !before(*hit, found.flat)) return;
        found.flat = *hit;
        limit = std::min(limit, double(hit->num) / double(hit->den) * (1 + 0x1p-40));
    };
    for (const std::uint32_t number : planes_) flat(number);
    if (ray.targets == SolidRay::Targets::planes) return found;
    const tree::Ray search(ray.origin, ray.direction, ray.frac);
    const auto after = [&](double near) { return near > 2 * limit * search.main_size() * (1 + 0x1p-40); };
    tree_.nearest_first(search, after, [&](std::uint32_t place) {
        const std::uint32_t number = bounded_[tree_.order()[place]];
        if (solids_[number].shape == Solid::Shape::triangle) return flat(number);
        const SphereRoot which = meets_sphere(ray, solids_[number], is_self(ray, number));
        if (which == SphereRoot::none) return;
        const double distance = sphere_distance(ray, solids_[number], which);
        if (found.sphere.primitive != no_primitive &&
            (distance > found.sphere.distance ||
             (distance == found.sphere.distance && number > found.sphere.primitive)))
            return;
        found.sphere = {number, which, distance};
        limit = std::min(limit, distance * (1 + 0x1p-40));
    });
    return found;
}

bool Solids::meets_any(const SolidRay& ray, const LetsPass& lets_pass) const {
    bool met = false;
    const auto test_primitive = [&](std::uint32_t number) {
        if (met) return;
        const Solid& s = solids_[number];
        if (s.shape == Solid::Shape::sphere) {
            met = meets_sphere(ray, s, is_self(ray, number)) != SphereRoot::none;
            return;
        }
        const auto hit = cross_flat(ray, s, number);
        met = hit && !(lets_pass && lets_pass(*hit));
    };
    if (ray.targets != SolidRay::Targets::bounded)
        for (const std::uint32_t number : planes_) test_primitive(number);
    tree_.nearest_first(
        tree::Ray(ray.origin, ray.direction, ray.frac), [&](double) { return met; },
        [&](std::uint32_t place) { test_primitive(bounded_[tree_.order()[place]]); });
    return met;
}

bool Solids::blocks(const SolidRay& ray, int frac_end, const LetsPass& lets_pass) const {
    bool met = false;
    const auto test_primitive = [&](std::uint32_t number) {
        if (met) return;
        const Solid& s = solids_[number];
        if (s.shape == Solid::Shape::sphere) {
            met = s.radius_squared > 0 && sphere_blocks(ray, s, is_self(ray, number), frac_end);
            return;
        }
        const auto hit = cross_flat(ray, s, number);
        met = hit && hit->num * (Int128(1) << frac_end) < hit->den && !(lets_pass && lets_pass(*hit));
    };
    for (const std::uint32_t number : planes_) test_primitive(number);
    const tree::Ray search(ray.origin, ray.direction, ray.frac);
    const double end = 2 * std::ldexp(search.main_size(), -frac_end) * (1 + 0x1p-40);
    tree_.nearest_first(
        search, [&](double near) { return met || near > end; },
        [&](std::uint32_t place) { test_primitive(bounded_[tree_.order()[place]]); });
    return met;
}

}   // namespace rayclock::oracle
