// Words the result of a lockstep comparison.
#include "sim/view/report/lockstep.hpp"

#include <fmt/format.h>

#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

std::string counters_text(const LockstepResult& r) {
    if (r.counter) {
        const CounterDifference& c = *r.counter;
        const std::string more = c.others == 0   ? ""
                                 : c.others == 1 ? "; 1 more counter differs"
                                                 : fmt::format("; {} more counters differ", c.others);
        if (c.unit == "host")
            return fmt::format(
                "DIFFER\n    the frame took {} cycles in the model, and the RTL's register says {}",
                grouped(c.model), grouped(c.rtl));
        return fmt::format("DIFFER\n    {} was {} in {} cycles of the model and in {} of the RTL{}", c.unit,
                           c.cause, grouped(c.model), grouped(c.rtl), more);
    }
    if (r.counters_compared) return "equal";
    return r.first && r.first->unit == "host" ? "not compared, since the RTL counts only while its frame runs"
                                              : "not compared, since the machines parted";
}

/// Says where a difference lies.
std::string place_text(const Divergence& d) {
    if (d.on) return fmt::format("link {}, ray {}, pixel ({}, {})", d.link, d.ray, d.x, d.y);
    if (d.link == "none") return "assertion";
    if (d.link == "counters") return "counters";
    return fmt::format("{} {}", d.link == "cycles" ? "register" : "signal", d.link);
}

}   // namespace

std::string lockstep_lines(const LockstepResult& r) {
    std::string text = fmt::format(
        "  model and RTL: {} transfers compared in {} cycles, {} values differ, cycle gap {}, counters {}\n",
        grouped(r.events_compared), grouped(r.model.cycles), grouped(r.value_mismatches), r.cycle_gap,
        counters_text(r));
    return r.first ? text + divergence_lines(*r.first) : text;
}

std::string divergence_lines(const Divergence& d) {
    std::string text =
        fmt::format("  FIRST DIVERGENCE at cycle {}: unit {}, {}\n    expected {}\n    got      {}\n",
                    grouped(d.cycle), d.unit, place_text(d), d.expected, d.got);
    if (!d.later.empty()) text += fmt::format("    {}\n", d.later);
    return text;
}

}   // namespace rayclock
