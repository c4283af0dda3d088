#include "sim/report_page/page.hpp"

#include <fmt/format.h>

#include "sim/files/table.hpp"
#include "sim/image/image.hpp"
#include "sim/report/accounts.hpp"
#include "sim/report_page/data.hpp"
#include "sim/report_page/html.hpp"
#include "sim/report_page/library.hpp"
#include "sim/report_page/tables.hpp"

namespace rayclock {

// Of the files beside this one; CMake makes them part of the program.
extern const char* const page_style;
extern const char* const page_viewer;
extern const char* const page_charts;
extern const char* const page_machine;

namespace {

std::string section(const char* id, const char* title, const std::string& inside) {
    return fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", id, title, inside);
}
std::string chart(const char* id, const char* label) {
    return fmt::format("<div class=\"chart\" id=\"chart-{}\" role=\"img\" aria-label=\"{}\"></div>\n", id,
                       label);
}
std::string picture_element(const char* id, const char* label, const Picture& picture) {
    return fmt::format(
        "<figure><img id=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" "
        "src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
        id, label, picture.size.width, picture.size.height, html::base64(png_bytes(picture)), label);
}

/// The picture and what differs. Scripts put them, and the heat maps, under one slider.
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
</div>
<div id="pictures">
)" + pictures +
           "</div>\n" + error_table(input);
}

std::string key_figures(const PageInput& input) {
    const auto& clock = input.report.at("clocks")[0];
    const auto tile = [](const std::string& value, const char* what) {
        return fmt::format("<div><b>{}</b><span>{}</span></div>", html::escaped(value), what);
    };
    return "<div class=\"figures\">" + tile(grouped(input.costs.cycles), "cycles") +
           tile(fmt::format("{:.2f}", clock.at("fps").get<double>()), "frames a second") +
           tile(fmt::format("{:.2f}", clock.at("mrays_per_s").get<double>()), "million rays a second") +
           tile(fmt::format("{:.0f} %", 100 * clock.at("bound_reached").get<double>()),
                "of the roofline reached") +
           tile(clock.at("bound").get<std::string>(), "is the bound") + "</div>\n";
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
                    chart("roofline", "cycles of the frame beside the least that each resource needs") +
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

std::string scripts(const PageInput& input) {
    std::string out =
        html::data_element("report", input.report) + html::data_element("data", page_data(input));
    out += "<script>\nconst vegaModules = {};\n";
    for (const LibraryModule& module : chart_library())
        out += fmt::format("vegaModules[\"{}\"] = function(exports, module, require, define) {{{}\n}};\n",
                           module.name, module.source);
    return out + "</script>\n<script>\n" + page_viewer + page_charts + page_machine + "</script>\n";
}

}   // namespace

void check_page_library() { chart_library(); }

std::string report_page(const PageInput& input) {
    const auto& scene = input.report.at("scene");
    const std::string title = html::escaped(fmt::format(
        "{} on {} at {:g} MHz", scene.at("name").get<std::string>(), input.config.name, input.khz / 1e3));
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">\n<title>" + title +
           "</title>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<link rel=\"icon\" href=\"data:,\">\n<style>\n" +
           page_style + "</style></head>\n<body>\n<header><h1>" + title + "</h1>\n" +
           fmt::format("<p>{} x {} pixels, made by rayclock.</p>", input.costs.width, input.costs.height) +
           key_figures(input) +
           "</header>\n<noscript><p class=\"note\">Without scripts this page has its pictures and tables, "
           "and no "
           "charts.</p></noscript>\n<main>\n" +
           body(input) + "</main>\n" + scripts(input) + "</body></html>\n";
}

}   // namespace rayclock
