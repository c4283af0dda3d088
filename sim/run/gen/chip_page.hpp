#pragma once
// The tables of docs/machine/chip.md and rtl/README.md, from the descriptions that also define the RTL's
// package.
#include <string>

namespace rayclock {

/// Returns the page with its tables regenerated: the text between each "<!-- made: NAME -->" and "<!-- end
/// -->". Throws std::logic_error for an unknown name or a missing end.
std::string with_tables(const std::string& page);

}   // namespace rayclock
