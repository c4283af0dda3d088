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

namespace {

using namespace std::chrono_literals;
constexpr auto between_looks = 50ms;   // for signals, which only Python's main thread may handle
constexpr int max_looks = 10;          // after a signal

/// A call, which its thread and its caller share.
struct Call {
    std::function<void(const Progress& stop)> work;
    std::mutex mutex;
    std::condition_variable ended;
    bool has_ended = false, is_alone = false;   ///< is_alone: the call has returned before its work ended
    std::atomic<bool> must_stop = false;
    std::exception_ptr failure;
};

/// The number of calls that returned before their work ended. wait_for_interrupted_work() reads it.
std::atomic<int> alone = 0;

void work_on(const std::shared_ptr<Call>& call) {
    try {
        call->work([&](std::string_view, std::uint64_t, std::uint64_t) {
            if (call->must_stop.load(std::memory_order_relaxed))
                throw Interrupted("interrupted: nothing is kept");
        });
    } catch (...) {
        call->failure = std::current_exception();
    }
    call->work = {};
    const std::lock_guard lock(call->mutex);
    call->has_ended = true;
    if (call->is_alone) --alone;
    call->ended.notify_one();
}

/// Waits for the call's end, or until Python has an exception from a signal. Returns true for a signal.
bool wait(Call& call) {
    const py::gil_scoped_release unlocked;
    std::unique_lock lock(call.mutex);
    int looks = 0;   // since the signal
    while (!call.ended.wait_for(lock, between_looks, [&] { return call.has_ended; })) {
        if (looks > 0) {
            if (++looks > max_looks) {
                call.is_alone = true;
                ++alone;
                return true;
            }
            continue;
        }
        lock.unlock();
        {
            const py::gil_scoped_acquire locked;
            if (PyErr_CheckSignals() != 0) looks = 1;
        }
        if (looks > 0) call.must_stop = true;
        lock.lock();
    }
    return looks > 0;
}

}   // namespace

void run(std::function<void(const Progress& stop)> work, py::object kept) {
    const auto call = std::make_shared<Call>();
    call->work = std::move(work);
    std::thread(work_on, call).detach();
    if (wait(*call)) {
        if (call->is_alone) kept.release();   // never freed: the work still uses it
        throw py::error_already_set();
    }
    if (call->failure) std::rethrow_exception(call->failure);
}

int continuing_work() { return alone; }

void wait_for_interrupted_work() {
    while (alone > 0) {
        {
            const py::gil_scoped_release unlocked;
            std::this_thread::sleep_for(between_looks);
        }
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
}

}   // namespace rayclock::python
