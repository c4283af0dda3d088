// Writes GTKWave save files.
#include "sim/view/wave/gtkw.hpp"

#include <fmt/format.h>

namespace rayclock {

namespace {

// GTKWave's flags of a line; the file has them in hexadecimal.
constexpr unsigned right_aligned = 0x20, hexadecimal = 0x2, decimal = 0x4, binary = 0x8, ascii = 0x10,
                   blank = 0x200, group_begin = 0x800000, group_end = 0x1000000, closed = 0x400000;
constexpr int cycles_zoom = -6;   // the window shows a few hundred nanoseconds, at least ten cycles

unsigned flags_of(GtkwSignal::As as) {
    switch (as) {
        case GtkwSignal::As::decimal: return right_aligned | decimal;
        case GtkwSignal::As::hexadecimal: return right_aligned | hexadecimal;
        case GtkwSignal::As::text: return right_aligned | ascii;
        default: return right_aligned | binary;
    }
}

}   // namespace

std::string gtkw_text(const Gtkw& gtkw) {
    std::string text = fmt::format(
        "[*]\n[*] rayclock\n[*]\n[dumpfile] \"{}\"\n[timestart] {}\n[size] 1600 900\n[pos] -1 -1\n"
        "*{}.000000 {}{}\n[sst_width] 300\n[signals_width] 420\n[sst_expanded] 1\n",
        gtkw.waveform, gtkw.first, cycles_zoom, gtkw.marker,
        " -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1");
    for (const GtkwGroup& group : gtkw.groups) {
        const unsigned state = group.is_open ? 0 : closed;
        text += fmt::format("@{:x}\n-{}\n", group_begin | blank | state, group.name);
        for (const GtkwSignal& signal : group.signals)
            text += fmt::format("@{:x}\n{}\n", flags_of(signal.as), signal.name);
        text += fmt::format("@{:x}\n-{}\n", group_end | blank | state, group.name);
    }
    return text + "[pattern_trace] 1\n[pattern_trace] 0\n";
}

}   // namespace rayclock
