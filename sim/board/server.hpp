#pragma once
// A simulated board behind a pseudo-terminal: other programs drive it as they drive a real board.
#include <cstdint>
#include <functional>
#include <limits>

#include "model/board/scan_out.hpp"
#include "sim/board/pseudo_terminal.hpp"
#include "sim/board/simulated_board.hpp"

namespace rayclock {

/// Longer than three periods of the screen: then it has shown the last picture.
constexpr LinkTime three_screen_periods{51'000};
static_assert(double(three_screen_periods.count()) * ScreenTiming::frames_per_second() > 3e6);

/// When a served board stops by itself.
struct ServeLimits {
    std::uint64_t last_cycle = std::numeric_limits<std::uint64_t>::max();
    /// Time of the board without a byte from the host after which it stands still, until the next byte comes:
    /// three screen periods. Without effect if there is a last cycle.
    LinkTime linger = three_screen_periods;
};

/// Simulates the board until `ends` returns true, or until the board has its last cycle. The bytes of its
/// UART go to and from the terminal. `ends` is called every few hundredths of a second. When a program opens
/// the terminal, the server drops all bytes of earlier programs and completes their last packet with zeros.
void serve(SimulatedBoard& board, PseudoTerminal& terminal, const std::function<bool()>& ends,
           ServeLimits limits = {});

}   // namespace rayclock
