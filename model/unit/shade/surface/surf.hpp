#pragma once
// Surfaces in a pass.
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// Handles a surface's arrival in a pass: fills the state's fields about the surface that the ray hit, and
/// returns the ambient contribution, 0 if a texture follows. Mirror of rtl/unit/shade/surface/rc_surf.sv.
/// - Triangle: o = a + u (b - a) + v (c - a), exactly in its plane and strictly inside
///   (docs/proofs/origins.md). u and v have B + fine fraction bits, and o has B.
/// - Plane: the same, with u and v rounded to B fraction bits. `far` is set if o lies beyond the lattice.
///   `lost` is set if u, v or o do not fit; o is then the nearest value that does.
/// - Sphere: o is the ray at t, rounded to nearest.
///
/// With two levels all this is in the mesh's space, until transform_surface().
std::array<std::uint32_t, 3> surf(const PassIn& in, const Config& config, ShadeState& state);

/// Returns the length of the path to the hit: path + t |d|, rounded down, as in TexReq. |d| counts as its
/// largest component plus 3/8 of the second and 5/16 of the smallest, and as 1 for 2^(M-1). Its logarithm
/// errs by -0.041 to 0.155. ShadeFrame::spread is smaller by the middle of this range, length_bias. Mirror of
/// rtl/unit/shade/surface/rc_path_length.sv.
///
/// Where t is saturated on a plane, |o - in.o| replaces t |d|. The same formula gives it in units of 2^-B,
/// and it is rounded down. For a ray from beyond the lattice, in.o lacks its factor 2^far_drop and is used
/// without it. Mirror of rtl/unit/shade/surface/rc_far_path.sv. `state`: the surface.
std::uint32_t path_to(const PassIn& in, const ShadeState& state, const Config& config);

/// Returns the place (u, v) of a sphere's hit in its octahedral picture, bary_bits fraction bits. n is the
/// unit normal that points outwards. With h = 2^(bary_bits - 1) and L = |n_x| + |n_y| + |n_z| + 1,
///     p = floor(h |n_x| / L), q = floor(h |n_z| / L); if n_y < 0, (p, q) = (h - q, h - p)
/// u is h + p, or h - p if n_x < 0; v is h + q, or h - q if n_z < 0. The 1 in L keeps both quotients below h.
/// Mirror of rtl/unit/shade/surface/rc_octahedral.sv.
std::array<std::uint32_t, 2> octahedral(const ShadeState& state, const Config& config);

/// Multiplies the albedo by a texture's colour, and returns the ambient contribution.
std::array<std::uint32_t, 3> apply_texture(const std::array<std::uint32_t, 3>& texel, ShadeState& state);

/// Returns the contribution of ambient light. `share`: the surface's weight for it.
std::array<std::uint32_t, 3> ambient_light(const ShadeState& state, std::uint32_t share);

/// Maps the surface to the scene's space, for two levels. o becomes `inner`, and the ray at t, rounded to
/// nearest, replaces it. The unit normal becomes A^T times itself, normalised, since n' . x' = n' . A x. View
/// and cosine follow.
void transform_surface(const PassIn& in, const Config& config, ShadeState& state);

}   // namespace rayclock
