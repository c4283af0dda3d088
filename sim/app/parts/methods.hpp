#pragma once
// nextpnr's algorithms as options of the commands that route: chip, and fit with a device.
#include <optional>
#include <string>

#include "sim/app/options/parser.hpp"
#include "sim/silicon/chip/nextpnr.hpp"

namespace rayclock {

/// The options as typed; missing ones default to chip::usual_methods().
struct MethodOptions {
    std::optional<std::string> placer, router;
    std::optional<int> placements;

    /// Returns the first option that was typed; empty if none was.
    std::string first() const {
        return placer ? "--placer" : router ? "--router" : placements ? "--placements" : "";
    }
};
/// Declares the options under the heading `group` of --help.
void method_options(Parser& parser, MethodOptions& options, const char* group);

/// Returns the methods for the whole chip ("chip"), or for the unit of that name. Throws UserError.
chip::Methods methods_of(const MethodOptions& options, const std::string& top);

}   // namespace rayclock
