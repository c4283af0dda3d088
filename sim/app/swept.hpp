#pragma once
// What sweep and merge write about the points of a sweep.
#include "sim/app/options.hpp"
#include "sim/explore/sweep/merge.hpp"

namespace rayclock {

struct SweepOutputs {
    std::string table, report;
    std::vector<std::string> plots;
    LimitsChoice limits;
    JsonOutput json;
};
void sweep_outputs(Parser& parser, SweepOutputs& o);
/// Fails early (UserError) if something could not be written later.
void check_outputs(const SweepOutputs& o);
/// Throws UserError if a plot is of a column that the table has not.
void check_plots(const SweepOutputs& o, const std::vector<sweep::Axis>& axes);

/// A value of the axis `clock` in kHz. Throws UserError.
int axis_clock(const std::string& value);

/// Prints the table under `how` ("6 points from 3 traces") and writes the files; `shard` as shard_json().
void write_sweep(const SweepOutputs& o, const sweep::Merged& swept, const std::string& how,
                 const nlohmann::ordered_json& shard);

}   // namespace rayclock
