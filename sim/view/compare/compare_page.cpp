// Builds the page of a comparison.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/table.hpp"
#include "sim/view/compare/compare.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/page/html.hpp"

namespace rayclock {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

/// The cycles of a page's pixels: integers stored as planes of bytes, the lowest byte first.
class Cycles {
public:
    Cycles(const NamedReport& report, std::size_t pixels) : pixels_(pixels) {
        for (const json& map : report.page.value("maps", json::array())) {
            if (map["key"] != "cycles") continue;
            bytes_ = map["bytes"].get<std::size_t>();
            try {
                planes_ = html::inflated(map["data"].get_ref<const std::string&>(), bytes_ * pixels);
            } catch (const std::runtime_error&) {
                throw UserError(printable(report.file) +
                                ": the cycles of its pixels are not packed as simulate packs them");
            }
            return;
        }
        throw UserError(printable(report.file) + " has no cycles of pixels");
    }
    std::uint32_t operator[](std::size_t i) const {
        std::uint32_t value = 0;
        for (std::size_t b = 0; b < bytes_; ++b)
            value |= std::uint32_t(std::uint8_t(planes_[b * pixels_ + i])) << 8 * b;
        return value;
    }

private:
    std::size_t pixels_, bytes_ = 0;
    std::string planes_;
};

bool same_frame(const NamedReport& a, const NamedReport& b) {
    return a.page.is_object() && b.page.is_object() &&
           a.page.value("width", json()) == b.page.value("width", json()) &&
           a.page.value("height", json()) == b.page.value("height", json());
}

/// Returns the maps that both pages have, still packed.
ordered_json maps_json(const NamedReport& first, const NamedReport& last) {
    ordered_json maps = ordered_json::array();
    for (const json& a : first.page.at("maps"))
        for (const json& b : last.page.at("maps"))
            if (a.at("key") == b.at("key") && a.at("key") != "first")
                maps.push_back({{"name", a.at("name")}, {"first", a}, {"last", b}});
    return maps;
}

std::string value_text(const std::optional<double>& value) {
    if (!value) return "-";
    if (*value == std::floor(*value) && std::fabs(*value) < 1e15)
        return (*value < 0 ? "-" : "") + grouped(std::uint64_t(std::fabs(*value)));
    return fmt::format("{:.6g}", *value);
}

std::string differences_table(const std::vector<NamedReport>& reports, const Comparison& c) {
    std::vector<std::string> head{"figure", "verdict"};
    for (std::size_t i = 0; i < reports.size(); ++i) head.push_back(std::string(1, char('A' + int(i % 26))));
    head.insert(head.end(), {"change", "in the JSON report"});
    std::vector<std::vector<std::string>> rows;
    for (const Difference& d : c.differences) {
        rows.push_back({figure_name(d.figure), d.verdict == Verdict::better  ? "better"
                                               : d.verdict == Verdict::worse ? "worse"
                                                                             : ""});
        for (const auto& value : d.values) rows.back().push_back(value_text(value));
        rows.back().push_back(d.is_new ? "new" : fmt::format("{:+.2f} %", 100 * d.change));
        rows.back().push_back(d.figure);
    }
    return "<div class=\"scroll\">" + html::table("", head, rows, 2) + "</div>";
}

std::string settings_table(const std::vector<NamedReport>& reports, const Comparison& c) {
    std::vector<std::string> head{"what was set"};
    std::vector<std::vector<std::string>> rows{{"file"}};
    for (std::size_t i = 0; i < reports.size(); ++i) {
        head.push_back(std::string(1, char('A' + int(i % 26))));
        rows[0].push_back(reports[i].file);
    }
    for (const auto& [key, values] : c.settings) {
        rows.push_back({key});
        rows.back().insert(rows.back().end(), values.begin(), values.end());
    }
    return html::table("", head, rows, 99);
}

std::string pixels_section(const std::optional<PixelChange>& change) {
    if (!change)
        return html::section(
            "pixels", "Pixels",
            "<p>Cycles of pixels can be compared if all reports are pages that simulate --report wrote, of "
            "frames of one size.</p>");
    return html::section(
        "pixels", "Cycles gained and lost, pixel by pixel",
        fmt::format("<p>{} pixels are faster, by {} cycles together; {} are slower, by {}; {} are equal.</p>",
                    grouped(change->faster), grouped(change->gained), grouped(change->slower),
                    grouped(change->lost), grouped(change->equal)) +
            R"(<div id="viewer" hidden><p class="controls"><label>figure <select id="figure"></select></label></p>
<div class="stage"><div id="canvases"><canvas id="change"></canvas></div>
<aside><div id="scales"></div><p id="pixel">Point at a pixel.</p></aside></div></div>
)");
}

}   // namespace

std::optional<PixelChange> pixel_change(const NamedReport& first, const NamedReport& last) {
    if (!same_frame(first, last)) return std::nullopt;
    const std::size_t pixels =
        first.page.value("width", std::size_t(0)) * first.page.value("height", std::size_t(0));
    const Cycles a(first, pixels), b(last, pixels);
    PixelChange change;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (b[i] < a[i]) ++change.faster, change.gained += a[i] - b[i];
        if (b[i] > a[i]) ++change.slower, change.lost += b[i] - a[i];
        change.equal += a[i] == b[i];
    }
    return change;
}

std::string comparison_page(const std::vector<NamedReport>& reports, const Comparison& c,
                            const std::vector<std::pair<std::string, std::string>>& origin) {
    const NamedReport &first = reports.front(), &last = reports.back();
    const std::optional<PixelChange> change = pixel_change(first, last);
    std::size_t better = 0, worse = 0;
    for (const Difference& d : c.differences)
        better += d.verdict == Verdict::better, worse += d.verdict == Verdict::worse;
    ordered_json data{{"differences", comparison_json(reports, c)["differences"]},
                      {"maps", ordered_json::array()}};
    if (change) {
        data["width"] = first.page.at("width");
        data["height"] = first.page.at("height");
        data["maps"] = maps_json(first, last);
    }
    std::vector<std::vector<std::string>> lines;
    for (const auto& [key, value] : origin) lines.push_back({key, value});
    FramedPage page;
    page.title = fmt::format("What changed: {} reports", reports.size());
    page.header = "<p>Made by rayclock. Changes are those of the last report against the first.</p>" +
                  html::figures({{"figures are better", grouped(better)},
                                 {"figures are worse", grouped(worse)},
                                 {"figures differ", grouped(c.differences.size())},
                                 {"figures are equal", grouped(c.equal)}});
    page.body = html::section("settings", "What was set", settings_table(reports, c)) +
                html::section("effects", "Effects", html::chart("effects", "change of every figure")) +
                pixels_section(change) +
                html::section("table", "Every figure that differs", differences_table(reports, c)) +
                html::section("origin", "Origin", html::table("", {"what", "value"}, lines, 2));
    page.data = html::data_element("data", data);
    page.scripts = page_compare;
    for (const std::string& far : far_sentences(reports))
        if (!far.empty()) page.far += (page.far.empty() ? "" : "; ") + far;
    return framed(page);
}

}   // namespace rayclock
