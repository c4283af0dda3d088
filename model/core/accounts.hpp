#pragma once
// What every unit did in every cycle: exactly one of a few causes, in model and RTL alike.
#include <array>
#include <cstdint>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// Units of one pipeline; then those that all pipelines share. The memory is beside the chip.
enum class Unit : std::uint8_t {
    sched,
    raygen,
    trav,
    node_cache,
    box,
    list,
    prim_cache,
    tri,
    surf_cache,
    shade,
    dispatch,
    memport,
    l2,
    memory
};
constexpr std::size_t pipeline_units = 10, unit_count = 14, cause_count = 8;

enum class Kind : std::uint8_t { none, busy, starved, stalled };

/// A cause: whether the unit worked, had nothing to do (and who did not deliver), or could not go on (and
/// what it waited for).
struct Cause {
    Kind kind = Kind::none;
    const char* name = "";
};
struct UnitInfo {
    const char* name;
    std::array<Cause, cause_count> causes;   ///< by the code that the unit gives in each cycle
};
constexpr Cause busy(const char* what = "work") { return {Kind::busy, what}; }
constexpr Cause starved(const char* by) { return {Kind::starved, by}; }
constexpr Cause stalled(const char* by) { return {Kind::stalled, by}; }

// A cache's codes are those of CacheDeed, the memory's those of MemoryDeed.
constexpr std::array<UnitInfo, unit_count> unit_infos{{
    {"sched", {busy(), starved("contexts"), starved("dispatch"), stalled("raygen")}},
    {"raygen", {busy(), starved("sched"), stalled("trav")}},
    {"trav", {busy(), starved("list"), stalled("recirculation")}},
    {"node_cache",
     {busy("hit"), busy("miss"), busy("merge"), busy("drain"), starved("trav"), stalled("mshrs"),
      stalled("conflict"), stalled("box")}},
    {"box", {busy(), starved("memory"), starved("trav"), stalled("trav")}},
    {"list", {busy(), starved("trav")}},
    {"prim_cache",
     {busy("hit"), busy("miss"), busy("merge"), busy("drain"), starved("list"), stalled("mshrs"),
      stalled("conflict"), stalled("tri")}},
    {"tri", {busy(), starved("memory"), starved("list"), stalled("list")}},
    {"surf_cache",
     {busy("hit"), busy("miss"), busy("merge"), busy("drain"), starved("shade"), stalled("mshrs"),
      stalled("conflict"), stalled("shade")}},
    {"shade", {busy(), starved("memory"), starved("list"), stalled("queue")}},
    {"dispatch", {busy(), starved("frame"), stalled("sched")}},
    {"memport", {busy(), starved("caches"), stalled("memory")}},
    {"l2",
     {busy("hit"), busy("miss"), busy("merge"), busy("drain"), starved("memport"), stalled("mshrs"),
      stalled("conflict"), stalled("memport")}},
    {"memory", {busy(), stalled("latency"), stalled("refresh"), starved("memport")}},
}};
constexpr std::size_t index(Unit u) { return std::size_t(u); }

/// Whether a chip of this configuration has the unit.
constexpr bool is_there(Unit u, const Config& config) {
    return u == Unit::l2                               ? config.l2_sets > 0
           : u != Unit::surf_cache && u != Unit::shade ? true
                                                       : config.shading != 0;
}

using CauseCounts = std::array<std::uint64_t, cause_count>;

/// Cycles by cause: [unit], summed over the pipelines, so that a unit of a pipeline has pipelines * cycles in
/// all.
struct Accounts {
    std::array<CauseCounts, unit_count> units{};
    Accounts& operator+=(const Accounts& other);
    friend Accounts operator-(Accounts a, const Accounts& b);
    friend bool operator==(const Accounts&, const Accounts&) = default;
};
inline Accounts& Accounts::operator+=(const Accounts& other) {
    for (std::size_t u = 0; u < unit_count; ++u)
        for (std::size_t c = 0; c < cause_count; ++c) units[u][c] += other.units[u][c];
    return *this;
}
inline Accounts operator-(Accounts a, const Accounts& b) {
    for (std::size_t u = 0; u < unit_count; ++u)
        for (std::size_t c = 0; c < cause_count; ++c) a.units[u][c] -= b.units[u][c];
    return a;
}

}   // namespace rayclock
