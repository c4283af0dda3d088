#pragma once
// Computes the figures of all points in parallel. Computes only figures that are not cached.
#include <optional>

#include "sim/explore/sweep/axes.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/run/sample/sample.hpp"
#include "sim/run/stream/input.hpp"
#include "sim/silicon/synth/parts.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock::sweep {

/// The errors of the last frame against the reference, and its needs. Depends only on the format.
struct PictureFigures {
    FrameError error;   ///< 0 pixels for a stream of rays and for a sample
    /// Only for triangles that camera rays meet, in scenes without instances.
    std::optional<std::uint64_t> cracks;
    std::uint64_t memory_bytes = 0;   ///< size of the memory image
    RayCounts rays;                   ///< rays sent

    bool has_error() const { return error.pixels > 0; }
};

/// Reads JSON with the keys of `error`, `cracks`, `memory_bytes` and `rays`. Without the key
/// `pixels` the result has no error. Throws a JSON exception if the format is wrong.
PictureFigures picture_figures_from_json(const nlohmann::ordered_json& json);

/// A point and its figures. A figure is missing if the point is refused, or if the run was interrupted before
/// it.
struct Result {
    Point point;
    /// clock_json() of the last frame, or null. For a sample the key `sample` has its half-width and its
    /// rays.
    nlohmann::ordered_json clock;
    std::optional<PictureFigures> picture;
    std::optional<std::uint64_t> multipliers, flip_flops;   ///< of all pipelines
    std::optional<synth::Count> area;                       ///< of the chip, if requested

    bool refused() const { return !point.refused.empty(); }
    bool complete() const { return picture && !clock.is_null(); }
    double cycles() const { return clock.at("cycles").get<double>(); }
    double fps() const { return clock.at("fps").get<double>(); }
    double mrays_per_s() const { return clock.at("mrays_per_s").get<double>(); }
    bool sampled() const { return clock.is_object() && clock.contains("sample"); }
    double cycles_per_ray() const {
        return cycles() / double(std::max<std::uint64_t>(1, picture->rays.all()));
    }
    /// Sums over all frames, including the host's writes before each.
    std::size_t frames() const { return clock.at("frames").size(); }
    std::uint64_t film_cycles() const;
    double film_fps() const;
    double speed() const { return frames() > 1 ? film_fps() : fps(); }
};

/// The input of a run.
struct Plan {
    const Scene& scene;   ///< with a camera
    FrameSize size;
    std::vector<Point> points;
    int threads = 0;        ///< 0: all cores
    bool netlists = true;   ///< count multipliers and flip-flops
    PictureChoice picture{};
    const StreamInput* stream = nullptr;   ///< traced in place of a picture; `scene` is its scene
    std::optional<sample::Ask> sample{};   ///< estimates each point from a sample of this size
};

/// The result of a run.
struct Evaluation {
    std::vector<Result> results;   ///< [point]
    std::size_t traces = 0;        ///< number of distinct formats
    std::size_t known = 0;         ///< points found in the cache
    std::string netlist_note;      ///< the reason why multipliers and flip-flops are missing, or empty
    bool partial = false;          ///< interrupted before the end
};

/// Runs a sweep. Stops early when interrupted(); finished work is in the cache.
Evaluation run(const Plan& plan, results::Cache& cache, const Progress& progress);

}   // namespace rayclock::sweep
