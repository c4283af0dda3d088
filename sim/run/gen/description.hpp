#pragma once
// The units and links of the machine in Markdown, from model/machine/units.hpp and links.hpp, for
// rtl/README.md.
#include <string>

namespace rayclock {

/// Return the tables of units and of links.
std::string units_table();
std::string links_table();
/// Returns a Mermaid diagram. Links that exist only in some configurations are dotted.
std::string links_diagram();

}   // namespace rayclock
