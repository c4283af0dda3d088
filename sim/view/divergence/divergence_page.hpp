#pragma once
// A divergence as a sentence and as a page.
#include <string>

#include "sim/view/divergence/capture.hpp"
#include "sim/view/divergence/divergence.hpp"
#include "sim/view/divergence/source.hpp"

namespace rayclock {

/// Returns a sentence about the difference: the transfer came later, with another payload, or never.
std::string verdict_of(const Divergence& divergence);

/// Returns the page: the difference and its cycle, the link cycle by cycle on both machines, the ray's path
/// until then, and the source line that drives the link.
std::string divergence_page(const DivergedRun& diverged, const Capture& capture, const SourceLine& source,
                            const DivergenceFiles& files, const std::string& rtl_wave);

}   // namespace rayclock
