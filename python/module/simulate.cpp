// rayclock.simulate(): pictures and streams of rays on the model or the RTL.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"
#include "python/module/bindings.hpp"
#include "python/module/work.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/app/run/simulate_run.hpp"
#include "sim/app/run/stream_run.hpp"

namespace rayclock::python {

namespace {

/// What one call of simulate() returns. Arrays are moved out once.
struct PyFrame {
    std::string json;
    std::vector<std::string> notes;
    Picture picture;
    HitFrame hits;
};
struct PyStream {
    std::string json, hits;   ///< the bytes of --hits
    std::vector<std::string> notes;
};

py::array picture_array(PyFrame& frame) {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    const FrameSize size = frame.picture.size;
    return array_of<float, Picture>(
        std::move(frame.picture), {size.height, size.width, 3},
        [](const Picture& p) { return reinterpret_cast<const float*>(p.pixels.data()); });
}

/// Returns the hits as rows of four 32-bit numbers: Hit.
py::array hits_array(PyFrame& frame) {
    static_assert(sizeof(Hit) == 16);
    const FrameSize size = frame.hits.size;
    return array_of<std::uint32_t, HitFrame>(
        std::move(frame.hits), {size.height, size.width, 4},
        [](const HitFrame& h) { return reinterpret_cast<const std::uint32_t*>(h.hits.data()); });
}

Disturbance disturbance_of(std::uint64_t seed, int jitter, int stall) { return {jitter, stall, seed}; }

PyFrame simulated(const PyScene& scene, const PyConfig& config, const FrameOptions& o,
                  const std::string& clock, std::uint64_t seed, int jitter, int stall, bool is_judged,
                  int threads) {
    check_frame_size(o.size);
    return result_of([=](const Progress& stop) {
        PyFrame made;
        Request request =
            request_of(scene.source(stop), config.choice, o.finish, seed, o.size, o.view, made.notes);
        const Config machine = request.config;
        if (o.tracer == Tracer::rtl) check_rtl(machine);
        const std::vector<int> clocks = clocks_of(clock, machine);
        Film film(std::move(request), o.frames, o.view.is_given(), o.size, stop);
        const SimulateInput work{film, o.size, clocks};
        const SimulateSettings how{.tracer = o.tracer,
                                   .disturbance = disturbance_of(seed, jitter, stall),
                                   .seed = seed,
                                   .is_compared = o.is_compared,
                                   .is_judged = is_judged,
                                   .threads = threads,
                                   .pan = o.frames.pan};
        SimulateResult s = run_simulation(how, work, stop);
        if (how.is_compared) compare_frames(s, how, work, stop);
        made.json = simulation_json(how, work, s, Limits{}, totals_of(s)).dump();
        made.picture = last_frame_picture(work, s);
        made.hits =
            s.compared ? std::move(s.compared->hits) : scaled(work.job(), s.traces.back().frame, s.answers());
        return made;
    });
}

/// Returns the answers to rays without timing.
PyStream traced(const PyScene& scene, const PyConfig& config, const py::array& array, const std::string& name,
                bool any_hit, const std::string& outside, const std::string& engine, int threads) {
    const PyRays rays(name, array, any_hit, outside);
    return result_of(
        [=](const Progress& stop) {
            PyStream made;
            const Tracer tracer = parse_tracer(engine);
            const StreamInput input = rays.with(scene, config, stop);
            const Config machine = stream_config(config.choice, input.scene(), made.notes);
            if (tracer == Tracer::rtl) check_rtl(machine);
            const StreamAnswers answers = trace_stream(input, tracer, machine, threads, stop);
            made.hits = hits_npy(answers.hits, {});
            made.notes.insert(made.notes.end(), answers.notes.begin(), answers.notes.end());
            return made;
        },
        array);
}

PyStream simulated_stream(const PyScene& scene, const PyConfig& config, const py::array& array,
                          const std::string& name, bool any_hit, const std::string& outside,
                          const std::string& clock, std::uint64_t seed, int jitter, int stall, bool is_judged,
                          int threads) {
    const PyRays rays(name, array, any_hit, outside);
    return result_of(
        [=](const Progress& stop) {
            const Stopwatch watch;
            const Disturbance disturbance = disturbance_of(seed, jitter, stall);
            PyStream made;
            const StreamInput input = rays.with(scene, config, stop);
            const Config machine = stream_config(config.choice, input.scene(), made.notes);
            const std::vector<int> clocks = clocks_of(clock, machine);
            const StreamJob stream = input.job(machine, stop);
            for (std::string& note : stream_notes(stream)) made.notes.push_back(std::move(note));
            const StreamResult run = run_stream(stream, clocks, disturbance, is_judged, threads, stop);
            const std::vector<std::uint64_t> retired =
                retirements(machine, clocks[0], run.frame(), disturbance, run.runs[0].last().cycles, stop);
            made.json = simulated_stream_json(stream, run, false, watch.seconds()).dump();
            made.hits = hits_npy(hits_of(stream, run.answers()), retired);
            return made;
        },
        array);
}

}   // namespace

StreamInput PyRays::with(const PyScene& scene, const PyConfig& config, const Progress& progress) const {
    return {scene.source(progress)(stream_primitives(config.choice)),
            std::make_unique<const RayTable>(name, numbers, shape, any_hit), parse_outside(outside)};
}

void bind_simulate(py::module_& module) {
    py::class_<ViewChoice>(module, "View")
        .def(py::init<>())
        .def_readwrite("eye", &ViewChoice::eye)
        .def_readwrite("at", &ViewChoice::at)
        .def_readwrite("fov", &ViewChoice::fov)
        .def_readwrite("orbit", &ViewChoice::orbit)
        .def_readwrite("ground", &ViewChoice::ground)
        .def_readwrite("material", &ViewChoice::material);
    py::class_<Finish>(module, "Finish")
        .def(py::init<>())
        .def_readwrite("depth", &Finish::depth)
        .def_readwrite("aa", &Finish::aa)
        .def_readwrite("threshold", &Finish::threshold)
        .def_readwrite("contrast", &Finish::contrast)
        .def_readwrite("jittered", &Finish::jittered)
        .def_readwrite("fresnel", &Finish::fresnel);
    py::class_<FramesOptions>(module, "Frames")
        .def(py::init<>())
        .def_readwrite("frames", &FramesOptions::frames)
        .def_readwrite("pan", &FramesOptions::pan)
        .def_readwrite("fps", &FramesOptions::fps)
        .def_readwrite("time", &FramesOptions::time)
        .def_readwrite("uploads", &FramesOptions::uploads)
        .def_readwrite("rebuild", &FramesOptions::rebuild);
    py::class_<FrameOptions>(module, "FrameOptions")
        .def(py::init([](int width, int height, const Finish& finish, const ViewChoice& view,
                         const FramesOptions& frames, const std::string& engine, bool is_compared) {
            return FrameOptions{{width, height}, finish, view, frames, parse_machine(engine), is_compared};
        }));
    py::class_<PyFrame>(module, "SimulatedFrame")
        .def_readonly("json", &PyFrame::json)
        .def_readonly("notes", &PyFrame::notes)
        .def("take_picture", &picture_array)
        .def("take_hits", &hits_array);
    py::class_<PyStream>(module, "SimulatedStream")
        .def_readonly("json", &PyStream::json)
        .def_readonly("notes", &PyStream::notes)
        .def("take_hits", [](PyStream& s) { return bytes_array(std::move(s.hits)); });
    module.def("simulate", &simulated);
    module.def("simulate_stream", &simulated_stream);
    module.def("trace", &traced);
}

}   // namespace rayclock::python
