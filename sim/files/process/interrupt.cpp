// Handlers of SIGINT and SIGTERM, with a timer for programs that do not poll interrupted().
#include "sim/files/process/interrupt.hpp"

#include <atomic>
#include <csignal>

#include <sys/time.h>
#include <unistd.h>

#include "sim/files/scratch.hpp"

namespace rayclock {

namespace {

// Microseconds until the program must have ended by itself. Ctrl-C may take one second.
constexpr suseconds_t patience = 500'000;

std::atomic<bool> seen, heard;
static_assert(std::atomic<bool>::is_always_lock_free);

void end_by(int signal) {
    remove_scratch();
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void nobody_listened(int) {
    if (!seen || heard) return;
    remove_scratch();
    constexpr char sentence[] = "rayclock: interrupted: nothing is written\n";
    (void)!::write(STDERR_FILENO, sentence, sizeof sentence - 1);
    ::_exit(1);
}

void interrupt(int signal) {
    if (seen.exchange(true)) return end_by(signal);
    const itimerval once{{0, 0}, {0, patience}};
    ::setitimer(ITIMER_REAL, &once, nullptr);
}

}   // namespace

void catch_interrupts() {
    std::signal(SIGALRM, nobody_listened);
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
}

bool interrupted() {
    if (!seen.load(std::memory_order_relaxed)) return false;
    heard.store(true, std::memory_order_relaxed);
    return true;
}

}   // namespace rayclock
