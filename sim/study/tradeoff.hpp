#pragma once
// The page docs/measured/speed-against-error.md: the cost and the gain of each bit.
#include "sim/study/study.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock::sweep {

/// The input of the page.
struct Tradeoff {
    std::vector<std::string> scenes;
    FrameSize size;
    int threads = 0;
    bool netlists = true;
    Limits limits{};   ///< a figure beyond these gets a mark
};

/// Returns the scenes of the page in docs/.
const std::vector<std::string>& default_tradeoff_scenes();

/// Throws UserError if the page at `path` or its plots cannot be written later, so that a command can fail
/// early.
void check_tradeoff_paths(const std::string& path, const std::vector<std::string>& scenes);

/// Runs the study on every scene, and writes the page with its plots next to it. `command` is the command
/// that makes it. Throws UserError if a scene or a file fails, and Interrupted after Ctrl-C.
void write_tradeoff(const std::string& path, const Tradeoff& what, const std::string& command,
                    results::Cache& cache, const Progress& progress);

}   // namespace rayclock::sweep
