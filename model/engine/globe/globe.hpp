#pragma once
#include "model/engine/bvh/box.hpp"

namespace rayclock {

/// A ray as globes are tested with it; made once per ray.
struct GlobeRay {
    Vec3i o{};               ///< with B fraction bits if the chip shades
    Vec3i toward{};          ///< its direction, the largest component from 2^16 to 2^17 in size
    std::uint32_t len = 0;   ///< bits of that component as it came; as of Ray, more if the ray fills dir_bits
};
/// All components are moved by the same power of two, until the longest fills toward_bits, and rounded to
/// nearest, halves up; what would be 2^17 is one less. Mirror of rtl/engine/globe/rc_toward.sv.
GlobeRay globe_ray(const Ray& ray, const Config& config);

/// A node of globes unpacked for the model.
struct WideGlobes {
    WideNode children;   ///< no planes and exp
    std::uint32_t exp = 0;
    std::array<std::array<std::int32_t, max_width>, 3> centre{};   ///< [axis][child], from org, 2^exp steps
    std::array<std::int32_t, max_width> radius{};                  ///< likewise
};
WideGlobes widen(const GlobeNode& node, int node_width);

/// Which globes of a node a ray meets, conservative: a globe that holds a point o + s d, s > 0, of the ray is
/// never left out, and its t_near is never beyond that point. docs/globes.md has the proof.
///
/// With o rounded down to the lattice, D = org - o, e the direction (GlobeRay::toward) and q a centre, both
/// as wholes: the moment (D + 2^exp q) x e is |e| times as long as the centre is far from the ray's line. In
/// units of 2^(exp + 13), an eighth of a node's step for |e| = 2^16, rounded towards zero or further,
///     X = floor((floor((D x e) / 2^exp) + q x e) / 2^13), or -1 - X if that is negative.
/// A globe's line is met if all X < 2^17 and
///     X . X <= most = floor((8 radius + s)^2 (floor(|e|^2 / 2^18) + 1) / 2^14),
/// s = floor((floor((|D| + 2) / 2^13) + 1 + u) / 2^exp) + 3 for what rounding may have done, |D| the sum of
/// the sizes on the three axes, u = 14 if the chip shades, else 0. Half the chord is at most H, made of
/// most + 1 - X . X by root_up_table(). With the way to the centre along the ray
///     A = floor((D . e - 49 [the chip shades] 2^13) / 2^(exp + 13)) + floor((q . e) / 2^13),
/// the globe lies behind the origin if A + H < -1, or -99 if the chip shades, and t_near is
/// floor(2^(F + M - 20 - len + exp - n) K max(A - H, 0)), saturated, where K is 2^(49 + n) / |e|^2 from
/// below, by near_inverse_table(), and n such that this has 17 bits. M is ray_dir_bits() here. Mirror of
/// rtl/engine/globe/rc_globe.sv, latency Config::globe_latency() + 1, one node per cycle.
///
/// Gives the children met, bit by bit, and t_near by child.
std::uint32_t globe_children(const GlobeRay& ray, const WideGlobes& node, const Config& config,
                             std::uint32_t* t_near);
/// The unit's answer.
inline BoxRsp globe(const GlobeReq& req, const Config& config) {
    const WideGlobes wide = widen(req.node, config.node_width);
    std::array<std::uint32_t, max_width> t_near{};
    const std::uint32_t hits = globe_children({req.o, req.toward, req.len}, wide, config, t_near.data());
    return box_answer(req.ray, hits, t_near.data(), wide.children);
}

}   // namespace rayclock
