#pragma once
// The study for docs/measured/speed-against-error.md: one width at a time around a configuration, and a grid
// of two widths.
#include "sim/explore/sweep/plot.hpp"

namespace rayclock::sweep {

/// One parameter varied, with all others fixed.
struct Series {
    Axis axis;
    std::string about;                 ///< the effect of the parameter, in a sentence
    std::vector<std::size_t> points;   ///< [value]: index in Study::points
};

/// All configurations of the study.
struct Study {
    std::vector<Point> points;   ///< each configuration once
    std::vector<Series> series;
    std::vector<Axis> grid;   ///< two axes
    std::vector<std::size_t> grid_points;
};

/// Returns the study around `default` at this clock.
Study make_study(int khz);

/// The results for one scene.
struct SceneStudy {
    std::string name;
    std::size_t triangles = 0;
    FrameSize size;
    Evaluation outcome;
    std::string plot;   ///< file name of the grid's plot, without extension
};

/// Returns the results of the grid alone.
std::vector<Result> grid_results(const Study& study, const Evaluation& outcome);

}   // namespace rayclock::sweep
