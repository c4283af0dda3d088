#pragma once
// Limits for the difference between a machine's picture and the reference, and the sentence for pictures
// beyond them. Every command, report and page prints this sentence. Only `verify` fails as well.
#include <string>
#include <vector>

#include "sim/view/report/json.hpp"

namespace rayclock {

/// The default limits hold for every built-in scene at its usual size on every shipped configuration
/// (docs/guide/report.md, Limits).
struct Limits {
    double max_other = 1;         ///< pixels with another primitive, in percent
    double min_psnr = 30;         ///< dB
    double max_depth_error = 1;   ///< error of any pixel's depth, in percent of the reference's
};

/// Returns "FAR FROM THE REFERENCE: ..." with every exceeded limit; empty if no limit is exceeded.
std::string far_from_reference(const Limits& limits, const FrameError& error);

/// The error of one of several pictures, with a name such as "frame 3" or "coord_bits 12".
struct NamedError {
    std::string name;
    FrameError error;
};
/// Returns the sentence of the worst PSNR among the far pictures: "FAR ... (frame 3; 2 of 8 frames are far)".
/// Empty if no picture is far. `all` is the number of pictures, `what` their plural noun.
std::string far_from_reference(const Limits& limits, const std::vector<NamedError>& errors, std::size_t all,
                               const char* what);
/// Returns the sentence for a film's frames. A single frame gets its own sentence without a count.
std::string far_frames(const Limits& limits, const std::vector<FrameError>& frames);

nlohmann::ordered_json limit_values_json(const Limits& limits);
/// Returns the limits and those that any frame exceeds; null without a comparison.
nlohmann::ordered_json limits_json(const Limits& limits, const std::vector<FrameError>& frames);

}   // namespace rayclock
