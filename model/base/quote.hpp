#pragma once
// Names and values that people wrote, made fit for a sentence and for a terminal.
#include <string>
#include <string_view>

namespace rayclock {

/// The text without anything that a terminal would obey: control characters, marks that turn the direction of
/// writing and bytes that are not UTF-8 become \xNN. Where that takes more than `most` bytes the middle is
/// left out ("..."). What it gives stays as it is when it is made printable once more.
std::string printable(std::string_view text, std::size_t most = 300);

/// The word in quotes, printable, cut after 40 bytes.
std::string shown(std::string_view word);

}   // namespace rayclock
