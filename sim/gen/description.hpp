#pragma once
#include <string>

namespace rayclock {

/// The units and links of the machine as tables and as a diagram (Mermaid) in Markdown, from
/// model/core/units.hpp and links.hpp: a part of rtl/README.md.
std::string machine_description();

/// The page with the description in place of what lies between its two marks. Throws UserError if the page
/// has not each mark once, in order.
std::string with_description(const std::string& page);

}   // namespace rayclock
