#pragma once
// Chips with and without the units that a scene may need, and what they consist of.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock::area {

/// A configuration with some of the optional units.
struct Variant {
    std::string name;   ///< "shading + spheres"
    Config config;
};

/// Hits only; shading alone; shading with each further unit alone; all. All else is `base`'s. Throws
/// UserError if `base` cannot shade, or has no RTL.
std::vector<Variant> variants_of(const Config& base);

/// The same configuration with shading, and with no or every further unit.
Config shading_alone(Config config);
Config all_units(Config config);

/// A module of the machine, named without rc_.
struct UnitRow {
    const char* name;
    bool in_pipeline;   ///< one in each pipeline; otherwise one for all
    bool (*is_there)(const Config&);
};
/// In the order in which a ray meets them.
const std::vector<UnitRow>& unit_rows();

}   // namespace rayclock::area
