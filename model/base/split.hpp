#pragma once
// Splits text at a separator.
#include <string>
#include <string_view>
#include <vector>

namespace rayclock {

/// Splits a text at every separator. N separators give N + 1 parts.
inline std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

}   // namespace rayclock
