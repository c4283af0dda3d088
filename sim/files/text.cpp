// Splitting text into lines and words, and reading numbers.
#include "sim/files/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "model/base/error.hpp"

namespace rayclock {
namespace {

/// The longest number that is read. Longer ones are damage, and reading them takes time quadratic in their
/// length.
constexpr std::size_t longest_number = 1000;

std::optional<double> parsed_number(std::string_view digits) {
    if (digits.empty() || digits.size() > longest_number) return std::nullopt;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) return std::nullopt;
    // from_chars leaves `value` alone if it is out of range. strtod distinguishes too large (inf) from too
    // small (0 or subnormal).
    if (error == std::errc::result_out_of_range) return std::strtod(std::string(digits).c_str(), nullptr);
    return value;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}   // namespace

void SourcePosition::refuse(const std::string& sentence) const {
    const std::string name = printable(file);
    throw UserError(line != 0 ? fmt::format("{}: line {}: {}", name, line, sentence)
                              : fmt::format("{}: {}", name, sentence));
}

std::string_view take_word(std::string_view& rest) {
    std::size_t begin = 0;
    while (begin < rest.size() && is_blank(rest[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest.size() && !is_blank(rest[end])) ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

std::string joined_words(std::string_view text) {
    std::string all;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text))
        (all += all.empty() ? "" : " ") += word;
    return all;
}

std::string_view take_line(std::string_view& rest) {
    std::size_t end = 0;
    while (end < rest.size() && rest[end] != '\n' && rest[end] != '\r') ++end;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end);
    // Some programs write two carriage returns before the line feed.
    for (const std::string_view ending : {"\n", "\r\n", "\r\r\n", "\r"})
        if (rest.starts_with(ending)) {
            rest.remove_prefix(ending.size());
            break;
        }
    return line;
}

double any_number(std::string_view word, const SourcePosition& at) {
    if (word.empty()) at.refuse("a number is missing at the end");
    if (word.size() > longest_number)
        at.refuse(fmt::format("{} has {} characters, too many for a number", shown(word), word.size()));
    const std::optional<double> value = parsed_number(word);
    if (!value) at.refuse(shown(word) + " is not a number");
    return *value;
}

std::optional<float> float_of(std::string_view word) {
    const std::optional<double> value = parsed_number(word);
    if (!value || !(std::abs(*value) <= std::numeric_limits<float>::max())) return std::nullopt;
    return static_cast<float>(*value);
}

double finite_number(std::string_view word, const SourcePosition& at) {
    const double value = any_number(word, at);
    if (std::abs(value) <= std::numeric_limits<float>::max()) return value;
    if (std::find_if(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; }) != word.end())
        at.refuse(shown(word) + " is larger than a 32-bit float can hold");
    at.refuse(shown(word) + " is not a finite number");
}

std::int64_t whole_number(std::string_view word, const SourcePosition& at) {
    if (word.empty()) at.refuse("a whole number is missing at the end");
    std::string_view digits = word;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size())
        at.refuse(shown(word) + " is not a whole number");
    return value;
}

std::string_view without_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
}

std::string decode_percent(std::string_view uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const auto digit = [&](std::size_t at) {
            return std::string_view("0123456789abcdef").find(lower(uri.substr(at, 1)));
        };
        if (uri[i] == '%' && i + 2 < uri.size() && digit(i + 1) < 16 && digit(i + 2) < 16) {
            name += static_cast<char>(digit(i + 1) * 16 + digit(i + 2));
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

void check_text(std::string_view line, const SourcePosition& at, std::string_view kind) {
    for (const char c : line)
        if ((static_cast<unsigned char>(c) < 0x20 && !is_blank(c)) || c == 0x7f)
            at.refuse(fmt::format("this is not {}: {} is not text", kind, shown(line)));
}

}   // namespace rayclock
