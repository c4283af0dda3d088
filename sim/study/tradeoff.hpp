#pragma once
// docs/speed-against-error.md: what each bit costs and brings.
#include "sim/study/study.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock::sweep {

/// What the page is made of.
struct Tradeoff {
    std::vector<std::string> scenes;
    FrameSize size;
    int threads = 0;
    bool netlists = true;
    Limits limits{};   ///< beyond which a figure gets a mark
};

/// The scenes of the page in docs/.
const std::vector<std::string>& default_tradeoff_scenes();

/// Fails early (UserError) if the page at `path` or its plots could not be written later.
void check_tradeoff_paths(const std::string& path, const std::vector<std::string>& scenes);

/// Runs the study on every scene, and writes the page with its plots beside it. `command` is what to type for
/// it. Throws UserError.
void write_tradeoff(const std::string& path, const Tradeoff& what, const std::string& command,
                    jobs::Cache& cache, const Progress& progress);

}   // namespace rayclock::sweep
