// Long work without Python's lock.
#include "python/module/work.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "model/base/interrupted.hpp"

namespace rayclock::python {

namespace py = pybind11;

void run(const std::function<void(const Progress& stop)>& work) {
    using namespace std::chrono_literals;
    constexpr auto between_looks = 50ms;   // for signals, which only Python's main thread may handle
    std::mutex mutex;
    std::condition_variable ended;
    bool has_ended = false, is_stopped = false;
    std::atomic<bool> must_stop = false;
    std::exception_ptr failure;
    const auto stop = [&](std::string_view, std::uint64_t, std::uint64_t) {
        if (must_stop.load(std::memory_order_relaxed)) throw Interrupted("interrupted: nothing is kept");
    };
    {
        const py::gil_scoped_release unlocked;
        std::thread worker([&] {
            try {
                work(stop);
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard lock(mutex);
            has_ended = true;
            ended.notify_one();
        });
        std::unique_lock lock(mutex);
        while (!ended.wait_for(lock, between_looks, [&] { return has_ended; })) {
            if (is_stopped) continue;
            lock.unlock();
            {
                const py::gil_scoped_acquire locked;
                is_stopped = PyErr_CheckSignals() != 0;
                must_stop = is_stopped;
            }
            lock.lock();
        }
        lock.unlock();
        worker.join();
    }
    if (is_stopped) throw py::error_already_set();
    if (failure) std::rethrow_exception(failure);
}

}   // namespace rayclock::python
