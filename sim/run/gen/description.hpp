#pragma once
// The units and links of the machine in Markdown, from model/core/units.hpp and links.hpp, for rtl/README.md.
#include <string>

namespace rayclock {

std::string units_table();
std::string links_table();
/// A Mermaid diagram; links that exist only in some configurations are dotted.
std::string links_diagram();

}   // namespace rayclock
