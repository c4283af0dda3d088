// Derives unit accounts, cache hit rates, lower bounds and bottlenecks from the counters of a frame.
#include "sim/view/report/accounts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/core/dram_parts.hpp"
#include "model/machine/links.hpp"
#include "model/mem/frame_buffer.hpp"

namespace rayclock {

namespace {

/// Returns the cycles that a unit is occupied by one piece of work, including the pause before the next.
int interval_of(const Config& config, Unit unit) {
    switch (unit) {
        case Unit::raygen: return config.raygen_interval;
        case Unit::box: return config.box_interval();
        case Unit::tri: return config.tri_interval;
        case Unit::shade: return config.shade_interval;
        case Unit::xform: return config.xform_interval;
        default: return 1;
    }
}

/// Returns the number of transfers that bring a unit its work. docs/guide/report.md lists the link of each
/// unit.
std::uint64_t count_of(const Config& config, Unit unit, const FrameResult& run) {
    switch (unit) {
        case Unit::trav: return run.visits;
        case Unit::list: return run.triangle_tests;
        case Unit::memory: return run.memory.reads;
        case Unit::hits: return run.accounts.units[index(unit)][0] - run.memory.pixel_writes;
        case Unit::node_cache:
        case Unit::prim_cache:
        case Unit::surf_cache:
        case Unit::tex_cache:
        case Unit::stream:
        case Unit::l2: return cache_account(run, unit).accesses;
        default: return run.accounts.units[index(unit)][0] / std::uint64_t(interval_of(config, unit));
    }
}

}   // namespace

std::vector<UnitAccount> unit_accounts(const Config& config, const FrameResult& run) {
    std::vector<UnitAccount> accounts;
    for (std::size_t u = 0; u < unit_count; ++u) {
        if (!is_there(Unit(u), config)) continue;
        UnitAccount account{unit_infos[u].name,
                            u < pipeline_units ? config.pipelines : 1,
                            count_of(config, Unit(u), run),
                            0,
                            0,
                            0,
                            {},
                            {},
                            {}};
        for (std::size_t i = 0; i < cause_count; ++i) {
            const Cause& cause = unit_infos[u].causes[i];
            const std::uint64_t cycles = run.accounts.units[u][i];
            const auto add = [&](std::uint64_t& sum, std::vector<UnitAccount::Part>& parts) {
                sum += cycles;
                parts.push_back({cause.name, cycles});
            };
            if (cause.kind == CauseKind::busy) add(account.busy, account.busy_by);
            if (cause.kind == CauseKind::starved) add(account.starved, account.starved_by);
            if (cause.kind == CauseKind::stalled) add(account.stalled, account.stalled_by);
        }
        accounts.push_back(std::move(account));
    }
    return accounts;
}

CacheAccount cache_account(const FrameResult& run, Unit cache) {
    const CauseCounts& c = run.accounts.units[index(cache)];   // indexed by CacheOutcome: hit, miss, merge
    return {c[0] + c[1] + c[2], c[0], c[2]};
}

double peak_bytes_per_second(const Config& config, int khz) {
    const double port = 64.0 * khz * 1e3;
    const DramPart* part = config.dram_part();
    if (!part) return port / config.mem_interval;
    if (config.is_board()) return 2.0 * khz * 1e3;   // 16 bits in each cycle of the chip
    return std::min(port, double(peak_bytes_per_second(*part)) * config.dram_channels);
}

Bound bound_of(const Config& config, int khz, const FrameResult& run) {
    Bound bound;
    bound.triangles = double(run.triangle_tests) * config.tri_interval / config.pipelines;
    // The busy counts of node units include the pauses between two nodes.
    std::uint64_t nodes = run.visits;
    for (const NodeUnit& u : node_units) nodes = std::max(nodes, run.accounts.units[index(u.unit)][0]);
    bound.nodes = double(nodes) / config.pipelines;
    bound.passes = double(run.accounts.units[index(Unit::shade)][0]) / config.pipelines;
    bound.rays = double(run.accounts.units[index(Unit::raygen)][0]) / config.pipelines;
    // Scan-out takes its share of the memory's bandwidth. Reads and pixel writes must fit in the rest.
    const double seconds = double(run.cycles) / (khz * 1e3),
                 screen = config.is_board() && run.cycles ? double(64 * run.memory.scanned) / seconds
                          : config.scan_out               ? FrameBuffer::screen_bytes_per_second
                                                          : 0;
    const double peak = peak_bytes_per_second(config, khz);
    bound.memory = double(64 * (run.memory.reads - run.memory.scanned + run.memory.pixel_writes)) /
                   std::max(peak - screen, peak / 2) * khz * 1e3;
    bound.cycles = std::max({bound.nodes, bound.triangles, bound.passes, bound.rays, bound.memory});
    bound.unit = bound.cycles == bound.memory      ? "memory"
                 : bound.cycles == bound.nodes     ? "trav"
                 : bound.cycles == bound.triangles ? "tri"
                 : bound.cycles == bound.passes    ? "shade"
                                                   : "raygen";
    bound.reached = run.cycles ? bound.cycles / double(run.cycles) : 0;
    return bound;
}

std::string bottleneck(const Config& config, int khz, const FrameResult& run) {
    const Bound bound = bound_of(config, khz, run);
    const auto at_most = [](const char* what, const char* does, const char* one, int interval) {
        return fmt::format("{} limit this frame: a pipeline {} at most one {} {}", what, does, one,
                           interval == 1 ? "per cycle" : fmt::format("every {} cycles", interval));
    };
    const bool is_port = config.dram_part() && peak_bytes_per_second(config, khz) >= 64.0 * khz * 1e3;
    const std::string limit =
        bound.unit == "raygen"  ? at_most("camera rays", "starts", "ray", config.raygen_interval)
        : bound.unit == "trav"  ? at_most("node visits", "visits", "node", config.box_interval())
        : bound.unit == "tri"   ? at_most("primitive tests", "starts", "test", config.tri_interval)
        : bound.unit == "shade" ? at_most("passes of shade", "starts", "pass", config.shade_interval)
        : is_port ? "the port to memory limits this frame: it carries at most 64 bytes per cycle"
                  : "the memory's data bus limits this frame";
    std::string text =
        fmt::format("{}, and the frame reaches {:.0f} % of that limit", limit, bound.reached * 100);
    // List the reasons for which the limiting unit does not work in every cycle.
    const std::string unit = bound.unit == "trav" ? "box" : bound.unit;
    std::vector<UnitAccount::Part> losses;
    std::uint64_t cycles = 0;
    for (const UnitAccount& a : unit_accounts(config, run)) {
        if (a.unit != unit) continue;
        cycles = run.cycles * std::uint64_t(a.instances);
        for (const auto& part : a.starved_by) losses.push_back({"waits for " + part.cause, part.cycles});
        for (const auto& part : a.stalled_by) losses.push_back({"is held up by " + part.cause, part.cycles});
    }
    std::sort(losses.begin(), losses.end(), [](const auto& a, const auto& b) { return a.cycles > b.cycles; });
    std::string rest;
    for (const auto& loss : losses)
        if (double(loss.cycles) > 0.005 * double(cycles))
            rest += fmt::format("{} {} in {:.1f} %", rest.empty() ? "; " + unit : " and", loss.cause,
                                100.0 * double(loss.cycles) / double(cycles));
    return text + rest + (rest.empty() ? "" : " of the cycles");
}

}   // namespace rayclock
