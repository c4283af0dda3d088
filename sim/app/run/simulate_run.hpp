#pragma once
// A simulation and its report: runs the frames of a scene at each clock, compares the last one with the
// reference and judges it. The command simulate and the Python module call it.
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/trace/hits.hpp"
#include "sim/app/run/film_strip.hpp"
#include "sim/app/run/frame_comparison.hpp"
#include "sim/run/film/film.hpp"
#include "sim/run/request/tracer.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock {

/// The way in which a simulation runs.
struct SimulateSettings {
    Tracer tracer = Tracer::model;   ///< the model or the RTL
    Disturbance disturbance{};       ///< disturbances of memory and sink
    std::uint64_t seed = 1;          ///< of the RTL's uninitialised registers
    bool is_compared = true;         ///< the last frame with the reference
    bool is_judged = true;           ///< by the exact judge; needs is_compared
    int threads = 0;                 ///< 0: one per core
    double pan = 0;                  ///< degrees that the camera turns from frame to frame, for the report
    std::string folder{};            ///< for the pictures of a film; empty: none
};

/// The input of a simulation: the frames of a film, and the clocks.
struct SimulateInput {
    Film& film;
    FrameSize size;
    std::vector<int> clocks;
    /// Returns the last frame's request, once all frames are recorded.
    const Request& request() const { return film.request(); }
    const Job& job() const { return film.job(); }
};

/// The results of a simulation.
struct SimulateResult {
    Tracer tracer = Tracer::model;
    std::vector<RecordedFrame> traces;
    std::vector<FramesAtClock> runs;           ///< [clock]
    FilmStrip strip;                           ///< of the frames, if they were recorded one by one
    std::optional<FrameComparison> compared;   ///< the last frame compared with the reference
    bool partial = false;

    bool is_on_model() const { return tracer == Tracer::model; }
    std::optional<FrameError> error() const {
        return compared ? std::optional(compared->error) : std::nullopt;
    }
    /// Returns the errors of all compared frames.
    std::vector<FrameError> errors() const {
        return compared ? all_errors(strip, compared->error) : std::vector<FrameError>{};
    }
    const std::optional<Judgement>& judgement() const {
        static const std::optional<Judgement> none;
        return compared ? compared->judgement : none;
    }
    const std::vector<Closest>& answers() const {
        return is_on_model() ? traces.back().trace.hits : runs.back().last().answers;
    }
    const Colours& colours() const {
        return is_on_model() ? traces.back().trace.colours : runs.back().last().colours;
    }
};

/// Sums over all frames and clocks.
struct Totals {
    std::uint64_t cycles = 0;
    double machine_seconds = 0, record_seconds = 0, all_seconds = 0;   ///< on the host
    Digest digest;
};

/// Runs the frames at each clock. After Ctrl-C the result is partial. Rethrows what `progress` throws.
SimulateResult run_simulation(const SimulateSettings& how, const SimulateInput& work,
                              const Progress& progress);
/// Compares the last frame with the reference and judges it.
void compare_frames(SimulateResult& s, const SimulateSettings& how, const SimulateInput& work,
                    const Progress& progress);
Totals totals_of(const SimulateResult& s);
/// Returns the last frame's picture, from the comparison if there is one.
Picture last_frame_picture(const SimulateInput& work, const SimulateResult& s);
/// Returns the report of `simulate --json`: docs/guide/report.md.
nlohmann::ordered_json simulation_json(const SimulateSettings& how, const SimulateInput& work,
                                       const SimulateResult& s, const Limits& limits, const Totals& totals);

}   // namespace rayclock
