#pragma once
// A divergence as a sentence and as a page.
#include <string>

#include "sim/view/divergence/capture.hpp"
#include "sim/view/divergence/divergence.hpp"
#include "sim/view/divergence/source.hpp"

namespace rayclock {

/// What differs, in a sentence: whether it came later, with another payload, or never.
std::string verdict_of(const Divergence& divergence);

/// The page: what differs and when, the link cycle by cycle on both machines, what its ray did until then,
/// and the line of the source that drives it.
std::string divergence_page(const Diverged& diverged, const Capture& capture, const SourceLine& source,
                            const DivergenceFiles& files, const std::string& rtl_wave);

}   // namespace rayclock
