#pragma once
// simulate --sample: estimates frames from samples of them.
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "model/base/stopwatch.hpp"
#include "sim/app/run/film_strip.hpp"
#include "sim/app/run/typed_values.hpp"
#include "sim/view/report/sampled.hpp"

namespace rayclock {

/// The size of a sample, as typed: a share, a relative error, or a time.
struct SampleChoice {
    std::optional<std::string> share, error, within;
    bool is_given() const { return share || error || within; }
};
/// Throws UserError if the choice makes no sense for any frame.
void check_sample(const SampleChoice& choice);

/// Parses the share of --sample, in percent.
double parse_share(const std::string& typed);

/// A sampled film, or a single frame.
struct SampledFilm {
    std::vector<SampledFrame> frames;
    std::vector<FramesAtClock> runs;   ///< [clock]: all totals as whole numbers, in the form of a simulation
    std::vector<RecordedFrame> uploads;   ///< [frame]: the host's work, without lines and rays
    FilmStrip strip;
    double seconds = 0;      ///< of the host, for the samples
    std::string shortfall;   ///< a sentence if the sample misses the requested error or time; otherwise empty
};

/// Samples the frames of a film. Frame f has the seed `seed` + f, so that the errors of the frames are
/// independent. If the choice is an error or a time, measures a small sample of each frame first, and repeats
/// it with more parts if that is necessary or possible. `watch` began with the command.
SampledFilm run_sample(Film& film, const std::vector<int>& clocks, const SampleChoice& choice,
                       std::uint64_t seed, Disturbance disturbance, int threads, const Stopwatch& watch,
                       const Progress& progress);

/// Returns the report with the keys of simulate. Figures are estimates, and `sampling` has their intervals.
nlohmann::ordered_json sample_json(Film& film, FrameSize size, double pan, const std::vector<int>& clocks,
                                   const SampledFilm& sampled);

}   // namespace rayclock
