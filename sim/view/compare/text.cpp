// Formats a comparison as text and as JSON.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/files/table.hpp"
#include "sim/view/compare/compare.hpp"

namespace rayclock {

namespace {

std::string number(const std::optional<double>& value) {
    if (!value) return "-";
    if (*value == std::floor(*value) && std::fabs(*value) < 1e15)
        return (*value < 0 ? "-" : "") + grouped(std::uint64_t(std::fabs(*value)));
    return fmt::format("{:.6g}", *value);
}
const char* verdict_name(Verdict v) {
    return v == Verdict::better ? "better" : v == Verdict::worse ? "worse" : "";
}

std::string table_of(const char* what, const std::vector<std::string>& names,
                     const std::vector<Difference>& differences) {
    std::vector<std::string> head{what};
    head.insert(head.end(), names.begin(), names.end());
    head.insert(head.end(), {"change", ""});
    Table table(head);
    for (const Difference& d : differences) {
        std::vector<std::string> row{printable(d.figure)};
        for (const auto& value : d.values) row.push_back(number(value));
        row.push_back(d.is_new           ? "new"
                      : !d.values.back() ? "gone"
                                         : fmt::format("{:+.2f} %", 100 * d.change));
        row.push_back(verdict_name(d.verdict));
        table.add(row);
    }
    return table.text();
}

}   // namespace

std::string comparison_text(const std::vector<NamedReport>& reports, const Comparison& c, std::size_t most) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < reports.size(); ++i) names.push_back(std::string(1, char('A' + int(i % 26))));
    std::string text;
    for (const std::string& far : far_sentences(reports))
        if (!far.empty()) text += printable(far, 400) + "\n";
    for (std::size_t i = 0; i < reports.size(); ++i)
        text += fmt::format("  {}: {}\n", names[i], printable(reports[i].file));
    if (!c.settings.empty()) {
        std::vector<std::string> head{"what was set"};
        head.insert(head.end(), names.begin(), names.end());
        Table table(head, Table::words_only);
        for (const auto& [key, values] : c.settings) {
            std::vector<std::string> row{printable(key)};
            for (const std::string& value : values) row.push_back(value.empty() ? "-" : printable(value, 40));
            table.add(row);
        }
        text += "\n" + table.text();
    }
    if (c.differences.empty()) return text + fmt::format("\n  all {} figures are equal\n", grouped(c.equal));
    std::vector<Difference> key, others;
    for (const Difference& d : c.differences) (is_key_figure(d.figure) ? key : others).push_back(d);
    const std::size_t shown = most == 0 ? others.size() : std::min(most, others.size());
    others.resize(shown);
    if (!key.empty()) text += "\n" + table_of("key figures", names, key);
    if (!others.empty()) text += "\n" + table_of("other figures", names, others);
    return text + fmt::format("  {} figures differ, {} are equal{}\n", grouped(c.differences.size()),
                              grouped(c.equal),
                              shown + key.size() < c.differences.size() ? "; --all prints the rest" : "");
}

nlohmann::ordered_json comparison_json(const std::vector<NamedReport>& reports, const Comparison& c) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array(),
                           differences = nlohmann::ordered_json::array(),
                           settings = nlohmann::ordered_json::array();
    for (const NamedReport& report : reports) files.push_back(report.file);
    for (const Difference& d : c.differences) {
        nlohmann::ordered_json values = nlohmann::ordered_json::array();
        for (const auto& value : d.values)
            values.push_back(value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr));
        const char* verdict = verdict_name(d.verdict);
        differences.push_back(
            {{"figure", d.figure},
             {"name", figure_name(d.figure)},
             {"values", values},
             {"change", d.is_new ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(d.change)},
             {"verdict", *verdict ? nlohmann::ordered_json(verdict) : nlohmann::ordered_json(nullptr)}});
    }
    for (const auto& [key, values] : c.settings) settings.push_back({{"key", key}, {"values", values}});
    nlohmann::ordered_json far = nlohmann::ordered_json::array();
    for (const std::string& sentence : far_sentences(reports))
        far.push_back(sentence.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(sentence));
    return {{"files", files},
            {"far", far},
            {"settings", settings},
            {"differences", differences},
            {"equal", c.equal}};
}

}   // namespace rayclock
