#pragma once
// The tables of a report's page.
#include <string>

#include "sim/view/page/run_page.hpp"

namespace rayclock {

/// HTML tables of the page, readable without scripts. Each function returns one section or table.
std::string clock_section(const PageInput& input);
std::string accounts_table(const PageInput& input);
std::string kinds_table(const PageInput& input);
std::string memory_table(const PageInput& input);
std::string slowest_table(const PageInput& input);
std::string error_table(const PageInput& input);
std::string config_table(const PageInput& input);
std::string origin_table(const PageInput& input);

}   // namespace rayclock
