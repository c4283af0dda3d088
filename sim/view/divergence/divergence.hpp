#pragma once
// Shows the first divergence of model and RTL: a waveform, a save file for GTKWave, and a page.
#include <string>

#include "sim/files/scratch.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "sim/view/divergence/capture.hpp"

namespace rayclock {

/// A run that has found a divergence, in lockstep or elastic.
struct DivergedRun {
    const Job& job;
    const std::vector<RecordedFrame>& frames;
    Disturbance disturbance;
    int seed = 1;
    const Divergence& first;
    std::string scene, command;   ///< for the page
    bool is_elastic = false;
};

struct DivergenceFiles {
    std::string wave, view, page;   ///< paths; an elastic run has no page
    std::string note;               ///< a sentence if the second run differs from the first; otherwise empty
};

/// Runs both machines again from reset; the RTL writes its signals for the last cycles before the divergence.
/// In an elastic run only the RTL runs again, since the model is in another cycle. Writes divergence.fst and
/// divergence.gtkw into a folder, which it creates. page() writes the page later. Throws UserError if a file
/// cannot be written, and Interrupted after Ctrl-C.
class DivergenceShow {
public:
    DivergenceShow(const DivergedRun& diverged, const std::string& folder, const Progress& progress = {});
    /// Writes divergence.html, unless the run is elastic. `diverged` may contain more about the divergence
    /// than at construction.
    DivergenceFiles page(const DivergedRun& diverged);

private:
    TemporaryFolder work_;
    std::string rtl_wave_;
    Capture seen_;
    DivergenceFiles files_;
};

/// Throws UserError if the files could not be written later, so that a command can fail early.
void check_divergence_folder(const std::string& folder);

}   // namespace rayclock
