// Boxes of instances with their margins, and the searches through them.
#include "sim/judge/oracle/placed.hpp"

#include <algorithm>
#include <cmath>

namespace rayclock::oracle {

namespace {

/// Returns floor(n / d), d > 0.
Int128 whole_below(Int128 n, Int128 d) {
    const Int128 cut = n / d;
    return cut * d > n ? cut - 1 : cut;
}
Int128 whole_above(Int128 n, Int128 d) { return -whole_below(-n, d); }
/// Returns the integer nearest to n / 2^bits; halves round up.
std::int32_t nearest_whole(Int128 n, int bits) {
    return std::int32_t(whole_below(2 * n + (Int128(1) << bits), Int128(1) << (bits + 1)));
}
Int128 size_of(Int128 n) { return n < 0 ? -n : n; }

/// The inverse of a map's linear part times its determinant, by cofactors. The determinant is made positive.
struct Inverse {
    std::array<Int128, 9> rows{};
    Int128 volume = 0;
    explicit Inverse(const std::array<std::int64_t, 9>& a) {
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
                rows[3 * k + i] =
                    Int128(a[3 * i1 + k1]) * a[3 * i2 + k2] - Int128(a[3 * i1 + k2]) * a[3 * i2 + k1];
            }
        for (std::size_t k = 0; k < 3; ++k) volume += a[k] * rows[3 * k];
        if (volume > 0) return;
        volume = -volume;
        for (Int128& entry : rows) entry = -entry;
    }
    /// Returns the largest number of the scene's steps that one step of the mesh makes on an axis, rounded
    /// up.
    Int128 reach(std::size_t row, int frac) const {
        const Int128 sum = size_of(rows[3 * row]) + size_of(rows[3 * row + 1]) + size_of(rows[3 * row + 2]);
        return whole_above(sum << frac, volume);
    }
};

/// Returns the image of the mesh's bounds in the scene's lattice, rounded outward.
Extent image_of(const SolidPlace& place, const Inverse& inverse, const Extent& bounds, int frac) {
    Extent box;
    for (std::size_t k = 0; k < 3; ++k) {
        Int128 least = 0, most = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Int128 entry = inverse.rows[3 * k + i],
                         lo = entry * ((Int128(bounds.lo[i]) << frac) - place.b[i]),
                         hi = entry * ((Int128(bounds.hi[i]) << frac) - place.b[i]);
            least += std::min(lo, hi), most += std::max(lo, hi);
        }
        const Int128 far = Int128(1) << 24;   // no ray reaches this far
        box.lo[k] = std::int32_t(std::clamp(whole_below(least, inverse.volume), -far, far));
        box.hi[k] = std::int32_t(std::clamp(whole_above(most, inverse.volume), -far, far));
    }
    return box;
}

/// The bounds of a mesh, and whether it has unbounded primitives. Primitives that no ray can meet do not
/// count.
struct Bounds {
    std::optional<Extent> box;
    bool is_endless = false;
    bool is_empty() const { return !box && !is_endless; }
};

void add_sphere(const Solid& sphere, std::optional<Extent>& box) {
    if (sphere.radius_squared == 0) return;
    const auto radius = std::int32_t(std::sqrt(double(sphere.radius_squared))) + 1;
    Vec3i lo = sphere.centre, hi = sphere.centre;
    for (std::size_t k = 0; k < 3; ++k) lo[k] -= radius, hi[k] += radius;
    if (!box) box = Extent{lo, lo};
    box->add(lo), box->add(hi);
}

Bounds bounds_of(const Solids& mesh) {
    Bounds all;
    for (const Solid& solid : mesh.all()) {
        if (solid.shape == Solid::Shape::sphere) {
            add_sphere(solid, all.box);
            continue;
        }
        const Triple<std::int64_t> n = normal<std::int64_t>(solid.corners);
        if (n[0] == 0 && n[1] == 0 && n[2] == 0) continue;   // no ray meets it
        if (solid.shape == Solid::Shape::plane) {
            all.is_endless = true;
            continue;
        }
        if (!all.box) all.box = extent(solid.corners);
        for (const Vec3i& corner : {solid.corners.a, solid.corners.b, solid.corners.c}) all.box->add(corner);
    }
    return all;
}

