#pragma once
// The work of a pass through the unit shade. shade.hpp has its timing.
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// True if a shadow ray has met a hole, and its light has passed fewer than max_holes before. The pass then
/// repeats the event `light`: it sends the ray again, and this ray ignores one more cut-out.
bool passes_hole(const PassIn& in);
/// Returns the event that a pass handles, unless meets_cutout().
ShadeEvent event_of(const PassIn& in);

/// Performs one pass of a context through the unit shade, as a pure function. It adds the contribution of the
/// last ray or surface to the sample's colour, computes the next ray or light, and decides the context's next
/// step.
///
/// Local light: ambient, Lambert, and Phong 1975. Reflection R = 2 (N . V) N - V and refraction by Snell's
/// law (Whitted 1980), with index 1 for the surrounding medium. Schlick 1994 for Fresnel's term. Unless
/// stated otherwise every product is rounded once, to nearest, halves up. Colours saturate at 1. Mirror of
/// rtl/unit/shade/pass/rc_pass.sv, latency Config::pass_latency(), one pass every shade_interval cycles.
PassOut pass(const PassIn& in, const Frame& frame, const Config& config);

}   // namespace rayclock
