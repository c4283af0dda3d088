#pragma once
// The scene's tree of two levels: nodes of any structure over boxes of instances, with an instance where a
// leaf would be. Cells of a structure of planes have each instance that reaches into them: it may stand in
// several places then, and all its lines are alike.
#include <vector>

#include "model/compile/levels/maps.hpp"

namespace rayclock {

/// An instance of which something is left on its lattice.
struct UpperEntry {
    const InstanceMap* map = nullptr;
    std::uint32_t first = 0;                    ///< number of its first primitive
    std::uint32_t root = 0;                     ///< line of its class's root; may be given later
    std::uint32_t surfaces = 0, material = 0;   ///< as in Placement
    int stack_need = 0, depth = 0;              ///< of the structure below it
};

struct UpperReport {
    std::uint64_t nodes = 0, leaves = 0;
    int depth = 0, stack_need = 0;   ///< with what is below
    std::uint32_t lines = 0;
};

/// Where an entry stands.
struct PlacedEntry {
    std::uint32_t entry = 0, line = 0;
};

/// Writes the tree over all entries as lines from `line` on, the root first, behind whatever `words` holds
/// there; `words` grows as it must. `placed` gets the lines of entries, each at least once. `thorough`: a
/// tree of boxes or globes is improved by reinsertion, which takes several times as long. Throws UserError if
/// the lines cannot be addressed.
UpperReport write_upper(const std::vector<UpperEntry>& entries, std::uint32_t line, bool thorough,
                        const Config& config, const std::string& name, std::vector<std::uint32_t>& words,
                        std::vector<PlacedEntry>& placed);

/// The lines of entries, once their roots are known. An instance is called by its first line, wherever a ray
/// has met it.
void write_entries(const std::vector<UpperEntry>& entries, const std::vector<PlacedEntry>& placed,
                   const Config& config, std::vector<std::uint32_t>& words);

/// The most lines that a tree of boxes or globes over so many entries takes: each node but the root has two
/// children or more, and each child a line.
constexpr std::uint32_t most_upper_lines(std::size_t entries) {
    return std::uint32_t(2 * std::max<std::size_t>(entries, 1));
}

}   // namespace rayclock
