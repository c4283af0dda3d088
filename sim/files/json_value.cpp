// Parsing JSON by the library's event interface (SAX), and the accessors with their error messages.
#include "sim/files/json_value.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "sim/files/text.hpp"

namespace rayclock {
namespace {

/// Returns "line 3, column 7" for a byte position counted from 1, as the parser counts.
std::string position(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
    return fmt::format("line {}, column {}", line, before.size() - start + 1);
}

/// Returns the parser's message without its own position in front: "unexpected ...; last read: '...'".
std::string reason(std::string what) {
    for (const char* mark : {" - ", ": "})
        if (const std::size_t at = what.find(mark, what.find("column")); at != what.npos) {
            what = what.substr(at + std::string_view(mark).size());
            break;
        }
    for (char& c : what)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
    return what.substr(0, 200);
}

/// Builds the document from the parser's events. Unlike the library's own builder, it rejects equal keys in
/// one object and very deep nesting. The library's builder keeps the last of equal keys.
class Builder : public nlohmann::json_sax<Json> {
public:
    Builder(const std::string& file, std::string_view text) : file_(file), text_(text) {}
    Json take() { return std::move(root_); }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::value_t::object); }
    bool start_array(std::size_t) override { return open(Json::value_t::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        const auto [place, is_new] = open_.back()->get_ref<Json::object_t&>().try_emplace(name);
        if (!is_new) refuse(fmt::format("the key {} appears twice in one object", shown(name)));
        value_ = &place->second;
        return true;
    }
    bool parse_error(std::size_t byte, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        constexpr int out_of_range = 406;
        refuse(position(text_, byte) + ": " +
               (error.id == out_of_range ? shown(token) + " is larger than a double can hold"
                                         : reason(error.what())));
    }

private:
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw UserError(fmt::format("{}: {}", printable(file_), sentence));
    }

    /// Returns the place of the next value: in the open array, at the last key, or at the top.
    Json& place() {
        if (open_.empty()) return root_;
        return open_.back()->is_array() ? open_.back()->get_ref<Json::array_t&>().emplace_back() : *value_;
    }
    template <class Value> bool put(Value&& value) {
        place() = std::forward<Value>(value);
        return true;
    }
    bool open(Json::value_t type) {
        if (open_.size() == max_nested)
            refuse(fmt::format("objects and arrays are nested deeper than {}", max_nested));
        Json& here = place();
        here = Json(type);
        open_.push_back(&here);
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    const std::string& file_;
    std::string_view text_;
    Json root_;
    Json* value_ = nullptr;
    std::vector<Json*> open_;
};

}   // namespace

Json parse_json(const std::string& file, std::string_view text) {
    Builder builder(file, text);
    Json::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
}

std::string JsonValue::where() const {
    return printable(file_) + ": " + (path_.empty() ? "the file" : printable(path_, 200));
}

void JsonValue::refuse(const std::string& sentence) const { throw UserError(where() + " " + sentence); }

void JsonValue::expected(std::string_view wanted) const {
    std::string text = value_->is_structured() && value_->size() > 8
                           ? fmt::format("{} of {}", value_->type_name(), value_->size())
                           : value_->dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 60) + "...";
    text = printable(text);   // dump() does not escape the control character DEL
    refuse(fmt::format("must be {}, not {}", wanted, text));
}

void JsonValue::only_keys(std::initializer_list<std::string_view> known) const {
    for (const auto& [key, ignored] : object().value_->items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            refuse(fmt::format("has no key {}{}", shown(key), did_you_mean(key, known)));
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
    const auto found = object().value_->find(key);
    if (found == value_->end()) return std::nullopt;
    const std::string name = printable(key, 60);
    return JsonValue(*found, file_, path_.empty() ? name : path_ + "." + name);
}

JsonValue JsonValue::at(std::string_view key) const {
    if (auto found = find(key)) return *std::move(found);
    refuse(fmt::format("lacks the key '{}'", key));
}

JsonValue JsonValue::operator[](std::size_t index) const {
    return JsonValue((*value_)[index], file_, fmt::format("{}[{}]", path_, index));
}

const JsonValue& JsonValue::array() const {
    if (!value_->is_array()) expected("an array");
    return *this;
}

const JsonValue& JsonValue::object() const {
    if (!value_->is_object()) expected("an object");
    return *this;
}

double JsonValue::number() const {
    if (!value_->is_number() || !std::isfinite(value_->get<double>())) expected("a number");
    return value_->get<double>();
}

std::uint64_t JsonValue::whole(std::uint64_t limit) const {
    if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() >= limit)
        expected(limit == 0 ? std::string("left out, for there is nothing to count")
                            : fmt::format("a whole number from 0 to {}", limit - 1));
    return value_->get<std::uint64_t>();
}

std::string JsonValue::string() const {
    if (!value_->is_string()) expected("a string");
    return value_->get<std::string>();
}

glm::dvec3 JsonValue::triple() const {
    if (!value_->is_array() || value_->size() != 3) expected("3 numbers");
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) {
        const Json& x = (*value_)[static_cast<std::size_t>(i)];
        if (!x.is_number() || !std::isfinite(x.get<double>())) expected("3 numbers");
        v[i] = x.get<double>();
    }
    return v;
}

double JsonValue::number_or(std::string_view key, double otherwise) const {
    const auto found = find(key);
    return found ? found->number() : otherwise;
}

std::uint64_t JsonValue::whole_or(std::string_view key, std::uint64_t limit, std::uint64_t otherwise) const {
    const auto found = find(key);
    return found ? found->whole(limit) : otherwise;
}

}   // namespace rayclock
