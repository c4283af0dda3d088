#pragma once
// Options for replaced units: elastic verification, units from files, and a unit alone.
#include <optional>
#include <string>
#include <vector>

#include "sim/app/options/options.hpp"
#include "sim/run/elastic/elastic.hpp"

namespace rayclock {

/// The options as typed.
struct ElasticChoice {
    std::optional<std::string> units;   ///< of --elastic
    std::vector<std::string> files;     ///< of --unit: "tri=my_tri.sv"
    std::optional<std::string> alone;   ///< of --unit-only
    bool is_given() const { return units.has_value(); }
};
void elastic_options(Parser& parser, ElasticChoice& choice);

/// Makes the RTL use the files of --unit. If the word after --elastic is not a list of units, it becomes
/// `scene`. Throws UserError.
void take_elastic(ElasticChoice& choice, std::string& scene);

/// Throws UserError if `odd` is not null. It names an option that has no meaning with --unit-only.
void refuse_with_unit_only(const char* odd);

/// Runs the unit of --unit-only on the requests of a film's first frame. Returns the exit code.
int verify_unit_alone(const ElasticChoice& choice, Film& film, int threads, int seed, const JsonOutput& json);

/// Returns the result as a lockstep result without a cycle gap, for the parts that both reports share.
LockstepResult as_lockstep(const ElasticResult& result);

/// Returns the sum over all frames of the difference in cycles between RTL and model.
std::uint64_t cycle_gap_of(const ElasticResult& result);

}   // namespace rayclock
