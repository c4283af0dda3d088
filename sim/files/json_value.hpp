// A JSON value that knows its file and its path, so that every complaint can say "desk.json: objects[2].scale
// ...".
//
// The document must outlive the values.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace rayclock {

using Json = nlohmann::json;

/// Objects and arrays deeper in each other than this are refused: much that goes through a document does so
/// by recursion.
constexpr std::size_t most_nested = 200;

/// Parses. Refused with line and column: wrong syntax, numbers that a double cannot hold; by their name: keys
/// that appear twice in one object; nesting deeper than `most_nested`.
Json parse_json(const std::string& file, std::string_view text);

class JsonValue {
public:
    JsonValue(const Json& value, std::string file, std::string path = {})
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    const Json& raw() const { return *value_; }
    const std::string& path() const { return path_; }
    std::size_t size() const { return value_->size(); }

    /// "desk.json: objects[2].mesh", printable.
    std::string where() const;
    /// Throws UserError "<file>: <path> <sentence>".
    [[noreturn]] void refuse(const std::string& sentence) const;
    /// refuse("must be <wanted>, not <value>").
    [[noreturn]] void expected(std::string_view wanted) const;

    /// Refuses keys that are not in the list, with the nearest that is. Also refuses what is not an object.
    void only_keys(std::initializer_list<std::string_view> known) const;

    std::optional<JsonValue> find(std::string_view key) const;
    JsonValue at(std::string_view key) const;        ///< refuses if the key is missing
    JsonValue operator[](std::size_t index) const;   ///< of an array, index in range

    const JsonValue& array() const;   ///< itself, after a check of its type
    const JsonValue& object() const;
    double number() const;                            ///< finite
    std::uint64_t whole(std::uint64_t limit) const;   ///< 0 <= x < limit
    std::string string() const;
    glm::dvec3 triple() const;   ///< an array of 3 finite numbers

    double number_or(std::string_view key, double otherwise) const;
    std::uint64_t whole_or(std::string_view key, std::uint64_t limit, std::uint64_t otherwise) const;

private:
    const Json* value_;
    std::string file_, path_;
};

}   // namespace rayclock
