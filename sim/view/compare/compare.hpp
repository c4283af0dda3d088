#pragma once
// Compares reports: every figure that differs, by how much, and whether it became better or worse.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rayclock {

/// A report written by `simulate` or `verify`.
struct NamedReport {
    std::string file;
    nlohmann::json report;
    nlohmann::json page;   ///< for an HTML report: the data of every pixel; else null
};
/// Reads a report: JSON, or a page of simulate. Throws UserError if the file lacks a key that comparisons
/// need.
NamedReport read_report(const std::string& file);

enum class Verdict : std::uint8_t { none, better, worse };

/// A figure that differs. Its name is the path of its keys. A clock is named by its MHz: "clocks.66.cycles".
struct Difference {
    std::string figure;
    /// One value for each report. Empty where a report lacks the figure.
    std::vector<std::optional<double>> values;
    double change = 0;     ///< from the first report to the last, relative to the first
    bool is_new = false;   ///< the first is 0 or missing, so a relative change is undefined
    Verdict verdict = Verdict::none;
};
/// The result of a comparison.
struct Comparison {
    /// Key figures come first, then figures with a better direction, then all others. Each group is sorted by
    /// descending change.
    std::vector<Difference> differences;
    std::uint64_t equal = 0;   ///< number of figures that do not differ
    /// Words that differ, and all parameters of the configuration: the key and the value in each report.
    std::vector<std::pair<std::string, std::vector<std::string>>> settings;
};
/// The change in cycles of each pixel, from the first report to the last.
struct PixelChange {
    std::uint64_t faster = 0, slower = 0, equal = 0;   ///< numbers of pixels
    /// Cycles saved by faster pixels and lost by slower ones.
    std::uint64_t gained = 0, lost = 0;
};
/// Compares two pages pixel by pixel. Returns nothing unless both reports are pages of frames of one size.
/// Throws UserError if a page is broken.
std::optional<PixelChange> pixel_change(const NamedReport& first, const NamedReport& last);

Comparison compare_reports(const std::vector<NamedReport>& reports);

/// Returns the better direction of a figure: 1 for more, -1 for less, 0 for neither.
int direction_of(const std::string& figure);

/// Returns the sentence of each report whose picture is far from the reference; empty for the others.
std::vector<std::string> far_sentences(const std::vector<NamedReport>& reports);

/// Returns true for the figures listed first: cycles, frames per second and bytes of a clock, and errors.
bool is_key_figure(const std::string& figure);

/// Returns a figure's name in words: "cycles at 66 MHz" for clocks.66.cycles.
std::string figure_name(const std::string& figure);

/// Returns the figures that match one of the names and became worse by more than `share`.
std::vector<Difference> beyond(const Comparison& comparison, const std::vector<std::string>& figures,
                               double share);

/// Formats at most `most` differences; 0 formats all.
std::string comparison_text(const std::vector<NamedReport>& reports, const Comparison& comparison,
                            std::size_t most);
nlohmann::ordered_json comparison_json(const std::vector<NamedReport>& reports, const Comparison& comparison);

/// Returns the comparison as one HTML file. Throws UserError if the chart library is not installed.
std::string comparison_page(const std::vector<NamedReport>& reports, const Comparison& comparison,
                            const std::vector<std::pair<std::string, std::string>>& origin);

}   // namespace rayclock
