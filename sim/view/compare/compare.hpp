#pragma once
// What changed between reports of runs: every figure that differs, by how much, and for better or worse.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rayclock {

/// A report as `simulate` or `verify` wrote it.
struct NamedReport {
    std::string file;
    nlohmann::json report;
    nlohmann::json page;   ///< of an HTML report: its figures of every pixel; else null
};
/// Reads one, JSON or a page of simulate. Throws UserError if it is no report with the keys that a comparison
/// needs.
NamedReport read_report(const std::string& file);

enum class Verdict : std::uint8_t { none, better, worse };

/// A figure that differs. Its name is the path of its keys; clocks go by their MHz: "clocks.66.cycles".
struct Difference {
    std::string figure;
    std::vector<std::optional<double>> values;   ///< of each report; missing where it has no such figure
    double change = 0;                           ///< of the last against the first, relative to the first
    bool is_new = false;   ///< the first is 0 or missing, so nothing can be relative to it
    Verdict verdict = Verdict::none;
};
struct Comparison {
    /// Key figures, then those of which more or less is better, then all others; in each the largest change
    /// first.
    std::vector<Difference> differences;
    std::uint64_t equal = 0;   ///< figures that do not differ
    /// Words that differ, and all parameters of the configuration: key, and what each report has.
    std::vector<std::pair<std::string, std::vector<std::string>>> settings;
};
/// Cycles of pixels, the last report's against the first's.
struct PixelChange {
    std::uint64_t faster = 0, slower = 0, equal = 0;   ///< pixels
    std::uint64_t gained = 0, lost = 0;                ///< cycles, in the faster and the slower ones
};
/// Nothing unless both reports are pages of frames of one size. Throws UserError if a page is broken.
std::optional<PixelChange> pixel_change(const NamedReport& first, const NamedReport& last);

Comparison compare_reports(const std::vector<NamedReport>& reports);

/// Whether more or less of a figure is better, or neither.
int direction_of(const std::string& figure);

/// Of each report the sentence that its picture is far from the reference's, as it was told; or empty.
std::vector<std::string> far_sentences(const std::vector<NamedReport>& reports);

/// What people ask for first: cycles, frames a second and bytes of a clock, and errors.
bool is_key_figure(const std::string& figure);

/// A figure's name in words: "cycles at 66 MHz" for clocks.66.cycles.
std::string figure_name(const std::string& figure);

/// Figures under one of the prefixes that became worse by more than this share.
std::vector<Difference> beyond(const Comparison& comparison, const std::vector<std::string>& figures,
                               double share);

/// At most `most` differences; 0: all.
std::string comparison_text(const std::vector<NamedReport>& reports, const Comparison& comparison,
                            std::size_t most);
nlohmann::ordered_json comparison_json(const std::vector<NamedReport>& reports, const Comparison& comparison);

/// As one HTML file. Throws UserError if the library that draws its charts is not installed.
std::string comparison_page(const std::vector<NamedReport>& reports, const Comparison& comparison,
                            const std::vector<std::pair<std::string, std::string>>& origin);

}   // namespace rayclock
