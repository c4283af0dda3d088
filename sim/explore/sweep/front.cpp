// Computes Pareto fronts and knees of sweeps.
#include "sim/explore/sweep/front.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/silicon/synth/netlist.hpp"

namespace rayclock::sweep {

namespace {

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
    bool better = false;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (a[k] > b[k]) return false;
        better = better || a[k] < b[k];
    }
    return better;
}

std::optional<double> error_of(const Result& r) {
    return r.complete() ? std::optional(double(r.picture->error.pixels_other_primitive)) : std::nullopt;
}
std::optional<double> speed_of(const Result& r) {
    return r.complete() ? std::optional(r.fps()) : std::nullopt;
}
std::optional<double> ray_speed_of(const Result& r) {
    return r.complete() ? std::optional(r.mrays_per_s()) : std::nullopt;
}
/// True for a stream of rays, and for samples.
bool has_no_picture(const std::vector<Result>& results) {
    return std::any_of(results.begin(), results.end(),
                       [](const Result& r) { return r.complete() && !r.picture->has_error(); });
}
bool is_sampled(const std::vector<Result>& results) {
    return std::any_of(results.begin(), results.end(), [](const Result& r) { return r.sampled(); });
}
std::optional<double> film_speed_of(const Result& r) {
    return r.complete() ? std::optional(r.film_fps()) : std::nullopt;
}
bool is_film(const std::vector<Result>& results) {
    return std::any_of(results.begin(), results.end(),
                       [](const Result& r) { return r.complete() && r.frames() > 1; });
}
std::optional<double> bytes_of(const Result& r) {
    return r.complete() ? std::optional(double(r.picture->memory_bytes)) : std::nullopt;
}
std::optional<double> multipliers_of(const Result& r) {
    return r.complete() && r.multipliers ? std::optional(double(*r.multipliers)) : std::nullopt;
}

template <std::uint64_t (*figure)(const synth::Count&)> std::optional<double> area_of(const Result& r) {
    return r.complete() && r.area ? std::optional(double(figure(*r.area))) : std::nullopt;
}
std::uint64_t luts(const synth::Count& c) { return c.luts(); }
std::uint64_t multipliers(const synth::Count& c) { return c.dsp; }
std::uint64_t block_rams(const synth::Count& c) { return c.bram; }
std::optional<double> bits_of(const Result& r) {
    return r.complete() && synth::exists_in_rtl(r.point.config)
               ? std::optional(double(chip_memory_bits(r.point.config)))
               : std::nullopt;
}

Measure measure_of(Cost cost, const std::vector<Result>& results) {
    switch (cost) {
        case Cost::lut: return {"chip_luts", 1, area_of<luts>};
        case Cost::dsp: return {"chip_multipliers", 1, area_of<multipliers>};
        case Cost::bram: return {"chip_block_rams", 1, area_of<block_rams>};
        case Cost::bits: return {"chip_memory_bits", 1, bits_of};
        case Cost::multipliers:
        case Cost::automatic: break;
    }
    const bool netlists = std::any_of(results.begin(), results.end(),
                                      [](const Result& r) { return multipliers_of(r).has_value(); });
    return netlists ? Measure{"multipliers", 1, multipliers_of} : Measure{"memory_bytes", 1, bytes_of};
}

bool differs(const std::vector<Result>& results, std::optional<double> (*value)(const Result&)) {
    std::optional<double> first;
    for (const Result& r : results) {
        const std::optional<double> here = value(r);
        if (first && here && *here != *first) return true;
        if (!first) first = here;
    }
    return false;
}

/// Returns the cost that varies along the axes, and sets the reason for the choice.
Measure automatic_cost(const std::vector<Result>& results, std::string& why) {
    const bool counted = std::any_of(results.begin(), results.end(),
                                     [](const Result& r) { return r.multipliers.has_value(); });
    const char* not_multipliers =
        counted ? "the multipliers of all points are equal" : "multipliers were not counted";
    if (differs(results, multipliers_of)) {
        why = "multipliers, which differ between the points";
        return {"multipliers", 1, multipliers_of};
    }
    if (differs(results, bits_of)) {
        why = fmt::format("chip_memory_bits, because {}", not_multipliers);
        return {"chip_memory_bits", 1, bits_of};
    }
    if (differs(results, bytes_of)) {
        why = fmt::format("memory_bytes, because {} and all points have the same memory on the chip",
                          not_multipliers);
        return {"memory_bytes", 1, bytes_of};
    }
    const Measure same = measure_of(Cost::multipliers, results);
    why = same.key + ", although it is equal in all points: these axes change no cost";
    return same;
}

}   // namespace

std::vector<bool> front(const std::vector<Figures>& points) {
    std::vector<bool> on(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        on[i] = points[i] && std::none_of(points.begin(), points.end(), [&](const Figures& other) {
                    return other && dominates(*other, *points[i]);
                });
    return on;
}

std::optional<PlaneKnee> knee_of(const std::vector<Figures>& points) {
    const std::vector<bool> on = front(points);
    std::vector<double> lo, hi;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!on[i]) continue;
        if (lo.empty()) lo = hi = *points[i];
        for (std::size_t k = 0; k < 2; ++k) {
            lo[k] = std::min(lo[k], (*points[i])[k]);
            hi[k] = std::max(hi[k], (*points[i])[k]);
        }
    }
    if (lo.empty() || !(hi[0] > lo[0]) || !(hi[1] > lo[1]))
        return std::nullopt;   // fewer than two distinct points
    std::optional<PlaneKnee> knee;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!on[i]) continue;
        const double x = ((*points[i])[0] - lo[0]) / (hi[0] - lo[0]),
                     y = ((*points[i])[1] - lo[1]) / (hi[1] - lo[1]);
        const double distance = (1 - x - y) / std::sqrt(2.0);
        if (distance > 1e-12 && (!knee || distance > knee->distance))
            knee = {i, distance};   // tolerance: the ends of the chord have rounding errors
    }
    return knee;
}

std::vector<Figures> figures_in(const std::vector<Result>& results, const std::vector<Measure>& measures) {
    std::vector<Figures> points;
    for (const Result& r : results) {
        std::vector<double> values;
        for (const Measure& m : measures)
            if (const auto value = m.value(r)) values.push_back(m.sign * *value);
        points.push_back(values.size() == measures.size() ? Figures(std::move(values)) : std::nullopt);
    }
    return points;
}

Front front_of(const std::vector<Result>& results, Cost cost) {
    Front f;
    f.has_error = !has_no_picture(results);
    f.measures = {{"pixels_other_primitive", 1, error_of},
                  cost == Cost::automatic ? automatic_cost(results, f.why) : measure_of(cost, results),
                  is_film(results)                     ? Measure{"film_fps", -1, film_speed_of}
                  : f.has_error || is_sampled(results) ? Measure{"fps", -1, speed_of}
                                                       : Measure{"mrays_per_s", -1, ray_speed_of}};
    const std::vector<Figures> all = figures_in(results, f.measures);
    f.pareto = front(all);
    constexpr std::array<std::array<std::size_t, 2>, 3> planes{{{0, 1}, {0, 2}, {1, 2}}};
    for (const auto& plane : planes) {
        std::vector<Figures> points = figures_in(results, {f.measures[plane[0]], f.measures[plane[1]]});
        for (std::size_t i = 0; i < points.size(); ++i)
            if (!all[i]) points[i].reset();
        f.knee = knee_of(points);
        f.plane = plane;
        if (f.knee) break;
    }
    return f;
}

}   // namespace rayclock::sweep
