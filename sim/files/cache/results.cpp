// The cache of computed figures: JSON files with key, checksum and value.
#include "sim/files/cache/results.hpp"

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/cache/hash.hpp"
#include "sim/files/input.hpp"
#include "sim/files/json_value.hpp"
#include "sim/files/output.hpp"

namespace rayclock::results {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string hash_text(const std::string& text) { return fmt::format("{:016x}", hash_of(text)); }

namespace {

/// The largest file that is read. An entry takes some kilobytes.
constexpr std::uint64_t max_bytes = 1 << 20;

}   // namespace

std::optional<ordered_json> entry_value(const std::string& path, const std::string& text,
                                        const std::string& key) {
    try {
        parse_json(path, text);   // rejects text that is too long or too deep for the next line
    } catch (const UserError&) {
        return std::nullopt;
    }
    ordered_json entry = ordered_json::parse(text);
    if (!entry.is_object() || !entry.contains("key") || !entry.contains("check") || !entry.contains("value"))
        return std::nullopt;
    if (entry["key"] != key || entry["check"] != hash_text(entry["value"].dump())) return std::nullopt;
    return entry["value"];
}

Cache::Cache(fs::path folder, bool fresh) : folder_(std::move(folder)), fresh_(fresh) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) trouble_ = folder_.string() + ": " + error.message();
}

fs::path Cache::path_of(const std::string& kind, const std::string& key) const {
    return folder_ / fmt::format("{}-{}.json", kind, hash_text(key));
}

std::optional<ordered_json> Cache::find(const std::string& kind, const std::string& key) const {
    if (fresh_) return std::nullopt;
    try {
        const std::string path = path_of(kind, key).string();
        return entry_value(path, read_file(path, {}, max_bytes, Owner::program), key);
    } catch (const UserError&) {
        return std::nullopt;
    }
}

void Cache::keep(const std::string& kind, const std::string& key, const ordered_json& value) {
    const ordered_json entry{{"key", key}, {"check", hash_text(value.dump())}, {"value", value}};
    const std::lock_guard lock(mutex_);
    if (!trouble_.empty()) return;
    const fs::path path = path_of(kind, key);
    try {
        write_bytes(path.string(), entry.dump(1) + "\n", Durable::no);
    } catch (const UserError& error) {
        trouble_ = error.what();
    }
}

std::string Cache::trouble() const {
    const std::lock_guard lock(mutex_);
    return trouble_;
}

}   // namespace rayclock::results
