#pragma once
// Configurations by name, by file, and with single parameters set over them.
#include <string>
#include <string_view>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// A configuration as it is asked for.
struct ConfigChoice {
    std::string name = "default";   ///< or a file: JSON with every parameter, or "like": NAME and some of
                                    ///< them
    std::vector<std::string> set;   ///< key=value, each over the one before it
};
/// Throws UserError.
Config load_config(const ConfigChoice& choice);

/// What the text of a file says, whether it is legal or not; `path` names it, and files that it names lie
/// beside it. Throws UserError.
Config parse_config(const std::string& path, std::string_view text);

/// The configuration with every key=value of `set`; `where` begins the sentence if it is not legal then.
/// Throws UserError.
Config with_settings(Config config, const std::vector<std::string>& set, const std::string& where);

}   // namespace rayclock
