#pragma once
// Suggests the nearest known word when the user mistypes one.
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

/// Returns Levenshtein's edit distance: the number of letters to change, add or drop. O(|a| |b|) time.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t corner = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, corner + (a[i - 1] != b[j - 1])});
            corner = above;
        }
    }
    return row[b.size()];
}

/// Returns "; did you mean 'x'?" for the nearest known word. If no word is near and at most 10 are known, it
/// returns all of them: "; there are 'x', 'y'". Words of more than 40 letters are not compared: mistyping one
/// for another is unlikely, and the comparison takes quadratic time.
template <class Words> std::string did_you_mean(std::string_view word, const Words& known) {
    constexpr std::size_t longest = 40;
    std::string best;
    std::size_t distance = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const std::string_view candidate : known) {
        if (word.size() > longest || candidate.size() > longest) continue;
        if (const std::size_t d = edit_distance(word, candidate); d < distance) {
            distance = d;
            best = candidate;
        }
    }
    if (!best.empty()) return "; did you mean " + shown(best) + "?";
    constexpr std::size_t max_listed = 10;
    std::string all;
    if (std::size(known) <= max_listed)
        for (const std::string_view candidate : known)
            all += (all.empty() ? "; there are " : ", ") + shown(candidate);
    return all;
}

/// Returns the item with this name. Otherwise throws UserError: `none` ("no test"), "is called", the name,
/// the nearest known name, and `tail`.
template <class Items> const auto& by_name(const Items& items, std::string_view name, const std::string& none,
                                           const char* tail = "") {
    std::vector<std::string_view> names;
    for (const auto& item : items) {
        if (item.name == name) return item;
        names.push_back(item.name);
    }
    throw UserError(none + " is called " + shown(name) + did_you_mean(name, names) + tail);
}

}   // namespace rayclock