/// Returns the box of an instance with its margin, or nothing if no margin suffices.
std::optional<Extent> box_of(const SolidPlace& place, const Extent& bounds, int frac, int coord_bits,
                             std::int32_t least) {
    const Inverse inverse(place.a);
    if (inverse.volume == 0) return std::nullopt;
    Extent box = image_of(place, inverse, bounds, frac);
    Int128 reach = 0, farthest = Int128(1) << (coord_bits - 1);
    for (std::size_t k = 0; k < 3; ++k) {
        reach = std::max(reach, inverse.reach(k, frac));
        farthest = std::max({farthest, size_of(box.lo[k]), size_of(box.hi[k])});
    }
    if (reach >= least) return std::nullopt;
    const Int128 longest =
        whole_above(2 * (farthest + (Int128(1) << (coord_bits - 1))) + reach, 2 * least - reach);
    const Int128 margin = whole_above(reach * (1 + std::max<Int128>(longest, 1)), 2) + 1;
    if (farthest + margin >= Int128(1) << 21) return std::nullopt;   // limit of the tree (tree.hpp)
    for (std::size_t k = 0; k < 3; ++k) box.lo[k] -= std::int32_t(margin), box.hi[k] += std::int32_t(margin);
    return box;
}

std::vector<Extent> boxes_of(const std::vector<Solids>& meshes, const std::vector<SolidPlace>& places,
                             int frac, int coord_bits, std::int32_t least, std::vector<std::uint32_t>& boxed,
                             std::vector<std::uint32_t>& always, std::vector<std::uint32_t>& empty) {
    std::vector<Bounds> bounds;
    for (const Solids& mesh : meshes) bounds.push_back(bounds_of(mesh));
    std::vector<Extent> boxes;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        const Bounds& mesh = bounds[places[i].mesh];
        if (mesh.is_empty()) {
            empty.push_back(i);
            continue;
        }
        const auto box =
            mesh.is_endless ? std::optional<Extent>{} : box_of(places[i], *mesh.box, frac, coord_bits, least);
        (box ? boxed : always).push_back(i);
        if (box) boxes.push_back(*box);
    }
    return boxes;
}

}   // namespace

Vec3i placed_direction(const SolidPlace& place, const Vec3i& d, int frac) {
    Vec3i moved{};
    for (std::size_t i = 0; i < 3; ++i)
        moved[i] = nearest_whole(Int128(place.a[3 * i]) * d[0] + Int128(place.a[3 * i + 1]) * d[1] +
                                     Int128(place.a[3 * i + 2]) * d[2],
                                 frac);
    return moved;
}

Vec3i placed_point(const SolidPlace& place, const Vec3i& o, int origin_frac, int frac) {
    Vec3i moved{};
    for (std::size_t i = 0; i < 3; ++i)
        moved[i] = nearest_whole((Int128(place.b[i]) << origin_frac) + Int128(place.a[3 * i]) * o[0] +
                                     Int128(place.a[3 * i + 1]) * o[1] + Int128(place.a[3 * i + 2]) * o[2],
                                 frac);
    return moved;
}

PlacedSolids::PlacedSolids(std::vector<Solids> meshes, std::vector<SolidPlace> places, int frac,
                           int coord_bits, int dir_bits)
    : meshes_(std::move(meshes)),
      places_(std::move(places)),
      frac_(frac),
      least_(1 << (dir_bits - 3)),
      tree_(boxes_of(meshes_, places_, frac, coord_bits, least_, boxed_, always_, empty_), 1) {}

std::uint32_t PlacedSolids::place_of(std::uint32_t primitive) const {
    const auto after =
        std::upper_bound(places_.begin(), places_.end(), primitive,
                         [](std::uint32_t p, const SolidPlace& place) { return p < place.first; });
    if (after == places_.begin()) return PlacedRay::nowhere;
    const auto place = std::uint32_t(after - places_.begin()) - 1;
    return primitive - places_[place].first < mesh_of(place).all().size() ? place : PlacedRay::nowhere;
}

SolidRay PlacedSolids::seen_by(std::uint32_t place, const PlacedRay& ray) const {
    if (place == ray.home) return ray.at_home;
    SolidRay seen = ray.ray;
    seen.origin = placed_point(places_[place], ray.ray.origin, ray.ray.frac, frac_);
    seen.direction = placed_direction(places_[place], ray.ray.direction, frac_);
    const std::uint32_t first = places_[place].first, count = std::uint32_t(mesh_of(place).all().size());
    const bool is_own = ray.ray.self >= first && ray.ray.self - first < count;
    seen.self = is_own ? ray.ray.self - first : no_primitive;   // the number within the mesh
    return seen;
}

