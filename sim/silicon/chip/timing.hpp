#pragma once
// The slowest paths of a routed netlist, from the delays that nextpnr writes (SDF). nextpnr's own report has
// only one path.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rayclock::chip {

/// From one register, memory or multiplier to the next.
struct Path {
    double ns = 0;          ///< clock to output, everything between, and setup
    double logic = 0;       ///< of that within cells; the rest is wires
    int levels = 0;         ///< cells between
    std::string from, to;   ///< names of cells
};

/// The slowest path to each pin of a register, the slowest first, at most `most`; of those that `same` takes
/// for one only the slowest. Throws std::runtime_error if the text is not as nextpnr writes it.
std::vector<Path> slowest_paths(std::string_view sdf, std::size_t most,
                                const std::function<std::string(const Path&)>& same);

}   // namespace rayclock::chip
