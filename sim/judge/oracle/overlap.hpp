#pragma once
// Exact ray-box overlap in 64-bit integers by cross-multiplication: without division, reciprocal or rounding.
// It follows from the geometry alone and shares nothing with model/engine/bvh. Unlike fractions.hpp of the
// tests it needs no Boost and is fast enough for whole frames.
#include <array>
#include <cstdint>
#include <optional>

namespace rayclock::oracle {

/// num / den with den > 0, not reduced.
struct Fraction {
    std::int64_t num = 0, den = 1;
};
/// Compares exactly: the products have at most 126 bits.
inline bool less(const Fraction& a, const Fraction& b) {
    __extension__ using Int128 = __int128;
    return Int128(a.num) * b.den < Int128(b.num) * a.den;
}

using LatticeVec = std::array<std::int64_t, 3>;
inline LatticeVec wide(const std::array<std::int32_t, 3>& v) { return {v[0], v[1], v[2]}; }

/// Returns the point where the ray o + s d, s >= 0, enters the closed box [lo, hi]: the least such s. Returns
/// nothing if no point of the ray is in the box. Coordinates have a magnitude of at most 2^30, and components
/// of d at most 2^31, so every product fits 63 bits.
///
/// A component d_k > 0 is between the planes for s in [(lo - o) / d, (hi - o) / d]. For d_k < 0, the interval
/// is [(o - hi) / -d, (o - lo) / -d]. For d_k = 0 it is between them always or never. Intervals of a line
/// have a common point if and only if every two of them do (Helly's theorem in one dimension). The interval
/// [0, inf) is one of them. So the answer is yes if no interval begins after another one ends, which
/// cross-multiplication decides.
std::optional<Fraction> overlap(const LatticeVec& o, const LatticeVec& d, const LatticeVec& lo,
                                const LatticeVec& hi);

}   // namespace rayclock::oracle
