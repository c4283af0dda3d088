// Draws and wipes the progress line under a mutex.
#include "sim/view/report/terminal_line.hpp"

#include <chrono>
#include <cstdio>
#include <mutex>

namespace rayclock {

namespace {

using Clock = std::chrono::steady_clock;

std::mutex mutex;
Clock::time_point last_drawn;

}   // namespace

void draw_line(const std::string& text) {
    const std::lock_guard lock(mutex);
    std::fprintf(stderr, "\r\033[K%s", text.c_str());
    std::fflush(stderr);
    last_drawn = Clock::now();
}

void wipe_line() { draw_line({}); }

double seconds_since_line() {
    const std::lock_guard lock(mutex);
    return std::chrono::duration<double>(Clock::now() - last_drawn).count();
}

}   // namespace rayclock
