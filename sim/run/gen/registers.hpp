#pragma once
// The registers of the chip's face to its host: one list, from which come the constants of rc_pkg.sv, the bus
// writes of every program here and the tables of docs/chip.md. Addresses count words of 32 bits.
#include <cstdint>
#include <string>
#include <vector>

#include "model/core/units.hpp"
#include "model/core/frame.hpp"

namespace rayclock {

/// What a host may do with a register.
enum class Access { read, write, both };

struct HostRegister {
    std::uint32_t address = 0;
    const char* constant = nullptr;   ///< its address in rc_pkg.sv, without "Reg"
    const char* name = nullptr;
    Access access = Access::read;
    const char* what = nullptr;
};
/// All but the parameters, the frame and the counters.
const std::vector<HostRegister>& host_registers();
/// The address of the one with this constant's name.
std::uint32_t register_address(const std::string& constant);

constexpr std::uint32_t host_magic = 0x52434c4b;   ///< "RCLK"
constexpr std::uint32_t host_version = 1;
constexpr std::uint32_t parameter_base = 0x20, frame_base = 0x400, counter_base = 0x1000;
constexpr int address_bits = 13;
constexpr int tally_bits = 40;   ///< of a counter; it has two words

/// What a configuration says of itself to a host: read at parameter_base + its place.
struct HostParameter {
    const char* name;
    std::uint32_t value;
};
std::vector<HostParameter> host_parameters(const Config& config);

/// A word of the frame's registers: `bits` bits of one element of a field of Frame. Every element begins a
/// word of its own; one of more than 32 bits has several, the lowest first. Bits above are not looked at.
struct FrameWord {
    std::string field;
    int element = -1;   ///< -1: the field has but one
    int low = 0;        ///< which of the element's bits is the word's lowest
    int bits = 0;
    int at = 0;   ///< where that bit lies in frame_t
};
std::vector<FrameWord> frame_words(const Config& config);
/// Their values for a frame.
std::vector<std::uint32_t> frame_values(const Frame& frame, const Config& config);

/// The lower word of a unit's counter; the upper word is next to it. Units that all pipelines share have
/// pipeline 0.
constexpr std::uint32_t counter_address(Unit unit, int pipeline, std::size_t cause) {
    const bool shared = index(unit) >= pipeline_units;
    const auto group = shared ? 0 : std::uint32_t(pipeline) + 1;
    const auto number = std::uint32_t(shared ? index(unit) - pipeline_units : index(unit));
    return counter_base | group << 8 | number << 4 | std::uint32_t(cause) << 1;
}
/// The chip counts what all units do but the memory, which lies beside it.
constexpr std::size_t shared_units = unit_count - pipeline_units - 1;

}   // namespace rayclock
