#pragma once
// The units of the machine, one row each, and the causes of their activity. In every cycle each unit has
// exactly one cause, the same in model and RTL. These rows give the names of the codes in rc_pkg.sv, the
// counters that lockstep compares, the reports, and the table in rtl/README.md.
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "model/engine/engines.hpp"

namespace rayclock {

enum class CauseKind : std::uint8_t { none, busy, starved, stalled };

/// A cause: the unit was busy, starved (by the unit that did not deliver), or stalled (by the unit for which
/// it waited).
struct Cause {
    CauseKind kind = CauseKind::none;
    const char* name = "";
};
constexpr int cause_bits = 3;   ///< bits of the code that a unit drives in each cycle
constexpr std::size_t cause_count = 1 << cause_bits;
constexpr Cause busy(const char* what = "work") { return {CauseKind::busy, what}; }
constexpr Cause starved(const char* by) { return {CauseKind::starved, by}; }
constexpr Cause stalled(const char* by) { return {CauseKind::stalled, by}; }

/// When a part of the machine exists.
enum class Presence : std::uint8_t {
    always,
    shade,   // the unit shade and its cache
    textures,
    stream,   // rays from records
    hits,     // answers to a stream, written as records
    shared_cache,
    nodes,
    instances,
#define RAYCLOCK_NAME(with, structure, unit, Engine) structure,   // an engine that walks this structure
    RAYCLOCK_ENGINES(RAYCLOCK_NAME, )
#undef RAYCLOCK_NAME
};
constexpr bool is_there(Presence when, const Config& config) {
    switch (when) {
        case Presence::shade: return config.has_shade();
        case Presence::textures: return config.has_textures();
        case Presence::stream: return config.is_stream();
        case Presence::hits: return config.writes_hits();
        case Presence::shared_cache: return config.l2_sets > 0;
        case Presence::nodes: return !config.is_list();
#define RAYCLOCK_CASE(with, structure, unit, Engine) \
    case Presence::structure: return config.is_walked(Structure::structure);
            RAYCLOCK_ENGINES(RAYCLOCK_CASE, )
#undef RAYCLOCK_CASE
        case Presence::instances: return config.has_instances();
        default: return true;
    }
}

/// The place of a unit: in a pipeline, within a pipeline's engine, shared by all pipelines, or outside the
/// chip.
enum class UnitPlace : std::uint8_t { pipeline, engine, shared, outside };

// Columns: name, place, when it exists, then its causes by the code that the unit drives in each cycle. Units
// of a pipeline come first. A cache's codes are those of CacheOutcome, the memory's those of MemoryOutcome.
#define RAYCLOCK_CACHE_CAUSES(user, reader)                                                   \
    busy("hit"), busy("miss"), busy("merge"), busy("drain"), starved(user), stalled("mshrs"), \
        stalled("conflict"), stalled(reader)
// The causes of every node unit: all the same, since the same wiring drives them
// (rtl/engine/rc_tree.sv).
#define RAYCLOCK_NODE_UNIT(UNIT, structure, unit, Engine) \
    UNIT(unit, engine, structure, busy(), starved("memory"), starved("trav"), stalled("trav"))
#define RAYCLOCK_UNITS(UNIT)                                                                           \
    UNIT(sched, pipeline, always, busy(), starved("contexts"), starved("dispatch"), stalled("raygen"), \
         stalled("stream"))                                                                            \
    UNIT(raygen, pipeline, always, busy(), starved("sched"), stalled("trav"), starved("stream"))       \
    UNIT(trav, pipeline, always, busy(), starved("list"), stalled("recirculation"))                    \
    UNIT(node_cache, pipeline, nodes, RAYCLOCK_CACHE_CAUSES("trav", "box"))                            \
    RAYCLOCK_ENGINES(RAYCLOCK_NODE_UNIT, UNIT)                                                         \
    UNIT(list, pipeline, always, busy(), starved("trav"))                                              \
    UNIT(prim_cache, pipeline, always, RAYCLOCK_CACHE_CAUSES("list", "tri"))                           \
    UNIT(tri, pipeline, always, busy(), starved("memory"), starved("list"), stalled("list"))           \
    UNIT(surf_cache, pipeline, shade, RAYCLOCK_CACHE_CAUSES("shade", "shade"))                         \
    UNIT(shade, pipeline, shade, busy(), starved("memory"), starved("list"), stalled("queue"))         \
    UNIT(tex, pipeline, textures, busy(), starved("memory"), starved("shade"))                         \
    UNIT(tex_cache, pipeline, textures, RAYCLOCK_CACHE_CAUSES("tex", "tex"))                           \
    UNIT(xform, engine, instances, busy(), starved("memory"), starved("trav"))                         \
    UNIT(stream, pipeline, stream, RAYCLOCK_CACHE_CAUSES("sched", "raygen"))                           \
    UNIT(dispatch, shared, always, busy(), starved("frame"), stalled("sched"))                         \
    UNIT(memport, shared, always, busy(), starved("caches"), stalled("memory"))                        \
    UNIT(l2, shared, shared_cache, RAYCLOCK_CACHE_CAUSES("memport", "memport"))                        \
    UNIT(hits, shared, hits, busy(), starved("sched"), stalled("memory"))                              \
    UNIT(memory, outside, always, busy(), stalled("latency"), stalled("refresh"), starved("memport"))

#define RAYCLOCK_NAME(name, ...) name,
enum class Unit : std::uint8_t { RAYCLOCK_UNITS(RAYCLOCK_NAME) };
#undef RAYCLOCK_NAME

struct UnitInfo {
    const char* name;
    UnitPlace place;
    Presence when;
    std::array<Cause, cause_count> causes;
};
#define RAYCLOCK_INFO(name, place, when, ...) \
    UnitInfo{#name, UnitPlace::place, Presence::when, {{__VA_ARGS__}}},
constexpr std::array unit_infos{RAYCLOCK_UNITS(RAYCLOCK_INFO)};
#undef RAYCLOCK_INFO
#undef RAYCLOCK_UNITS
#undef RAYCLOCK_CACHE_CAUSES
#undef RAYCLOCK_NODE_UNIT

constexpr std::size_t unit_count = unit_infos.size();
constexpr std::size_t pipeline_units = [] {
    std::size_t n = 0;
    for (const UnitInfo& unit : unit_infos) n += unit.place <= UnitPlace::engine;
    return n;
}();
constexpr std::size_t index(Unit u) { return std::size_t(u); }

/// True if a chip of this configuration has the unit.
constexpr bool is_there(Unit u, const Config& config) { return is_there(unit_infos[index(u)].when, config); }

/// Returns the unit with this name, if there is one.
constexpr std::optional<Unit> unit_called(std::string_view name) {
    for (std::size_t u = 0; u < unit_count; ++u)
        if (unit_infos[u].name == name) return Unit(u);
    return {};
}
/// Returns the code by which a unit reports a cause. Fails to compile if its row does not have the cause.
consteval std::uint8_t cause_code(Unit unit, const Cause& cause) {
    for (std::size_t code = 0; code < cause_count; ++code) {
        const Cause& listed = unit_infos[index(unit)].causes[code];
        if (listed.kind == cause.kind && std::string_view(listed.name) == cause.name)
            return std::uint8_t(code);
    }
    throw "the unit's row does not have this cause";
}
constexpr std::uint8_t busy_code = 0;   ///< every unit without a cache is busy with this code

/// Returns the place of the unit with this name; an unknown name counts as outside the chip.
constexpr UnitPlace place_of(std::string_view name) {
    const std::optional<Unit> unit = unit_called(name);
    return unit ? unit_infos[index(*unit)].place : UnitPlace::outside;
}
constexpr bool is_of_pipeline(std::string_view unit) { return place_of(unit) <= UnitPlace::engine; }

using CauseCounts = std::array<std::uint64_t, cause_count>;

/// Cycles by cause and unit, summed over the pipelines: a unit of a pipeline has pipelines * cycles in all.
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
