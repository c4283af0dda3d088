#pragma once
// The cache of computed figures: one file per entry.
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace rayclock::results {

/// Returns the 64-bit FNV-1a hash as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

/// Returns the value in an entry's text if the entry is whole and has this key. `path` only names the file.
std::optional<nlohmann::ordered_json> entry_value(const std::string& path, const std::string& text,
                                                  const std::string& key);

/// A folder with one file per entry. A file's name holds the kind of the entry and a hash of its key. The
/// file holds the full key and a checksum. A damaged file, or one with another key, counts as missing. Files
/// appear whole or not at all, so several programs may share the folder and may be killed at any time.
class Cache {
public:
    /// Opens the folder and creates it if necessary. With `fresh`, find() finds nothing, but keep() still
    /// stores. trouble() reports a folder that cannot be made or written.
    Cache(std::filesystem::path folder, bool fresh);

    /// Returns the value of an entry, or nothing if the entry is missing or damaged.
    std::optional<nlohmann::ordered_json> find(const std::string& kind, const std::string& key) const;
    /// Returns read(value). An entry that `read` rejects with a JSON exception counts as missing, although
    /// its checksum is right.
    template <class Read> auto find(const std::string& kind, const std::string& key, Read read) const
        -> std::optional<decltype(read(nlohmann::ordered_json()))> {
        const auto value = find(kind, key);
        if (!value) return std::nullopt;
        try {
            return read(*value);
        } catch (const nlohmann::json::exception&) {
            return std::nullopt;
        }
    }
    /// Stores an entry. trouble() reports an error, after which nothing more is stored.
    void keep(const std::string& kind, const std::string& key, const nlohmann::ordered_json& value);

    /// Returns the reason why nothing can be stored, or an empty string.
    std::string trouble() const;
    const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path path_of(const std::string& kind, const std::string& key) const;

    std::filesystem::path folder_;
    bool fresh_;
    mutable std::mutex mutex_;
    std::string trouble_;
};

}   // namespace rayclock::results
