// Reading configuration files, and applying --set.
#include "sim/run/request/config_file.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/core/parameters.hpp"
#include "model/engine/check.hpp"
#include "sim/files/input.hpp"
#include "sim/files/json_value.hpp"
#include "sim/files/text.hpp"
#include "sim/run/memory/memory_file.hpp"

namespace rayclock {

namespace {

/// Throws UserError for an unknown key, and suggests the nearest known one.
void check_keys(const JsonValue& in) {
    std::vector<std::string> known{"like", "name"};
    for (const Parameter& p : parameters()) known.push_back(p.key);
    for (const auto& [key, ignored] : in.raw().items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            in.refuse(fmt::format("has no parameter {}{}", shown(key), did_you_mean(key, known)));
}

/// Returns the value of a parameter in the form that key= takes on the command line.
std::string text_of(const JsonValue& value, const Parameter& p) {
    if (p.names && value.raw().is_string()) return value.string();
    if (!value.raw().is_number_integer()) value.expected(p.names ? "one of its names" : "a whole number");
    return value.raw().dump();
}

}   // namespace

Config parse_config(const std::string& path, std::string_view text) {
    const Json json = parse_json(path, text);
    const JsonValue in(json, path);
    if (!json.is_object()) SourcePosition{path}.refuse("a configuration is a JSON object");
    check_keys(in);
    Config config;
    const auto like = in.find("like");
    const std::string base = like ? like->string() : "default";
    try {
        config = named_config(base);
    } catch (const UserError& e) {
        SourcePosition{path}.refuse(e.what());
    }
    const auto name = in.find("name");
    config.name = printable(name ? name->string() : std::filesystem::path(path).stem().string(), 80);
    for (const Parameter& p : parameters()) {
        const auto value = in.find(p.key);
        if (!value && !like)
            SourcePosition{path}.refuse(fmt::format(
                "{} is missing; a configuration states every parameter, or names one to start from "
                "under \"like\"",
                p.key));
        if (!value) continue;
        if (p.is("dram") && value->raw().is_object())
            config.own_dram = std::make_shared<const DramPart>(inner_memory(path, value->raw()));
        else
            set_value(config, p.key, text_of(*value, p), printable(path),
                      std::filesystem::path(path).parent_path().string());
    }
    return config;
}

Config load_config(const ConfigChoice& choice) {
    const std::string& name = choice.name;
    const bool named = std::find(config_names().begin(), config_names().end(), name) != config_names().end();
    const bool file = name.find_first_of("./\\") != std::string::npos;
    std::error_code error;
    if (!named && std::filesystem::is_directory(name, error))
        SourcePosition{name}.refuse("is a folder, not a configuration");
    constexpr std::uint64_t max_bytes = 1 << 20;
    const Config config =
        named || !file ? named_config(name) : parse_config(name, read_file(name, {}, max_bytes));
    return with_settings(config, choice.set, printable(name));
}

Config with_settings(Config config, const std::vector<std::string>& set, const std::string& where) {
    for (const std::string& item : set) {
        const std::size_t equals = item.find('=');
        if (equals == std::string::npos) throw UserError("--set: " + shown(item) + " is not key=value");
        set_value(config, item.substr(0, equals), item.substr(equals + 1), "--set");
    }
    check_config(config, where);
    return config;
}

}   // namespace rayclock
