#pragma once
// A memory as data: a DRAM's organisation, timing and controller in a JSON file.
#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "model/core/config.hpp"
#include "model/core/dram_parts.hpp"

namespace rayclock {

/// Returns true if a value of `dram` names a file: it has a dot or a slash, which no built-in memory's name
/// has.
bool is_memory_file(std::string_view value);

/// Parses the text of a file. `path` is for messages, and names the memory if the file has no "name". Throws
/// UserError with file, line and value.
DramPart parse_memory(const std::string& path, std::string_view text);
/// Parses an object inside another file, at "dram". Throws UserError.
DramPart inner_memory(const std::string& path, const nlohmann::json& object);

/// Sets a parameter as set_parameter() does, or sets `dram` to the memory in a file. A relative path starts
/// in `folder`. Throws UserError.
void set_value(Config& config, const std::string& key, const std::string& value, const std::string& where,
               const std::string& folder = {});

/// Returns the memory with every key in the form that parse_memory() reads.
nlohmann::ordered_json memory_file_json(const DramPart& part);

/// Returns every value of a memory from a file, for cache keys: figures of one memory must not serve for
/// another. Returns an empty string for a built-in memory.
std::string own_memory_text(const Config& config);

}   // namespace rayclock
