// Bytes between a simulated board and a pseudo-terminal.
#include "sim/board/server.hpp"

#include <array>
#include <deque>
#include <vector>

namespace rayclock {

void serve(SimulatedBoard& board, PseudoTerminal& terminal, const std::function<bool()>& ends,
           ServeLimits limits) {
    constexpr LinkTime slice{20};            // of the board: about 1,500 cycles
    constexpr LinkTime nap{50'000};          // of the host
    constexpr std::size_t max_queued = 64;   // the rest waits in the terminal, as in a port's driver
    const bool stands_still = limits.last_cycle == ServeLimits{}.last_cycle;
    std::array<std::uint8_t, 256> in, arrived;
    std::vector<std::uint8_t> out;
    LinkTime heard = board.now();
    while (!ends() && board.cycle() < limits.last_cycle) {
        if (terminal.is_left()) {
            while (terminal.read(in) > 0) {}
            out.clear();
        }
        std::deque<std::uint8_t>& queue = board.from_host().bytes;
        const std::size_t got = queue.size() < max_queued ? terminal.read(in) : 0;
        if (terminal.was_flushed()) {
            // Zeros complete a packet that the last program did not finish, so that the board drops it now.
            // Otherwise the board would take the next hello for the rest of this packet. Its timeout of 20 ms
            // would not help, because it takes seconds in a simulation.
            out.clear();
            queue.assign(link_packet_most, 0);
        }
        if (got > 0 || !queue.empty()) heard = board.now();
        if (stands_still && out.empty() && board.now() - heard > limits.linger) {
            terminal.wait(nap);
            continue;
        }
        const Channel::Moved moved = board.exchange(std::span(in).first(got), arrived, slice);
        out.insert(out.end(), arrived.begin(), arrived.begin() + std::ptrdiff_t(moved.read));
        out.erase(out.begin(), out.begin() + std::ptrdiff_t(terminal.write(out)));
    }
}

}   // namespace rayclock
