#pragma once
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// One pass of a context through the unit shade: a pure function. Adds what the last ray or surface gives to
/// the sample's colour, works out the next ray or light, and says what the context does next.
///
/// Local light: ambient, Lambert, and Phong 1975. Reflection R = 2 (N . V) N - V and refraction by Snell's
/// law (Whitted 1980), the surrounding medium's index being 1; Schlick 1994 for Fresnel's term. Every product
/// is rounded once, to nearest, halves up, unless said otherwise; colours saturate at 1. Mirror of
/// rtl/unit/shade/rc_shade.sv, latency Config::shade_latency() + 1, one pass every shade_interval cycles.
PassOut pass(const PassIn& in, const Frame& frame, const Config& config);

}   // namespace rayclock
