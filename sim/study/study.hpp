#pragma once
// The study behind docs/speed-against-error.md: one width at a time around a configuration, and a grid of
// two.
#include "sim/explore/sweep/plot.hpp"

namespace rayclock::sweep {

/// One parameter changed, all others held.
struct Series {
    Axis axis;
    std::string about;                 ///< what the parameter does, in a sentence
    std::vector<std::size_t> points;   ///< [value]: index in Study::points
};

struct Study {
    std::vector<Point> points;   ///< every configuration once
    std::vector<Series> series;
    std::vector<Axis> grid;   ///< two
    std::vector<std::size_t> grid_points;
};

/// Around `default`, at this clock.
Study make_study(int khz);

/// What came of it for one scene.
struct SceneStudy {
    std::string name;
    std::size_t triangles = 0;
    FrameSize size;
    Outcome outcome;
    std::string plot;   ///< file name of the grid's plot, without ending
};

/// The grid's results alone, and its front.
std::vector<Result> grid_results(const Study& study, const Outcome& outcome);

}   // namespace rayclock::sweep
