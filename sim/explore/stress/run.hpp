#pragma once
// Many rays of many families on many lattices: in batches, on all cores, to be gone on with later.
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "sim/explore/stress/judge.hpp"

namespace rayclock::stress {

/// One row of the table.
struct Cell {
    std::string test;
    int bits = 0;
    std::string family;
    Counts counts;
};
/// Throws UserError.
const NamedTest& named_test(const std::string& name);
/// All there are; first those of the machine and the baselines, then the controls.
const std::vector<NamedTest>& named_tests();
/// Whether the counts of a test's all families, except for those that must leak, are as demanded; and on
/// those that must, whether they do.
bool meets_demand(const NamedTest& test, const std::vector<Cell>& cells);
/// Whether all that is missing is a fault that should have shown (a control's, or a leak in a family that
/// must leak), and there were so few rays that this says nothing.
bool has_too_few_rays(const NamedTest& test, const std::vector<Cell>& cells);

struct Plan {
    std::vector<std::string> tests{"exact"};
    std::vector<int> bits{12, 14, 16, 18, 20};
    std::vector<std::string> families;
    std::uint64_t rays = 1'000'000;   ///< for each test of the machine, a tenth for others; shared evenly by
                                      ///< lattices and families
    std::uint64_t seed = 1;
    int threads = 0;
    std::uint64_t stop_after = ~std::uint64_t(0);   ///< batches, those of earlier runs included: a part of
                                                    ///< the run, as if interrupted
    std::string state;                              ///< file to go on from and to write to, or empty
};

struct Outcome {
    std::vector<Cell> cells;
    std::uint64_t rays = 0, rays_before = 0;   ///< in all, and of these in earlier runs
    double seconds = 0;                        ///< of this run
    double core_seconds = 0;                   ///< of all threads
    bool partial = false;
};

/// The same counts for the same plan, whatever the threads and however often it was stopped. Throws UserError
/// if the state is of another plan.
Outcome run(const Plan& plan, const Progress& progress = {});

/// Configuration of a lattice of `bits` for the given batch: direction widths alternate, the largest that the
/// rules allow first.
Config format_of(int bits, std::uint64_t batch);

}   // namespace rayclock::stress
