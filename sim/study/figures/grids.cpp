// Renders a checkered plane and an edge with samples on regular and on jittered grids.
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "sim/study/figures/figures_page.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::figures {

namespace {

struct Grid {
    int side;
    bool jitter;
};
constexpr Grid grids[] = {{1, false}, {1, true}, {2, false}, {2, true}, {4, false}, {4, true}};

std::string grid_name(const Grid& g) {
    return fmt::format("{}x{} {}", g.side, g.side, g.jitter ? "jittered" : "regular");
}
std::string file_of(const Grid& g) { return fmt::format("{}{}", g.side, g.jitter ? "j" : "r"); }

struct Sample {
    Grid grid;
    Tracer tracer;
    Shot shot;
};

std::vector<Sample> draw(Page& page, Stage& stage, const std::string& scene) {
    std::vector<Sample> all;
    for (const Grid& g : grids)
        for (auto& [tracer, shot] :
             page.shots(stage, scene + ", " + grid_name(g), {.depth = 0, .aa = g.side, .jitter = g.jitter}))
            all.push_back({g, tracer, std::move(shot)});
    return all;
}

/// Shows two rows of three pictures for each tracer: regular above, jittered below.
void show(Page& page, const std::vector<Sample>& all, const std::string& scene,
          const std::function<Picture(const Picture&)>& prepare) {
    for (const Tracer tracer : {Tracer::reference, Tracer::model, Tracer::rtl}) {
        if (!page.studio().has(tracer) || !page.is_shown(tracer)) continue;
        Table table({"", "1 sample", "2x2", "4x4"}, Table::words_only);
        for (const bool jitter : {false, true}) {
            std::vector<std::string> row{jitter ? "jittered" : "regular"};
            for (const Sample& s : all)
                if (s.tracer == tracer && s.grid.jitter == jitter)
                    row.push_back(page.picture(
                        fmt::format("{}-{}-{}", scene, figures::title_of(tracer), file_of(s.grid)),
                        prepare(s.shot.picture)));
            table.add(row);
        }
        page.say(fmt::format("\nBy the {}:\n\n{}", figures::title_of(tracer), table.markdown()));
    }
}

/// Tabulates the distance to the reference's picture with 8x8 regular samples.
void tabulate(Page& page, const std::vector<Sample>& all, const Picture& best, const char* key) {
    std::vector<std::vector<std::string>> rows;
    for (const Sample& s : all) {
        const Distance d = distance(s.shot.picture, best);
        if (page.is_shown(s.tracer))
            rows.push_back({grid_name(s.grid), figures::title_of(s.tracer), grouped(s.shot.rays.all()),
                            s.shot.run ? grouped(s.shot.run->cycles) : "", fmt::format("{:.4f}", d.rmse),
                            decibels(d.psnr_db)});
        nlohmann::ordered_json json{{"samples", s.grid.side * s.grid.side},
                                    {"jittered", s.grid.jitter},
                                    {"engine", figures::title_of(s.tracer)},
                                    {"rays", s.shot.rays.all()},
                                    {"rmse", d.rmse},
                                    {"psnr_db", d.psnr_db}};
        if (s.shot.run) json["cycles"] = s.shot.run->cycles;
        page.numbers[key].push_back(json);
    }
    page.table({"samples", "engine", "rays", "cycles", "RMSE", "PSNR, dB"}, rows);
}

constexpr Whitted best_settings{.depth = 0, .aa = 8};

}   // namespace

void endless_plane(Page& page) {
    Stage stage(page.studio(), "plane", {.depth = 0, .aa = 4, .jitter = true});
    const std::vector<Sample> all = draw(page, stage, "plane");
    page.say(
        "\n## The endless plane\n\nAn infinite checkered plane (`plane`). Towards the horizon its squares "
        "become smaller than pixels. One sample in the middle of each pixel makes false patterns (aliases). "
        "More samples push them towards the horizon; jitter turns them into noise. Where squares are too far "
        "away for its numbers, the machine takes the average of both colours.\n");
    show(page, all, "plane", [](const Picture& p) { return p; });
    page.say(
        "\nError against the reference's picture of 8x8 regular samples (RMSE of linear colours, 1 is full "
        "scale; PSNR of 8-bit sRGB):\n");
    tabulate(page, all, stage.take(Tracer::reference, best_settings).picture, "plane");
}

void edge(Page& page) {
    // The square's left edge, where the picture is magnified. It lies 0.3018 of the picture's height from the
    // middle.
    const FrameSize size{64, 48};
    constexpr int w = 32, h = 24, factor = 8;
    const double half_height = std::tan(45 * std::numbers::pi / 360) * 4;
    const int x = int(size.width / 2.0 - size.height / 2.0 / half_height) - w / 2, y = (size.height - h) / 2;
    Stage stage(page.studio(), "square", {.depth = 0, .aa = 4, .jitter = true}, size);
    const std::vector<Sample> all = draw(page, stage, "square");
    page.say(
        fmt::format("\n## An edge\n\nThe left edge of a slightly turned white square (`square`): {}x{} "
                    "pixels of a picture of {}x{}, magnified {} times. On a regular grid of n x n "
                    "samples the edge becomes a staircase. Jitter makes the position of the steps random.\n",
                    w, h, size.width, size.height, factor));
    show(page, all, "square", [&](const Picture& p) { return magnified(p, x, y, w, h, factor); });
    page.say("\nError against the reference's picture of 8x8 regular samples, over the whole picture:\n");
    tabulate(page, all, stage.take(Tracer::reference, best_settings).picture, "square");
}

}   // namespace rayclock::figures
