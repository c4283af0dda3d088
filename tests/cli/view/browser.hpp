#pragma once
// Pages that the program wrote: their data, and their display in a real browser.
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace rayclock::test {

/// Returns the JSON in an element of the page.
nlohmann::json data_of(const std::string& page, const std::string& id);

std::size_t count(const std::string& text, const std::string& what);

bool is_installed(const std::string& program);

/// Returns the output of a script after the page is shown; empty without a browser.
std::string shown(const TestFolder& folder, const std::string& page, const std::string& script);

/// Times in milliseconds from the start of a page.
struct PageTimes {
    double opened;   ///< until its first screen is drawn and usable
    double whole;    ///< until all charts are drawn
};
/// Measures these times without an added script, with the browser's real clock. In shown() the clock stops
/// while scripts run.
PageTimes time_to_open(const TestFolder& folder, const std::string& page);

/// Requires that the page needs no other file, and has tables that need no script.
void check_alone(const std::string& page);

}   // namespace rayclock::test
