#pragma once
// Runs many rays of many families on many lattices, in batches on all cores. A run can be continued later.
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "sim/explore/stress/judge.hpp"

namespace rayclock::stress {

/// The counts of one test, lattice and family: a row of the table.
struct Cell {
    std::string test;
    int bits = 0;
    std::string family;
    Counts counts;
};
/// Returns the test of this name. Throws UserError.
const NamedTest& named_test(const std::string& name);
/// Returns all tests: first those of the machine and the baselines, then the controls.
const std::vector<NamedTest>& named_tests();
/// Returns true if a test's counts meet its demand. Families that must leak are judged separately: they must
/// leak.
bool meets_demand(const NamedTest& test, const std::vector<Cell>& cells);
/// Returns true if only an expected fault is missing, and too few rays were shot to show it. The fault is a
/// control's, or a leak in a family that must leak.
bool has_too_few_rays(const NamedTest& test, const std::vector<Cell>& cells);

/// The input of a stress run.
struct Plan {
    std::vector<std::string> tests{"exact"};
    std::vector<int> bits{12, 14, 16, 18, 20};
    std::vector<std::string> families;
    /// For each test of the machine, a tenth for other tests. Lattices and families share them evenly.
    std::uint64_t rays = 1'000'000;
    std::uint64_t seed = 1;
    int threads = 0;
    /// Number of batches, including earlier runs, after which the run stops as if interrupted.
    std::uint64_t stop_after = ~std::uint64_t(0);
    std::string state;   ///< file to continue from and to write, or empty
};

/// The result of a stress run.
struct StressResult {
    std::vector<Cell> cells;
    std::uint64_t rays = 0, rays_before = 0;   ///< total, and the part from earlier runs
    double seconds = 0;                        ///< of this run
    double core_seconds = 0;                   ///< summed over all threads
    bool partial = false;
};

/// Runs the plan. Equal plans give equal counts, for any number of threads and interruptions. Throws
/// UserError if the state belongs to another plan.
StressResult run(const Plan& plan, const Progress& progress = {});

/// Returns the configuration of a lattice of `bits` for a batch. Direction widths alternate between batches,
/// starting with the largest that the rules allow.
Config format_of(int bits, std::uint64_t batch);

}   // namespace rayclock::stress
