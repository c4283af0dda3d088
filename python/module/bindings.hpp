#pragma once
// The parts of the module, and the types that they share.
#include <memory>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "model/scene/scene.hpp"
#include "sim/run/film/film.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/request/request.hpp"
#include "sim/run/stream/input.hpp"

namespace rayclock::python {

namespace py = pybind11;

/// A configuration in Python: the name and the settings as on the command line, and the resulting values.
/// Only check() and a run check whether the values are legal together.
struct PyConfig {
    ConfigChoice choice;
    Config value;
};

/// A scene as Python holds it. Two threads may use it at once: it never changes.
struct PyScene {
    std::string builtin;   ///< the name of a built-in scene, which has a second form; empty for others
    std::shared_ptr<const Scene> scene;
    std::vector<std::string> notes;   ///< a sentence for each kind of content that is changed or not drawn

    /// Returns a source of the scene for request_of(). The source may be used without Python's lock.
    SceneSource source(const Progress& progress) const;
};

/// The arguments that a picture takes.
struct FrameOptions {
    FrameSize size;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    Tracer tracer = Tracer::model;
    bool is_compared = true;
};

/// The rays of an array, which the caller keeps, and their treatment.
struct PyRays {
    std::string name;
    const void* numbers;
    RayTable::Shape shape;
    bool any_hit;
    std::string outside;

    PyRays(std::string given, const py::array& rays, bool any, std::string treatment)
        : name(std::move(given)),
          numbers(rays.data()),
          shape{std::size_t(rays.shape(0)), std::size_t(rays.shape(1)), std::size_t(rays.itemsize())},
          any_hit(any),
          outside(std::move(treatment)) {}
    /// Returns the rays with a scene, in the form that the configuration requests. It may be called without
    /// Python's lock.
    StreamInput with(const PyScene& scene, const PyConfig& config, const Progress& progress) const;
};

void bind_config(py::module_& module);
void bind_scene(py::module_& module);
void bind_simulate(py::module_& module);
void bind_explore(py::module_& module);
void bind_rays(py::module_& module);
void bind_units(py::module_& module);

/// Returns values as an array that owns them. Nothing is copied.
template <class T, class Values>
py::array array_of(Values values, std::vector<py::ssize_t> shape, const T* (*first)(const Values&)) {
    auto* kept = new Values(std::move(values));
    const py::capsule owner(kept, [](void* p) { delete static_cast<Values*>(p); });
    return py::array(py::dtype::of<T>(), std::move(shape), first(*kept), owner);
}
/// Returns the bytes of an .npy file as an array of bytes that owns them.
inline py::array bytes_array(std::string bytes) {
    const py::ssize_t size = py::ssize_t(bytes.size());
    return array_of<std::uint8_t, std::string>(std::move(bytes), {size}, [](const std::string& b) {
        return reinterpret_cast<const std::uint8_t*>(b.data());
    });
}

}   // namespace rayclock::python
