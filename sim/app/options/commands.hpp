#pragma once
// All commands. Each has a file of its name, those of `study` in study/.
#include "sim/app/options/command.hpp"

namespace rayclock {

/// The command whose subcommands make pages of docs.
constexpr const char* study_name = "study";
constexpr const char* study_what = "make a page of docs again: area, counts, figures, streams, ...";

Command scenes_command();
Command render_command();
Command simulate_command();
Command rays_command();
Command verify_command();
Command stress_command();
Command explain_command();
Command trace_command();
Command compare_command();
Command sweep_command();
Command merge_command();
Command fit_command();
Command tradeoff_command();
Command yardstick_command();
Command figures_command();
Command counts_command();
Command structures_command();
Command textures_command();
Command sampling_command();
Command scale_command();
Command streams_command();
Command gigahertz_command();
Command area_command();
Command chip_command();
Command board_command();
Command bench_command();
Command export_command();
Command config_command();
Command rtl_command();
Command template_command();
Command doctor_command();

/// Runs `verify --torture` and writes its JSON report to `json`.
int run_torture_set(const struct JsonOutput& json);

}   // namespace rayclock
