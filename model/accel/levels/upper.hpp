#pragma once
// The scene's tree of two levels: nodes over boxes of instances, with an instance where a leaf would be.
#include <vector>

#include "model/accel/levels/maps.hpp"

namespace rayclock {

/// An instance of which something is left on its lattice.
struct UpperEntry {
    const InstanceMap* map = nullptr;
    std::uint32_t first = 0;         ///< number of its first primitive
    std::uint32_t root = 0;          ///< line of its class's root; may be given later
    int stack_need = 0, depth = 0;   ///< of the structure below it
};

struct UpperReport {
    std::uint64_t nodes = 0, leaves = 0;
    int depth = 0, stack_need = 0;   ///< with what is below
};

/// Writes the tree over all entries as lines from `line` on, the root first, behind whatever `words` holds
/// there; `words` grows as it must. `placed` gets the line of each entry. `thorough`: the tree is improved by
/// reinsertion, which takes several times as long. Throws UserError if the lines cannot be addressed.
UpperReport write_upper(const std::vector<UpperEntry>& entries, std::uint32_t line, bool thorough,
                        const Config& config, const std::string& name, std::vector<std::uint32_t>& words,
                        std::vector<std::uint32_t>& placed);

/// The line of an entry, once its root is known.
void write_entry(const UpperEntry& entry, std::uint32_t line, const Config& config,
                 std::vector<std::uint32_t>& words);

/// The most lines that a tree over so many entries takes: each node but the root has two children or more,
/// and each child a line.
constexpr std::uint32_t most_upper_lines(std::size_t entries) {
    return std::uint32_t(2 * std::max<std::size_t>(entries, 1));
}

}   // namespace rayclock
