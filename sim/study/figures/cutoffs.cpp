// Compares two cut-offs of a ray's tree: what each saves, and the error it causes.
#include <cmath>

#include <fmt/format.h>

#include "sim/study/figures/figures_page.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::figures {

namespace {

struct Case {
    const char* scene;
    const char* what;
};
constexpr Case cases[] = {{"spheres", "glass, mirror and matt spheres"},
                          {"balls:3", "half mirroring spheres"},
                          {"mount:5", "glass spheres above a mountain"},
                          {"gears:2", "gears, some of them glass"}};
constexpr int finest_cutoff = 8;   // thresholds 2^-8 to 2^-1

struct CutoffPoint {
    Whitted settings;
    RayCounts rays;
    std::uint64_t cycles = 0;
    Distance error;
    std::string label() const {
        return settings.threshold > 0 ? fmt::format("1/{:.0f}", 1 / settings.threshold)
                                      : fmt::format("{}", settings.depth);
    }
};

struct Curves {
    Tracer tracer;
    /// The last depth and the first threshold are the whole tree.
    std::vector<CutoffPoint> depths, thresholds;
};

CutoffPoint point_of(const Shot& shot, const Whitted& settings, const Picture& whole) {
    return {settings, shot.rays, shot.run ? shot.run->cycles : 0, distance(shot.picture, whole)};
}

Curves measure_cutoffs(Stage& stage, Tracer tracer) {
    Curves curves{tracer, {}, {}};
    const Whitted all{.depth = max_depth};
    const Shot whole = stage.take(tracer, all);
    for (int depth = 0; depth < max_depth; ++depth) {
        const Whitted settings{.depth = depth};
        curves.depths.push_back(point_of(stage.take(tracer, settings), settings, whole.picture));
        if (curves.depths.back().rays == whole.rays) break;   // no ray goes deeper
    }
    curves.depths.push_back(point_of(whole, all, whole.picture));
    curves.thresholds.push_back(curves.depths.back());
    for (int shift = finest_cutoff; shift >= 1; --shift) {
        const Whitted settings{.depth = max_depth, .threshold = 1.0 / (1 << shift)};
        curves.thresholds.push_back(point_of(stage.take(tracer, settings), settings, whole.picture));
    }
    return curves;
}

std::vector<std::string> row_of(const CutoffPoint& p, const CutoffPoint& whole, const std::string& name,
                                Tracer tracer, int khz) {
    std::vector<std::string> row{name, title_of(tracer), grouped(p.rays.all()),
                                 per_cent(1 - double(p.rays.all()) / double(whole.rays.all()))};
    if (p.cycles)
        row.insert(row.end(), {grouped(p.cycles), fmt::format("{:.1f}", khz * 1e3 / double(p.cycles))});
    else
        row.insert(row.end(), {"", ""});
    row.insert(row.end(), {fmt::format("{:.5f}", p.error.rmse), decibels(p.error.psnr_db)});
    return row;
}

nlohmann::ordered_json json_of(const std::vector<CutoffPoint>& points) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const CutoffPoint& p : points) {
        list.push_back({{"depth", p.settings.depth},
                        {"threshold", p.settings.threshold},
                        {"rays", p.rays.all()},
                        {"rmse", p.error.rmse},
                        {"psnr_db", p.error.psnr_db}});
        if (!std::isfinite(p.error.psnr_db)) list.back()["psnr_db"] = nullptr;
        if (p.cycles) list.back()["cycles"] = p.cycles;
    }
    return list;
}

/// Plots a machine's curve against frames per second, and the reference's against rays.
plot::Panel panel_of(const std::string& title, const std::vector<CutoffPoint>& points,
                     const std::string& whole, int khz) {
    const bool is_machine = points[0].cycles > 0;
    plot::Panel panel{title,
                      is_machine ? fmt::format("frames per second at {} MHz", khz / 1000) : "rays, thousands",
                      "RMSE against the whole tree",
                      true,
                      {}};
    for (const CutoffPoint& p : points) {
        const bool is_whole = p.settings.depth == max_depth && p.settings.threshold == 0;
        panel.marks.push_back({is_machine ? khz * 1e3 / double(p.cycles) : double(p.rays.all()) / 1e3,
                               p.error.rmse, is_whole ? whole : p.label(), true, false});
    }
    return panel;
}

