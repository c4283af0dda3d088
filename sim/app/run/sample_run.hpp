#pragma once
// simulate --sample: estimates a frame from a sample of it.
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "sim/app/run/typed_values.hpp"
#include "sim/run/sample/sample.hpp"

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

/// Samples one frame. If the choice is an error or a time, measures a small sample first, and repeats it with
/// more parts if that is necessary or possible. `ask` receives the share and seed of the last sample.
std::vector<sample::Sampled> run_sample(const Job& job, const std::vector<int>& clocks,
                                        const SampleChoice& choice, double seconds_gone, sample::Ask& ask,
                                        Traffic traffic, int threads, const Progress& progress);

/// Returns a sentence if the sample misses the requested error or time; otherwise nothing.
std::string shortfall(const SampleChoice& choice, const std::vector<sample::Sampled>& clocks, double seconds);

/// Returns the report with the keys of simulate. Figures are estimates, and `sampling` has their intervals.
nlohmann::ordered_json sample_json(const Request& request, const Job& job, FrameSize size,
                                   const Camera& camera, const sample::Ask& ask,
                                   const std::vector<sample::Sampled>& clocks);

}   // namespace rayclock
