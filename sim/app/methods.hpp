#pragma once
// nextpnr's algorithms as options of the commands that route: chip, and fit with a device.
#include <optional>
#include <string>

#include "sim/app/parser.hpp"
#include "sim/silicon/chip/nextpnr.hpp"

namespace rayclock {

/// As typed; what is not typed is chip::usual_methods().
struct MethodOptions {
    std::optional<std::string> placer, router;
    std::optional<int> placements;

    /// The first of them that was typed; empty if none was.
    std::string first() const {
        return placer ? "--placer" : router ? "--router" : placements ? "--placements" : "";
    }
};
/// `group`: under which heading of --help.
void method_options(Parser& parser, MethodOptions& options, const char* group);

/// For the whole chip ("chip"), or a unit of that name alone. Throws UserError.
chip::Methods methods_of(const MethodOptions& options, const std::string& top);

}   // namespace rayclock
