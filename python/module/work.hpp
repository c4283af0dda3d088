#pragma once
// Long work without Python's lock.
#include <functional>
#include <optional>

#include <pybind11/pybind11.h>

#include "model/base/progress.hpp"

namespace rayclock::python {

/// Calls `work` on another thread while the caller waits without Python's lock, so other Python threads run.
/// Several calls may run at once: they share nothing. At Ctrl-C the progress callback that `work` received
/// throws Interrupted, and run() throws Python's KeyboardInterrupt once `work` has ended. Otherwise it
/// rethrows what `work` throws. `work` must not use Python.
void run(const std::function<void(const Progress& stop)>& work);

/// Does the same, and returns the result of `work`.
template <class Work> auto result_of(Work work) {
    std::optional<std::invoke_result_t<Work, const Progress&>> result;
    run([&](const Progress& stop) { result.emplace(work(stop)); });
    return std::move(*result);
}

}   // namespace rayclock::python
