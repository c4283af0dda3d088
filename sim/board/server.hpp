#pragma once
// A simulated board behind a pseudo-terminal: other programs drive it as they drive a real board.
#include <cstdint>
#include <functional>
#include <limits>

#include "sim/board/pseudo_terminal.hpp"
#include "sim/board/simulated_board.hpp"

namespace rayclock {

/// Simulates the board until `ends` returns true, or until the board has this cycle. The bytes of its UART go
/// to and from the terminal. `ends` is called every few hundredths of a second.
///
/// Bytes that a program has sent are dropped when it closes the terminal. Without a limit of cycles, the
/// board stands still after three screen periods without a byte from the host, until the next one comes.
void serve(SimulatedBoard& board, PseudoTerminal& terminal, const std::function<bool()>& ends,
           std::uint64_t last_cycle = std::numeric_limits<std::uint64_t>::max());

}   // namespace rayclock
