#pragma once
// The outputs of sweep and merge.
#include "sim/app/options/options.hpp"
#include "sim/explore/sweep/merge.hpp"

namespace rayclock {

/// Output options as typed.
struct SweepOutputs {
    std::string table, report;
    std::vector<std::string> plots;
    LimitsChoice limits;
    JsonOutput json;
};
void sweep_outputs(Parser& parser, SweepOutputs& o);
/// Throws UserError if an output could not be written later, so that a command can fail early.
void check_outputs(const SweepOutputs& o);
/// What each point of a sweep simulates.
enum class Drawn { picture, stream, sample };
/// Throws UserError if a plot names a column that the table lacks or that holds words. A stream and a sample
/// have no pictures, so for them it also throws on a plot of a picture's column, and on the page.
void check_plots(const SweepOutputs& o, const std::vector<sweep::Axis>& axes, Drawn drawn);

/// Prints the table under the line `how` ("6 points from 3 traces") and writes the files. `shard` is the
/// result of shard_json().
void write_sweep(const SweepOutputs& o, const sweep::MergedSweep& swept, const std::string& how,
                 const nlohmann::ordered_json& shard);

}   // namespace rayclock
