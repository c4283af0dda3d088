#pragma once
// Names of chips, "prefix:prefix:base". Every word is looked up in a table, so a misspelt name throws and no
// test checks another chip than it names.
#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model/engine/check.hpp"

namespace rayclock::test {

/// A word before a colon. If `digits` has any, one of them follows the word, and `change` receives it.
struct FormatPrefix {
    std::string_view word, digits;
    void (*change)(Config&, int digit);
};

/// Reads a name: makes the base and applies the prefixes from right to left. Throws std::invalid_argument for
/// a prefix that is not in the table.
inline Config read_format(const std::string& name, std::span<const FormatPrefix> prefixes,
                          Config (*base)(const std::string&)) {
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) return base(name);
    Config config = read_format(name.substr(colon + 1), prefixes, base);
    const std::string_view prefix = std::string_view(name).substr(0, colon);
    for (const FormatPrefix& p : prefixes) {
        if (!prefix.starts_with(p.word)) continue;
        const std::string_view digit = prefix.substr(p.word.size());
        const bool is_digit = digit.size() == 1 && p.digits.find(digit) != std::string_view::npos;
        if (p.digits.empty() ? !digit.empty() : !is_digit) continue;
        p.change(config, digit.empty() ? 0 : digit[0] - '0');
        return config;
    }
    throw std::invalid_argument("no format has the prefix '" + std::string(prefix) + ":'");
}

/// Throws std::invalid_argument if a base is not in `known`, the list of its kind.
inline void check_base(const std::string& name, std::initializer_list<std::string_view> known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    std::string all;
    for (const std::string_view word : known) all += ' ' + std::string(word);
    throw std::invalid_argument("no format is named '" + name + "'; the names are" + all);
}

/// Paths cut for a fast clock, and the queues that their latency needs.
inline void make_fast(Config& config) {
    config.timing = Timing::fast;
    config.raygen_queue = config.box_queue = 32;
    config.tri_queue = 64;
}

inline void make_shading(Config& config) {
    config.shading = 1;
    config.origin_bits = std::min(config.origin_bits, 30 - config.coord_bits);
}

}   // namespace rayclock::test
