#pragma once
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// The part of a pass that a surface's arrival takes: fills the state's fields about the surface that the ray
/// hit, and gives what the surrounding light adds. Mirror of rtl/unit/shade/rc_surf.sv.
///
/// Triangle: o = a + u (b - a) + v (c - a), exactly in its plane and strictly inside (docs/origins.md);
/// u and v have B + fine fraction bits, and o has B. Plane: the same, u and v
/// rounded to B fraction bits; `far` if o lies beyond the lattice, `lost` if u, v or o do not fit, and o then
/// is the nearest that does. Sphere: o = the ray at t, rounded to nearest.
///
/// With two levels all this is in the mesh's space, until turn_surface().
std::array<std::uint32_t, 3> surf(const PassIn& in, const Config& config, ShadeState& state);

/// With two levels: o becomes `inner`, and the ray at t takes its place, rounded to nearest; the unit normal
/// becomes A^T times it, unit again, since n' . x' = n' . A x; view and cosine follow.
void turn_surface(const PassIn& in, const Config& config, ShadeState& state);

}   // namespace rayclock
