#pragma once
// Runs the built program as a user would.
#include <functional>
#include <string>
#include <vector>

#include "tests/support/files/test_folder.hpp"

namespace rayclock::test {

/// The outcome of a run.
struct ProgramRun {
    int code = -1;   ///< exit code, or -1 if a signal ended the program
    std::string out, err;
    double seconds = 0;   ///< processor time of all threads
    double peak_mb = 0;   ///< peak memory use
};

/// Returns the folder of the sources.
std::string source_folder();

/// Runs the program. `environment` has NAME=value, which override the test's own.
ProgramRun run_program(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& environment = {});

/// Runs the program from a shell, which may redirect streams and set limits first: `script` runs the program
/// as "$@".
ProgramRun run_in_shell(const std::string& script, const std::vector<std::string>& arguments);

/// Runs the program and sends Ctrl-C after this number of milliseconds.
ProgramRun run_and_interrupt(const std::vector<std::string>& arguments, int milliseconds);

/// Runs the program and sends a signal when `ready` returns true, after a minute at the latest.
ProgramRun run_and_stop(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& environment, int signal,
                        const std::function<bool()>& ready);

/// Requires exit code 2, no standard output, and one sentence on standard error that has all `words`.
void check_refused(const ProgramRun& outcome, const std::vector<std::string>& words);

}   // namespace rayclock::test
