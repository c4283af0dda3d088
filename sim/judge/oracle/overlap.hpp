#pragma once
// Exact ray-box overlap in wide integers, by cross-multiplication: no division, no reciprocal, no rounding.
// Written from the geometry; shares nothing with model/engine/bvh. Unlike exact.hpp it needs no Boost and is
// fast enough for whole frames.
#include <array>
#include <cstdint>
#include <optional>

namespace rayclock::oracle {

/// num / den with den > 0, not reduced.
struct Fraction {
    std::int64_t num = 0, den = 1;
};
/// Exact; the products have at most 126 bits.
inline bool less(const Fraction& a, const Fraction& b) {
    __extension__ using Wide = __int128;
    return Wide(a.num) * b.den < Wide(b.num) * a.den;
}

using LatticeVec = std::array<std::int64_t, 3>;
inline LatticeVec wide(const std::array<std::int32_t, 3>& v) { return {v[0], v[1], v[2]}; }

/// Where the ray o + s d, s >= 0, enters the closed box [lo, hi]: the least such s, or nothing if no point of
/// the ray is in the box. Coordinates of magnitude 2^30 at most, components of d 2^31 at most, so that every
/// product has 63 bits.
///
/// A component d_k > 0 is between the planes for s in [(lo - o) / d, (hi - o) / d], d_k < 0 for s in
/// [(o - hi) / -d, (o - lo) / -d], and d_k = 0 always or never. Intervals of a line have a point in common if
/// and only if every two of them have one (Helly's theorem in one dimension), and [0, inf) is one of them. So
/// the answer is yes if no interval begins after another ends, which cross-multiplication decides.
std::optional<Fraction> overlap(const LatticeVec& o, const LatticeVec& d, const LatticeVec& lo,
                                const LatticeVec& hi);

}   // namespace rayclock::oracle
