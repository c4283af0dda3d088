#pragma once
// The codes that a pipeline's units report in a cycle (rows of units.hpp), by what the unit's next item does,
// and the packed form in which a pipeline counts them.
#include <algorithm>
#include <array>
#include <cstdint>

#include "model/machine/units.hpp"
#include "model/unit/hits/hits.hpp"
#include "model/unit/shade/shade.hpp"

namespace rayclock {

/// By sched_.pixel_valid(), plus whether a slot is on offer, plus whether raygen or stream accepts it.
constexpr std::array sched_codes{cause_code(Unit::sched, starved("dispatch")),
                                 cause_code(Unit::sched, starved("contexts")),
                                 cause_code(Unit::sched, stalled("raygen")), cause_code(Unit::sched, busy())};
/// By whether a ray is on offer to raygen, plus whether raygen accepts it.
constexpr std::array raygen_codes{cause_code(Unit::raygen, starved("sched")),
                                  cause_code(Unit::raygen, stalled("trav")),
                                  cause_code(Unit::raygen, busy())};
/// By whether a step waits, plus 2 if no ray recirculates. A ray that recirculates makes trav busy, or
/// stalls a step.
constexpr std::array trav_codes{cause_code(Unit::trav, busy()),
                                cause_code(Unit::trav, stalled("recirculation")),
                                cause_code(Unit::trav, starved("list")), cause_code(Unit::trav, busy())};
constexpr std::uint8_t list_starved = cause_code(Unit::list, starved("trav"));
/// Of a unit that tests what a cache has read, by whether the data is on offer, plus whether the unit
/// accepts it, plus 3 if the cache has misses in flight. `neighbour`: the unit on its other side.
template <Unit unit> consteval std::array<std::uint8_t, 6> codes_of_test(const char* neighbour) {
    return {
        cause_code(unit, starved(neighbour)), cause_code(unit, stalled(neighbour)), cause_code(unit, busy()),
        cause_code(unit, starved("memory")),  cause_code(unit, stalled(neighbour)), cause_code(unit, busy())};
}
constexpr std::array tri_codes = codes_of_test<Unit::tri>("list"),
                     node_unit_codes = codes_of_test<Unit::box>("trav");   // see same_causes()
static_assert(cause_code(Unit::sched, busy()) == busy_code && cause_code(Unit::list, busy()) == busy_code &&
              cause_code(Unit::tri, busy()) == busy_code && cause_code(Unit::box, busy()) == busy_code &&
              cause_code(Unit::raygen, busy()) == busy_code && cause_code(Unit::xform, busy()) == busy_code &&
              cause_code(Unit::tex, busy()) == busy_code);
static_assert(cause_code(Unit::shade, busy()) == Shade::busy &&
              cause_code(Unit::shade, starved("memory")) == Shade::starved_by_memory &&
              cause_code(Unit::shade, starved("list")) == Shade::starved_by_list &&
              cause_code(Unit::shade, stalled("queue")) == Shade::stalled_by_queue);
static_assert(cause_code(Unit::hits, busy()) == Hits::busy &&
              cause_code(Unit::hits, starved("sched")) == Hits::starved_by_sched &&
              cause_code(Unit::hits, stalled("memory")) == Hits::stalled_by_memory);

/// The codes of two units of one side of a pipeline in a cycle as one number, so that one counter counts each
/// combination.
struct UnitCodes {
    std::uint32_t first = 0, second = 0;
    static constexpr int code_bits = 2;   ///< bits of a code that occurs in a pipeline without a stream
    constexpr std::uint32_t packed() const { return first | second << code_bits; }
    static constexpr UnitCodes of(std::uint32_t packed) {
        return {packed & ((1u << code_bits) - 1), packed >> code_bits};
    }
};
constexpr bool fits_code_bits(const auto& codes) {
    return std::ranges::all_of(codes, [](std::uint8_t code) { return code < 1 << UnitCodes::code_bits; });
}
static_assert(fits_code_bits(sched_codes) && fits_code_bits(raygen_codes) && fits_code_bits(trav_codes) &&
              fits_code_bits(tri_codes) && fits_code_bits(node_unit_codes) && list_starved < 2);
static_assert(UnitCodes::of(UnitCodes{2, 3}.packed()).first == 2 &&
              UnitCodes::of(UnitCodes{2, 3}.packed()).second == 3);

}   // namespace rayclock
