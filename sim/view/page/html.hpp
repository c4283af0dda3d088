#pragma once
// Pieces of an HTML page.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rayclock::html {

/// Text as it may stand in an element or in an attribute between double quotes.
std::string escaped(std::string_view text);

/// JSON as it may stand in a script element: nothing in it ends the element.
std::string data_element(std::string_view id, const nlohmann::ordered_json& json);

/// A table: the first `left` columns are words, the others numbers.
std::string table(std::string_view caption, const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows, std::size_t left = 1);

/// A section with its heading; what is inside is HTML.
std::string section(const char* id, const char* title, const std::string& inside);
/// The place where a script draws the chart of this name.
std::string chart(const char* id, const char* label);
/// A row of figures in boxes: what each is, and its value as text.
std::string figures(const std::vector<std::pair<const char*, std::string>>& figures);

/// The sentence of a report's `limits`, or nothing: a page begins with it.
std::string far_sentence(const nlohmann::ordered_json& report);

std::string base64(std::string_view bytes);
/// zlib's format; browsers know it as "deflate".
std::string deflated(std::string_view bytes);
/// Back again. Throws std::runtime_error if the text is not of `size` bytes, or broken.
std::string inflated(std::string_view text, std::size_t size);

}   // namespace rayclock::html
