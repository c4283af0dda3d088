// Writes docs/measured/area.md from Yosys's counts and from measurements. All numbers are computed.
#include "sim/study/area.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "model/scene/builtin.hpp"
#include "sim/run/request/request.hpp"
#include "sim/silicon/chip/device.hpp"
#include "sim/silicon/synth/yosys.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::area {

using nlohmann::ordered_json;

namespace {

using Row = std::vector<std::string>;

// A scene that needs shading and no other unit. So the other units are idle on one machine and absent on the
// other.
constexpr const char* speed_scene = "mirrors";
constexpr FrameSize speed_size{96, 72};
constexpr int speed_depth = 4, speed_rounds = 3;

const Row count_heads{"LUTs", "LUT4", "CCU2C", "DPR16X4", "FF", "MULT18X18D", "DP16KD"};

/// Returns the counts in the order of the headings.
std::array<std::uint64_t, 7> figures_of(const Count& c) {
    return {c.luts(), c.lut4, c.carry, c.ram, c.ff, c.dsp, c.bram};
}
Row count_cells(const Count& c) {
    Row cells;
    for (const std::uint64_t n : figures_of(c)) cells.push_back(grouped(n));
    return cells;
}

std::string signed_text(std::uint64_t now, std::uint64_t before) {
    return now == before ? "0" : now > before ? "+" + grouped(now - before) : "-" + grouped(before - now);
}
Row change_cells(const Count& now, const Count& before) {
    const auto mine = figures_of(now), theirs = figures_of(before);
    Row cells;
    for (std::size_t i = 0; i < mine.size(); ++i) cells.push_back(signed_text(mine[i], theirs[i]));
    return cells;
}

Row joined(const std::string& first, const Row& rest) {
    Row row{first};
    row.insert(row.end(), rest.begin(), rest.end());
    return row;
}

/// Returns a table of units and their resources, with `first` as heading of the first column.
Table count_table(const std::string& first, const std::vector<Row>& rows) {
    Table table(joined(first, count_heads));
    for (const Row& row : rows) table.add(row);
    return table;
}

std::string name_text(const Part& part, const std::string& indent) {
    return indent + (indent.empty() ? part.name : "rc_" + part.name) +
           (part.times > 1 ? fmt::format(", {} of them", part.times) : "");
}

/// Appends a part and everything below it. Each level is indented by `step` more than the one above.
void add_rows(std::vector<Row>& rows, const Part& part, const std::string& indent, const std::string& step) {
    rows.push_back(joined(name_text(part, indent), count_cells(part.count)));
    for (const Part& p : part.parts) add_rows(rows, p, indent + step, step);
}

std::vector<Row> unit_rows_of(const Areas& areas, std::size_t variant, const std::string& step) {
    std::vector<Row> rows;
    const auto& units = areas.units[variant];
    for (const bool in_pipeline : {true, false}) {
        for (const UnitRow& unit : unit_rows())
            if (const auto part = units.find(unit.name);
                part != units.end() && unit.in_pipeline == in_pipeline)
                add_rows(rows, part->second, "", step);
        if (in_pipeline)
            rows.push_back(joined("**one pipeline**", count_cells(pipeline_count(areas, variant))));
    }
    return rows;
}

/// Returns the units that differ between a variant and the one with which it is compared.
std::vector<Row> changes(const Areas& areas, std::size_t variant) {
    std::vector<Row> rows;
    for (const UnitRow& unit : unit_rows()) {
        const auto &now = areas.units[variant], &then = areas.units[areas.variants[variant].base];
        const auto part = now.find(unit.name), old = then.find(unit.name);
        if (part == now.end()) continue;
        const Count none;
        const Count& was = old == then.end() ? none : old->second.count;
        if (part->second.count != was)
            rows.push_back(joined(unit.name, change_cells(part->second.count, was)));
    }
    return rows;
}

std::string summary(const Areas& areas) {
    Table table(
        {"one pipeline", "LUTs", "FF", "MULT18X18D", "DP16KD", "more LUTs", "more FF", "more multipliers"});
    for (std::size_t v = 0; v < areas.variants.size(); ++v) {
        const Count now = pipeline_count(areas, v), was = pipeline_count(areas, areas.variants[v].base);
        Row cells{areas.variants[v].name, grouped(now.luts()), grouped(now.ff), grouped(now.dsp),
                  grouped(now.bram)};
        if (v == hits_alone)
            cells.insert(cells.end(), {"", "", ""});
        else
            cells.insert(cells.end(), {signed_text(now.luts(), was.luts()), signed_text(now.ff, was.ff),
                                       signed_text(now.dsp, was.dsp)});
        table.add(cells);
    }
    return table.markdown();
}

std::string speed_table(const std::vector<Speed>& speeds) {
    Table table({"machine", "cycles of the frame", "rays", "model, s", "RTL, s", "model, M cycles/s",
                 "RTL, k cycles/s", "model / RTL", "RTL's time, first is 1", "compiled RTL, kB"});
    for (const Speed& s : speeds) {
        const double cycles = double(s.cycles), first = speeds[0].rtl_seconds / double(speeds[0].cycles);
        table.add({s.name, grouped(s.cycles), grouped(std::uint64_t(s.rays)),
                   fmt::format("{:.3f}", s.model_seconds), fmt::format("{:.2f}", s.rtl_seconds),
                   fmt::format("{:.2f}", cycles / s.model_seconds / 1e6),
                   fmt::format("{:.1f}", cycles / s.rtl_seconds / 1e3),
                   fmt::format("{:.1f}", s.rtl_seconds / s.model_seconds),
                   fmt::format("{:.2f}", s.rtl_seconds / cycles / first), grouped(s.library / 1000)});
    }
    return table.markdown();
}

std::string how_counted() {
    return fmt::format(R"(
## How it is counted

Yosys synthesises each unit alone: `read_verilog -sv -defer` of the package and all sources, `hierarchy -check
-top rc_UNIT` (for the arbiter with the sources and the width that rc_top gives it), `setattr -mod -set
keep_hierarchy 1` on the cells that have a row of their own, then `synth_ecp5 -nowidelut` and `stat -json`. The
last step of `synth_ecp5`, which names cells and checks, is left out, and resets of fewer than 16 flip-flops
become logic first. {}. Units whose netlists are equal before synthesis are synthesised once.

- **LUTs** are sites of a LUT4: one for a LUT4, two for a CCU2C (two bits of a carry chain), six for a
  TRELLIS_DPR16X4 (16 words of 4 bits of distributed memory take three slices of two LUT4 each, one of
  them for writing).
- **FF** are TRELLIS_FF, **MULT18X18D** 18 x 18 multipliers, **DP16KD** block memories of 18 Kbit. Delay
  lines are flip-flops, but long ones (`rc_delay_ram`) are distributed memory.
- A row includes the rows below it that are indented further. A cell is optimised alone: nothing is shared or
  propagated across its border, so a unit counts slightly more than if it were flattened. The same holds for
  the borders between units.
- Not counted: PFUMX and L6MUX21, which join LUTs of a slice and take no site; the activity counters
  (`rc_counters`), the host's registers (`rc_host`) and the wires of rc_pipeline, rc_top and rc_chip; the
  memory's controller; placement and routing. This page claims no clock rate.
)",
                       synth::yosys_version().substr(0, synth::yosys_version().find(" (")));
}

}   // namespace

