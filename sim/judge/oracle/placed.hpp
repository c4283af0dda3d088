#pragma once
// The truth about rays in a scene of two levels: meshes in their places, each seen by the ray as it was
// rounded for it.
//
// The stated rule (docs/motion.md): o' = round(A o + b), d' = round(A d), round(y) = floor(y + 1/2), once for
// each ray and instance; in the instance that a ray leaves, o' and d' are given. What a ray then meets in
// that instance is decided by Solids, in whole numbers, and instances are compared by t as exact fractions.
// Only the rule is shared with the unit that moves rays, and no formula of it.
//
// Which instances are asked. A ray that meets a mesh at o' + s d' has o + s d in the image of the mesh's
// bounds under the map's inverse, but for r (1/2 + s/2) steps, r being the largest row of sizes of that
// inverse. As o lies in the lattice, and the largest component of d is D, s (D - r/2) is at most the farthest
// coordinate of that image plus the lattice's end plus r/2. So the image's box with a margin for that s holds
// the ray at the very s at which it meets the mesh. A ray with a shorter direction than `least`, for which
// the margins were taken, asks every instance; so does an instance that turns steps into too many, or has
// planes. All of it is worked out in whole numbers; a step is added for divisions.
#include "sim/judge/oracle/solids.hpp"

namespace rayclock::oracle {

/// A mesh in its place: 2^frac x' = a x + b.
struct SolidPlace {
    std::uint32_t mesh = 0;            ///< which Solids
    std::uint32_t first = 0;           ///< number of its first primitive
    std::array<std::int64_t, 9> a{};   ///< [3 * row + column]
    std::array<std::int64_t, 3> b{};
};

/// A ray of the scene's space, and what it is in the instance that it leaves or at which it ends.
struct PlacedRay {
    static constexpr std::uint32_t nowhere = ~0u;
    SolidRay ray;
    std::uint32_t home = nowhere;   ///< an instance
    SolidRay at_home{};
};

/// The closest triangle or plane, and the closest sphere: which of the two is closer is left open, as in
/// Nearest. `hit` and `sphere` are numbered in their meshes.
struct PlacedHit {
    std::uint32_t place = PlacedRay::nowhere;   ///< nowhere: no triangle and no plane is met
    FlatHit hit;
    std::uint32_t sphere_place = PlacedRay::nowhere;   ///< likewise
    SphereHit sphere;

    bool is_none() const { return place == PlacedRay::nowhere && sphere_place == PlacedRay::nowhere; }
};

class PlacedSolids {
public:
    /// Spheres and planes are in meshes whose maps are the identity. `frac`: of the maps; lattice coordinates
    /// and directions have so many bits.
    PlacedSolids(std::vector<Solids> meshes, std::vector<SolidPlace> places, int frac, int coord_bits,
                 int dir_bits);

    const std::vector<SolidPlace>& places() const { return places_; }
    const Solids& mesh_of(std::uint32_t place) const { return meshes_[places_[place].mesh]; }

    /// The instance of a primitive; `nowhere` if its number belongs to none.
    std::uint32_t place_of(std::uint32_t primitive) const;

    /// The ray as an instance sees it.
    SolidRay seen_by(std::uint32_t place, const PlacedRay& ray) const;

    /// Closest along t > 0; of equal triangles and planes the lowest number.
    PlacedHit nearest(const PlacedRay& ray) const;
    /// An instance that has something in the way 0 < t; `nowhere` if none has.
    std::uint32_t meets_any(const PlacedRay& ray) const;
    /// The same in the way 0 < t < 2^-frac_end of a shadow ray.
    std::uint32_t blocks(const PlacedRay& ray, int frac_end) const;
    /// The same of one instance alone: all of the way, or that of a shadow ray.
    bool is_met(std::uint32_t place, const PlacedRay& ray, bool ends, int frac_end) const;

private:
    /// Calls ask(place) until it returns false, for all instances that the ray may meet and some more.
    template <class After, class Ask>
    void each(const PlacedRay& ray, bool is_long, const After& after, const Ask& ask) const;

    std::vector<Solids> meshes_;
    std::vector<SolidPlace> places_;
    int frac_;
    std::int32_t least_;   ///< a direction's largest component, for the boxes' margins
    std::vector<std::uint32_t> boxed_, always_, empty_;   ///< places
    Tree tree_;
};

/// A v, rounded: that of a direction; with b and the fraction bits of v that of a point.
Vec3i placed_direction(const SolidPlace& place, const Vec3i& d, int frac);
Vec3i placed_point(const SolidPlace& place, const Vec3i& o, int origin_frac, int frac);

}   // namespace rayclock::oracle
