#pragma once
// A simulated board whose test does something in each cycle.
#include "sim/board/simulated_board.hpp"

namespace rayclock::test {

/// The channel of a simulated board. step() is called for each cycle in which the host waits; it must call
/// board.step().
class SteppedBoard : public Channel {
public:
    SteppedBoard(const Config& config, const BoardShape& shape) : board(config, shape) {}

    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) override {
        Moved moved = board.exchange(out, in, LinkTime(0));
        for (const LinkTime end = board.now() + most; moved.read == 0 && board.now() < end;) {
            step();
            moved.read = board.exchange({}, in, LinkTime(0)).read;
        }
        return moved;
    }
    LinkTime now() override { return board.now(); }

    SimulatedBoard board;

private:
    virtual void step() = 0;
};

}   // namespace rayclock::test
