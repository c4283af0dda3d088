#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace rayclock {

/// What GTKWave shows of a waveform when it opens.
struct GtkwSignal {
    enum class As { bits, decimal, hexadecimal, text } as = As::bits;
    std::string name;   ///< with all scopes, "TOP.rc_chip.clk_i"; of several bits with its range, "x[3:0]"
};
struct GtkwGroup {
    std::string name;
    std::vector<GtkwSignal> signals;
    bool is_open = true;
};
struct Gtkw {
    std::string waveform;                  ///< file name, in the same folder
    std::uint64_t marker = 0, first = 0;   ///< times: of the marker, at the left edge
    std::vector<GtkwGroup> groups;
};

/// The save file that GTKWave opens.
std::string gtkw_text(const Gtkw& gtkw);

}   // namespace rayclock
