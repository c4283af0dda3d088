// Escapes and truncates user input for messages.
#include "model/base/quote.hpp"

#include <algorithm>
#include <vector>

namespace rayclock {
namespace {

/// Returns the bytes of the UTF-8 letter at the start of `text`, or 0 if it is not one that may be shown.
std::size_t letter(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
    const std::size_t size = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
    if (size == 0 || text.size() < size) return 0;
    unsigned code = first & (0xffu >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3f);
    }
    const bool is_overlong = code < (size == 2 ? 0x80u : size == 3 ? 0x800u : 0x10000u);
    const bool is_control = code < 0xa0 || (code >= 0x200e && code <= 0x200f) ||
                            (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) ||
                            (code >= 0xd800 && code < 0xe000) || code == 0xfeff;
    return is_overlong || is_control || code > 0x10ffff ? 0 : size;
}

/// Appends the first letter if it may be shown, otherwise the first byte as \xNN. Returns how many bytes of
/// `text` that was.
std::size_t escape_first(std::string& out, std::string_view text) {
    constexpr char digits[] = "0123456789abcdef";
    const std::size_t size = letter(text);
    if (size > 0) {
        out += text.substr(0, size);
        return size;
    }
    const auto byte = static_cast<unsigned char>(text[0]);
    ((out += "\\x") += digits[byte >> 4]) += digits[byte & 15];
    return 1;
}

void escape(std::string& out, std::string_view text) {
    while (!text.empty()) text.remove_prefix(escape_first(out, text));
}

/// Returns `at`, moved back to the start of its letter.
std::size_t boundary(std::string_view text, std::size_t at) {
    std::size_t start = at;
    while (start > 0 && at - start < 3 && (static_cast<unsigned char>(text[start]) & 0xc0) == 0x80) --start;
    return start;
}

}   // namespace

std::string printable(std::string_view text, std::size_t most) {
    std::string out;
    if (text.size() <= most) {
        escape(out, text);
        if (out.size() <= most) return out;
        out.clear();
    }
    constexpr std::string_view gap = "...";
    const std::size_t last = most / 3, first = most - last - gap.size();
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t before = out.size();
        rest.remove_prefix(escape_first(out, rest));
        if (out.size() <= first) continue;
        out.resize(before);
        break;
    }
    // Escape the tail first, because only then are its letters known. Keep the longest run of whole letters
    // that fits into `last` bytes.
    std::string end;
    std::vector<std::size_t> starts;
    for (std::string_view rest = text.substr(boundary(text, text.size() - std::min(last, text.size())));
         !rest.empty();) {
        starts.push_back(end.size());
        rest.remove_prefix(escape_first(end, rest));
    }
    starts.push_back(end.size());
    const auto start =
        std::find_if(starts.begin(), starts.end(), [&](std::size_t at) { return end.size() - at <= last; });
    return (out += gap) += end.substr(*start);
}

std::string shown(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "'";
    escape(text, word.size() > longest ? word.substr(0, boundary(word, longest)) : word);
    return text + (word.size() > longest ? "...'" : "'");
}

}   // namespace rayclock
