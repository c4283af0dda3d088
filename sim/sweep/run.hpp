#pragma once
// Works out the figures of every point: in parallel, and only those that are not known yet.
#include <optional>

#include "sim/report/json.hpp"
#include "sim/sweep/axes.hpp"
#include "sim/jobs/cache.hpp"
#include "sim/synth/parts.hpp"

namespace rayclock::sweep {

/// How a frame's picture differs from the reference's, and what it needs; depends on the format only.
struct PictureFigures {
    FrameError error;
    std::uint64_t cracks = 0;
    std::uint64_t memory_bytes = 0;   ///< of the memory image
};

/// From JSON with the keys of `error`, and `cracks` and `memory_bytes`. Throws a JSON exception.
PictureFigures picture_of(const nlohmann::ordered_json& json);

/// One point with what came of it. A figure is missing if the point is refused, or the run was interrupted
/// before it.
struct Result {
    Point point;
    nlohmann::ordered_json clock;   ///< as clock_json() gives it, or null
    std::optional<PictureFigures> picture;
    std::optional<std::uint64_t> multipliers, flip_flops;   ///< of all pipelines
    std::optional<synth::Count> area;                       ///< of the chip, if it was asked for

    bool refused() const { return !point.refused.empty(); }
    bool complete() const { return picture && !clock.is_null(); }
    double cycles() const { return clock.at("cycles").get<double>(); }
    double fps() const { return clock.at("fps").get<double>(); }
    double cycles_per_ray() const { return cycles() / double(picture->error.pixels); }
};

struct Plan {
    const Scene& scene;   ///< with a camera
    FrameSize size;
    std::vector<Point> points;
    int threads = 0;        ///< 0: all cores
    bool netlists = true;   ///< count multipliers and flip-flops
};

struct Outcome {
    std::vector<Result> results;   ///< [point]
    std::size_t traces = 0;        ///< different formats
    std::size_t known = 0;         ///< points that the cache had
    std::string netlist_note;      ///< why multipliers and flip-flops are missing, or empty
    bool partial = false;          ///< interrupted before everything was done
};

/// Stops early when interrupted(); what was done is in the cache.
Outcome run(const Plan& plan, jobs::Cache& cache, const Progress& progress);

}   // namespace rayclock::sweep
