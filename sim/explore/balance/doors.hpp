#pragma once
// What the search asks, answered by the model and by Yosys. Every answer is kept, so that an interrupted
// search goes on where it was.
#include <map>

#include "model/base/progress.hpp"
#include "sim/explore/balance/search.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/files/cache/results.hpp"

namespace rayclock::balance {

class SceneDoors {
public:
    /// The scene must have a camera, and stay. Machines are compared at `khz`.
    SceneDoors(const Scene& scene, FrameSize size, int khz, int threads, bool fresh, const Progress& progress,
               const PictureChoice& picture = {});

    Doors doors();

    /// What the scene needs of a configuration beside its ladders: the depth of the stack and the bits of an
    /// address, which depend on how many children a node has.
    Config with_needs(Config config);

private:
    bool fps(std::vector<Machine>& machines);
    bool use(std::vector<Machine>& machines);

    const Scene& scene_;
    FrameSize size_;
    int khz_, threads_;
    jobs::Cache frames_, areas_;
    const Progress& progress_;
    PictureChoice picture_;
    std::map<int, CompileReport> reports_;   ///< by node_width
};

}   // namespace rayclock::balance
