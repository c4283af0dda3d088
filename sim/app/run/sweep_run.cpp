// Runs a sweep and makes its report.
#include "sim/app/run/sweep_run.hpp"

#include "sim/app/run/clock.hpp"
#include "sim/app/run/typed_values.hpp"
#include "sim/explore/sweep/cost.hpp"
#include "sim/explore/sweep/table.hpp"
#include "sim/run/rtl/builder.hpp"

namespace rayclock {

int axis_clock(const std::string& value) { return parse_clocks(value).at(0); }

namespace {

/// Returns the requested points of the grid, each with its own clock.
std::vector<sweep::Point> points_of(const SweepRequest& o) {
    const bool at_fmax = o.clock == "fmax";
    std::vector<sweep::Point> points =
        sweep::make_points(o.axes, o.request.config, at_fmax ? 0 : parse_clocks(o.clock)[0], axis_clock);
    sweep::keep_size(points, o.cache_bytes);
    for (sweep::Point& point : points)   // an axis over clocks takes precedence
        if (at_fmax && point.khz == 0) point.khz = clocks_of(o.clock, point.config)[0];
    return points;
}

/// Removes all points outside this part. Returns the indices of the remaining points.
std::vector<std::size_t> keep_part(std::vector<sweep::Point>& points, const sweep::Shard& shard) {
    const std::vector<std::size_t> mine = sweep::points_of(shard, points);
    std::vector<sweep::Point> kept;
    for (const std::size_t i : mine) kept.push_back(std::move(points[i]));
    points = std::move(kept);
    return mine;
}

}   // namespace

SweepResult run_sweep(SweepRequest ask, const Progress& progress) {
    const sweep::Cost cost = sweep::parse_cost(ask.cost);
    const Scene& scene = ask.request.scene;
    PictureChoice picture;
    if (!ask.stream)
        picture = {ask.request.finished, ask.request.settings, settled_frames(ask.frames, scene), ask.view};
    std::vector<sweep::Point> points = points_of(ask);
    const std::vector<std::size_t> mine = keep_part(points, ask.shard);
    results::Cache cache(rtl_cache() / "sweep", ask.fresh);
    sweep::MergedSweep swept{scene_json(scene),
                             ask.request.config,
                             ask.size,
                             {std::move(ask.axes), ask.clock, ask.cost, ask.cache_bytes, ask.netlists,
                              ask.stream ? nlohmann::ordered_json() : sweep::picture_json(picture),
                              ask.stream ? sweep::stream_json(*ask.stream) : nlohmann::ordered_json(),
                              ask.sample ? sweep::sample_json(*ask.sample) : nlohmann::ordered_json()},
                             {}};
    sweep::Evaluation& outcome = swept.outcome;
    const bool netlists = ask.netlists && !sweep::needs_area(cost) && cost != sweep::Cost::bits;
    outcome = sweep::run(
        {scene, ask.size, std::move(points), ask.threads, netlists, picture, ask.stream, ask.sample}, cache,
        progress);
    if (sweep::needs_area(cost) && !outcome.partial) {
        results::Cache areas(rtl_cache() / "area", ask.fresh);
        sweep::count_areas(outcome, ask.threads, areas, progress);
    }
    for (sweep::Result& result : outcome.results)
        if (!result.clock.is_null()) mark_clock(result.clock, result.point.config, result.point.khz);
    return {std::move(swept), sweep::shard_json(ask.shard, mine, scene), cache.trouble()};
}

nlohmann::ordered_json sweep_json(const sweep::MergedSweep& swept, const Limits& limits,
                                  const nlohmann::ordered_json& shard) {
    const std::vector<sweep::Axis>& axes = swept.settings.axes;
    const std::vector<sweep::Result>& results = swept.outcome.results;
    const sweep::Front front = sweep::front_of(results, sweep::parse_cost(swept.settings.cost));
    return {{"scene", swept.scene},
            {"config", config_json_object(swept.config)},
            {"frame", swept.settings.is_stream() ? nlohmann::ordered_json()
                                                 : nlohmann::ordered_json{{"width", swept.size.width},
                                                                          {"height", swept.size.height}}},
            {"sweep", sweep::settings_json(swept.settings)},
            {"shard", shard},
            {"partial", swept.outcome.partial},
            {"front",
             {{"error",
               front.has_error ? nlohmann::ordered_json(front.measures[0].key) : nlohmann::ordered_json()},
              {"cost", front.measures[1].key},
              {"cost_is",
               front.why.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(front.why)},
              {"speed", front.measures[2].key}}},
            {"knee", sweep::knee_json(axes, results, front)},
            {"limits", sweep::far_json(axes, results, limits)},
            {"points", sweep::points_json(axes, results, front)}};
}

}   // namespace rayclock
