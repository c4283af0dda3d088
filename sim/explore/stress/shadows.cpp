// Shoots secondary rays from exact hits, and compares each scheme of origins with exact visibility.
#include "sim/explore/stress/shadows.hpp"

#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/unit/tri/origin.hpp"
#include "model/unit/tri/tri.hpp"
#include "sim/judge/oracle/visibility.hpp"

namespace rayclock {

namespace {

using oracle::Corners;
using oracle::Int128;
using oracle::Visibility;

PrimData prim_of(const Corners& t, std::uint32_t number) { return {t.a, t.b, t.c, number}; }

template <class Number> glm::dvec3 vector(const std::array<Number, 3>& v) {
    return {double(v[0]), double(v[1]), double(v[2])};
}
int largest(const Vec3i& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// The hit of a camera ray.
struct CameraHit {
    std::uint32_t primitive = no_primitive;
    oracle::RationalPoint at;
    glm::dvec3 near{0};   ///< approximation of `at`
    std::uint32_t u = 0, v = 0;
    int facing = 0;   ///< the side from which the ray came
};

/// A secondary ray, equal for all schemes: to a light, or along a direction.
struct Task {
    std::optional<Vec3i> light;
    Vec3i direction{};
    int facing = 0;   ///< the side on which it must leave
};

/// The origin that a scheme chooses for it.
struct ShadowStart {
    SurfacePoint at;
    std::uint32_t excluded = no_primitive;
};

}   // namespace

/// One series of rays.
class ShadowProbe {
public:
    ShadowProbe(const Shadows& world, std::uint64_t seed, const OriginScheme& scheme)
        : world_(world), scheme_(scheme), draw_(world.mesh(), world.bounds_, world.coord_bits_, seed) {
        config_.coord_bits = world.coord_bits_;
        config_.dir_bits = world.coord_bits_ + 2;
    }
    ShadowCounts run(std::uint64_t rays) {
        // The limit ends the loop for a mesh that no ray hits.
        for (std::uint64_t tries = 0; counts_.rays < rays && tries < 100 * rays && !world_.mesh().empty();
             ++tries)
            one_hit(rays);
        return counts_;
    }

private:
    const Corners& triangle(std::uint32_t number) const { return world_.mesh()[number]; }

    CameraHit first_hit() {
        const Vec3i o = draw_.camera(), at = draw_.target();
        // Components are below 2^(N+1), which fits M = N + 2 bits.
        Vec3i d = by_axis([&](std::size_t k) { return at[k] - 2 * o[k]; });
        if (largest(d) == 0) return {};
        const int room = config_.dir_bits - 1 - std::bit_width(std::uint32_t(largest(d)));
        for (auto& x : d) x *= 1 << std::max(room, 0);
        const oracle::ExactHit exact = world_.surface_.closest(o, d);
        if (exact.primitive == no_primitive) return {};
        const PrimData prim = prim_of(triangle(exact.primitive), exact.primitive);
        TriRsp rsp;
        tri_test(o, d, prim, {}, config_, rsp);
        const auto at_hit = [&](std::size_t k) {
            return Int128(o[k]) * exact.den + Int128(d[k]) * exact.num;
        };
        return {exact.primitive,
                {by_axis(at_hit), exact.den},
                vector(o) + vector(d) * (double(exact.num) / double(exact.den)),
                rsp.u,
                rsp.v,
                -side_of_direction(prim, d)};
    }

    Vec3i nearest(const CameraHit& hit) const {
        return inside_lattice(by_axis([&](std::size_t k) { return int(std::lround(hit.near[int(k)])); }),
                              config_.coord_bits);
    }

    /// Returns a ray towards a light or in its direction; nothing if the light is in the plane of the
    /// triangle.
    std::optional<Task> task(const CameraHit& hit, const PrimData& prim) {
        const Vec3i from = nearest(hit), lamp = draw_.light(triangle(hit.primitive), from);
        const bool endless = draw_.below(4) == 0, through = draw_.below(8) != 0;
        Task task{lamp, {}, 0};
        int side = side_of_point(prim, lamp);
        if (endless) {
            task.light.reset();
            task.direction = by_axis([&](std::size_t k) { return (lamp[k] - from[k]) * 2; });
            side = side_of_direction(prim, task.direction);
        }
        if (side == 0) return std::nullopt;
        // A light on the other side is in the surface's own shadow, unless the ray is refracted.
        task.facing = side != hit.facing && through ? side : hit.facing;
        return task;
    }

    /// Shoots up to four rays from the hit of one camera ray.
    void one_hit(std::uint64_t rays) {
        const CameraHit hit = first_hit();
        if (hit.primitive == no_primitive) return;
        const PrimData prim = prim_of(triangle(hit.primitive), hit.primitive);
        for (int i = 0; i < 4 && counts_.rays < rays; ++i)
            if (const std::optional<Task> to = task(hit, prim)) one_ray(hit, prim, *to);
    }

