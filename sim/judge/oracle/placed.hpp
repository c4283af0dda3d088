#pragma once
// Exact truth about rays in a scene of two levels: placed meshes, each hit by the ray that was rounded for
// it.
//
// The rule (docs/machine/motion.md) is o' = round(A o + b), d' = round(A d), round(y) = floor(y + 1/2), once
// for each ray and instance. In the instance that a ray leaves, o' and d' are given. Solids decides in
// integers what the ray meets in an instance. Instances are compared by t as exact fractions. It shares this
// rule with the unit that transforms rays, but none of the unit's formulas.
//
// The search for instances is conservative. Let r be the largest row sum of magnitudes of the map's inverse.
// If a ray meets a mesh at o' + s d', consider o + s d. It lies in the image of the mesh's bounds under the
// inverse, except for r (1/2 + s/2) steps. Let D be the largest component of d. As o lies in the lattice, s
// (D - r/2) is at most the farthest coordinate of that image plus the lattice's end plus r/2. So the image's
// box, with a margin for that s, holds the ray at exactly the s at which it meets the mesh.
//
// The margins are computed for directions of at least `least`. A ray with a shorter direction tests every
// instance. All rays test an instance whose map is too coarse for a margin, or that has planes. All of this
// uses integers; one step is added for divisions.
#include "sim/judge/oracle/solids.hpp"

namespace rayclock::oracle {

/// A placed mesh: 2^frac x' = a x + b.
struct SolidPlace {
    std::uint32_t mesh = 0;            ///< index of its Solids
    std::uint32_t first = 0;           ///< number of its first primitive
    std::array<std::int64_t, 9> a{};   ///< [3 * row + column]
    std::array<std::int64_t, 3> b{};
};

/// A ray in the scene's space, and the same ray in the instance that it leaves or at which it ends.
struct PlacedRay {
    static constexpr std::uint32_t nowhere = ~0u;
    SolidRay ray;
    std::uint32_t home = nowhere;   ///< an instance, or nowhere
    SolidRay at_home{};
};

/// The closest triangle or plane, and the closest sphere. It does not decide which of the two is closer;
/// neither does Nearest. `hit` and `sphere` use the primitive numbers of their meshes.
struct PlacedHit {
    std::uint32_t place = PlacedRay::nowhere;   ///< nowhere: the ray meets neither a triangle nor a plane
    FlatHit hit;
    std::uint32_t sphere_place = PlacedRay::nowhere;   ///< nowhere: the ray meets no sphere
    SphereHit sphere;

    bool is_none() const { return place == PlacedRay::nowhere && sphere_place == PlacedRay::nowhere; }
};

/// Returns true if a ray to or from a light passes through a triangle or plane of an instance at this hit.
using PlaceLetsPass = std::function<bool(std::uint32_t place, const FlatHit&)>;

/// All instances of a scene, with a search tree over their boxes.
class PlacedSolids {
public:
    /// Builds the tree. Meshes with spheres and planes must have the identity as their map. `frac` is the
    /// number of fraction bits of the maps. `coord_bits` and `dir_bits` are the widths of lattice coordinates
    /// and directions.
    PlacedSolids(std::vector<Solids> meshes, std::vector<SolidPlace> places, int frac, int coord_bits,
                 int dir_bits);

    const std::vector<SolidPlace>& places() const { return places_; }
    const Solids& mesh_of(std::uint32_t place) const { return meshes_[places_[place].mesh]; }

    /// Returns the instance of a primitive, or `nowhere` if the number belongs to none.
    std::uint32_t place_of(std::uint32_t primitive) const;

    /// Returns the ray in the space of an instance.
    SolidRay seen_by(std::uint32_t place, const PlacedRay& ray) const;

    /// Returns the closest hit along t > 0. Of equally close triangles and planes it takes the lowest number.
    PlacedHit nearest(const PlacedRay& ray) const;
    /// Returns an instance that the ray meets at 0 < t, or `nowhere` if it meets none.
    std::uint32_t meets_any(const PlacedRay& ray, const PlaceLetsPass& lets_pass = {}) const;
    /// Returns an instance that blocks a shadow ray in 0 < t < 2^-frac_end, or `nowhere`.
    std::uint32_t blocks(const PlacedRay& ray, int frac_end, const PlaceLetsPass& lets_pass = {}) const;
    /// Decides the same for one instance: at any t > 0, or in the range of a shadow ray if `ends`.
    bool is_met(std::uint32_t place, const PlacedRay& ray, bool ends, int frac_end,
                const PlaceLetsPass& lets_pass = {}) const;

private:
    /// Calls ask(place) for all instances that the ray may meet, and some more, until it returns false.
    template <class After, class Ask>
    void each(const PlacedRay& ray, bool is_long, const After& after, const Ask& ask) const;

    std::vector<Solids> meshes_;
    std::vector<SolidPlace> places_;
    int frac_;
    std::int32_t least_;   ///< the least largest component of a direction for which the margins hold
    /// Numbers of the instances in the tree, of those without a box, and of those that are never met.
    std::vector<std::uint32_t> boxed_, always_, empty_;
    Tree tree_;
};

/// placed_direction() returns A v, rounded. placed_point() adds b, for a point with `origin_frac` fraction
/// bits.
Vec3i placed_direction(const SolidPlace& place, const Vec3i& d, int frac);
Vec3i placed_point(const SolidPlace& place, const Vec3i& o, int origin_frac, int frac);

}   // namespace rayclock::oracle
