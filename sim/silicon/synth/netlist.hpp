#pragma once
// What a configuration costs as hardware: Yosys on its RTL.
#include <filesystem>
#include <optional>
#include <string>

#include "model/core/config.hpp"

namespace rayclock::synth {

/// Counts of one machine's pipelines together; what they share (dispatch, arbiter, l2) is not among them.
struct Netlist {
    std::uint64_t multipliers = 0;   ///< MULT18X18D of an ECP5, after products are cut into 18x18 tiles and
                                     ///< shared where exclusive
    std::uint64_t flip_flops = 0;    ///< bits of registers; memories (queues, caches, stacks) are not
                                     ///< registers
};

/// Whether there is RTL for a configuration: some tests of primitives are software only.
bool exists_in_rtl(const Config& config);

/// What the counts depend on; the same for configurations whose RTL is the same.
std::string netlist_key(const Config& config);

/// Runs Yosys (about ten seconds on one core) in a folder under `work`, which is removed. Nothing if
/// interrupted() meanwhile; std::runtime_error with the tool's words if it fails.
std::optional<Netlist> count_netlist(const Config& config, const std::filesystem::path& work);

}   // namespace rayclock::synth
