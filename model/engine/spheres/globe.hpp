#pragma once
// The unit globe: nodes with bounding spheres.
#include "model/engine/node_answer.hpp"
#include "model/engine/spheres/node.hpp"

namespace rayclock {

/// A ray in the form of the globe test; computed once per ray.
struct GlobeRay {
    Vec3i o{};        ///< with B fraction bits if the chip shades
    Vec3i toward{};   ///< its direction, with the absolute value of the largest component in 2^16..2^17
    /// Bits of that component before scaling; as in Ray, more if the ray fills dir_bits.
    std::uint32_t len = 0;
};
/// Returns the ray of a globe test. It shifts all components by the same amount, until the longest fills
/// toward_bits, and rounds to nearest, halves up. 2^17 becomes one less. Mirror of
/// rtl/engine/spheres/rc_globe_ray.sv.
GlobeRay globe_ray(const Ray& ray, const Config& config);

/// A node of globes unpacked for the model.
struct WideGlobes {
    WideNode children;   ///< planes and exp are unused
    std::uint32_t exp = 0;
    /// [axis][child]: centre from org, in steps of 2^exp.
    std::array<std::array<std::int32_t, max_width>, 3> centre{};
    std::array<std::int32_t, max_width> radius{};   ///< [child], in steps of 2^exp
};
WideGlobes widen(const GlobeNode& node, int node_width);

/// Returns the globes of a node that a ray meets, conservatively. It never leaves out a globe that holds a
/// point o + s d, s > 0, of the ray, and the globe's t_near is never beyond that point. docs/proofs/globes.md
/// has the proof.
///
/// Let o be rounded down to the lattice, D = org - o, e the direction (GlobeRay::toward) and q a centre, both
/// integers. The moment (D + 2^exp q) x e has |e| times the length of the centre's distance from the ray's
/// line. In units of 2^(exp + 13), an eighth of a node's step for |e| = 2^16, rounded towards zero or
/// further,
///         X = floor((floor((D x e) / 2^exp) + q x e) / 2^13), or -1 - X if that is negative.
/// The ray's line meets a globe if all X < 2^17 and
///         X . X <= most = floor((8 radius + s)^2 (floor(|e|^2 / 2^18) + 1) / 2^14),
/// where s = floor((floor((|D| + 2) / 2^13) + 1 + u) / 2^exp) + 3 covers rounding. |D| is the sum of the
/// absolute values on the three axes; u = 14 if the chip shades, else 0. Half the chord is at most H, which
/// root_up_table() gives for most + 1 - X . X. The way to the centre along the ray is
///         A = floor((D . e - 49 [the chip shades] 2^13) / 2^(exp + 13)) + floor((q . e) / 2^13).
/// The globe lies behind the origin if A + H < -1, or -99 if the chip shades. t_near is
///         floor(2^(F + M - 20 - len + exp - n) K max(A - H, 0)),
/// saturated, where K is 2^(49 + n) / |e|^2 from below, by near_inverse_table(), and n makes K 17 bits long.
/// M is ray_dir_bits() here. Mirror of rtl/engine/spheres/rc_globe.sv, latency spheres::Engine::latency() +
/// 1, one node per cycle.
///
/// Returns the children met, one bit each, and writes t_near by child.
std::uint32_t globe_children(const GlobeRay& ray, const WideGlobes& node, const Config& config,
                             std::uint32_t* t_near);
/// Returns the unit's answer.
inline NodeAnswer globe(const GlobeReq& req, const Config& config) {
    const WideGlobes wide = widen(req.node, config.node_width);
    std::array<std::uint32_t, max_width> t_near{};
    const std::uint32_t hits = globe_children({req.o, req.toward, req.len}, wide, config, t_near.data());
    return node_answer(req.ray, hits, t_near.data(), wide.children);
}

}   // namespace rayclock
