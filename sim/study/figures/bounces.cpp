// Renders reflecting spheres on a checkered floor, bounce by bounce, and the contribution of each bounce.
#include <fmt/format.h>

#include "sim/study/figures/figures_page.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::figures {

namespace {

constexpr int most = 5;
constexpr double factor = 4;

struct Series {
    Tracer tracer;
    std::vector<Shot> shots;   ///< by depth
};

/// Renders all depths. Returns a series for each tracer, in the order of the first depth's shots.
std::vector<Series> draw(Page& page) {
    Stage stage(page.studio(), "spheres", {.depth = most});
    std::vector<Series> all;
    for (int depth = 0; depth <= most; ++depth) {
        auto shots = page.shots(stage, fmt::format("spheres at depth {}", depth), {.depth = depth});
        for (std::size_t i = 0; i < shots.size(); ++i) {
            if (depth == 0) all.push_back({shots[i].first, {}});
            if (i < all.size()) all[i].shots.push_back(std::move(shots[i].second));
        }
    }
    return all;
}

std::vector<std::string> row_of(const Series& s, std::size_t k, const Series& first) {
    const Shot& shot = s.shots[k];
    std::vector<std::string> row{std::to_string(k),
                                 title_of(s.tracer),
                                 grouped(shot.rays.primary),
                                 grouped(shot.rays.shadow),
                                 grouped(shot.rays.reflection),
                                 grouped(shot.rays.refraction)};
    row.push_back(shot.run ? grouped(shot.run->cycles) : "");
    row.push_back(s.tracer != Tracer::reference && first.tracer == Tracer::reference
                      ? decibels(distance(shot.picture, first.shots[k].picture).psnr_db)
                      : "");
    if (k == 0) {
        row.insert(row.end(), {"", ""});
    } else {
        const Distance d = distance(shot.picture, s.shots[k - 1].picture);
        row.push_back(fmt::format("{:.3f} %", 100 * d.mean));
        row.push_back(fmt::format("{:.2f} %", 100 * d.mean / mean_of(s.shots.back().picture)));
    }
    return row;
}

nlohmann::ordered_json json_of(const Series& s) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < s.shots.size(); ++k) {
        const Shot& shot = s.shots[k];
        list.push_back({{"depth", k}, {"rays", shot.rays.all()}, {"mean", mean_of(shot.picture)}});
        if (k > 0) list.back()["added"] = distance(shot.picture, s.shots[k - 1].picture).mean;
        if (shot.run) list.back()["cycles"] = shot.run->cycles;
    }
    return list;
}

void show(Page& page, const Series& s, std::size_t from, std::size_t to) {
    std::vector<std::string> head, pictures, differences;
    for (std::size_t k = from; k < to; ++k) {
        const Picture& picture = s.shots[k].picture;
        const std::string name = fmt::format("spheres-{}-{}", title_of(s.tracer), k);
        head.push_back(fmt::format("depth {}", k));
        pictures.push_back(page.picture(name, picture));
        if (k == 0)
            differences.emplace_back();
        else
            differences.push_back(
                page.picture(name + "-added", amplified_difference(picture, s.shots[k - 1].picture, factor)));
    }
    Table table(head, Table::words_only);
    table.add(pictures);
    table.add(differences);
    page.say("\n" + table.markdown());
}

}   // namespace

void bounces(Page& page) {
    const std::vector<Series> all = draw(page);
    page.say(fmt::format(
        "\n## Bounce by bounce\n\nGlass, mirror, metal and matt spheres on an endless checkered floor "
        "(`spheres`). The tree of each camera ray is followed to depth 0 (its hit, and shadows) up to {}. "
        "Below each picture is its difference from the previous depth, |difference| times {:.0f}.\n",
        most, factor));
    for (const Series& s : all) {
        if (!page.is_shown(s.tracer)) continue;
        page.say(fmt::format("\nBy the {}:\n", title_of(s.tracer)));
        show(page, s, 0, 3);
        show(page, s, 3, most + 1);
    }
    page.say(
        "\nRays of each purpose, and the energy that each depth added: the mean over all pixels and channels "
        "of the absolute difference of linear colours, in per cent of full scale and of the mean of the last "
        "picture. Distant points of the floor exceed the machine's number range. From them the machine sends "
        "no rays, counts all lights, and shows the background in the mirror.\n");
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 0; k <= most; ++k)
        for (const Series& s : all)
            if (k < s.shots.size() && page.is_shown(s.tracer)) rows.push_back(row_of(s, k, all[0]));
    page.table({"depth", "engine", "camera", "shadow", "reflected", "refracted", "cycles",
                "PSNR from reference, dB", "added, of full scale", "of the last picture"},
               rows);
    if (!all.empty()) {
        const std::vector<Shot>& shots = all.back().shots;
        const auto added = [&](std::size_t k) {
            return distance(shots[k].picture, shots[k - 1].picture).mean;
        };
        page.say(
            fmt::format("The first bounce adds {:.1f} times as much as the third, and {:.0f} times as much "
                        "as the fifth.\n",
                        added(1) / added(3), added(1) / added(5)));
    }
    for (const Series& s : all) page.numbers["bounces"][title_of(s.tracer)] = json_of(s);
}

}   // namespace rayclock::figures
