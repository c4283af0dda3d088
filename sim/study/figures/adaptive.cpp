// Compares adaptive samples with the same number of samples everywhere.
#include <fmt/format.h>

#include "sim/study/figures/figures_page.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::figures {

namespace {

constexpr const char* adaptive_scenes[] = {"spheres", "plane"};
constexpr int adaptive_depth = 3;
constexpr int sides[] = {1, 2, 3, 4};
constexpr int adaptive_side = 4, finest = 8;   // contrasts 2^-8 to 2^-1

struct SamplingPoint {
    std::string label;
    Whitted settings;
    RayCounts rays;
    std::uint64_t cycles = 0;
    Distance error;
};

std::vector<SamplingPoint> measure_samplings(Stage& stage, Tracer tracer) {
    const Picture best = stage.take(tracer, {.depth = adaptive_depth, .aa = max_aa}).picture;
    std::vector<SamplingPoint> points;
    const auto add = [&](const std::string& label, const Whitted& settings) {
        const Shot shot = stage.take(tracer, settings);
        points.push_back(
            {label, settings, shot.rays, shot.run ? shot.run->cycles : 0, distance(shot.picture, best)});
    };
    for (const int side : sides) add(fmt::format("{}x{}", side, side), {.depth = adaptive_depth, .aa = side});
    for (int shift = 1; shift <= finest; ++shift)
        add(fmt::format("1/{}", 1 << shift),
            {.depth = adaptive_depth, .aa = adaptive_side, .contrast = 1.0 / (1 << shift)});
    return points;
}

nlohmann::ordered_json json_of(const std::vector<SamplingPoint>& points) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SamplingPoint& p : points) {
        list.push_back({{"aa", p.settings.aa},
                        {"contrast", p.settings.contrast},
                        {"samples", p.rays.primary},
                        {"rays", p.rays.all()},
                        {"rmse", p.error.rmse},
                        {"psnr_db", p.error.psnr_db}});
        if (p.cycles) list.back()["cycles"] = p.cycles;
    }
    return list;
}

double cost(const SamplingPoint& p, int khz) {
    return p.cycles ? double(p.cycles) / khz : double(p.rays.all()) / 1e3;
}

/// Draws uniform samples dark and adaptive samples pale. Adaptive samples that beat a uniform grid are dark.
plot::Drawing drawing(const std::string& title, const std::vector<SamplingPoint>& points, int khz) {
    plot::Panel even{"the same everywhere",
                     points[0].cycles ? "milliseconds a frame at 66 MHz" : "rays, thousands",
                     "RMSE against 8x8 samples",
                     true,
                     {}};
    plot::Panel adaptive = even;
    adaptive.title =
        fmt::format("4 samples, and the rest of {}x{} where needed", adaptive_side, adaptive_side);
    for (const SamplingPoint& p : points) {
        if (p.settings.contrast == 0) {
            even.marks.push_back({cost(p, khz), p.error.rmse, p.label, true, false});
            adaptive.marks.push_back({cost(p, khz), p.error.rmse, p.label, false, false});
        } else {
            adaptive.marks.push_back({cost(p, khz), p.error.rmse, p.label, true, false});
            even.marks.push_back({cost(p, khz), p.error.rmse, "", false, false});
        }
    }
    return plot::chart(
        title,
        "left: samples a pixel; right: the contrast above which a pixel gets all; pale: the other panel's",
        {even, adaptive});
}

double work(const SamplingPoint& p) { return p.cycles ? double(p.cycles) : double(p.rays.all()); }

/// Names the finest uniform grid that some contrast beats in error and in work, and the cheapest such
/// contrast.
std::string sentence(const std::vector<SamplingPoint>& points, Tracer tracer) {
    const SamplingPoint *even = nullptr, *cheap = nullptr;
    for (const SamplingPoint& e : points) {
        if (e.settings.contrast > 0) continue;
        const SamplingPoint* least = nullptr;
        for (const SamplingPoint& p : points)
            if (p.settings.contrast > 0 && p.error.rmse <= e.error.rmse && work(p) < work(e) &&
                (!least || work(p) < work(*least)))
                least = &p;
        if (least) even = &e, cheap = least;
    }
    if (!even) return fmt::format("By the {}, no contrast beats an even grid.", title_of(tracer));
    return fmt::format(
        "By the {}, contrast {} has an error of {:.4f}, {} everywhere of {:.4f} with {:.2f} times the {}.",
        title_of(tracer), cheap->label, cheap->error.rmse, even->label, even->error.rmse,
        work(*even) / work(*cheap), cheap->cycles ? "cycles" : "rays");
}

}   // namespace

void adaptive(Page& page) {
    page.say(fmt::format(
        "\n## Samples where they are needed\n\nEach pixel takes four samples, one in each quarter. It takes "
        "the other {} of {}x{} only if some channel of the four differs by more than the contrast (after "
        "Mitchell 1987). Depth {}. Error against the same engine's picture of 8x8 samples everywhere.\n",
        adaptive_side * adaptive_side - 4, adaptive_side, adaptive_side, adaptive_depth));
    for (const char* scene : adaptive_scenes) {
        Stage stage(page.studio(), scene, {.depth = adaptive_depth, .aa = max_aa});
        page.say(fmt::format("\n### `{}`\n\n", scene));
        std::vector<std::vector<std::string>> rows;
        std::string sentences;
        for (const Tracer tracer : page.measured()) {
            const std::vector<SamplingPoint> points = measure_samplings(stage, tracer);
            const int khz = stage.job().khz;
            const double pixels = double(stage.job().size.width) * stage.job().size.height;
            if (tracer == page.measured().back())
                page.say(page.plot(std::string("adaptive-") + scene,
                                   drawing(fmt::format("{}, {}x{} pixels, {}", scene, stage.job().size.width,
                                                       stage.job().size.height, title_of(tracer)),
                                           points, khz)) +
                         "\n\n");
            for (const SamplingPoint& p : points)
                rows.push_back({p.settings.contrast > 0 ? "contrast " + p.label : p.label, title_of(tracer),
                                fmt::format("{:.2f}", double(p.rays.primary) / pixels), grouped(p.rays.all()),
                                p.cycles ? grouped(p.cycles) : "", fmt::format("{:.5f}", p.error.rmse),
                                decibels(p.error.psnr_db)});
            sentences += sentence(points, tracer) + " ";
            page.numbers["adaptive"][scene][title_of(tracer)] = json_of(points);
        }
        page.say(sentences + "\n");
        page.table({"samples", "engine", "samples a pixel", "rays", "cycles", "RMSE", "PSNR, dB"}, rows);
    }
}

}   // namespace rayclock::figures