template <class After, class Ask>
void PlacedSolids::each(const PlacedRay& ray, bool is_long, const After& after, const Ask& ask) const {
    const bool has_home = ray.home != PlacedRay::nowhere;
    if (has_home && !ask(ray.home)) return;
    const auto ask_others = [&](const std::vector<std::uint32_t>& places) {
        for (const std::uint32_t place : places)
            if (place != ray.home && !ask(place)) return false;
        return true;
    };
    if (!ask_others(always_)) return;
    if (!is_long) return void(ask_others(boxed_));
    bool goes_on = true;
    tree_.nearest_first(
        tree::Ray(ray.ray.origin, ray.ray.direction, ray.ray.frac),
        [&](double near) { return !goes_on || after(near); },
        [&](std::uint32_t at) {
            const std::uint32_t place = boxed_[tree_.order()[at]];
            if (goes_on && place != ray.home) goes_on = ask(place);
        });
}

namespace {

std::int32_t longest_of(const Vec3i& d) { return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])}); }

}   // namespace

PlacedHit PlacedSolids::nearest(const PlacedRay& ray) const {
    PlacedHit best;
    double limit = std::numeric_limits<double>::infinity();   // of t
    const double along = longest_of(ray.ray.direction);
    const auto after = [&](double near) { return near > 2 * limit * along; };
    each(ray, longest_of(ray.ray.direction) >= least_, after, [&](std::uint32_t place) {
        const Nearest found = mesh_of(place).nearest(seen_by(place, ray));
        if (found.sphere.primitive != no_primitive &&
            (best.sphere_place == PlacedRay::nowhere || found.sphere.distance < best.sphere.distance)) {
            best.sphere_place = place, best.sphere = found.sphere;
            limit = std::min(limit, found.sphere.distance * (1 + 0x1p-40));
        }
        const FlatHit& hit = found.flat;
        if (hit.primitive == no_primitive) return true;
        const int order = best.place == PlacedRay::nowhere
                              ? -1
                              : compare_fractions(hit.num, hit.den, best.hit.num, best.hit.den);
        if (order > 0 || (order == 0 && place > best.place)) return true;   // numbers rise with places
        best.place = place, best.hit = hit;
        limit = std::min(limit, double(hit.num) / double(hit.den) * (1 + 0x1p-40));
        return true;
    });
    return best;
}

bool PlacedSolids::is_met(std::uint32_t place, const PlacedRay& ray, bool ends, int frac_end,
                          const PlaceLetsPass& lets_pass) const {
    const SolidRay seen = seen_by(place, ray);
    LetsPass here;
    if (lets_pass) here = [&](const FlatHit& hit) { return lets_pass(place, hit); };
    return ends ? mesh_of(place).blocks(seen, frac_end, here) : mesh_of(place).meets_any(seen, here);
}

std::uint32_t PlacedSolids::meets_any(const PlacedRay& ray, const PlaceLetsPass& lets_pass) const {
    std::uint32_t met = PlacedRay::nowhere;
    each(
        ray, longest_of(ray.ray.direction) >= least_, [](double) { return false; },
        [&](std::uint32_t place) {
            if (is_met(place, ray, false, 0, lets_pass)) met = place;
            return met == PlacedRay::nowhere;
        });
    return met;
}

/// The end of a shadow ray has s <= 1. So its margin holds however short the direction is.
std::uint32_t PlacedSolids::blocks(const PlacedRay& ray, int frac_end, const PlaceLetsPass& lets_pass) const {
    std::uint32_t met = PlacedRay::nowhere;
    const double end = 2 * std::ldexp(double(longest_of(ray.ray.direction)), -frac_end) * (1 + 0x1p-40);
    each(
        ray, true, [&](double near) { return near > end; },
        [&](std::uint32_t place) {
            if (is_met(place, ray, true, frac_end, lets_pass)) met = place;
            return met == PlacedRay::nowhere;
        });
    return met;
}

}   // namespace rayclock::oracle
