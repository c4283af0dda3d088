// Fuzzes entries of the cache of figures.
#include "sim/files/json_value.hpp"
#include "sim/files/cache/results.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {

void cache(std::string_view bytes) {
    using Json = nlohmann::ordered_json;
    const std::string path = file("frame-0.json").string(), key = "the key";
    const auto value = results::entry_value(path, std::string(bytes), key);
    // Try again with the right key and checksum, which mutation would never find.
    if (!passes([&] { parse_json(path, bytes); })) return demand(!value, "an entry is sound JSON");
    auto json = Json::parse(bytes, nullptr, false);
    if (!json.is_object() || !json.contains("value")) return demand(!value, "an entry has a value");
    const auto text = [](const Json& part) {
        return part.dump(-1, ' ', false, Json::error_handler_t::replace);
    };
    json["key"] = key;
    json["check"] = results::hash_text(text(json["value"]));
    const auto found = results::entry_value(path, text(json), key);
    demand(!value || (found && *found == *value), "an entry that was found is found again");
    demand(!found || text(*found) == text(json["value"]), "an entry gives the value that was written");
    demand(!results::entry_value(path, text(json), "another key"), "an entry is of its key only");
}

}   // namespace rayclock::fuzz
