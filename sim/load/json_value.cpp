#include "sim/load/json_value.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/nearest.hpp"
#include "sim/load/text.hpp"

namespace rayclock {
namespace {

/// "line 3, column 7" of a byte counted from 1, as the parser counts.
std::string position(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
    return fmt::format("line {}, column {}", line, before.size() - start + 1);
}

/// The parser's sentence without its own numbering in front: "unexpected ...; last read: '...'".
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

/// Goes through a text that is known to parse and refuses a key that appears twice. A second reading, since the parser's own
/// callbacks look at all that an array holds whenever an element ends: minutes for a million.
class Keys : public nlohmann::json_sax<Json> {
public:
    explicit Keys(const std::string& file) : file_(file) {}
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }
    bool start_object(std::size_t) override {
        open_.emplace_back();
        return true;
    }
    bool end_object() override {
        open_.pop_back();
        return true;
    }
    bool key(string_t& name) override {
        if (!open_.back().insert(name).second) throw UserError(fmt::format("{}: the key {} appears twice in one object", file_, shown(name)));
        return true;
    }

private:
    const std::string& file_;
    std::vector<std::set<std::string>> open_;
};

} // namespace

Json parse_json(const std::string& file, std::string_view text) {
    try {
        Json document = Json::parse(text.begin(), text.end());
        Keys keys(file);
        Json::sax_parse(text.begin(), text.end(), &keys);
        return document;
    } catch (const Json::parse_error& error) {
        throw UserError(fmt::format("{}: {}: {}", file, position(text, error.byte), reason(error.what())));
    } catch (const Json::exception& error) {
        throw UserError(fmt::format("{}: {}", file, reason(error.what())));
    }
}

void JsonValue::refuse(const std::string& sentence) const {
    throw UserError(fmt::format("{}: {} {}", file_, path_.empty() ? "the file" : path_, sentence));
}

void JsonValue::expected(std::string_view wanted) const {
    std::string text = value_->is_structured() && value_->size() > 8 ? fmt::format("{} of {}", value_->type_name(), value_->size())
                                                                     : value_->dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 60) + "...";
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
    return JsonValue(*found, file_, path_.empty() ? std::string(key) : path_ + "." + std::string(key));
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
        expected(limit == 0 ? std::string("left out, for there is nothing to count") : fmt::format("a whole number from 0 to {}", limit - 1));
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

} // namespace rayclock
