// Compares a ray's answer with the exact oracle.
#include "sim/judge/paths/answer.hpp"

#include "sim/judge/paths/placed.hpp"
#include "sim/judge/paths/arithmetic.hpp"

namespace rayclock {

namespace {

using oracle::FlatHit;
using oracle::Nearest;
using oracle::Solid;
using oracle::SolidRay;
using oracle::Solids;
using oracle::SphereRoot;

/// The direction's length is 2^tick_bits units of t.
int tick_bits(const Config& c) { return c.dir_bits - 1 + c.t_frac_bits; }
std::int64_t max_ticks(const Config& c) { return (std::int64_t(1) << c.t_bits()) - 1; }

/// Returns the largest allowed excess of a sphere's t, in units of t: model/unit/tri/any_primitive.hpp.
double sphere_error(const SolidRay& ray, const Solid& sphere, const Config& c) {
    const glm::dvec3 d = vector_of(ray.direction);
    const double square = glm::dot(d, d), unit = std::ldexp(1.0, tick_bits(c));
    const double radius = std::sqrt(double(sphere.radius_squared) / square) * unit;
    return 1 + std::max(std::ldexp(unit, -ray.frac) / square, std::ldexp(radius, 1 - root_bits));
}

std::uint32_t field(Int128 value, int bits) {
    return std::uint32_t(std::uint64_t(value) & ((std::uint64_t(1) << bits) - 1));
}

/// Returns floor(2^bary_bits part / total). In a chip with planes it is signed and saturated, in two's
/// complement.
std::uint32_t weight_of(Int128 part, Int128 total, const Config& c) {
    Int128 whole = floor_of(part * (Int128(1) << c.bary_bits), total);
    const Int128 most = (Int128(1) << (c.uv_bits() - 1)) - 1;
    if (c.planes) whole = std::clamp(whole, -most - 1, most);
    return field(whole, c.uv_bits());
}

/// True if a sphere is hit before t = ticks, even with the machine's largest rounding error.
bool sphere_is_sooner(const Nearest& nearest, const Solids& solids, const SolidRay& ray, const Config& c,
                      double ticks) {
    if (nearest.sphere.primitive == no_primitive) return false;
    const double error = sphere_error(ray, solids.all()[nearest.sphere.primitive], c);
    return (std::ldexp(nearest.sphere.distance, tick_bits(c)) + error) * (1 + Range::slack) <
           ticks * (1 - Range::slack);
}

/// Judges t, u, v and the side of a triangle or plane that the ray does hit.
const char* judge_values(const FlatHit& hit, const Config& c, const Closest& answer) {
    const Int128 most = max_ticks(c);
    // num has up to 3N + B + 4 bits; if it would overflow, t saturates anyway.
    const Int128 t = hit.num > (Int128(1) << 90)
                         ? most
                         : std::min(most, ceil_of(hit.num * (Int128(1) << tick_bits(c)), hit.den));
    if (answer.t != std::uint32_t(t)) return "t is not the exact one, rounded up";
    if (answer.u != weight_of(hit.u, hit.total, c) || answer.v != weight_of(hit.v, hit.total, c))
        return "u or v is not the exact one, rounded down";
    if (c.shading && (answer.back != 0) != hit.back) return "it meets the other side";
    return nullptr;
}

double ticks_of(const FlatHit& hit, const Config& c) {
    return std::ldexp(double(hit.num) / double(hit.den), tick_bits(c));
}

const char* judge_flat(const Nearest& nearest, const Solids& solids, const SolidRay& ray, const Config& c,
                       const Closest& answer) {
    const FlatHit& hit = nearest.flat;
    if (hit.primitive != answer.prim)
        return solids.flat_hit(ray, answer.prim) ? "another primitive is closer" : "it misses that primitive";
    if (sphere_is_sooner(nearest, solids, ray, c, ticks_of(hit, c))) return "a sphere is closer";
    return judge_values(hit, c, answer);
}

/// `first`: the number in answers of the first of `solids`. The closest triangle or plane is numbered the
/// same way.
const char* judge_sphere(const Nearest& nearest, const Solids& solids, std::uint32_t first,
                         const SolidRay& ray, const Config& c, const Closest& answer) {
    const Solid& sphere = solids.all()[answer.prim - first];
    const SphereRoot which = oracle::meets_sphere(ray, sphere, ray.self == answer.prim - first);
    if (which == SphereRoot::none) return "it misses that sphere";
    const std::int64_t t = answer.t;
    const auto slack = std::int64_t(std::ceil(sphere_error(ray, sphere, c)));
    const bool beyond = t == max_ticks(c);
    if (!beyond && !oracle::reaches_sphere(ray, sphere, which, t, tick_bits(c)))
        return "t is before the sphere";
    if (t > slack && oracle::reaches_sphere(ray, sphere, which, t - slack - 1, tick_bits(c)))
        return "t is farther behind the sphere's than it may be rounded";
    if (sphere_is_sooner(nearest, solids, ray, c, double(t))) return "another sphere is closer";
    if (nearest.flat.primitive != no_primitive) {
        const int order =
            oracle::compare_fractions(nearest.flat.num, nearest.flat.den, t, Int128(1) << tick_bits(c));
        if (order < 0 || (order == 0 && nearest.flat.primitive < answer.prim))
            return "another primitive is closer";
    }
    if (answer.u != 0 || answer.v != 0) return "a sphere has no u and v";
    if (c.shading && (answer.back != 0) != (which == SphereRoot::far)) return "it meets the other side";
    return nullptr;
}

/// True if the answer holds more than hit or miss.
bool says_more(const Closest& answer) {
    return answer.prim || answer.t || answer.u || answer.v || answer.back;
}

/// Judges an answer to a ray to or from a light, if it reports no cut-out.
const char* judge_way(bool is_blocked, const Closest& answer) {
    if (is_blocked != (answer.found != 0)) return is_blocked ? "its way is blocked" : "its way is free";
    return says_more(answer) ? "more is said of a shadow ray than yes or no" : nullptr;
}

/// True if a triangle may lie in the way to a light without contradiction to an answer that reports no
/// cut-out. If the answer is "blocked", an opaque primitive must lie in the way, so any triangle with holes
/// may. If it is "free", only triangles whose holes the light has passed may lie in the way. `primitive`: the
/// number in the scene.
bool lets_pass(const Cutouts& cutouts, const Closest& answer, std::uint32_t primitive) {
    return cutouts.has_holes(primitive) && (answer.found != 0 || cutouts.is_passed(primitive));
}

/// Judges a cut-out that was reported in the way to or from a light. `hit`: the oracle's.
const char* judge_cutout(const std::optional<FlatHit>& hit, bool ends, const Config& c,
                         const Closest& answer) {
    if (!hit) return "it misses that primitive";
    if (ends && hit->num * (Int128(1) << c.origin_frac()) >= hit->den)
        return "a cut-out behind the end of its ray is reported";
    return judge_values(*hit, c, answer);
}

const char* no_place(const Closest& answer) {
    return answer.instance_line ? "an instance is told where nothing is met" : nullptr;
}

}   // namespace

SolidRay solid_ray(const Ray& ray, const Config& c) {
    const auto kind = ray.kind;
    SolidRay r{ray.o, c.origin_frac(), ray.d, no_primitive, ray.is_inside != 0};
    if (ray.is_partial != 0 && ends_at_any(ray.kind)) r.targets = SolidRay::Targets::bounded;
    // The origin of a bounce from beyond the lattice has lost bits: docs/proofs/origins.md.
    if (ray.is_partial != 0 && kind == RayKind::bounce) {
        r.targets = SolidRay::Targets::planes;
        r.frac -= light_reach + 1;
    }
    if (kind != RayKind::camera && !c.is_stream()) r.self = ray.self;   // a stream names no surfaces
    if (kind == RayKind::shadow) {
        for (std::int32_t& o : r.origin) o >>= c.origin_frac();
        r.frac = 0;
    }
    return r;
}

const char* judge_answer(const Solids& solids, const Config& c, const Ray& ray, const Closest& answer,
                         const Cutouts* cutouts) {
    const SolidRay r = solid_ray(ray, c);
    if (ends_at_any(ray.kind)) {
        const bool is_shadow = ray.kind == RayKind::shadow;
        if (answer.cutout) {
            if (answer.prim >= solids.all().size() || !cutouts || !cutouts->has_holes(answer.prim))
                return "there is no such cut-out";
            return judge_cutout(solids.flat_hit(r, answer.prim), is_shadow, c, answer);
        }
        oracle::LetsPass passes;
        if (cutouts) passes = [&](const FlatHit& hit) { return lets_pass(*cutouts, answer, hit.primitive); };
        return judge_way(is_shadow ? solids.blocks(r, c.origin_frac(), passes) : solids.meets_any(r, passes),
                         answer);
    }
    if (answer.cutout) return "a cut-out is reported for a ray that does not test a light";
    const Nearest nearest = solids.nearest(r);
    if (!answer.found) {
        if (nearest.flat.primitive != no_primitive || nearest.sphere.primitive != no_primitive)
            return "it meets something";
        return says_more(answer) ? "more is said of a miss than that it is one" : nullptr;
    }
    if (answer.prim >= solids.all().size()) return "there is no such primitive";
    return solids.all()[answer.prim].shape == Solid::Shape::sphere
               ? judge_sphere(nearest, solids, 0, r, c, answer)
               : judge_flat(nearest, solids, r, c, answer);
}

namespace {

/// Judges an answer that names a sphere.
const char* judge_placed_sphere(const oracle::PlacedHit& nearest, const oracle::PlacedSolids& solids,
                                std::uint32_t place, const oracle::PlacedRay& ray, const Config& c,
                                const Closest& answer) {
    Nearest seen{nearest.hit, nearest.sphere};
    if (nearest.place != oracle::PlacedRay::nowhere)
        seen.flat.primitive += solids.places()[nearest.place].first;
    return judge_sphere(seen, solids.mesh_of(place), solids.places()[place].first, solids.seen_by(place, ray),
                        c, answer);
}

/// Judges an answer that names a triangle or plane.
const char* judge_placed_flat(const oracle::PlacedHit& nearest, const oracle::PlacedSolids& solids,
                              std::uint32_t place, const oracle::PlacedRay& ray, const Config& c,
                              const Closest& answer) {
    const std::uint32_t number = answer.prim - solids.places()[place].first;
    if (nearest.place != place || nearest.hit.primitive != number)
        return solids.mesh_of(place).flat_hit(solids.seen_by(place, ray), number)
                   ? "another primitive is closer"
                   : "it misses that primitive";
    const std::uint32_t round = nearest.sphere_place;
    if (round != oracle::PlacedRay::nowhere &&
        sphere_is_sooner({nearest.hit, nearest.sphere}, solids.mesh_of(round), solids.seen_by(round, ray), c,
                         ticks_of(nearest.hit, c)))
        return "a sphere is closer";
    return judge_values(nearest.hit, c, answer);
}

}   // namespace

const char* judge_answer(const PlacedWorld& world, const Config& c, const Ray& ray, const Closest& answer,
                         const Cutouts* cutouts) {
    constexpr std::uint32_t nowhere = oracle::PlacedRay::nowhere;
    const oracle::PlacedRay r = world.ray(ray);
    const oracle::PlacedSolids& solids = world.solids();
    if (ends_at_any(ray.kind)) {
        const bool is_shadow = ray.kind == RayKind::shadow;
        if (answer.cutout) {
            const std::uint32_t place = world.place_of(answer.prim);
            if (place == nowhere) return "there is no such cut-out";
            if (answer.instance_line != world.line(place)) return "it meets another instance";
            return judge_cutout(solids.mesh_of(place).flat_hit(solids.seen_by(place, r),
                                                               answer.prim - solids.places()[place].first),
                                is_shadow, c, answer);
        }
        oracle::PlaceLetsPass passes;
        if (cutouts)
            passes = [&](std::uint32_t place, const FlatHit& hit) {
                return lets_pass(*cutouts, answer, solids.places()[place].first + hit.primitive);
            };
        const bool is_blocked =
            (is_shadow ? solids.blocks(r, c.origin_frac(), passes) : solids.meets_any(r, passes)) != nowhere;
        const char* const wrong = judge_way(is_blocked, answer);
        if (wrong || !is_blocked) return wrong ? wrong : no_place(answer);
        const std::uint32_t place = world.place_at(answer.instance_line);
        return place != nowhere && solids.is_met(place, r, is_shadow, c.origin_frac(), passes)
                   ? nullptr
                   : "another instance blocks its way";
    }
    if (answer.cutout) return "a cut-out is reported for a ray that does not test a light";
    const oracle::PlacedHit nearest = solids.nearest(r);
    if (!answer.found) {
        if (!nearest.is_none()) return "it meets something";
        return says_more(answer) ? "more is said of a miss than that it is one" : no_place(answer);
    }
    const std::uint32_t place = world.place_of(answer.prim);
    if (place == nowhere) return "there is no such primitive";
    const Solid& met = solids.mesh_of(place).all()[answer.prim - solids.places()[place].first];
    const char* const wrong = met.shape == Solid::Shape::sphere
                                  ? judge_placed_sphere(nearest, solids, place, r, c, answer)
                                  : judge_placed_flat(nearest, solids, place, r, c, answer);
    if (wrong) return wrong;
    return c.has_homes() && answer.instance_line != world.line(place) ? "it meets another instance" : nullptr;
}

}   // namespace rayclock
