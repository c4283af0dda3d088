// Configurations by name, by file, and with single parameters set over them.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/core/error.hpp"
#include "model/core/nearest.hpp"
#include "sim/app/setup.hpp"
#include "sim/report/json.hpp"

namespace rayclock {

namespace {

using nlohmann::ordered_json;

/// Reads a file that states every parameter, or names a configuration to start from under "like".
Config read_config(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw UserError(path + ": no such configuration file, and no configuration of that name" + did_you_mean(path, config_names()));
    ordered_json json;
    try {
        json = ordered_json::parse(file);
    } catch (const ordered_json::parse_error& e) {
        const std::string text = e.what();   // "[json.exception.parse_error.101] parse error at line 1, ..."
        throw UserError(path + ": " + text.substr(text.find("] ") + 2));
    }
    if (!json.is_object()) throw UserError(path + ": a configuration is a JSON object");
    Config config;
    const bool like = json.contains("like");
    if (like) {
        if (!json["like"].is_string()) throw UserError(path + ": \"like\" must name a configuration");
        try {
            config = named_config(json["like"].get<std::string>());
        } catch (const UserError& e) {
            throw UserError(path + ": " + e.what());
        }
    }
    config.name = std::filesystem::path(path).stem().string();
    for (const auto& [key, value] : json.items()) {
        if (key == "like") continue;
        if (key == "name") {
            if (!value.is_string()) throw UserError(path + ": \"name\" must be text, not " + value.dump());
            config.name = value.get<std::string>();
            continue;
        }
        const bool named = std::any_of(parameters().begin(), parameters().end(), [&](const Parameter& p) { return key == p.key && p.names; });
        set_parameter(config, key, named && value.is_string() ? value.get<std::string>() : value.dump(), path);
    }
    for (const Parameter& p : parameters())
        if (!like && !json.contains(p.key))
            throw UserError(fmt::format("{}: {} is missing; a configuration states every parameter, or names one to start from under \"like\"", path, p.key));
    return config;
}

} // namespace

Config load_config(const std::string& name_or_file, const std::vector<std::string>& set) {
    const bool named = std::find(config_names().begin(), config_names().end(), name_or_file) != config_names().end();
    const bool file = name_or_file.find_first_of("./\\") != std::string::npos;
    if (std::filesystem::is_directory(name_or_file)) throw UserError(name_or_file + ": is a folder, not a configuration");
    return with_settings(named || !file ? named_config(name_or_file) : read_config(name_or_file), set, name_or_file);
}

Config with_settings(Config config, const std::vector<std::string>& set, const std::string& where) {
    for (const std::string& item : set) {
        const std::size_t equals = item.find('=');
        if (equals == std::string::npos) throw UserError("--set: '" + item + "' is not key=value");
        set_parameter(config, item.substr(0, equals), item.substr(equals + 1), "--set");
    }
    check_config(config, where);
    return config;
}

std::string config_json(const Config& config) {
    return config_json_object(config).dump(2) + "\n";
}

} // namespace rayclock
