#pragma once
// A JSON value that carries its file and its path, so that every error message can say "desk.json:
// objects[2].scale ...".
//
// The caller must keep the document alive as long as the values.
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace rayclock {

using Json = nlohmann::json;

/// The deepest nesting of objects and arrays that parse_json() accepts: much of the code that walks a
/// document is recursive.
constexpr std::size_t max_nested = 200;

/// Parses a document. Throws UserError with line and column for wrong syntax and for numbers that a double
/// cannot hold. Throws UserError for a key that appears twice in one object (the message names the key) and
/// for nesting deeper than `max_nested`.
Json parse_json(const std::string& file, std::string_view text);

/// A reference to a value in a document. All accessors throw UserError if the value has another type or
/// range.
class JsonValue {
public:
    JsonValue(const Json& value, std::string file, std::string path = {})
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    const Json& raw() const { return *value_; }
    const std::string& path() const { return path_; }
    std::size_t size() const { return value_->size(); }

    /// Returns file and path for a message: "desk.json: objects[2].mesh", in printable characters.
    std::string where() const;
    /// Throws UserError "<file>: <path> <sentence>".
    [[noreturn]] void refuse(const std::string& sentence) const;
    /// refuse("must be <wanted>, not <value>").
    [[noreturn]] void expected(std::string_view wanted) const;

    /// Throws UserError if a key is not in the list, and suggests the nearest known key. Throws UserError too
    /// if this is not an object.
    void only_keys(std::initializer_list<std::string_view> known) const;

    std::optional<JsonValue> find(std::string_view key) const;
    JsonValue at(std::string_view key) const;        ///< throws UserError if the key is missing
    JsonValue operator[](std::size_t index) const;   ///< of an array; the index must be in range

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
