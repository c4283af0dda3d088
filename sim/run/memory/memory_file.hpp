#pragma once
// A memory as data: a DRAM's organisation, gates and controller in a JSON file.
#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "model/core/config.hpp"
#include "model/core/dram_parts.hpp"

namespace rayclock {

/// Whether a value of `dram` names a file: it has a dot or a slash in it, which no memory's name has.
bool is_memory_file(std::string_view value);

/// What the text of a file says; `path` names it, and the memory, if it has no "name". Throws UserError with
/// file, line and value.
DramPart parse_memory(const std::string& path, std::string_view text);
/// The same of an object inside another file, at "dram".
DramPart inner_memory(const std::string& path, const nlohmann::json& object);

/// Sets a parameter as set_parameter() does, or `dram` to the memory that a file describes; a relative path
/// begins in `folder`. Throws UserError.
void set_value(Config& config, const std::string& key, const std::string& value, const std::string& where,
               const std::string& folder = {});

/// The memory as parse_memory() reads it, every key.
nlohmann::ordered_json memory_file_json(const DramPart& part);

/// Every value of a memory that a file describes, so that figures of another one are never taken for its own;
/// empty if the configuration has a memory with a name.
std::string own_memory_text(const Config& config);

}   // namespace rayclock
