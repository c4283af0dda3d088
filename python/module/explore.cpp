// rayclock.sweep() and rayclock.explain().
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "model/base/error.hpp"
#include "python/module/bindings.hpp"
#include "python/module/work.hpp"
#include "sim/app/run/explain_run.hpp"
#include "sim/app/run/stream_run.hpp"
#include "sim/app/run/sweep_run.hpp"

namespace rayclock::python {

namespace {

/// The JSON of a command, and notes.
using Told = std::pair<std::string, std::vector<std::string>>;

Told told_of(const SweepResult& run, std::vector<std::string> notes) {
    if (!run.cache_trouble.empty()) notes.push_back("nothing is kept for the next run: " + run.cache_trouble);
    return {sweep_json(run.swept, Limits{}, run.shard).dump(), std::move(notes)};
}

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
        return told_of(run, std::move(notes));
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

Told swept_stream(const PyScene& scene, const PyConfig& config, const py::array& array,
                  const std::string& name, bool any_hit, const std::string& outside, const std::string& clock,
                  const std::vector<std::string>& axes, const std::string& cost, bool netlists, bool fresh,
                  int threads) {
    const PyRays rays(name, array, any_hit, outside);
    return result_of(
        [=](const Progress& stop) {
            std::vector<std::string> notes;
            std::vector<sweep::Axis> parsed;
            for (const std::string& axis : axes) parsed.push_back(sweep::parse_axis(axis));
            const StreamInput input = rays.with(scene, config, stop);
            Request request;
            request.config = stream_config(config.choice, input.scene(), notes);
            request.scene = input.scene();
            SweepRequest ask{request, {0, 0}, std::move(parsed), clock, cost, std::nullopt};
            ask.netlists = netlists, ask.fresh = fresh, ask.threads = threads, ask.stream = &input;
            return told_of(run_sweep(std::move(ask), stop), std::move(notes));
        },
        array);
}

std::tuple<std::string, std::string, std::vector<std::string>> explained_stream(
    const PyScene& scene, const PyConfig& config, const py::array& array, const std::string& name,
    bool any_hit, const std::string& outside, std::size_t ray, const std::string& clock, std::uint64_t seed,
    int jitter, int stall, int threads) {
    const PyRays rays(name, array, any_hit, outside);
    return result_of(
        [=](const Progress& stop) {
            std::tuple<std::string, std::string, std::vector<std::string>> told;
            auto& [json, text, notes] = told;
            const StreamInput input = rays.with(scene, config, stop);
            const Config machine = stream_config(config.choice, input.scene(), notes);
            explain_ray(input, machine, ray, {{jitter, stall, seed}, clock, false, false, threads}, stop,
                        [&](const Explanation& e, const StreamJob& stream) {
                            for (std::string& note : stream_notes(stream)) notes.push_back(std::move(note));
                            json = explained_ray_json(stream, e).dump();
                            text = explanation_text(e, true);
                        });
            return told;
        },
        array);
}

}   // namespace

void bind_explore(py::module_& module) {
    module.def("sweep", &swept);
    module.def("sweep_stream", &swept_stream);
    module.def("explain", &explained);
    module.def("explain_stream", &explained_stream);
}

}   // namespace rayclock::python
