#pragma once
// The registers of the chip's host interface. This one list defines the constants of rc_pkg.sv, the bus
// writes of all programs here, and the tables of docs/machine/chip.md. Addresses count 32-bit words.
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "model/core/frame.hpp"
#include "model/machine/units.hpp"

namespace rayclock {

/// The host's access to a register.
enum class Access { read, write, both };

/// A register of the interface.
struct HostRegister {
    std::uint32_t address = 0;
    const char* constant = nullptr;   ///< name of its address in rc_pkg.sv, without "Reg"; null: none
    const char* name = nullptr;
    Access access = Access::read;
    const char* what = nullptr;
};
/// Returns all registers except the parameters, the frame and the counters.
const std::vector<HostRegister>& host_registers();
/// Returns the address of the register with this constant's name. Throws std::logic_error if there is none.
std::uint32_t register_address(const std::string& constant);

constexpr std::uint32_t host_magic = 0x52434c4b;   ///< "RCLK"
constexpr std::uint32_t host_version = 2;
constexpr std::uint32_t parameter_base = 0x20, frame_base = 0x400, counter_base = 0x2000;
constexpr int address_bits = 14;
constexpr int counter_bits = 40;   ///< width of a counter, which takes two words
/// Width of a counter's number, {group, unit, cause}. The address has one more bit, which selects the word.
constexpr int counter_number_bits = std::countr_zero(counter_base) - 1;

/// A parameter of the configuration that the host can read, at parameter_base + its index.
struct HostParameter {
    const char* name;
    std::uint32_t value;
};
std::vector<HostParameter> host_parameters(const Config& config);

/// A word of the frame's registers: `bits` bits of one element of a field of Frame. Every element begins a
/// new word. An element of more than 32 bits takes several words, the lowest first. The chip ignores the bits
/// above.
struct FrameWord {
    std::string field;
    int element = -1;   ///< -1: the field is not an array
    int low = 0;        ///< the element's bit at the bottom of the word
    int bits = 0;
    int at = 0;   ///< position of that bit in frame_t
};
std::vector<FrameWord> frame_words(const Config& config);
/// Returns the values of these words for a frame.
std::vector<std::uint32_t> frame_values(const Frame& frame, const Config& config);

/// Returns the address of the lower word of a unit's counter; the upper word follows it. Units that all
/// pipelines share use pipeline 0.
constexpr std::uint32_t counter_address(Unit unit, int pipeline, std::size_t cause) {
    const bool shared = index(unit) >= pipeline_units;
    const auto group = shared ? 0 : std::uint32_t(pipeline) + 1;
    const auto number = std::uint32_t(shared ? index(unit) - pipeline_units : index(unit));
    return counter_base | group << 9 | number << 4 | std::uint32_t(cause) << 1;
}
static_assert(pipeline_units <= 32, "a unit has a number of 5 bits");
/// The chip has counters for all units except the memory, which lies outside it.
constexpr std::size_t shared_units = unit_count - pipeline_units - 1;

}   // namespace rayclock
