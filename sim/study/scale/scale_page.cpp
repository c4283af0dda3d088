// Writes the page of the study of scale.
#include "sim/study/scale/scale_page.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/task_arena.h>

#include "sim/files/process/parallel.hpp"
#include "sim/files/table.hpp"

namespace rayclock::scale {

namespace {

std::uint64_t triangles_of(const Row& row) { return row.triangles; }
std::uint64_t pixels_of(const Row& row) { return row.pixels(); }

std::string size_text(FrameSize size) { return fmt::format("{}x{}", size.width, size.height); }

std::string seconds_text(double seconds) {
    return seconds < 0.995 ? fmt::format("{:.3f}", seconds) : fmt::format("{:.2f}", seconds);
}

std::vector<std::string> head(const char* first) {
    std::vector<std::string> names{first, "triangles", "pixels"};
    for (const char* name : work_names) names.push_back(std::string(name) + " s");
    names.insert(names.end(), {"image MB", "peak MB", "cycles", "judged", "wrong"});
    return names;
}

std::vector<std::string> cells_of(const Row& row) {
    std::vector<std::string> text{fmt::format("`{}`", row.scene), grouped(row.triangles),
                                  size_text(row.size)};
    for (const double seconds : row.seconds) text.push_back(seconds_text(seconds));
    text.insert(text.end(), {fmt::format("{:.1f}", double(row.image_bytes) / 1e6),
                             fmt::format("{:.0f}", double(row.peak_bytes) / 1e6), grouped(row.cycles),
                             grouped(row.judged), grouped(row.wrong)});
    return text;
}

/// Returns a series as a table. If `x` is given, it returns the size of a row, and the table ends with the
/// exponents.
std::string table(const std::vector<Row>& rows, std::uint64_t (*x)(const Row&)) {
    Table table(head("scene"));
    for (const Row& row : rows) table.add(cells_of(row));
    if (x) {
        std::vector<std::string> last{"**exponent**", "", ""};
        for (std::size_t w = 0; w < works; ++w) {
            const double p = exponent(rows, Work(w), x);
            last.push_back(std::isnan(p) ? "" : fmt::format("**{:.2f}**", p));
        }
        last.resize(head("").size());
        table.add(last);
    }
    return table.markdown();
}

using Json = nlohmann::ordered_json;

Json row_json(const Row& row) {
    Json seconds = Json::object();
    for (std::size_t w = 0; w < works; ++w) seconds[work_names[w]] = row.seconds[w];
    return {{"scene", row.scene},           {"width", row.size.width}, {"height", row.size.height},
            {"triangles", row.triangles},   {"seconds", seconds},      {"image_bytes", row.image_bytes},
            {"peak_bytes", row.peak_bytes}, {"cycles", row.cycles},    {"rays_judged", row.judged},
            {"rays_wrong", row.wrong}};
}

Json series_json(const std::vector<Row>& rows, std::uint64_t (*x)(const Row&)) {
    Json series{{"rows", Json::array()}, {"exponents", Json::object()}};
    for (const Row& row : rows) series["rows"].push_back(row_json(row));
    for (std::size_t w = 0; w < works; ++w) {
        const double p = exponent(rows, Work(w), x);
        series["exponents"][work_names[w]] = std::isnan(p) ? Json() : Json(p);
    }
    return series;
}

}   // namespace

Json figures_json(const Figures& figures) {
    return {{"triangles", series_json(figures.scenes, triangles_of)},
            {"placed", series_json(figures.placed, triangles_of)},
            {"pixels", series_json(figures.pictures, pixels_of)},
            {"largest", row_json(figures.largest)}};
}

std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture) {
    std::string text = fmt::format(
        "# Scale\n\nMade by `{}`. Do not edit.\n\nThis page shows how the cost of a frame grows with the "
        "scene and with the picture. Times are wall time on {} cores. They depend on the host. *load* "
        "generates the scene, and *compile* makes the memory image. *record* walks the rays of the model, "
        "and *replay* computes the cycles. *reference* builds its own tree and draws the picture in double "
        "precision. *judge* checks every ray with exact arithmetic. *peak* is the most memory that the "
        "process uses until the frame is judged. *judged* counts the rays, and *wrong* counts the wrong "
        "answers. All pictures have camera rays only. The configuration is `{}`{}.\n\nThe last row of a "
        "series has the exponent p of the power law that fits each column best: the time grows as the p-th "
        "power of the size. For n log n from ten thousand to ten million, p is 1.08.\n\n![The cost of a "
        "frame against triangles and pixels]({}.svg)\n\n",
        command, parallel::threads_of(study.threads), study.config.name,
        study.config.set.empty() ? std::string()
                                 : fmt::format(" with `{}`", fmt::join(study.config.set, " ")),
        picture);
    text += fmt::format("## Triangles\n\nEach picture is {} pixels.\n\n{}\n", size_text(study.size),
                        table(figures.scenes, triangles_of));
    if (!figures.placed.empty())
        text += fmt::format(
            "These scenes have instances. A machine of one level needs them written out as one list of "
            "triangles:\n\n{}\n",
            table(figures.placed, triangles_of));
    text += fmt::format("## Pixels\n\n{}\n## The largest frame\n\n{}", table(figures.pictures, pixels_of),
                        table({figures.largest}, nullptr));
    return text;
}

}   // namespace rayclock::scale
