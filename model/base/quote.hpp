#pragma once
// Makes names and values from users fit for a sentence and for a terminal.
#include <string>
#include <string_view>

namespace rayclock {

/// Returns the text without anything that a terminal would obey. Control characters, marks that turn the
/// direction of writing, and bytes that are not UTF-8 become \xNN. If the result needs more than `most`
/// bytes, "..." replaces its middle. Applying the function twice has the same result as applying it once.
std::string printable(std::string_view text, std::size_t most = 300);

/// Returns the word in quotes, escaped, cut after 40 bytes.
std::string shown(std::string_view word);

}   // namespace rayclock
