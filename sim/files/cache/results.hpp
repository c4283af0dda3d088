#pragma once
// Figures that were worked out before, in files of their own.
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace rayclock::jobs {

/// FNV-1a, 64 bits, as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

/// The value of an entry, from the text of its file, if it is whole and of this key. `path` only names it.
std::optional<nlohmann::ordered_json> entry_value(const std::string& path, const std::string& text,
                                                  const std::string& key);

/// One file per entry, named by the kind of entry and a hash of its key; the key stands in it in full, and a
/// checksum. A file that is not whole, or that has another key, counts as missing. Files appear whole or not
/// at all, so several programs may share the folder, and may be killed at any time.
class Cache {
public:
    /// `fresh`: nothing is found, but everything is kept. A folder that cannot be made or written is told by
    /// trouble().
    Cache(std::filesystem::path folder, bool fresh);

    std::optional<nlohmann::ordered_json> find(const std::string& kind, const std::string& key) const;
    /// What `read` makes of the value. An entry that it cannot read counts as missing, although its checksum
    /// is right.
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
    void keep(const std::string& kind, const std::string& key, const nlohmann::ordered_json& value);

    /// Why nothing can be kept, or empty.
    std::string trouble() const;
    const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path path_of(const std::string& kind, const std::string& key) const;

    std::filesystem::path folder_;
    bool fresh_;
    mutable std::mutex mutex_;
    std::string trouble_;
};

}   // namespace rayclock::jobs
