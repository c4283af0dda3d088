#pragma once
// Works out the figures of every point: in parallel, and only those that are not known yet.
#include <optional>

#include "sim/run/film/choice.hpp"
#include "sim/view/report/json.hpp"
#include "sim/explore/sweep/axes.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/silicon/synth/parts.hpp"

namespace rayclock::sweep {

/// How the last frame's picture differs from the reference's, and what it needs; depends on the format only.
struct PictureFigures {
    FrameError error;
    std::optional<std::uint64_t> cracks;   ///< of triangles that camera rays meet, without instances
    std::uint64_t memory_bytes = 0;        ///< of the memory image
    RayCounts rays;                        ///< sent
};

/// From JSON with the keys of `error`, and `cracks`, `memory_bytes` and `rays`. Throws a JSON exception.
PictureFigures picture_of(const nlohmann::ordered_json& json);

/// One point with what came of it. A figure is missing if the point is refused, or the run was interrupted
/// before it.
struct Result {
    Point point;
    nlohmann::ordered_json clock;   ///< as clock_json() gives it, of the last frame; or null
    std::optional<PictureFigures> picture;
    std::optional<std::uint64_t> multipliers, flip_flops;   ///< of all pipelines
    std::optional<synth::Count> area;                       ///< of the chip, if it was asked for

    bool refused() const { return !point.refused.empty(); }
    bool complete() const { return picture && !clock.is_null(); }
    double cycles() const { return clock.at("cycles").get<double>(); }
    double fps() const { return clock.at("fps").get<double>(); }
    double cycles_per_ray() const {
        return cycles() / double(std::max<std::uint64_t>(1, picture->rays.all()));
    }
    /// Of all frames, with what the host writes before each.
    std::size_t frames() const { return clock.at("frames").size(); }
    std::uint64_t film_cycles() const;
    double film_fps() const;
    double speed() const { return frames() > 1 ? film_fps() : fps(); }
};

struct Plan {
    const Scene& scene;   ///< with a camera
    FrameSize size;
    std::vector<Point> points;
    int threads = 0;        ///< 0: all cores
    bool netlists = true;   ///< count multipliers and flip-flops
    PictureChoice picture{};
};

struct Outcome {
    std::vector<Result> results;   ///< [point]
    std::size_t traces = 0;        ///< different formats
    std::size_t known = 0;         ///< points that the cache had
    std::string netlist_note;      ///< why multipliers and flip-flops are missing, or empty
    bool partial = false;          ///< interrupted before everything was done
};

nlohmann::ordered_json rays_json(const RayCounts& rays);

/// Stops early when interrupted(); what was done is in the cache.
Outcome run(const Plan& plan, jobs::Cache& cache, const Progress& progress);

}   // namespace rayclock::sweep
