#pragma once
// Variants of a chip with and without optional units, and the units of each.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock::area {

/// A configuration with some of the optional units.
struct Variant {
    std::string name;   ///< "shading, spheres"
    Config config;
    std::size_t base = 0;   ///< number of the variant with which this one is compared
};

/// Returns the variants: hits only, hits of a stream of rays, the same written into memory, shading alone,
/// shading with each further unit alone, and all units. Other parameters are those of `base`. Throws
/// UserError if `base` cannot shade or has no RTL.
std::vector<Variant> variants_of(const Config& base);
/// Places of the first variants.
constexpr std::size_t hits_alone = 0, stream_alone = 1, stream_writes = 2, shading_only = 3;

/// Return the configuration with shading and with no further unit, or with all of them.
Config shading_alone(Config config);
Config all_units(Config config);
/// Returns the configuration of a chip that reads rays from memory, for scenes of triangles.
Config streaming_alone(Config config);

/// A module of the machine, named without its prefix rc_.
struct UnitRow {
    const char* name;
    bool in_pipeline;   ///< one in each pipeline; otherwise one in the chip
    bool (*is_there)(const Config&);
};
/// Returns the units in the order in which a ray meets them.
const std::vector<UnitRow>& unit_rows();

}   // namespace rayclock::area
