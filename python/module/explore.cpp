// rayclock.sweep() and rayclock.explain().
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "model/base/error.hpp"
#include "python/module/bindings.hpp"
#include "python/module/work.hpp"
#include "sim/app/run/explain_run.hpp"
#include "sim/app/run/sweep_run.hpp"

namespace rayclock::python {

namespace {

/// The JSON of a command, and notes.
using Told = std::pair<std::string, std::vector<std::string>>;

Told swept(const PyScene& scene, const PyConfig& config, const FrameOptions& o, const std::string& clock,
           std::uint64_t seed, const std::vector<std::string>& axes, const std::string& cost, bool netlists,
           bool fresh, int threads) {
    check_frame_size(o.size);
    return result_of([=](const Progress& stop) {
        std::vector<std::string> notes;
        std::vector<sweep::Axis> parsed;
        for (const std::string& axis : axes) parsed.push_back(sweep::parse_axis(axis));
        const Request request =
            request_of(scene.source(stop), config.choice, o.finish, seed, o.size, o.view, notes);
        const SweepResult run = run_sweep({request,
                                           o.size,
                                           std::move(parsed),
                                           clock,
                                           cost,
                                           std::nullopt,
                                           {},
                                           netlists,
                                           fresh,
                                           threads,
                                           o.frames,
                                           o.view},
                                          stop);
        if (!run.cache_trouble.empty())
            notes.push_back("nothing is kept for the next run: " + run.cache_trouble);
        return Told{sweep_json(run.swept, Limits{}, run.shard).dump(), notes};
    });
}

std::tuple<std::string, std::string, std::vector<std::string>> explained(
    const PyScene& scene, const PyConfig& config, const FrameOptions& o, int x, int y,
    const std::string& clock, std::uint64_t seed, int jitter, int stall, bool is_judged, int threads) {
    check_frame_size(o.size);
    if (x < 0 || y < 0 || x >= o.size.width || y >= o.size.height)
        throw UserError(fmt::format("pixel ({}, {}) is outside the picture of {} x {}", x, y, o.size.width,
                                    o.size.height));
    return result_of([=](const Progress& stop) {
        std::tuple<std::string, std::string, std::vector<std::string>> told;
        auto& [json, text, notes] = told;
        Film film(request_of(scene.source(stop), config.choice, o.finish, seed, o.size, o.view, notes),
                  o.frames, o.view.is_given(), o.size, stop);
        const ExplainSettings how{{jitter, stall, seed}, clock, o.is_compared, is_judged, threads};
        const auto pixel = std::size_t(y) * std::size_t(o.size.width) + std::size_t(x);
        explain_pixel(
            film, pixel, how, stop, [&](const Explanation& e, const std::vector<FrameError>& error) {
                json = explanation_json(film.request(), o.size, e, limits_json(Limits{}, error)).dump();
                text = explanation_text(e, true);
            });
        return told;
    });
}

}   // namespace

void bind_explore(py::module_& module) {
    module.def("sweep", &swept);
    module.def("explain", &explained);
}

}   // namespace rayclock::python
