// Builds the page of a sweep.
#include "sim/explore/sweep/sweep_page.hpp"

#include <fmt/format.h>

#include "model/base/split.hpp"
#include "sim/explore/sweep/table.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/page/html.hpp"

namespace rayclock::sweep {

using nlohmann::ordered_json;

namespace {

/// Returns a point with the figures that the charts show.
ordered_json figures_json(const ordered_json& point, const Result& r) {
    ordered_json json = point;
    json["typed"] = r.point.values;
    json.erase("clock");
    json.erase("error");
    json.erase("chip");
    json.erase("film");
    if (!r.complete()) return json;
    for (const char* key : {"cycles", "fps", "bytes_per_ray", "bound"}) json[key] = r.clock.at(key);
    json["pixels_other_primitive"] = r.picture->error.pixels_other_primitive;
    json["rays"] = r.picture->rays.all();
    if (r.frames() > 1) json["film_fps"] = r.film_fps();
    if (!r.area) return json;
    json["chip_luts"] = r.area->luts();
    json["chip_multipliers"] = r.area->dsp;
    json["chip_block_rams"] = r.area->bram;
    return json;
}

std::string points_table(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : split(text, '\n'))
        if (!line.empty()) rows.push_back(split(line, ','));
    const std::vector<std::string> head = rows.front();
    rows.erase(rows.begin());
    return html::table("", head, rows, 0);
}

std::string charts() {
    return html::section(
               "all", "All points",
               "<p>A line is a point. Point at it in one chart, and all show it; a click keeps it. The "
               "boxes leave points out.</p><div id=\"filters\"></div>" +
                   html::chart("parallel", "axes and figures of every point") +
                   "<div class=\"scroll\" id=\"picked\"></div>") +
           html::section("fronts", "What is worth having",
                         "<p>Ringed points are on the front of the two figures that the chart shows: none is "
                         "as good in "
                         "both and better in one. The diamond is the knee.</p><div class=\"row\">" +
                             html::chart("error", "error against cost") +
                             html::chart("speed", "speed against cost") +
                             html::chart("price", "error against speed") + "</div>") +
           html::section("axes", "What each axis does alone",
                         "<p class=\"controls\"><label>figure <select "
                         "id=\"figure\"></select></label></p><p>A thin line "
                         "joins points that differ in this axis only; the thick one is their mean.</p><div "
                         "class=\"row\" "
                         "id=\"alone\"></div>");
}

}   // namespace

std::string sweep_page(const MergedSweep& swept, const Front& front, const std::string& far,
                       const std::vector<std::pair<std::string, std::string>>& origin) {
    const std::vector<Axis>& axes = swept.settings.axes;
    const std::vector<Result>& results = swept.outcome.results;
    const ordered_json rows = points_json(axes, results, front);
    ordered_json points = ordered_json::array();
    std::size_t on_front = 0, done = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        points.push_back(figures_json(rows[i], results[i]));
        on_front += front.pareto[i];
        done += results[i].complete();
    }
    const std::string scene = swept.scene.at("name").get<std::string>();
    std::vector<std::vector<std::string>> lines;
    for (const auto& [key, value] : origin) lines.push_back({key, value});
    const ordered_json config = config_json_object(swept.config);
    for (const auto& [key, value] : config.items())
        lines.push_back({key, value.is_string() ? value.get<std::string>() : value.dump()});
    const ordered_json data{{"axes", settings_json(swept.settings)["axes"]},
                            {"front", {front.measures[0].key, front.measures[1].key, front.measures[2].key}},
                            {"points", points}};
    FramedPage page;
    page.title = fmt::format("{}: a sweep over {} points", scene, results.size());
    page.header =
        fmt::format("<p>{} x {} pixels, made by rayclock.</p>", swept.size.width, swept.size.height) +
        html::figures({{"points with figures", std::to_string(done)},
                       {"on the front of error, cost and speed", std::to_string(on_front)},
                       {"is the knee", front.knee ? name_of(axes, results[front.knee->point]) : "none"}});
    page.body =
        charts() +
        html::section(
            "table", "Every point",
            "<div class=\"scroll\" id=\"points\">" + points_table(csv(axes, results, front)) + "</div>") +
        html::section("origin", "Configuration and origin",
                      "<div class=\"scroll\">" + html::table("", {"what", "value"}, lines, 2) + "</div>");
    page.data = html::data_element("data", data);
    page.scripts = page_sweep;
    page.far = far;
    return framed(page);
}

}   // namespace rayclock::sweep
