#pragma once
// A simulated board behind a pseudo-terminal: other programs drive it as they drive a real board.
#include <cstdint>
#include <functional>
#include <limits>

#include "sim/board/pseudo_terminal.hpp"
#include "sim/board/simulated_board.hpp"

namespace rayclock {

/// When a served board stops by itself.
struct ServeLimits {
    std::uint64_t last_cycle = std::numeric_limits<std::uint64_t>::max();
    /// Time of the board without a byte from the host after which it stands still, until the next byte comes:
    /// three screen periods. Without effect if there is a last cycle.
    LinkTime linger{50'000};
};

/// Simulates the board until `ends` returns true, or until the board has its last cycle. The bytes of its
/// UART go to and from the terminal. `ends` is called every few hundredths of a second. When a program opens
/// the terminal, what others have left under way is dropped, and zeros complete the last packet.
void serve(SimulatedBoard& board, PseudoTerminal& terminal, const std::function<bool()>& ends,
           ServeLimits limits = {});

}   // namespace rayclock
