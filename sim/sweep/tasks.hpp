#pragma once
// Work on several threads, where a piece of work may bring more: the newest is done first, so what it holds is soon let go.
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace rayclock::sweep {

class Tasks {
public:
    using Task = std::function<void()>;

    /// To be done after all that is there already; or, from inside a task, next.
    void add(Task task) {
        const std::lock_guard lock(mutex_);
        queue_.push_back(std::move(task));
        wake_.notify_one();
    }
    void add_next(Task task) {
        const std::lock_guard lock(mutex_);
        queue_.push_front(std::move(task));
        wake_.notify_one();
    }

    /// Works until nothing is left, with this thread and `threads` - 1 others. The first exception of a task drops what is
    /// left, and is thrown here.
    void run(std::size_t threads) {
        std::vector<std::thread> helpers;
        for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back([this] { work(); });
        work();
        for (std::thread& helper : helpers) helper.join();
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    void work() {
        std::unique_lock lock(mutex_);
        for (;;) {
            wake_.wait(lock, [this] { return !queue_.empty() || running_ == 0; });
            if (queue_.empty()) return;
            Task task = std::move(queue_.front());
            queue_.pop_front();
            ++running_;
            lock.unlock();
            std::exception_ptr failure;
            try {
                task();
            } catch (...) {
                failure = std::current_exception();
            }
            task = nullptr;
            lock.lock();
            --running_;
            if (failure && !failure_) failure_ = failure;
            if (failure) queue_.clear();
            if (running_ == 0 && queue_.empty()) wake_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Task> queue_;
    std::size_t running_ = 0;
    std::exception_ptr failure_;
};

} // namespace rayclock::sweep
