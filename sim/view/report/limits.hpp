#pragma once
// How far a machine's picture may be from the reference's: the limits, and the one sentence that every
// command, report and page says beyond them. `verify` fails then; other commands only say it.
#include <string>
#include <vector>

#include "sim/view/report/json.hpp"

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

/// One of several pictures: "frame 3", "coord_bits 12".
struct NamedError {
    std::string name;
    FrameError error;
};
/// Of several pictures the sentence of the one with the least PSNR among those that are far, its name and how
/// many are far: "FAR ... (frame 3; 2 of 8 frames are far)". Empty if none is. `all`: how many `what` there
/// are.
std::string far_from_reference(const Limits& limits, const std::vector<NamedError>& errors, std::size_t all,
                               const char* what);
/// A film's frames; of a single frame its sentence alone.
std::string far_frames(const Limits& limits, const std::vector<FrameError>& frames);

nlohmann::ordered_json limit_values_json(const Limits& limits);
/// The limits and what is beyond them in any frame; null without a comparison.
nlohmann::ordered_json limits_json(const Limits& limits, const std::vector<FrameError>& frames);

}   // namespace rayclock
