// Computes the rows, means and rankings of structures.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/study/structures/structures_page.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::structures {

namespace {

nlohmann::ordered_json row_of(const SceneCells& scene, const Cell& cell, const Frame& frame, bool finished,
                              const area::Count* area, const Limits& limits) {
    nlohmann::ordered_json row{
        {"scene", scene.name},
        {"structure", cell.structure},
        {"frame", finished ? "finished" : "camera"},
        {"rays", std::uint64_t(frame.rays())},
        {"visits", frame.run.visits},
        {"tests", frame.run.triangle_tests},
        {"primitives", scene.primitives},
        {"references", finished ? nullptr : nlohmann::ordered_json(cell.report.references)},
        {"bytes", finished ? nullptr : nlohmann::ordered_json(cell.report.bytes)},
        {"depth", finished ? nullptr : nlohmann::ordered_json(cell.report.depth)},
        {"build_seconds", finished ? nullptr : nlohmann::ordered_json(cell.build)},
        {"cycles", frame.run.cycles},
        {"fps", frame.fps()},
        {"bytes_read", bytes_read(frame.run)},
        {"bound", frame.bound.unit},
        {"bound_reached", frame.bound.reached},
        {"pixels_other_primitive", frame.error.pixels_other_primitive},
        {"psnr_db", decibel(frame.error.psnr_db)},
        {"far", !far_from_reference(limits, frame.error).empty()}};
    for (const char* key : {"lut", "ff", "dsp", "bram"}) row[key] = nullptr;
    if (area)
        row["lut"] = area->luts(), row["ff"] = area->ff, row["dsp"] = area->dsp, row["bram"] = area->bram;
    return row;
}

/// Returns the structure with the fewest cycles in the surroundings `at`, and the lead over the next one.
std::string best_of(const SceneCells& scene, std::size_t at) {
    const Ranking ranking = ranked(scene, at);
    if (!ranking.next) return "-";
    const Cell &best = *ranking.best, &next = *ranking.next;
    return fmt::format("{} {:.2f} ({} x {:.2f})", best.structure, best.elsewhere[at], next.structure,
                       next.elsewhere[at] / best.elsewhere[at]);
}

}   // namespace

Ranking ranked(const SceneCells& scene, std::size_t at) {
    Ranking ranking;
    for (const Cell& c : scene.cells) {
        if (!c.refused.empty() || c.structure == "bvh, splits") continue;
        if (!ranking.best || c.elsewhere[at] < ranking.best->elsewhere[at]) {
            ranking.next = ranking.best, ranking.best = &c;
        } else if (!ranking.next || c.elsewhere[at] < ranking.next->elsewhere[at]) {
            ranking.next = &c;
        }
    }
    return ranking;
}

std::vector<SceneCells> triangle_scenes(const Figures& figures) {
    std::vector<SceneCells> scenes;
    for (const SceneCells& scene : figures.large)
        if (!scene.is_round) scenes.push_back(scene);
    return scenes;
}

const area::Count* area_of(const Figures& figures, const SceneCells& scene, std::size_t structure,
                           bool finished) {
    if (!figures.areas) return nullptr;
    const Areas& areas = (*figures.areas)[structure];
    return finished || scene.is_round ? &areas.all : &areas.hits;
}

nlohmann::ordered_json rows(const Figures& figures, const Limits& limits) {
    auto all = nlohmann::ordered_json::array();
    for (const SceneCells& scene : figures.large)
        for (std::size_t i = 0; i < scene.cells.size(); ++i) {
            const Cell& cell = scene.cells[i];
            if (!cell.refused.empty()) continue;
            all.push_back(row_of(scene, cell, cell.camera, false, area_of(figures, scene, i, false), limits));
            if (cell.finished)
                all.push_back(
                    row_of(scene, cell, *cell.finished, true, area_of(figures, scene, i, true), limits));
        }
    return {{"rows", all}};
}

double mean_of(const std::vector<SceneCells>& scenes, std::size_t structure, double (*value)(const Cell&)) {
    double sum = 0;
    int n = 0;
    for (const SceneCells& scene : scenes) {
        if (std::any_of(scene.cells.begin(), scene.cells.end(),
                        [](const Cell& c) { return !c.refused.empty(); }))
            continue;
        sum += std::log(value(scene.cells[structure]));
        ++n;
    }
    return n > 0 ? std::exp(sum / n) : 0;
}

std::string best_table(const std::vector<SceneCells>& scenes, const Config& base) {
    std::vector<std::string> head{"scene"};
    for (const Surroundings& around : surroundings())
        head.push_back(
            fmt::format("{}, {} KB", around.dram, around.sets * base.node_ways * base.node_line / 1024));
    Table table(head);
    for (const SceneCells& scene : scenes) {
        std::vector<std::string> row{scene.name};
        for (std::size_t i = 0; i < surroundings().size(); ++i) row.push_back(best_of(scene, i));
        table.add(row);
    }
    return table.markdown();
}

}   // namespace rayclock::structures
