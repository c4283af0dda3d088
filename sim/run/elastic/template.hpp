#pragma once
// The files from which a user starts a replacement of a unit.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// A file of a template.
struct TemplateFile {
    std::string name, bytes;
};

/// Returns the files for a unit: a copy of its module, a wrapper around the project's module, and a README
/// with ports, links, payloads of this configuration, rules, don't-care outputs and run lines. Throws
/// UserError if there is no such unit, if it has no module of its own, or if the chip lacks it. `options`:
/// what follows --config in the run lines, in shell syntax.
std::vector<TemplateFile> unit_template(const std::string& unit, const Config& config,
                                        const std::string& options);

}   // namespace rayclock
