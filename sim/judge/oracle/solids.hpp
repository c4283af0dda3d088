#pragma once
// Exact truth about all rays of a chip that shades: camera rays, bounces and shadow rays against triangles,
// spheres and planes. It uses integers: signed volumes, and the squared distance from a sphere's centre. It
// shares no formula with the units.
//
// A ray begins at origin / 2^frac and goes along `direction`; t counts directions. As in Surface, an origin
// moved by (e, e^2, e^3), e -> 0+, decides whether the ray crosses a triangle inside its edges. All other
// values hold for the unmoved origin, and t = 0 is not a hit.
//
// Widths: N lattice bits, M bits of a bounce's direction, B fraction bits. A shadow ray begins at a lattice
// point and has N + B + 1 bits of direction. Relative to the origin, corners are below 2^(N+B) and areas
// below 2^(2N+2B+1). Volumes with a direction are below 2^(2N+2B+M+3), and those of shadow rays below
// 2^(3N+B+5). For spheres see Ball. 128 bits hold all of these for N + B <= 31 and M <= 24.
#include <functional>
#include <optional>

#include "model/scene/hit.hpp"
#include "sim/judge/oracle/cross.hpp"
#include "sim/judge/oracle/tree.hpp"

namespace rayclock::oracle {

__extension__ using Int128 = __int128;

/// A primitive on the lattice, in the order of the scene's numbers.
struct Solid {
    enum class Shape { triangle, sphere, plane } shape = Shape::triangle;
    Corners corners;   ///< of a triangle; of a plane, a corner of a square and the two next to it
    Vec3i centre{};    ///< of a sphere
    std::int64_t radius_squared = 0;
    bool is_glass = false;    ///< of a sphere: its material transmits, so rays inside it meet it
    bool is_second = false;   ///< of a sphere: one before it has its centre and radius, and no ray meets it
};

/// A ray of the machine.
struct SolidRay {
    Vec3i origin{};
    int frac = 0;
    Vec3i direction{};
    /// The surface that the ray leaves, or at which a shadow ray ends. None: the ray comes from the eye.
    std::uint32_t self = no_primitive;
    bool inside = false;   ///< of a sphere: the ray is on its inside
    enum class Targets {
        all,
        bounded,
        planes
    } targets = Targets::all;   ///< bounded: triangles and spheres only
};

/// A hit of a triangle or a plane at t = num / den, with the weights u / total and v / total of b and c. Both
/// den and total are positive.
struct FlatHit {
    std::uint32_t primitive = no_primitive;
    Int128 num = 0, den = 1;
    Int128 u = 0, v = 0, total = 1;
    bool back = false;   ///< seen from the side to which (b - a) x (c - a) does not point
};

/// A sphere along a ray. The squared distance from the centre minus the squared radius, in units of 4^-frac,
/// is the polynomial start + 2^(frac + 1) along t + 4^frac square t^2. Its signs at integer positions decide;
/// no square root is taken. |start| < 3 4^(N+B), |along| < 3 2^(M+N+B), square < 3 4^M: disc <
/// 2^(2M+2N+2B+4). For shadow rays, with frac = 0 and N + B + 1 for M, disc is below 2^(4N+2B+6).
struct Ball {
    Int128 start, along, square;
    Int128 disc() const { return along * along - square * start; }
};
Ball ball_of(const SolidRay& ray, const Solid& sphere);

/// How a ray meets a sphere: not at all, where it enters, or where it leaves.
enum class SphereRoot { none, near, far };
SphereRoot meets_sphere(const SolidRay& ray, const Solid& sphere, bool is_self);

/// Returns t at that point, with a relative error of at most 2^-48.
double sphere_distance(const SolidRay& ray, const Solid& sphere, SphereRoot which);

/// Returns true if t = ticks / 2^tick_bits, tick_bits >= ray.frac, is that point or lies after it. Exact.
bool reaches_sphere(const SolidRay& ray, const Solid& sphere, SphereRoot which, std::int64_t ticks,
                    int tick_bits);

/// Compares num1 / den1 with num2 / den2 by continued fractions: -1 less, 0 equal, 1 greater. All numbers are
/// positive and of any size.
int compare_fractions(Int128 num1, Int128 den1, Int128 num2, Int128 den2);

/// The closest sphere of a ray; no_primitive if it meets none.
struct SphereHit {
    std::uint32_t primitive = no_primitive;
    SphereRoot which = SphereRoot::none;
    double distance = 0;
};
/// The closest triangle or plane (the lowest number of equally close ones), and the closest sphere.
struct Nearest {
    FlatHit flat;
    SphereHit sphere;
};

/// Returns true if a ray to or from a light passes through a triangle or plane at this hit.
using LetsPass = std::function<bool(const FlatHit&)>;

/// All primitives of a scene, with a search tree.
class Solids {
public:
    explicit Solids(std::vector<Solid> solids);

    const std::vector<Solid>& all() const { return solids_; }

    /// Returns the closest primitives along t > 0.
    Nearest nearest(const SolidRay& ray) const;

    /// Tests one triangle or plane. Returns nothing if the ray does not hit it.
    std::optional<FlatHit> flat_hit(const SolidRay& ray, std::uint32_t number) const;

    /// Returns true if anything is in the way at 0 < t, for rays to a light beyond the lattice.
    bool meets_any(const SolidRay& ray, const LetsPass& lets_pass = {}) const;

    /// Returns true if anything blocks a shadow ray in 0 < t < 2^-frac_end. Surfaces that hold the light or
    /// the point do not block.
    bool blocks(const SolidRay& ray, int frac_end, const LetsPass& lets_pass = {}) const;

private:
    std::vector<Solid> solids_;
    /// Primitive numbers. `bounded_` has the order of the tree's boxes.
    std::vector<std::uint32_t> planes_, bounded_;
    Tree tree_;
};

}   // namespace rayclock::oracle
