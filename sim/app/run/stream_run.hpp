#pragma once
// A simulation of a stream of rays: the runs at each clock, the exact judge's verdict, and the report. The
// command simulate and the Python module call it.
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/scene/builtin.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/stream/input.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

/// Returns the form of built-in scenes that the choice requests: true spheres if it sets spheres=1, otherwise
/// triangles.
Primitives stream_primitives(const ConfigChoice& choice);

/// Returns the configuration with the parameters that a stream through this scene needs. Throws UserError if
/// the choice contradicts them. Appends a sentence to `notes` for each setting without effect.
Config stream_config(const ConfigChoice& choice, const Scene& scene, std::vector<std::string>& notes);
/// Returns the configuration with which rays are made for a stream through this scene.
Config rays_config(const ConfigChoice& choice, const Scene& scene, std::vector<std::string>& notes);

/// The results of a stream at each clock.
struct StreamResult {
    std::vector<RecordedFrame> frames;   ///< one
    std::vector<FramesAtClock> runs;
    std::optional<StreamJudgement> judged;

    const RecordedFrame& frame() const { return frames[0]; }
    const std::vector<Closest>& answers() const { return frames[0].trace.hits; }
    bool partial() const { return runs.back().partial(); }
};
/// Runs a stream on the model at each clock. The result is partial if Ctrl-C stopped it.
StreamResult run_stream(const StreamJob& stream, const std::vector<int>& clocks, Disturbance disturbance,
                        bool is_judged, int threads, const Progress& progress);

/// Returns the report's entry for the rays of a stream, without their answers.
nlohmann::ordered_json stream_json(const StreamJob& stream);
/// Returns the part of the report that the model and lockstep share.
nlohmann::ordered_json stream_run_json(const StreamJob& stream, const std::vector<Closest>& answers,
                                       const std::vector<FramesAtClock>& runs, bool partial,
                                       const std::optional<StreamJudgement>& judged);
/// Returns the report of `simulate --rays --json`: docs/guide/streams.md.
nlohmann::ordered_json simulated_stream_json(const StreamJob& stream, const StreamResult& run, bool partial,
                                             double seconds);

}   // namespace rayclock