std::string table(const Areas& areas) {
    std::string text;
    for (std::size_t v = 0; v < areas.variants.size(); ++v) {
        if (areas.units[v].empty()) continue;
        std::vector<Row> rows = unit_rows_of(areas, v, "  ");
        for (Row& row : rows) std::erase(row[0], '*');
        text += count_table(areas.variants[v].name, rows).text() + "\n";
    }
    return text;
}

ordered_json json(const Areas& areas, const std::vector<Speed>& speeds) {
    ordered_json all{{"yosys", synth::yosys_version()},
                     {"script", synth::synth_script()},
                     {"variants", ordered_json::array()},
                     {"speed", ordered_json::array()}};
    for (std::size_t v = 0; v < areas.variants.size(); ++v) {
        ordered_json variant{{"name", areas.variants[v].name},
                             {"pipeline", synth::count_json(pipeline_count(areas, v))},
                             {"units", ordered_json::array()}};
        for (const UnitRow& unit : unit_rows())
            if (const auto part = areas.units[v].find(unit.name); part != areas.units[v].end())
                variant["units"].push_back(synth::part_json(part->second));
        all["variants"].push_back(variant);
    }
    for (const Speed& s : speeds)
        all["speed"].push_back({{"name", s.name},
                                {"cycles", s.cycles},
                                {"rays", s.rays},
                                {"model_seconds", s.model_seconds},
                                {"rtl_seconds", s.rtl_seconds},
                                {"library_bytes", s.library}});
    return all;
}

