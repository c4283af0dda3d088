#pragma once
// Operators of the campaign: what a slip of the pen does to an expression.
#include "tests/meta/campaign/source.hpp"

namespace rayclock::campaign {

/// A changed expression. An expression that needs a register of its own (`latched late`) has `late` set, and
/// no text.
struct Fault {
    std::string what;    ///< the operator's name
    std::string text;    ///< takes the region's place
    std::string shown;   ///< "<" -> "<=", for people
    bool late = false;
};

/// Everything that the operators make of a region; `plain` is the file as blanked().
std::vector<Fault> faults(const std::string& plain, const Region& region, Language language);

}   // namespace rayclock::campaign
