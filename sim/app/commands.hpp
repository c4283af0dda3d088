#pragma once
#include "sim/app/setup.hpp"

namespace rayclock {

/// One function per subcommand; each returns the exit code (0 good, 1 a check failed) and throws UserError for exit 2.
int render_command(const Options& options);
int simulate_command(const Options& options);
int verify_command(const Options& options);
int torture_command(const Options& options);   ///< verify --torture
int sweep_command(const Options& options);
int stress_command(const Options& options);
int fit_command(const Options& options);
int tradeoff_command(const Options& options);
int yardstick_command(const Options& options);
int figures_command(const Options& options);
int counts_command(const Options& options);
int area_command(const Options& options);
int bench_command(const Options& options);
int scenes_command(const Options& options);
int config_command(const Options& options);
int rtl_command(const Options& options);
int doctor_command(const Options& options);

/// From now on builds of RTL are told on standard error: a line that moves on a terminal, otherwise one at the beginning.
void show_builds();

/// The scenes of docs/speed-against-error.md.
const std::vector<std::string>& default_tradeoff_scenes();

/// The scenes of docs/spd.md.
std::vector<std::string> published_scenes();

} // namespace rayclock
