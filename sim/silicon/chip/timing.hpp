#pragma once
// Finds the slowest paths of a routed netlist in the delays (SDF) that nextpnr writes. nextpnr's own report
// has only one path.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rayclock::chip {

/// A path from one register, memory or multiplier to the next.
struct Path {
    double ns = 0;          ///< clock to output, all cells and wires between, and setup
    double logic = 0;       ///< the part of `ns` within cells; the rest is wire delay
    int levels = 0;         ///< cells between the ends
    std::string from, to;   ///< names of cells
};

/// Returns the slowest path to each register pin, the slowest first, at most `most`. Of paths with equal
/// `same` it keeps only the slowest. Throws std::runtime_error if the text is not in nextpnr's format.
std::vector<Path> slowest_paths(std::string_view sdf, std::size_t most,
                                const std::function<std::string(const Path&)>& same);

}   // namespace rayclock::chip
