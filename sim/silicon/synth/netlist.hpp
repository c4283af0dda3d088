#pragma once
// The hardware cost of a configuration, counted by Yosys on its RTL.
#include <filesystem>
#include <optional>
#include <string>

#include "model/core/config.hpp"

namespace rayclock::synth {

/// Counts of all pipelines of a machine. The shared units (dispatch, arbiter, l2) are not included.
struct Netlist {
    /// MULT18X18D of an ECP5. Products are cut into 18x18 tiles, and exclusive products share tiles.
    std::uint64_t multipliers = 0;
    /// Bits of registers. Memories (queues, caches, stacks) are not registers.
    std::uint64_t flip_flops = 0;
};

/// Returns true if a configuration has RTL. Some tests of primitives exist only in software.
bool exists_in_rtl(const Config& config);

/// Returns the key of the counts. Configurations with the same RTL have the same key.
std::string netlist_key(const Config& config);

/// Runs Yosys in a temporary folder under `work`; about ten seconds on one core. Returns nothing if
/// interrupted(). Throws UserError with the tool's message if it fails.
std::optional<Netlist> count_netlist(const Config& config, const std::filesystem::path& work);

}   // namespace rayclock::synth
