// The results of a sample.
#include <algorithm>
#include <cmath>

#include "sim/run/sample/sample.hpp"

namespace rayclock::sample {

namespace {

/// Returns the values of the measured parts, paired by stratum. `value(i)` is the value of part numbers[i].
template <class Value> PartValues by_stratum(const std::vector<Stratum>& strata,
                                             const std::vector<std::uint32_t>& numbers, Value&& value) {
    const auto at = [&](std::uint32_t number) {
        return value(std::size_t(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin()));
    };
    PartValues values;
    values.certain = value(0) + value(numbers.size() - 1);
    for (const Stratum& s : strata) values.pairs.emplace_back(at(s.chosen[0]), at(s.chosen[1]));
    return values;
}

}   // namespace

Effort& Effort::operator+=(const Effort& other) {
    parts += other.parts;
    measured += other.measured;
    strata += other.strata;
    pixels += other.pixels;
    measured_pixels += other.measured_pixels;
    replayed_pixels += other.replayed_pixels;
    single_pixels += other.single_pixels;
    seconds += other.seconds;
    return *this;
}

Sampled::Sampled(int khz, Effort effort, std::vector<Stratum> strata, std::vector<Measured> parts,
                 std::vector<std::uint32_t> numbers, std::array<Auxiliary, work_kinds> coarse)
    : khz_(khz),
      effort_(effort),
      strata_(std::move(strata)),
      parts_(std::move(parts)),
      numbers_(std::move(numbers)),
      works_(std::move(coarse)) {
    for (std::size_t k = 0; k < work_kinds; ++k)
        works_[k].parts =
            by_stratum(strata_, numbers_, [&](std::size_t i) { return double(parts_[i].work[k]); });
}

PartValues Sampled::values(const Figure& figure) const {
    return by_stratum(strata_, numbers_, [&](std::size_t i) { return figure(parts_[i].timing); });
}

Work work_of(Unit unit) {
    if (unit == Unit::sched) return Work::primary;
    if (unit == Unit::xform) return Work::instances;
    if (place_of(unit_infos[index(unit)].name) == UnitPlace::engine || unit == Unit::node_cache ||
        unit == Unit::trav)
        return Work::visits;
    return unit == Unit::prim_cache || unit == Unit::tri || unit == Unit::list ? Work::triangle_tests
                                                                               : Work::expected_cycles;
}

Estimate Sampled::account(const Config& config, Unit unit, std::size_t code) const {
    const bool is_work = unit_infos[index(unit)].causes[code].kind == CauseKind::busy;
    if (unit == Unit::dispatch && is_work)   // one cycle for each tile
        return {std::ldexp(work(Work::slots).value, -2 * config.tile_bits), 0};
    return total([=](const FrameTiming& t) { return double(t.accounts.units[index(unit)][code]); },
                 is_work ? work_of(unit) : Work::expected_cycles);
}

FrameResult Sampled::frame(const Config& config) const {
    FrameResult frame;
    const auto whole = [](const Estimate& e) { return std::uint64_t(std::llround(std::max(0.0, e.value))); };
    const auto of_memory = [&](std::uint64_t MemoryStats::*member) {
        frame.memory.*member = whole(total([=](const FrameTiming& t) { return double(t.memory.*member); }));
    };
    frame.cycles = whole(total([](const FrameTiming& t) { return double(t.cycles); }));
    frame.pixels = effort_.pixels;
    frame.finished_picture = config.has_shade();
    frame.rays = {whole(work(Work::primary)), whole(work(Work::shadow)), whole(work(Work::reflection)),
                  whole(work(Work::refraction)), whole(work(Work::primary_hits))};
    if (!config.supersampling) frame.rays.primary = effort_.pixels;
    frame.visits = whole(work(Work::visits));
    frame.box_tests = whole(work(Work::box_tests));
    frame.triangle_tests = whole(work(Work::triangle_tests));
    for (const auto member :
         {&MemoryStats::reads, &MemoryStats::row_hits, &MemoryStats::row_conflicts, &MemoryStats::refreshes,
          &MemoryStats::writes, &MemoryStats::scanned, &MemoryStats::pixel_writes})
        of_memory(member);
    for (std::size_t u = 0; u < unit_count; ++u) {
        if (!is_there(Unit(u), config)) continue;
        CauseCounts& causes = frame.accounts.units[u];
        std::uint64_t sum = 0;
        for (std::size_t c = 0; c < cause_count; ++c) {
            causes[c] = whole(account(config, Unit(u), c));
            sum += causes[c];
        }
        // Each cause is estimated alone, so their sum may be off. The largest cause absorbs the difference.
        *std::max_element(causes.begin(), causes.end()) +=
            frame.cycles * std::uint64_t(u < pipeline_units ? config.pipelines : 1) - sum;
    }
    frame.seconds = effort_.seconds;
    return frame;
}

}   // namespace rayclock::sample
