#include "sim/report/lockstep.hpp"

#include <fmt/format.h>

#include "sim/report/text.hpp"

namespace rayclock {

namespace {

std::string counters_text(const LockstepResult& r) {
    if (r.counter) {
        const CounterDifference& c = *r.counter;
        return fmt::format("DIFFER\n    {} was {} in {} cycles of the model and {} of the RTL{}", c.unit,
                           c.cause, grouped(c.model), grouped(c.rtl),
                           c.others ? fmt::format("; {} more counters differ", c.others) : "");
    }
    return r.counters_compared ? "equal" : "not compared, since the machines parted";
}

}   // namespace

std::string lockstep_lines(const LockstepResult& r) {
    std::string text = fmt::format(
        "  model and RTL: {} transfers compared in {} cycles, {} values differ, cycle gap {}, counters {}\n",
        grouped(r.events_compared), grouped(r.model.cycles), grouped(r.value_mismatches), r.cycle_gap,
        counters_text(r));
    if (!r.first) return text;
    const Divergence& d = *r.first;
    text += fmt::format(
        "  FIRST DIVERGENCE at cycle {}: unit {}, link {}, ray {}, pixel ({}, {})\n    expected {}\n    "
        "got      {}\n",
        grouped(d.cycle), d.unit, d.link, d.ray, d.x, d.y, d.expected, d.got);
    if (!d.later.empty()) text += fmt::format("    {}\n", d.later);
    return text;
}

}   // namespace rayclock
