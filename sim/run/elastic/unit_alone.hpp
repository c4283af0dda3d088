#pragma once
// One unit of the RTL alone, on the requests that it gets in a frame.
#include <cstdint>
#include <optional>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// The result of a unit alone.
struct UnitAlone {
    std::uint64_t requests = 0, answers = 0, cycles = 0;
    std::uint64_t value_mismatches = 0;   ///< answers that are wrong, lost or not due
    std::optional<Divergence> first;      ///< `ray` is the number that the request had here; no pixel
    double seconds = 0;
    bool interrupted = false;
    bool agrees() const { return value_mismatches == 0 && !interrupted; }
};

/// True if the unit answers each request with one transfer: tri, xform, and the node units.
bool runs_alone(const std::string& unit);

/// Records at most `most` requests of a frame, with the answers of the unit's pure function. Adds the same
/// number of corner cases if has_corners(). Then offers them to the unit with random valid and
/// ready. Each request gets the number of a ray that is not in flight. Answers may come in any order.
/// Don't-care outputs are not compared. Throws UserError unless runs_alone().
UnitAlone run_unit_alone(const Job& job, const RecordedFrame& frame, const std::string& unit, int seed = 1,
                         std::uint64_t most = 1'000'000);

}   // namespace rayclock
