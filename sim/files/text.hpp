#pragma once
// Words, lines and numbers of a text file, and the form of all error messages about it: "<file>: line 7:
// ...".
//
// The standard's from_chars reads numbers: exactly and independently of the locale. A coordinate must also be
// finite as a 32-bit float, because the mesh readers store floats.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/quote.hpp"

namespace rayclock {

/// A position in a file, for error messages. Line 0 means that the file has no lines (a binary file).
struct SourcePosition {
    std::string file;
    std::uint64_t line = 0;
    /// Throws UserError "<file>: line <line>: <sentence>", with the file's name in printable characters.
    [[noreturn]] void refuse(const std::string& sentence) const;
};

/// Removes the next word from the front of `rest` and returns it. Returns an empty word at the end.
std::string_view take_word(std::string_view& rest);

/// Returns the words of `text`, separated by single blanks.
std::string joined_words(std::string_view text);

/// Removes the next line from the front of `rest` and returns it without its end (\n, \r\n, \r\r\n or \r
/// alone). `rest` must not be empty.
std::string_view take_line(std::string_view& rest);

/// Reads a finite number that fits a 32-bit float. Throws UserError that names the word if it is none.
double finite_number(std::string_view word, const SourcePosition& at);

/// Reads the same kind of number. Returns nothing if the word is none.
std::optional<float> float_of(std::string_view word);

/// Reads any number, including nan and inf. Throws UserError if the word is none.
double any_number(std::string_view word, const SourcePosition& at);

/// Reads a whole number. Throws UserError if the word is none or does not fit 64 bits.
std::int64_t whole_number(std::string_view word, const SourcePosition& at);

/// Returns the text without the byte order mark that some editors put in front of UTF-8.
std::string_view without_mark(std::string_view text);

/// Returns the text in lower case (ASCII only).
std::string lower(std::string_view text);

/// Decodes the percent escapes of a URI, such as %20.
std::string decode_percent(std::string_view uri);

/// Throws UserError if a line holds control characters: the file is not text, even if its extension says so.
void check_text(std::string_view line, const SourcePosition& at, std::string_view kind);

}   // namespace rayclock
