#pragma once
// The truth about any ray of a chip that shades: camera rays, bounces, shadow rays; triangles, spheres and
// planes. In exact integers, by signed volumes and by the square of the distance from a sphere's centre;
// shares no formula with the units.
//
// A ray begins at origin / 2^frac and goes along `direction`, t being counted in directions. As for Surface,
// whether a triangle is crossed inside its edges is decided for an origin that is moved by (e, e^2, e^3), e
// -> 0+; everything else holds for the origin as it stands, and t = 0 is no hit.
//
// Widths. N lattice bits, M of a bounce's direction, B fraction bits; a shadow ray begins at a lattice point
// and has N + B + 1 bits of direction. Relative to the origin corners are below 2^(N+B), areas below
// 2^(2N+2B+1), volumes with a direction below 2^(2N+2B+M+3); of shadow rays below 2^(3N+B+5). Of spheres see
// Ball. 128 bits hold all for N + B <= 31 and M <= 24.
#include <optional>

#include "sim/judge/oracle/cross.hpp"
#include "sim/judge/oracle/tree.hpp"
#include "model/scene/hit.hpp"

namespace rayclock::oracle {

__extension__ using Int128 = __int128;

/// A primitive on the lattice, in the order of the scene's numbers.
struct Solid {
    enum class Kind { triangle, sphere, plane } kind = Kind::triangle;
    Corners corners;   ///< a triangle's; of a plane a corner of a square and the two next to it
    Vec3i centre{};    ///< of a sphere
    std::int64_t radius_squared = 0;
    bool is_glass = false;   ///< of a sphere: its material transmits, so rays inside it meet it
};

struct SolidRay {
    Vec3i origin{};
    int frac = 0;
    Vec3i direction{};
    std::uint32_t self = no_primitive;   ///< the surface that it leaves, or at which a shadow ray ends; none:
                                         ///< from the eye
    bool inside = false;                 ///< of a sphere: the ray is on its inside
    enum class Asks { all, bounded, planes } asks = Asks::all;   ///< bounded: what has an end, no plane
};

/// Where a triangle or a plane is hit: at t = num / den, with weights u / total and v / total of b and c. den
/// and total are positive.
struct FlatHit {
    std::uint32_t primitive = no_primitive;
    Int128 num = 0, den = 1;
    Int128 u = 0, v = 0, total = 1;
    bool back = false;   ///< seen from the side to which (b - a) x (c - a) does not point
};

/// Sphere and ray: the square of the distance from the centre less the square of the radius, in units of
/// 4^-frac, is the polynomial start + 2^(frac + 1) along t + 4^frac square t^2. Its signs at whole places
/// decide; no root is taken. |start| < 3 4^(N+B), |along| < 3 2^(M+N+B), square < 3 4^M: disc <
/// 2^(2M+2N+2B+4); of shadow rays, with frac = 0 and N + B + 1 for M, below 2^(4N+2B+6).
struct Ball {
    Int128 start, along, square;
    Int128 disc() const { return along * along - square * start; }
};
Ball ball_of(const SolidRay& ray, const Solid& sphere);

/// How a sphere is met: not, where the ray goes in, or where it goes out.
enum class Meets { no, near, far };
Meets meets_sphere(const SolidRay& ray, const Solid& sphere, bool is_self);

/// The distance of that place in directions, to a relative error of 2^-48.
double sphere_distance(const SolidRay& ray, const Solid& sphere, Meets which);

/// Whether t = ticks / 2^tick_bits, tick_bits >= ray.frac, is the place itself or lies after it. Exact.
bool reaches_sphere(const SolidRay& ray, const Solid& sphere, Meets which, std::int64_t ticks, int tick_bits);

/// num1 / den1 < num2 / den2 is -1, equal 0, greater 1; all are positive and of any size: by continued
/// fractions.
int compare_fractions(Int128 num1, Int128 den1, Int128 num2, Int128 den2);

struct SphereHit {
    std::uint32_t primitive = no_primitive;
    Meets which = Meets::no;
    double distance = 0;
};
/// What a ray may meet first: the closest triangle or plane, of equal ones the lowest number, and the closest
/// sphere.
struct Nearest {
    FlatHit flat;
    SphereHit sphere;
};

class Solids {
public:
    explicit Solids(std::vector<Solid> solids);

    const std::vector<Solid>& all() const { return solids_; }

    Nearest nearest(const SolidRay& ray) const;

    /// A triangle or plane alone; nothing if it is not hit.
    std::optional<FlatHit> flat_hit(const SolidRay& ray, std::uint32_t number) const;

    /// Anything is in the way 0 < t: for rays to a light beyond the lattice.
    bool meets_any(const SolidRay& ray) const;

    /// Anything is in the way 0 < t < 2^-frac_end of a shadow ray; what holds the light or the point is not.
    bool blocks(const SolidRay& ray, int frac_end) const;

private:
    std::vector<Solid> solids_;
    std::vector<std::uint32_t> planes_, bounded_;   ///< numbers; bounded_: by the tree's boxes
    Tree tree_;
};

}   // namespace rayclock::oracle
