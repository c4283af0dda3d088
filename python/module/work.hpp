#pragma once
// Long work without Python's lock.
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

#include "model/base/progress.hpp"

namespace rayclock::python {

/// Calls `work` on another thread while the caller waits without Python's lock, so other Python threads run.
/// Several calls may run at once: they share nothing. Rethrows what `work` throws.
///
/// At Ctrl-C the progress callback that `work` received throws Interrupted, and run() throws Python's
/// KeyboardInterrupt as soon as `work` has ended, or after half a second. In the second case `work` goes on
/// until it reports progress, and its result is discarded. So `work` must own what it uses, and must not use
/// Python. `kept` holds the Python objects whose memory it uses.
void run(std::function<void(const Progress& stop)> work, pybind11::object kept = {});

/// Does the same, and returns the result of `work`.
template <class Work> auto result_of(Work work, pybind11::object kept = {}) {
    const auto result = std::make_shared<std::optional<std::invoke_result_t<Work&, const Progress&>>>();
    run([result, work = std::move(work)](const Progress& stop) mutable { result->emplace(work(stop)); },
        std::move(kept));
    return std::move(**result);
}

/// Waits, without Python's lock, until no work goes on after its call has ended. Python's exit calls it,
/// because the libraries cannot be unloaded below a thread that uses them. Returns early at Ctrl-C.
void wait_for_interrupted_work();

}   // namespace rayclock::python
