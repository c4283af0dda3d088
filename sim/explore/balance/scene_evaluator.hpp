#pragma once
// Answers the search's questions with the model and with Yosys. Every answer is cached, so an interrupted
// search continues where it stopped.
#include <map>

#include "model/base/progress.hpp"
#include "sim/explore/balance/search.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/run/film/choice.hpp"

namespace rayclock::balance {

/// The speed and the area of machines on one scene.
class SceneEvaluator {
public:
    /// The scene must have a camera and must outlive this object. Machines are compared at `khz`.
    SceneEvaluator(const Scene& scene, FrameSize size, int khz, int threads, bool fresh,
                   const Progress& progress, const PictureChoice& picture = {});

    Evaluator evaluator();

    /// Returns the configuration with the stack depth and the address bits that the scene needs. Both depend
    /// on the number of children of a node.
    Config with_needs(Config config);

private:
    bool fps(std::vector<Machine>& machines);
    bool use(std::vector<Machine>& machines);

    const Scene& scene_;
    FrameSize size_;
    int khz_, threads_;
    results::Cache frames_, areas_;
    const Progress& progress_;
    PictureChoice picture_;
    std::map<int, CompileReport> reports_;   ///< by node_width
};

}   // namespace rayclock::balance
