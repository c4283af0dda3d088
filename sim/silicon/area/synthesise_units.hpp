#pragma once
// Synthesises every unit of every variant with Yosys, each distinct one once.
#include <map>

#include "model/base/progress.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/silicon/area/variants.hpp"
#include "sim/silicon/synth/parts.hpp"

namespace rayclock::area {

using synth::Count;
using synth::Part;

/// Cell counts of the units of all variants.
struct Areas {
    std::vector<Variant> variants;
    /// Counts by [variant] and by the unit's name. Units that a variant lacks are missing.
    std::vector<std::map<std::string, Part>> units;
    std::size_t different = 0;   ///< number of distinct units in all variants
    std::size_t known = 0;       ///< number of these taken from the cache
    bool partial = false;        ///< interrupted() before the end
};

/// Synthesises the units named in `only`, or all units if it is empty. `threads` run at the same time; 0 uses
/// all cores. Throws UserError if Yosys is missing.
Areas run(std::vector<Variant> variants, const std::vector<std::string>& only, int threads,
          results::Cache& cache, const Progress& progress);

/// Returns the counts of one pipeline.
Count pipeline_count(const Areas& areas, std::size_t variant);

/// Returns the counts of all units of the chip: every pipeline, and the shared units. Excludes the host's
/// registers and the wiring between units.
Count chip_count(const Areas& areas, std::size_t variant);

}   // namespace rayclock::area