void tabulate(Page& page, const std::vector<Curves>& all, int khz) {
    std::vector<std::vector<std::string>> rows;
    for (const Curves& c : all) {
        const CutoffPoint& whole = c.depths.back();
        for (const CutoffPoint& p : c.depths)
            rows.push_back(row_of(p, whole, "depth " + p.label(), c.tracer, khz));
        for (std::size_t i = 1; i < c.thresholds.size(); ++i)
            rows.push_back(
                row_of(c.thresholds[i], whole, "weight >= " + c.thresholds[i].label(), c.tracer, khz));
    }
    page.table({"cut-off", "engine", "rays", "rays saved", "cycles", "fps at 66 MHz", "RMSE", "PSNR, dB"},
               rows);
}

/// Names the cheapest settings whose error is barely visible in an 8-bit picture.
std::string best_sentence(const Curves& c) {
    constexpr double enough = 50;
    const CutoffPoint &whole = c.depths.back(), *depth = &whole, *threshold = &whole;
    for (auto p = c.depths.rbegin(); p != c.depths.rend() && p->error.psnr_db >= enough; ++p) depth = &*p;
    for (const CutoffPoint& p : c.thresholds)
        if (p.error.psnr_db >= enough) threshold = &p;
    const auto saved = [&](const CutoffPoint& p) {
        return per_cent(1 - double(p.rays.all()) / double(whole.rays.all()));
    };
    return fmt::format("By the {}, {:.0f} dB are kept by depth {} ({} of the rays saved){}.",
                       title_of(c.tracer), enough, depth->label(), saved(*depth),
                       threshold == &whole ? ", and by none of the thresholds"
                                           : fmt::format(", and by the threshold {} ({} saved)",
                                                         threshold->label(), saved(*threshold)));
}

}   // namespace

void cutoffs(Page& page) {
    page.say(fmt::format(
        "\n## Two cut-offs: speed against error\n\nA ray's tree ends at a depth, or where a ray's weight "
        "falls below a threshold (Hall and Greenberg 1983). The tables show the rays of all purposes, the "
        "share of them that each cut-off saves, and the error against the same engine's picture of the whole "
        "tree (depth {}, threshold 0; RMSE of linear colours, 1 is full scale). Depths that no ray reaches "
        "are left out. Thresholds are measured at depth {}.\n",
        max_depth, max_depth));
    for (const Case& c : cases) {
        Stage stage(page.studio(), c.scene, {.depth = max_depth});
        std::vector<Curves> all;
        for (const Tracer tracer : page.measured()) all.push_back(measure_cutoffs(stage, tracer));
        if (all.empty()) continue;
        const int khz = stage.job().khz;
        page.say(fmt::format("\n### `{}`: {}\n\n", c.scene, c.what));
        const Curves& shown = all.back();
        const std::string file =
            "cutoffs-" + std::string(c.scene).substr(0, std::string_view(c.scene).find(':'));
        page.say(
            page.plot(file, plot::chart(fmt::format("{}, {}x{} pixels, {}", c.scene, stage.job().size.width,
                                                    stage.job().size.height, title_of(shown.tracer)),
                                        "labels: the depth, the threshold",
                                        {panel_of("depth", shown.depths, "15", khz),
                                         panel_of("threshold", shown.thresholds, "0", khz)})) +
            "\n\n");
        for (const Curves& curves : all) page.say(best_sentence(curves) + " ");
        page.say("\n");
        tabulate(page, all, khz);
        for (const Curves& curves : all)
            page.numbers["cutoffs"][c.scene][title_of(curves.tracer)] = {
                {"depths", json_of(curves.depths)}, {"thresholds", json_of(curves.thresholds)}};
    }
}

}   // namespace rayclock::figures
