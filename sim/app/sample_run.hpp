#pragma once
// simulate --sample: a frame of which only a sample is simulated.
#include <optional>
#include <string>

#include "sim/app/options/options.hpp"
#include "sim/run/sample/sample.hpp"

namespace rayclock {

/// The size of a sample, as typed: a share, a relative error, or a time.
struct SampleChoice {
    std::optional<std::string> share, error, within;
    bool is_given() const { return share || error || within; }
};
/// Throws UserError if the choice makes no sense, whatever the frame.
void check_sample(const SampleChoice& choice);

/// Runs one frame. Repeats the sample with more parts if an error or a time is asked for. `ask` receives the
/// sample that was taken.
std::vector<sample::Sampled> run_sample(const Job& job, const std::vector<int>& clocks,
                                        const SampleChoice& choice, double seconds_gone, sample::Ask& ask,
                                        Traffic traffic, int threads, const Progress& progress);

/// Returns the report: the keys of simulate. Those of figures hold estimates, and `sampling` holds their
/// intervals.
nlohmann::ordered_json sample_json(const Request& request, const Job& job, FrameSize size,
                                   const Camera& camera, const sample::Ask& ask,
                                   const std::vector<sample::Sampled>& clocks);

}   // namespace rayclock
