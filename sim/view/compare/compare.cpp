// Reads reports, flattens their figures and compares them.
#include "sim/view/compare/compare.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/scene/camera.hpp"
#include "sim/files/input.hpp"
#include "sim/files/json_value.hpp"

namespace rayclock {

namespace {

using nlohmann::json;
using Figures = std::map<std::string, double>;
using Words = std::map<std::string, std::string>;

/// Returns true for values that depend on the host or the date, and for values that a clock repeats.
/// Top-level units and memory belong to the first clock.
bool is_left_out(const std::string& path) {
    return path == "units" || path == "memory" || path.starts_with("host.") || path.ends_with("seconds") ||
           path == "digest" || path.ends_with(".bottleneck");
}

/// A figure's name is the path of its keys. A path may not be longer, because a file can hold about as many
/// figures as it has bytes.
constexpr std::size_t longest_path = 200;

void flatten(const json& value, const std::string& path, Figures& figures, Words& words) {
    if (is_left_out(path)) return;
    if (path.size() > longest_path)
        throw UserError(fmt::format("the path of the key {} has {} bytes, more than {}", shown(path),
                                    path.size(), longest_path));
    if (path.starts_with("config.") && value.is_number()) {
        words[path] = value.dump();
    } else if (value.is_number()) {
        figures[path] = value.get<double>();
    } else if (value.is_string() || value.is_boolean()) {
        words[path] = value.is_string() ? value.get<std::string>() : value.dump();
    } else if (value.is_object()) {
        for (const auto& [key, inner] : value.items())
            flatten(inner, path.empty() ? key : path + "." + key, figures, words);
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            const json& inner = value[i];
            const bool clock = path == "clocks" && inner.is_object() && inner.contains("mhz");
            const std::string name =
                clock ? fmt::format("{:g}", inner["mhz"].get<double>()) : std::to_string(i);
            flatten(inner, path + "." + name, figures, words);
        }
    }
}

bool ends(const std::string& figure, std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return figure.ends_with(e); });
}
bool holds(const std::string& figure, std::initializer_list<const char*> parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const char* p) { return figure.find(p) != figure.npos; });
}

Difference difference_of(const std::string& name, std::vector<std::optional<double>> values) {
    Difference d{name, std::move(values), 0, false, Verdict::none};
    const double first = d.values.front().value_or(0), last = d.values.back().value_or(0);
    d.is_new = first == 0 || !d.values.front();
    d.change = first == 0 ? (last > 0) - (last < 0) : (last - first) / std::fabs(first);
    if (const int direction = direction_of(name); direction != 0 && last != first)
        d.verdict = (last > first) == (direction > 0) ? Verdict::better : Verdict::worse;
    return d;
}

}   // namespace

namespace {

/// Returns the JSON of a script element of a page.
std::string element_of(const std::string& file, const std::string& page, const std::string& id) {
    const std::string head = "<script type=\"application/json\" id=\"" + id + "\">";
    const std::size_t begin = page.find(head);
    if (begin == page.npos)
        throw UserError(printable(file) + " is not a report of simulate: it is a page of something else");
    const std::size_t end = page.find("</script>", begin);
    return page.substr(begin + head.size(), end == page.npos ? end : end - begin - head.size());
}

/// Checks the pixel maps of a page: their keys, names, data and widths.
void check_page(const JsonValue& page) {
    for (const char* key : {"width", "height"})
        if (const auto side = page.find(key)) side->whole(max_frame_side + 1);
    const auto maps = page.find("maps");
    if (!maps) return;
    std::set<std::string> keys;
    for (std::size_t i = 0; i < maps->array().size(); ++i) {
        const JsonValue map = (*maps)[i];
        for (const char* key : {"key", "name", "data"}) map.at(key).string();
        if (map.at("bytes").whole(5) == 0) map.at("bytes").expected("1 to 4");
        if (!keys.insert(map.at("key").string()).second) map.at("key").refuse("stands in two maps");
    }
}

}   // namespace

