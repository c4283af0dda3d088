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
/// After Ctrl-C the progress callback of `work` throws Interrupted. run() throws Python's KeyboardInterrupt
/// as soon as `work` has ended, or after half a second. In the second case `work` continues until it reports
/// progress, and its result is discarded. So `work` must own the data that it uses, and must not call Python.
/// `kept` holds the Python objects whose memory `work` uses.
void run(std::function<void(const Progress& stop)> work, pybind11::object kept = {});

/// Does the same, and returns the result of `work`.
template <class Work> auto result_of(Work work, pybind11::object kept = {}) {
    const auto result = std::make_shared<std::optional<std::invoke_result_t<Work&, const Progress&>>>();
    run([result, work = std::move(work)](const Progress& stop) mutable { result->emplace(work(stop)); },
        std::move(kept));
    return std::move(**result);
}

/// Returns the number of calls that have returned while their work continues.
int continuing_work();

/// Waits, without Python's lock, for all work that continues after its call has returned. Python calls it at
/// exit, because a running thread still uses the libraries. Ctrl-C ends the wait early.
void wait_for_interrupted_work();

}   // namespace rayclock::python
