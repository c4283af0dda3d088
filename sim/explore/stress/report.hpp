#pragma once
// A stress run as tables and JSON.
#include <nlohmann/json.hpp>

#include "sim/explore/stress/run.hpp"

namespace rayclock::stress {

std::string text(const Plan& plan, const Outcome& outcome);
nlohmann::ordered_json json(const Plan& plan, const Outcome& outcome);

/// What came of a test, in words.
const char* verdict(const NamedTest& test, const std::vector<Cell>& cells);
/// Child boxes looked into in vain, in per cent of those that the rays meet.
std::string extra_boxes(const Counts& counts);

/// All cells that `wanted` holds for, added up.
template <class Wanted> Counts sum(const std::vector<Cell>& cells, const Wanted& wanted) {
    Counts counts;
    for (const Cell& cell : cells)
        if (wanted(cell)) counts += cell.counts;
    return counts;
}

}   // namespace rayclock::stress