    void one_ray(const CameraHit& hit, const PrimData& prim, const Task& to) {
        ++counts_.rays;
        const int side = to.light ? side_of_point(prim, *to.light) : side_of_direction(prim, to.direction);
        const ShadowStart start = begin(hit, prim, to.facing);
        const bool blocked = side != to.facing || is_blocked(start, to);
        const Visibility::Answer at_hit =
            truth({hit.at, to.light, to.direction}, hit.primitive, to.facing, hit.near);
        const oracle::RationalPoint own{{start.at.at[0], start.at.at[1], start.at.at[2]},
                                        Int128(1) << start.at.frac_bits};
        // Only a point of the surface may replace the hit.
        if (scheme_.method != OriginScheme::Method::surface ||
            !oracle::in_plane(own, triangle(hit.primitive)))
            return judge(blocked, at_hit);
        const Visibility::Answer at_own =
            truth({own, to.light, to.direction}, hit.primitive, to.facing, place(start.at));
        judge(blocked, at_own);
        if (at_own == Visibility::Answer::either || blocked == (at_own == Visibility::Answer::blocked))
            judge_moved(blocked, at_hit);
    }
    void judge(bool blocked, Visibility::Answer answer) {
        counts_.either += answer == Visibility::Answer::either;
        counts_.false_shadows += blocked && answer == Visibility::Answer::free;
        counts_.light_leaks += !blocked && answer == Visibility::Answer::blocked;
    }
    void judge_moved(bool blocked, Visibility::Answer answer) {
        counts_.moved_shadows += blocked && answer == Visibility::Answer::free;
        counts_.moved_leaks += !blocked && answer == Visibility::Answer::blocked;
    }

    ShadowStart begin(const CameraHit& hit, const PrimData& prim, int facing) const {
        using Method = OriginScheme::Method;
        const int bits = scheme_.frac_bits;
        if (scheme_.method == Method::surface)
            return {surface_point(prim, inner_weights(hit.u, hit.v, config_.bary_bits, bits), bits),
                    no_primitive};
        if (scheme_.method == Method::epsilon) return {lifted(hit, prim, facing), no_primitive};
        Vec3i at = nearest(hit);
        if (scheme_.method == Method::pushed) push(at, prim, facing);
        return {{{at[0], at[1], at[2]}, 0},
                scheme_.method == Method::excluded ? hit.primitive : no_primitive};
    }
    static glm::dvec3 normal(const PrimData& t) {
        return glm::cross(vector(t.b) - vector(t.a), vector(t.c) - vector(t.a));
    }
    static void push(Vec3i& at, const PrimData& prim, int facing) {
        const glm::dvec3 n = normal(prim), size = glm::abs(n);
        const int main = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        while (side_of_point(prim, at) != facing)
            at[std::size_t(main)] += (n[main] > 0) == (facing > 0) ? 1 : -1;
    }
    SurfacePoint lifted(const CameraHit& hit, const PrimData& prim, int facing) const {
        const glm::dvec3 n = normal(prim);
        const double step = facing * 1e-4 * double(1 << config_.coord_bits);
        const glm::dvec3 at = (hit.near + step * n / glm::length(n)) * double(1 << max_origin_bits);
        return {{std::llround(at.x), std::llround(at.y), std::llround(at.z)}, max_origin_bits};
    }

    static glm::dvec3 place(const SurfacePoint& at) {
        return vector(at.at) / double(std::int64_t(1) << at.frac_bits);
    }
    /// Returns the end of the search for triangles: the light, or a point beyond the lattice. A direction is
    /// never zero.
    glm::dvec3 end(const glm::dvec3& from, const std::optional<Vec3i>& light, const Vec3i& d) const {
        if (light) return vector(*light);
        return from + double(2 << config_.coord_bits) / double(largest(d)) * vector(d);
    }

    bool is_blocked(const ShadowStart& start, const Task& to) const {
        const Vec3l inwards = to.light ? shadow_direction(*to.light, start.at) : Vec3l{};
        bool blocked = false;
        const glm::dvec3 from = place(start.at);
        world_.surface_.along(from, end(from, to.light, to.direction), [&](std::uint32_t number) {
            if (number == start.excluded) return true;
            const PrimData prim = prim_of(triangle(number), number);
            blocked = to.light ? shadow_test(*to.light, inwards, start.at.frac_bits, prim)
                               : bounce_test(start.at, to.direction, prim).has_value();
            return !blocked;
        });
        return blocked;
    }
    Visibility::Answer truth(const oracle::Path& path, std::uint32_t primitive, int facing,
                             const glm::dvec3& from) const {
        Visibility visibility(path, triangle(primitive), facing);
        world_.surface_.along(from, end(from, path.to, path.direction),
                              [&](std::uint32_t number) { return visibility.add(triangle(number)); });
        return visibility.answer();
    }

    const Shadows& world_;
    OriginScheme scheme_;
    ShadowRays draw_;
    Config config_;
    ShadowCounts counts_;
};

std::string OriginScheme::name() const {
    switch (method) {
        case Method::excluded: return "nearest, own triangle excluded";
        case Method::pushed: return "nearest, pushed off the plane";
        case Method::epsilon: return "epsilon along the normal";
        default: return "on the surface, B = " + std::to_string(frac_bits);
    }
}

ShadowCounts& ShadowCounts::operator+=(const ShadowCounts& other) {
    rays += other.rays;
    false_shadows += other.false_shadows;
    light_leaks += other.light_leaks;
    either += other.either;
    moved_shadows += other.moved_shadows;
    moved_leaks += other.moved_leaks;
    return *this;
}

Shadows::Shadows(std::vector<oracle::Corners> mesh, int coord_bits)
    : surface_(std::move(mesh), 1), coord_bits_(coord_bits), bounds_(surface_.bounds()) {}

ShadowCounts Shadows::count(std::uint64_t seed, std::uint64_t rays, const OriginScheme& scheme) const {
    return ShadowProbe(*this, seed, scheme).run(rays);
}

ShadowCounts shadow_counts(const std::vector<oracle::Corners>& mesh, int coord_bits, std::uint64_t seed,
                           std::uint64_t rays, const OriginScheme& scheme) {
    return Shadows(mesh, coord_bits).count(seed, rays, scheme);
}

}   // namespace rayclock
