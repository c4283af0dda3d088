#pragma once
// Configurations by name or from a file, with single parameters overridden.
#include <string>
#include <string_view>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// The user's choice of a configuration.
struct ConfigChoice {
    /// A name, or a file: JSON with every parameter, or "like": NAME and some of them.
    std::string name = "default";
    std::vector<std::string> set;   ///< key=value; later ones override earlier ones
};
/// Loads a configuration. Throws UserError if it does not exist or is not legal.
Config load_config(const ConfigChoice& choice);

/// Parses the text of a file; the result need not be legal. `path` is for messages, and files that the text
/// names lie in its folder. Throws UserError.
Config parse_config(const std::string& path, std::string_view text);

/// Returns the configuration with every key=value of `set`. Throws UserError if it is not legal; the message
/// then begins with `where`.
Config with_settings(Config config, const std::vector<std::string>& set, const std::string& where);

}   // namespace rayclock
