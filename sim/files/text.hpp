// Words, lines and numbers of a text file, and the one form of a complaint about it: "<file>: line 7: ...".
//
// Numbers are read by the standard's from_chars: exact, without locale. A coordinate must be finite also as
// a 32-bit float, because that is what the importer keeps.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/quote.hpp"

namespace rayclock {

/// Where something was found; the name of the file is shown printable. Line 0 means that lines make no sense
/// here (a binary file).
struct Place {
    std::string file;
    std::uint64_t line = 0;
    [[noreturn]] void refuse(const std::string& sentence) const;
};

/// Takes the next word off the front of `rest`; empty at its end.
std::string_view take_word(std::string_view& rest);

/// The words, with single blanks between them.
std::string joined_words(std::string_view text);

/// Takes the next line off the front of `rest`, without its end (\n, \r\n, or \r alone). Only while `rest` is
/// not empty.
std::string_view take_line(std::string_view& rest);

/// A finite number that a 32-bit float can hold, or a refusal that names the word.
double finite_number(std::string_view word, const Place& at);

/// The same number, or nothing.
std::optional<float> float_of(std::string_view word);

/// Any number, nan and inf included.
double any_number(std::string_view word, const Place& at);

/// A whole number.
std::int64_t whole_number(std::string_view word, const Place& at);

/// The text without the mark that some editors put in front of UTF-8.
std::string_view without_mark(std::string_view text);

/// The same text in small letters (ASCII).
std::string lower(std::string_view text);

/// Refuses a line with control characters: it is not text, whatever the name of the file says.
void check_text(std::string_view line, const Place& at, std::string_view kind);

}   // namespace rayclock
