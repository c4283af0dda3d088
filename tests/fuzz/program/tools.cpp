// Fuzzes the output of tools: counts and faces of Yosys; clocks, delays and logs of nextpnr.
#include "sim/silicon/chip/harness.hpp"
#include "sim/silicon/chip/nextpnr.hpp"
#include "sim/silicon/chip/route.hpp"
#include "sim/silicon/chip/timing.hpp"
#include "sim/silicon/synth/parts.hpp"
#include "sim/silicon/synth/stat.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {

void yosys(std::string_view bytes) {
    const std::string text(bytes);
    passes([&] { synth::counts_of(text); });
    passes([&] {
        const synth::Part part = synth::parts_of_stat(text, "raygen");
        demand(part.name == "raygen", "the unit that was asked for is counted");
        demand(synth::part_json(synth::part_of(synth::part_json(part))) == synth::part_json(part),
               "what is kept is read again");
    });
    passes([&] {
        const chip::ModuleInterface interface = chip::interface_of(text, "box");
        for (const chip::Port& port : interface.ports) demand(port.width <= bytes.size(), "a port has bits");
    });
}

void nextpnr(std::string_view bytes) {
    const std::string text(bytes);
    passes([&] {
        const double mhz = chip::clocks_of(text).front().achieved;
        demand(mhz > 0 && mhz < 1e5, "a clock is one");
    });
    const chip::RouteStep step = chip::step_of_log(text);
    demand(step.percent >= 0 && step.percent <= 100, "a step is a part of the whole");
    try {
        for (const chip::Path& path : chip::slowest_paths(text, 5, [](const chip::Path& p) { return p.to; }))
            demand(!path.to.empty(), "a path ends somewhere");
    } catch (const std::runtime_error&) {   // the caller reports that the file is incomplete
    }
}

}   // namespace rayclock::fuzz
