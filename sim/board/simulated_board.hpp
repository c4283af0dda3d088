#pragma once
// The board in simulation: rc_board under Verilator, with its SDRAM, its screen and the wires of its UART.
#include <deque>
#include <memory>
#include <string>

#include "model/core/config.hpp"
#include "sim/board/link.hpp"
#include "sim/board/screen.hpp"
#include "sim/board/sdram_chip.hpp"
#include "sim/board/sdram_ports.hpp"
#include "sim/board/serial_line.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "sim/run/rtl/signal.hpp"

namespace rayclock {

/// Parameters of the simulated board.
struct BoardShape {
    int khz = 75'000;   ///< clock of the chip and of the SDRAM
    std::uint32_t baud = 3'000'000;
    std::string sdram = "as4c32m16sb";
    int initial_wait_us = 200;   ///< of the SDRAM after power-on
    bool is_lit = true;          ///< the screen is simulated, which costs time
    bool gates_clock = true;     ///< no time is spent on the chip while it is idle
    int seed = 1;                ///< of registers without a reset
};

/// rtl/board/rc_board.sv from pin to pin. The host's end of the UART is the channel, whose time is
/// the simulation's. The board is switched on by the constructor.
class SimulatedBoard : public Channel {
public:
    /// Builds the RTL if necessary. Throws UserError if the board cannot have this chip.
    SimulatedBoard(const Config& config, const BoardShape& shape);

    /// Simulates until a byte has arrived and nothing is left to send, or for the given time.
    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) override;
    LinkTime now() override;

    /// One cycle of the chip.
    void step();
    /// Presses the reset button, which resets all registers of the board that have a reset. It affects the
    /// SDRAM and the screen only through their pins.
    void reset();
    /// Simulates until the screen has shown that many more whole pictures. Reports its progress in cycles.
    void watch(std::uint64_t pictures, const Progress& progress = {});

    std::uint64_t cycle() const { return cycle_; }
    std::uint8_t leds() const { return std::uint8_t(led_); }
    /// The pins after the last cycle: the wires from and to the host, the memory's pins, and the screen's
    /// pairs of bits.
    bool rx() const { return rx_ != 0; }
    bool tx() const { return tx_ != 0; }
    SdramChipPins memory_pins() const { return pins_.get(); }
    std::uint32_t tmds() const { return std::uint32_t(tmds_); }
    const SdramChip& sdram() const { return sdram_; }
    const Screen& screen() const { return screen_; }
    const TmdsReceiver& receiver() const { return receiver_; }
    /// The two wires of the UART, with the bytes that they carry.
    SerialSender& from_host() { return from_host_; }
    SerialReceiver& to_host() { return to_host_; }

private:
    void shift();

    BoardShape shape_;
    RtlModule rtl_;
    SdramChip sdram_;
    Screen screen_;
    TmdsReceiver receiver_;
    SerialSender from_host_;
    SerialReceiver to_host_;
    std::uint64_t cycle_ = 0, shift_time_ = 0, shift_edges_ = 0;

    Signal rx_, tx_, led_, tmds_;
    Signal pixel_clk_, pixel_rst_, shift_clk_, shift_rst_;
    SdramPorts pins_;
};

}   // namespace rayclock
