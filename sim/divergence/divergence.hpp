#pragma once
// The first divergence of model and RTL, to be looked at: a waveform, a save file for GTKWave, and a page.
#include <string>

#include "sim/lockstep/lockstep.hpp"

namespace rayclock {

/// A run in lockstep that has found a divergence.
struct Diverged {
    const Job& job;
    const std::vector<FrameTrace>& frames;
    Traffic traffic;
    int seed = 1;
    const Divergence& first;
    std::string scene, command;   ///< for the page
};

struct DivergenceFiles {
    std::string wave, view, page;   ///< paths
    std::string note;               ///< a sentence if the second run was not like the first; otherwise empty
};

/// Runs both machines again from reset, the RTL with its signals written for the last cycles before the
/// divergence, and writes divergence.fst, divergence.gtkw and divergence.html into a folder, which is made.
/// Throws UserError if they cannot be written, std::runtime_error if interrupted().
DivergenceFiles show_divergence(const Diverged& diverged, const std::string& folder,
                                const Progress& progress = {});

/// Fails early (UserError) if they could not be written.
void check_divergence_folder(const std::string& folder);

}   // namespace rayclock
