#pragma once
// The explanation of a pixel or of a stream's ray, and its report. The command explain and the Python module
// call it.
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/app/run/pixel_findings.hpp"
#include "sim/run/film/film.hpp"
#include "sim/run/stream/input.hpp"

namespace rayclock {

/// The way in which a pixel is explained.
struct ExplainSettings {
    Disturbance disturbance{};
    std::string clock = "66";   ///< MHz, or fmax
    bool is_compared = true;    ///< with the reference
    bool is_judged = true;      ///< by the exact judge; needs is_compared
    int threads = 0;
};
/// Runs all frames of the film. Calls `use` with the explanation of a pixel of the last frame, and with that
/// frame's errors if it was compared. Throws UserError, and Interrupted after Ctrl-C.
void explain_pixel(Film& film, std::size_t pixel, const ExplainSettings& how, const Progress& progress,
                   const std::function<void(const Explanation&, const std::vector<FrameError>&)>& use);

/// Traces a stream of rays. Calls `use` with the explanation of one of its rays. `how` compares nothing.
/// Throws UserError, and Interrupted after Ctrl-C.
void explain_ray(const StreamInput& input, const Config& config, std::size_t ray, const ExplainSettings& how,
                 const Progress& progress,
                 const std::function<void(const Explanation&, const StreamJob&)>& use);
/// Returns the report of `explain --rays --json`: docs/guide/report.md.
nlohmann::ordered_json explained_ray_json(const StreamJob& stream, const Explanation& e);

/// Returns the report of `explain --json`: docs/guide/report.md.
nlohmann::ordered_json explanation_json(const Request& request, const FrameSize& size, const Explanation& e,
                                        const nlohmann::ordered_json& limits);

}   // namespace rayclock