std::vector<Speed> page_speeds(const Areas& areas, const Progress& progress) {
    Whitted settings;
    settings.depth = speed_depth;
    const std::vector<Variant> machines{areas.variants[hits_alone], areas.variants[shading_only],
                                        areas.variants.back()};
    return measure(machines, ready_scene(speed_scene, speed_size, progress), speed_size, settings,
                   speed_rounds, progress);
}

std::string page(const Areas& areas, const std::vector<Speed>& speeds, const std::string& base,
                 const std::string& command) {
    const chip::Device& largest = chip::devices().back();
    std::string text = fmt::format(
        "# Area\n\nThe resources of each unit on an ECP5, and the cost of the units that only some scenes "
        "need.\n\nMade by `{}`, which counts or measures every figure.\nConditions: configuration `{}` "
        "except for its optional units; {}.\n\n## With and without\n\n`hits` finds the hits of camera rays "
        "and computes no colours. `stream` finds the hits of rays from memory\n"
        "([streams](../guide/streams.md)), and `stream, hits in memory` writes its answers there. The other "
        "machines make finished pictures: `shading` has no "
        "further "
        "unit,\nthe next ones have one more each, and the last has all. \"More\" compares `stream` and "
        "`shading` with `hits`, `stream, hits in memory` with `stream`, and the others with "
        "`shading`.\nThe largest ECP5, {}, has {} LUTs and as "
        "many flip-flops, "
        "{} multipliers and {} block memories.\n\n",
        command, base, synth::yosys_version().substr(0, synth::yosys_version().find(" (")), largest.name,
        grouped(largest.has.lut), largest.has.dsp, largest.has.bram);
    text += summary(areas);
    for (const std::size_t v : {hits_alone, stream_alone, shading_only, areas.variants.size() - 1}) {
        text += fmt::format("\n## Units of `{}`\n\n", areas.variants[v].name);
        text += count_table("unit", unit_rows_of(areas, v, "&emsp;")).markdown();
    }
    text +=
        "\n## Units that change\n\nEach machine is compared as above; all other units are the same. The unit "
        "`hits` is not part of a pipeline, so the first table does not contain it.\n";
    for (std::size_t v = 1; v < areas.variants.size(); ++v) {
        if (v == shading_only) continue;
        text += fmt::format("\n### {}\n\n", areas.variants[v].name) +
                count_table("unit", changes(areas, v)).markdown();
    }
    if (!speeds.empty()) {
        text += fmt::format(
            "\n## Speed of simulation\n\n{} as triangles, {}x{}, depth {}; one thread, the best of several "
            "runs that take turns on one host. `hits` traces only camera rays, so compare\nits cycles per "
            "second, not its seconds. The command checks that model and RTL take the same cycles.\n\n",
            speed_scene, speed_size.width, speed_size.height, speed_depth);
        text += speed_table(speeds);
    }
    return text + how_counted();
}

}   // namespace rayclock::area
