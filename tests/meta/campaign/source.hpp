#pragma once
// Expressions of a source file in which a fault can be put: right sides, conditions, what goes into a port.
#include <string>
#include <vector>

namespace rayclock::campaign {

enum class Language { verilog, cpp };

/// An expression, text[begin, end).
struct Region {
    std::size_t begin = 0, end = 0;
    std::string target;   ///< the assigned signal, for its width; empty for a condition or a port
    /// The beginning of the item of the module around it, before which a declaration may be put; npos in a
    /// function.
    std::size_t outside = 0;
    bool is_condition = false;
};

/// The text with comments, strings, directives and assertions turned to blanks, of the same length.
std::string blanked(const std::string& text, Language language);

std::vector<Region> regions(const std::string& text, Language language);

/// Position behind the bracket that closes the one at `at`; npos if there is none.
std::size_t behind_bracket(const std::string& text, std::size_t at);

}   // namespace rayclock::campaign
