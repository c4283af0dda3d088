// Writes the page of one simulated frame: viewer, key figures, sections, tables and downloads.
#include "sim/view/page/run_page.hpp"

#include <fmt/format.h>

#include "model/machine/links.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/table.hpp"
#include "sim/view/page/data.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/page/html.hpp"
#include "sim/view/page/tables.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock {

namespace {

using html::chart;
using html::section;

std::string picture_element(const char* id, const char* label, const Picture& picture) {
    return fmt::format(
        "<figure><img id=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" "
        "src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
        id, label, picture.size.width, picture.size.height, html::base64(png_bytes(picture)), label);
}

/// Returns the pictures: machine, reference and differences. Scripts put them and the heat maps under one
/// slider.
std::string viewer(const PageInput& input) {
    std::string pictures = picture_element("picture", "picture of the machine", input.picture);
    if (input.reference) pictures += picture_element("reference", "reference", *input.reference);
    if (input.judgement)
        pictures += picture_element("difference", "difference by cause",
                                    cause_picture(*input.reference, *input.judgement));
    return R"(<div id="viewer" hidden>
<p class="controls"><label>left <select id="left-layer"></select></label>
<label>right <select id="right-layer"></select></label>
<label class="wide">slider <input type="range" id="slider" min="0" max="1000" value="500"></label></p>
<div class="stage"><div id="canvases"><canvas id="right-canvas"></canvas><canvas id="left-canvas"></canvas>
<div id="divider"></div></div>
<aside><div id="scales"></div><table id="pixel"><caption>Point at a pixel; a click keeps it</caption><tbody></tbody></table>
<p id="why"></p><p><code id="explain"></code></p></aside></div>
<pre id="explanation" hidden></pre>
</div>
<div id="pictures">
)" + pictures +
           "</div>\n" + error_table(input);
}

std::string key_figures(const PageInput& input) {
    const auto& clock = input.report.at("clocks")[0];
    return html::figures(
        {{"cycles", grouped(input.costs.cycles)},
         {"frames a second", fmt::format("{:.2f}", clock.at("fps").get<double>())},
         {"million rays a second", fmt::format("{:.2f}", clock.at("mrays_per_s").get<double>())},
         {"of the roofline reached", fmt::format("{:.0f} %", 100 * clock.at("bound_reached").get<double>())},
         {"is the bound", clock.at("bound").get<std::string>()}});
}

/// Returns a selector of clocks, or an empty string for a single clock. Observed data always belongs to the
/// first clock.
std::string clock_choice(const PageInput& input) {
    const auto& clocks = input.report.at("clocks");
    if (clocks.size() < 2) return {};
    std::string options;
    for (std::size_t i = 0; i < clocks.size(); ++i)
        options +=
            fmt::format("<option value=\"{}\">{:g} MHz</option>", i, clocks[i].at("mhz").get<double>());
    return fmt::format(
        "<p class=\"controls\"><label>clock <select id=\"clock\">{}</select></label>"
        "<span id=\"clock-note\" hidden>Maps of pixels, links, caches, kinds of rays and charts over time "
        "stay "
        "those at {:g} MHz.</span></p>\n",
        options, input.khz / 1e3);
}

std::string downloads() {
    return R"(<p class="controls" id="downloads" hidden><button data-save="report.json">report as JSON</button>
<button data-save="pixels.csv">all pixels as CSV</button> <button data-save="units.csv">units as CSV</button>
<button data-save="windows.csv">windows as CSV</button> <button data-save="links.csv">links as CSV</button></p>
)";
}

std::string body(const PageInput& input) {
    std::string page =
        section("picture-section", "Picture, reference and cost of every pixel", viewer(input));
    page += section("pixels", "What pixels cost",
                    chart("histogram", "histogram of the pixels' cycles") +
                        "<details open><summary>The hundred slowest pixels</summary><div class=\"scroll\">" +
                        slowest_table(input) + "</div></details>");
    page +=
        section("machine", "The machine",
                "<p>Each unit's bar says how it spent its cycles. A link is the wider the more it carried, "
                "and the redder the more often it was refused.</p>" +
                    chart("machine", "block diagram of the machine") +
                    chart("roofline", "cycles of the frame, and the fewest that each resource needs") +
                    clock_section(input));
    page += section("accounts", "What every unit did",
                    chart("accounts", "cycles of every unit by cause") + accounts_table(input));
    page += section(
        "kinds", "By what rays are for",
        chart("kinds", "cycles of rays by unit and purpose") + kinds_table(input) + memory_table(input));
    page +=
        section("time", "Over time",
                chart("rays", "rays under way over time") + chart("activity", "busy units over time") +
                    chart("hits", "hit rates over time") + chart("bandwidth", "memory bandwidth over time") +
                    chart("tiles", "tiles as they were worked on"));
    return page + section("origin", "Configuration and origin",
                          origin_table(input) + downloads() +
                              "<details open><summary>Configuration</summary><div class=\"scroll\">" +
                              config_table(input) + "</div></details>");
}

/// Packs the explanations of the slowest pixels.
nlohmann::ordered_json explanations_json(const PageInput& input) {
    if (input.explanations.empty()) return nullptr;
    nlohmann::ordered_json texts = nlohmann::ordered_json::object();
    for (const auto& [pixel, text] : input.explanations) texts[std::to_string(pixel)] = text;
    return html::base64(html::deflated(texts.dump()));
}

/// Returns the node units, for the scripts. They have one place and one colour.
std::string node_units_script() {
    std::string names;
    for (const NodeUnit& u : node_units) names += fmt::format("\"{}\",", unit_name(u.unit));
    return "const nodeUnits = [" + names +
           "], forNodeUnits = value => Object.fromEntries(nodeUnits.map(unit => [unit, value]));\n";
}

}   // namespace

std::string report_page(const PageInput& input) {
    const auto& scene = input.report.at("scene");
    const std::string title = fmt::format("{} on {} at {:g} MHz", scene.at("name").get<std::string>(),
                                          input.config.name, input.khz / 1e3);
    nlohmann::ordered_json data = page_data(input);
    data["explanations"] = explanations_json(input);
    return framed(
        {title,
         fmt::format("<p>{} x {} pixels, made by rayclock.</p>", input.costs.width, input.costs.height) +
             key_figures(input) + clock_choice(input),
         body(input), html::data_element("report", input.report) + html::data_element("data", data),
         std::string(page_viewer) + node_units_script() + page_charts + page_machine, false,
         html::far_sentence(input.report)});
}

}   // namespace rayclock
