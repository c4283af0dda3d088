#pragma once
// The tables of docs/chip.md and rtl/README.md, from the descriptions that the RTL's package is made from.
#include <string>

namespace rayclock {

/// The page with its tables made anew: whatever lies between "<!-- made: NAME -->" and "<!-- end -->". Throws
/// std::logic_error for a name that no table has.
std::string with_tables(const std::string& page);

}   // namespace rayclock
