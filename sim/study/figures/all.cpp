// Assembles the page of figures.
#include <fmt/format.h>

#include "sim/study/figures/figures_page.hpp"

namespace rayclock::figures {

namespace {

constexpr const char* intro = R"(# Figures

The classic figures of ray tracing, drawn by the engines of this program: the reference in double
precision, the fixed-point model, and the RTL. Made by `{}`. Pictures have {}x{}
pixels unless stated otherwise. Cycles are those of the configuration `default` with the units that the
scene needs, at 66 MHz with DDR3.

{}
)";

}   // namespace

std::string make_page(Page& page, const std::string& command) {
    for (void (*figure)(Page&) : {bounces, endless_plane, edge, test_share, cutoffs, adaptive}) {
        stop_if_interrupted();
        figure(page);
    }
    const FrameSize size = page.studio().size;
    return fmt::format(fmt::runtime(intro), command, size.width, size.height, page.rtl_sentence()) +
           page.text();
}

}   // namespace rayclock::figures
