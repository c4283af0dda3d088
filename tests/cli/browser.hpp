#pragma once
// Pages that the program wrote: what is in them, and what a real browser makes of them.
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace rayclock::test {

/// The JSON in an element of the page.
nlohmann::json data_of(const std::string& page, const std::string& id);

std::size_t count(const std::string& text, const std::string& what);

bool is_installed(const std::string& program);

/// What a script in the page says when the page is shown. Empty if there is no browser.
std::string shown(const Folder& folder, const std::string& page, const std::string& script);

/// Milliseconds from the start of a page.
struct PageTimes {
    double opened;   ///< until its first screen is drawn and can be used
    double whole;    ///< until all of its charts stand
};
/// No script is added to what is timed, and the browser's clock is the real one; shown() has a clock that
/// stands still while scripts run.
PageTimes time_to_open(const Folder& folder, const std::string& page);

/// One file that asks for nothing else, with tables that need no script.
void check_alone(const std::string& page);

}   // namespace rayclock::test
