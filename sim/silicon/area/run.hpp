#pragma once
// Every unit of every variant through Yosys, each different one once.
#include <map>

#include "model/base/progress.hpp"
#include "sim/silicon/area/variants.hpp"
#include "sim/silicon/synth/parts.hpp"
#include "sim/files/cache/results.hpp"

namespace rayclock::area {

using synth::Count;
using synth::Part;

struct Areas {
    std::vector<Variant> variants;
    std::vector<std::map<std::string, Part>> units;   ///< [variant], by the unit's name; a unit that is not
                                                      ///< there is missing
    std::size_t different = 0;                        ///< of all units of all variants
    std::size_t known = 0;                            ///< taken from the cache
    bool partial = false;                             ///< interrupted() before the end
};

/// `only`: names of units, or none for all. `threads` at the same time, 0 for all cores. Throws UserError if
/// there is no Yosys.
Areas run(std::vector<Variant> variants, const std::vector<std::string>& only, int threads,
          jobs::Cache& cache, const Progress& progress);

/// Of one pipeline.
Count pipeline_count(const Areas& areas, std::size_t variant);

/// Of all units of the chip: every pipeline, and what they share. The host's registers and the wiring between
/// units are not counted.
Count chip_count(const Areas& areas, std::size_t variant);

}   // namespace rayclock::area
