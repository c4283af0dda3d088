#pragma once
// How far a machine's picture may be from the reference's: the limits, and the one sentence that every
// command, report and page says beyond them. `verify` fails then; other commands only say it.
#include <optional>
#include <string>

#include "sim/report/json.hpp"

namespace rayclock {

/// The defaults hold for every built-in scene at its usual size on every configuration that ships
/// (docs/report.md, Limits).
struct Limits {
    double max_other = 1;         ///< pixels with another primitive, per cent
    double min_psnr = 30;         ///< dB
    double max_depth_error = 1;   ///< of any pixel's depth, per cent of the reference's
};

/// "FAR FROM THE REFERENCE: ..." with every limit that is exceeded; empty if none is.
std::string far_from_reference(const Limits& limits, const FrameError& error);
nlohmann::ordered_json limit_values_json(const Limits& limits);
/// The limits and what is beyond them; null without a comparison.
nlohmann::ordered_json limits_json(const Limits& limits, const std::optional<FrameError>& error);

}   // namespace rayclock
