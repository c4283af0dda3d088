#pragma once
// Save files of GTKWave.
#include <cstdint>
#include <string>
#include <vector>

namespace rayclock {

/// One signal in GTKWave's window.
struct GtkwSignal {
    enum class As { bits, decimal, hexadecimal, text } as = As::bits;
    std::string name;   ///< full name with scopes, "TOP.rc_chip.clk_i"; several bits have a range, "x[3:0]"
};
struct GtkwGroup {
    std::string name;
    std::vector<GtkwSignal> signals;
    bool is_open = true;
};
/// The state of GTKWave's window when it opens a waveform.
struct Gtkw {
    std::string waveform;                  ///< file name, in the same folder
    std::uint64_t marker = 0, first = 0;   ///< time of the marker, and time at the left edge
    std::vector<GtkwGroup> groups;
};

/// Returns the text of the save file.
std::string gtkw_text(const Gtkw& gtkw);

}   // namespace rayclock
