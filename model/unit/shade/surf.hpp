#pragma once
// Surfaces in a pass.
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// Handles a surface's arrival in a pass: fills the state's fields about the surface that the ray hit, and
/// returns the ambient contribution. Mirror of rtl/unit/shade/rc_surf.sv.
/// - Triangle: o = a + u (b - a) + v (c - a), exactly in its plane and strictly inside
///   (docs/proofs/origins.md). u and v have B + fine fraction bits, and o has B.
/// - Plane: the same, with u and v rounded to B fraction bits. `far` is set if o lies beyond the lattice.
///   `lost` is set if u, v or o do not fit; o is then the nearest value that does.
/// - Sphere: o is the ray at t, rounded to nearest.
///
/// With two levels all this is in the mesh's space, until transform_surface().
std::array<std::uint32_t, 3> surf(const PassIn& in, const Config& config, ShadeState& state);

/// Maps the surface to the scene's space, for two levels. o becomes `inner`, and the ray at t, rounded to
/// nearest, replaces it. The unit normal becomes A^T times itself, normalised, since n' . x' = n' . A x. View
/// and cosine follow.
void transform_surface(const PassIn& in, const Config& config, ShadeState& state);

}   // namespace rayclock
