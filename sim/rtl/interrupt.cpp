#include "sim/rtl/interrupt.hpp"

#include <csignal>

namespace rayclock {

namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

}   // namespace

void catch_interrupts() {
    std::signal(SIGINT, [](int) {
        interrupt_seen = 1;
        std::signal(SIGINT, SIG_DFL);
    });
}

bool interrupted() { return interrupt_seen != 0; }

}   // namespace rayclock
