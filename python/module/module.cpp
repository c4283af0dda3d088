// The compiled part of the Python package rayclock. The package's Python files check arguments and arrays.
#include <filesystem>
#include <new>
#include <stdexcept>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "python/module/bindings.hpp"
#include "python/module/work.hpp"

namespace {

using namespace rayclock;

/// Python's exceptions, in the order in which they are tried.
void translate(std::exception_ptr failure, PyObject* error) {
    constexpr std::size_t longest = 1000;   // of a sentence, which may quote input
    try {
        std::rethrow_exception(failure);
    } catch (const UserError& e) {
        PyErr_SetString(error, printable(e.what(), longest).c_str());
    } catch (const std::bad_alloc&) {
        PyErr_SetString(PyExc_MemoryError, "not enough memory for this scene and picture");
    } catch (const std::length_error&) {
        PyErr_SetString(PyExc_MemoryError, "not enough memory for this scene and picture");
    } catch (const std::filesystem::filesystem_error& e) {
        PyErr_SetString(error, (e.path1().string() + ": " + e.code().message()).c_str());
    } catch (const Interrupted& e) {
        PyErr_SetString(PyExc_KeyboardInterrupt, e.what());
    }
}

}   // namespace

PYBIND11_MODULE(_rayclock, module) {
    namespace py = pybind11;
    module.doc() = "The compiled part of rayclock. Use the package rayclock.";
    module.attr("__version__") = RAYCLOCK_VERSION;
    static PyObject* const error = PyErr_NewExceptionWithDoc(
        "rayclock.Error", "Input that makes no sense, in one sentence.", PyExc_ValueError, nullptr);
    module.add_object("Error", py::reinterpret_borrow<py::object>(error));
    py::register_exception_translator([](std::exception_ptr failure) {
        if (failure) translate(failure, error);
    });
    rayclock::python::bind_config(module);
    rayclock::python::bind_scene(module);
    rayclock::python::bind_simulate(module);
    rayclock::python::bind_explore(module);
    rayclock::python::bind_rays(module);
    rayclock::python::bind_units(module);
    module.def("continuing_work", &rayclock::python::continuing_work);
    py::module_::import("atexit").attr("register")(
        py::cpp_function(rayclock::python::wait_for_interrupted_work));
}