NamedReport read_report(const std::string& file) {
    const std::string text = read_file(file);
    const bool is_page = text.starts_with("<!DOCTYPE html>");
    NamedReport read{file, parse_json(file, is_page ? element_of(file, text, "report") : text), {}};
    const json& report = read.report;
    const auto refuse = [&](const std::string& what) {
        throw UserError(printable(file) + " is not a report of simulate or verify: " + what);
    };
    if (!report.is_object()) refuse("it is not an object");
    if (report.contains("sampling") && !report["sampling"].is_null())
        throw UserError(
            printable(file) +
            " is a report of a sample, and its figures are estimates: compare takes exact reports");
    for (const char* key : {"scene", "config", "frame", "clocks", "units", "memory", "digest"})
        if (!report.contains(key)) refuse(fmt::format("it has no key '{}'", key));
    for (const char* key : {"scene", "config", "frame", "memory"})
        if (!report[key].is_object()) refuse(fmt::format("its '{}' is not an object", key));
    if (!report["clocks"].is_array() || report["clocks"].empty()) refuse("it has no clock");
    for (const json& clock : report["clocks"])
        if (!clock.is_object() || !clock.value("mhz", json()).is_number() ||
            !clock.value("cycles", json()).is_number())
            refuse("a clock has not its 'mhz' and 'cycles'");
    if (is_page) {
        read.page = parse_json(file, element_of(file, text, "data"));
        check_page(JsonValue(read.page, file, "data"));
    }
    return read;
}

std::vector<std::string> far_sentences(const std::vector<NamedReport>& reports) {
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const json limits = reports[i].report.value("limits", json()),
                   told = limits.is_object() ? limits.value("sentence", json()) : json();
        sentences.push_back(told.is_string() ? fmt::format("{} ({}: {})", told.get<std::string>(),
                                                           char('A' + int(i % 26)), reports[i].file)
                                             : "");
    }
    return sentences;
}

int direction_of(const std::string& figure) {
    if (ends(figure,
             {".fps", ".mrays_per_s", ".bound_reached", "psnr_db", ".hits", ".row_hits", "_hit_rate"}))
        return 1;
    if (ends(figure, {".cycles", ".dram_bytes", ".bytes_per_ray", ".pixels_other_primitive", ".max_abs_depth",
                      ".wrong", ".node_steps", ".box_tests", ".triangle_tests", ".primitive_tests", ".reads",
                      ".row_conflicts", ".bug", "compile.bytes", "compile.stack_need", ".cache_misses",
                      "value_mismatches", "cycle_gap", "account_mismatches"}) ||
        holds(figure, {".stalled.", ".causes.", ".bounds."}))
        return -1;
    return 0;
}

Comparison compare_reports(const std::vector<NamedReport>& reports) {
    std::vector<Figures> figures(reports.size());
    std::vector<Words> words(reports.size());
    std::map<std::string, int> names, keys;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        try {
            flatten(reports[i].report, "", figures[i], words[i]);
        } catch (const UserError& error) {
            throw UserError(printable(reports[i].file) + ": " + error.what());
        }
        for (const auto& [name, value] : figures[i]) ++names[name];
        for (const auto& [key, value] : words[i]) ++keys[key];
    }
    Comparison c;
    for (const auto& [name, count] : names) {
        std::vector<std::optional<double>> values;
        bool equal = true;
        for (const Figures& f : figures) {
            const auto at = f.find(name);
            values.push_back(at == f.end() ? std::nullopt : std::optional(at->second));
            equal &= values.back() == values.front();
        }
        if (equal)
            ++c.equal;
        else
            c.differences.push_back(difference_of(name, std::move(values)));
    }
    for (const auto& [key, count] : keys) {
        std::vector<std::string> values;
        for (const Words& w : words) values.push_back(w.contains(key) ? w.at(key) : "");
        if (std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) != values.end())
            c.settings.emplace_back(key, std::move(values));
    }
    const auto rank = [](const Difference& d) {
        return is_key_figure(d.figure) ? 0 : d.verdict != Verdict::none ? 1 : 2;
    };
    std::stable_sort(
        c.differences.begin(), c.differences.end(), [&](const Difference& a, const Difference& b) {
            return std::pair(rank(a), -std::fabs(a.change)) < std::pair(rank(b), -std::fabs(b.change));
        });
    return c;
}

std::vector<Difference> beyond(const Comparison& comparison, const std::vector<std::string>& figures,
                               double share) {
    std::vector<Difference> found;
    for (const Difference& d : comparison.differences)
        if (d.verdict == Verdict::worse && (std::fabs(d.change) > share || d.is_new) &&
            std::any_of(figures.begin(), figures.end(), [&](const std::string& name) {
                // A '*' matches one part of a name, such as the MHz of a clock.
                const std::size_t star = name.find('*');
                if (star == name.npos) return d.figure == name || d.figure.starts_with(name + ".");
                const std::string head = name.substr(0, star), tail = name.substr(star + 1);
                return d.figure.starts_with(head) && d.figure.ends_with(tail) &&
                       d.figure.size() > head.size() + tail.size() &&
                       d.figure.find('.', head.size()) >= d.figure.size() - tail.size();
            }))
            found.push_back(d);
    return found;
}

}   // namespace rayclock
