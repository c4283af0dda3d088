#pragma once
// The first divergence of model and RTL, to be looked at: a waveform, a save file for GTKWave, and a page.
#include <string>

#include "sim/view/divergence/capture.hpp"
#include "sim/files/scratch.hpp"
#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// A run in lockstep that has found a divergence.
struct Diverged {
    const Job& job;
    const std::vector<RecordedFrame>& frames;
    Traffic traffic;
    int seed = 1;
    const Divergence& first;
    std::string scene, command;   ///< for the page
};

struct DivergenceFiles {
    std::string wave, view, page;   ///< paths
    std::string note;               ///< a sentence if the second run was not like the first; otherwise empty
};

/// Both machines run again from reset, the RTL with its signals written for the last cycles before the
/// divergence. Writes divergence.fst and divergence.gtkw into a folder, which is made, and the page when more
/// is known. Throws UserError if they cannot be written, Interrupted after Ctrl-C.
class DivergenceShow {
public:
    DivergenceShow(const Diverged& diverged, const std::string& folder, const Progress& progress = {});
    /// Writes divergence.html, with what has become known of the divergence.
    DivergenceFiles page(const Diverged& diverged);

private:
    TemporaryFolder work_;
    std::string rtl_wave_;
    Capture seen_;
    DivergenceFiles files_;
};

/// Fails early (UserError) if they could not be written.
void check_divergence_folder(const std::string& folder);

}   // namespace rayclock
