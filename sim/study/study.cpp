// Runs the points of a study, from the cache where possible.
#include "sim/study/study.hpp"
#include "model/core/parameters.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace rayclock::sweep {

namespace {

int no_clock(const std::string&) { return 0; }   // no axis of the study is a clock

class StudyBuilder {
public:
    explicit StudyBuilder(int khz) : khz_(khz) {}

    std::vector<std::size_t> add(const std::vector<Axis>& axes, const Config& base) {
        std::vector<std::size_t> indices;
        for (Point& point : make_points(axes, base, khz_, no_clock)) {
            std::string text;
            for (const Parameter& p : parameters()) text += value_text(point.config, p) + " ";
            const auto [at, is_new] = known_.try_emplace(text, study.points.size());
            if (is_new) study.points.push_back(std::move(point));
            indices.push_back(at->second);
        }
        return indices;
    }
    void add_series(const std::string& axis, const char* about, const Config& base) {
        Series series{parse_axis(axis), about, {}};
        series.points = add({series.axis}, base);
        study.series.push_back(std::move(series));
    }

    Study study;

private:
    int khz_;
    std::map<std::string, std::size_t> known_;
};

}   // namespace

Study make_study(int khz) {
    StudyBuilder maker(khz);
    const Config base = named_config("default");
    Config deep = base;
    deep.stack_depth = 64;
    maker.add_series(
        "coord_bits=12:20:2",
        "Bits per lattice coordinate. They limit the positions of triangle corners. One bit less "
        "doubles the lattice's pitch; one bit more widens every product of the triangle test.",
        base);
    maker.add_series("dir_bits=16:24:2", "Bits per direction component. They limit the directions of rays.",
                     base);
    maker.add_series("box_bits=4:8",
                     "Bits of a child box plane relative to its node. Boxes are rounded outwards, so fewer "
                     "bits cost visits but never change a pixel.",
                     base);
    maker.add_series(
        "recip_bits=8:24:4",
        "Precision of the reciprocal directions in the box test, which are also rounded outwards.", base);
    maker.add_series("node_width=2,4,8",
                     "Children of a node, with a stack of 64 groups, which narrow trees need. This is not "
                     "the width of a number and causes no error; it is here for comparison.",
                     deep);
    maker.add_series(fmt::format("primitive_test={}", fmt::join(names_of<PrimitiveTest>(), ",")),
                     "The ray-triangle test. Only exact and sheared exist in hardware; the others have no "
                     "multipliers or flip-flops.",
                     base);
    maker.study.grid = {parse_axis("coord_bits=12:20:2"), parse_axis("dir_bits=16:24:2")};
    maker.study.grid_points = maker.add(maker.study.grid, base);
    return std::move(maker.study);
}

std::vector<Result> grid_results(const Study& study, const Evaluation& outcome) {
    std::vector<Result> results;
    for (std::size_t i = 0; i < study.grid_points.size(); ++i) {
        results.push_back(outcome.results[study.grid_points[i]]);
        const std::size_t inner = study.grid[1].values.size();
        results.back().point.values = {study.grid[0].values[i / inner], study.grid[1].values[i % inner]};
    }
    return results;
}

}   // namespace rayclock::sweep
