#pragma once
// The scene's tree of two levels: nodes of any structure over boxes of instances, with instances in place of
// leaves. In a structure of planes a cell holds each instance that reaches into it. An instance may then have
// several lines, all with the same content.
#include <vector>

#include "model/compile/levels/maps.hpp"

namespace rayclock {

/// An instance that has primitives left on its lattice.
struct UpperEntry {
    const InstanceMap* map = nullptr;
    std::uint32_t first = 0;                              ///< number of its first primitive
    std::uint32_t root = 0;                               ///< line of its class's root; may be set later
    std::uint32_t first_surface_line = 0, material = 0;   ///< as in Placement
    int stack_need = 0, depth = 0;                        ///< of the structure below it
};

struct UpperReport {
    std::uint64_t nodes = 0, leaves = 0;
    int depth = 0, stack_need = 0;   ///< including the structures below
    std::uint32_t lines = 0;
};

/// A line that holds an entry.
struct PlacedEntry {
    std::uint32_t entry = 0, line = 0;
};

/// Writes the tree over all entries as lines from `line` on, root first, and extends `words` as necessary.
/// `placed` receives the lines of entries, at least one for each. `thorough` improves a tree of boxes or
/// globes by reinsertion, which takes several times as long. Throws UserError if the lines cannot be
/// addressed.
UpperReport write_upper(const std::vector<UpperEntry>& entries, std::uint32_t line, bool thorough,
                        const Config& config, const std::string& name, std::vector<std::uint32_t>& words,
                        std::vector<PlacedEntry>& placed);

/// Writes the lines of entries, once their roots are known. An instance is identified by its first line,
/// wherever a ray meets it.
void write_entries(const std::vector<UpperEntry>& entries, const std::vector<PlacedEntry>& placed,
                   const Config& config, std::vector<std::uint32_t>& words);

/// Returns the most lines of a tree of boxes or globes over so many entries. Each node except the root has at
/// least two children, and each child takes a line.
constexpr std::uint32_t max_upper_lines(std::size_t entries) {
    return std::uint32_t(2 * std::max<std::size_t>(entries, 1));
}

}   // namespace rayclock
