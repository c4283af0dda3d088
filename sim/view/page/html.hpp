#pragma once
// Building blocks of an HTML page.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rayclock::html {

/// Escapes text for an element, or for an attribute in double quotes.
std::string escaped(std::string_view text);

/// Returns a script element with JSON, escaped so that no text in it can end the element.
std::string data_element(std::string_view id, const nlohmann::ordered_json& json);

/// Returns a table. The first `left` columns hold words, the others numbers.
std::string table(std::string_view caption, const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows, std::size_t left = 1);

/// Returns a section with its heading; `inside` is HTML.
std::string section(const char* id, const char* title, const std::string& inside);
/// Returns the element in which a script draws the chart with this id.
std::string chart(const char* id, const char* label);
/// Returns a row of boxes, each with a name and a value as text.
std::string figures(const std::vector<std::pair<const char*, std::string>>& figures);

/// Returns the sentence in a report's `limits`, or an empty string. A page begins with it.
std::string far_sentence(const nlohmann::ordered_json& report);

std::string base64(std::string_view bytes);
/// Compresses to zlib's format, which browsers call "deflate".
std::string deflated(std::string_view bytes);
/// Reverses base64() and deflated(). Throws std::runtime_error if the text is broken or does not expand to
/// `size` bytes.
std::string inflated(std::string_view text, std::size_t size);

}   // namespace rayclock::html
