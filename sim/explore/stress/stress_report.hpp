#pragma once
// The results of a stress run as tables and as JSON.
#include <nlohmann/json.hpp>

#include "sim/explore/stress/stress_batches.hpp"

namespace rayclock::stress {

std::string text(const Plan& plan, const StressResult& outcome);
nlohmann::ordered_json json(const Plan& plan, const StressResult& outcome);

/// Returns the verdict on a test in words.
const char* verdict(const NamedTest& test, const std::vector<Cell>& cells);
/// Returns the needless visits of child boxes, in percent of the boxes that the rays meet.
std::string extra_boxes(const Counts& counts);

/// Returns the sum of the counts of all cells for which `wanted` is true.
template <class Wanted> Counts sum(const std::vector<Cell>& cells, const Wanted& wanted) {
    Counts counts;
    for (const Cell& cell : cells)
        if (wanted(cell)) counts += cell.counts;
    return counts;
}

}   // namespace rayclock::stress
