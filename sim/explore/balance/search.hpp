#pragma once
// Searches the fastest machine that fits a device. Parameters of its shape rise step by step as long as the
// scene gains speed and the device has room.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/core/config.hpp"
#include "sim/silicon/chip/device.hpp"

namespace rayclock::balance {

/// A parameter of the machine's shape and its values, in order of rising hardware cost.
struct ParameterValues {
    const char* key;
    int Config::*member;
    std::vector<int> values;
};
const std::vector<ParameterValues>& parameter_values();

/// Each number of pipelines has its own search. Doubling them costs so much at once that single steps would
/// not lead from one number to the next.
constexpr int pipeline_counts[] = {1, 2, 4, 8};

/// A step to the next value of a parameter, up or down.
struct Step {
    const ParameterValues* parameter = nullptr;
    int from = 0, to = 0;
};

/// A machine and its known figures.
struct Machine {
    std::vector<Step> steps;   ///< from the machine that it was derived from
    Config config;
    std::optional<double> fps;      ///< empty if the configuration is illegal or cannot render the scene
    std::optional<chip::Use> use;   ///< empty if the search did not need it
};

/// The search's questions, each for many machines at once. Each fills in one member of every machine, or
/// leaves it empty. Each returns false if interrupted.
struct Evaluator {
    std::function<bool(std::vector<Machine>&)> fps;
    std::function<bool(std::vector<Machine>&)> use;
};

/// The result of a search.
struct SearchResult {
    Machine first;               ///< all parameters at their least values
    std::vector<Machine> path;   ///< the accepted machines after `first`, each with the steps that led to it
    /// Machines that are one step further in each parameter that would gain speed. None of them fits.
    std::vector<Machine> next;
    std::vector<Machine> others;   ///< results, or least machines, with other numbers of pipelines
    std::size_t machines = 0;      ///< number of machines whose speed was measured
    const Machine& best() const { return path.empty() ? first : path.back(); }
};

/// A smaller relative speed-up does not justify hardware.
constexpr double least_gain = 0.005;

bool fits(const chip::Use& use, const chip::Use& room);

/// Runs the search for each number of pipelines. The first machine has the least value of each parameter.
/// Each round takes the step up, or the pair of steps, with the largest gain per step that fits, until none
/// is left. Then it takes a step down in one parameter together with steps up in another, if that is faster,
/// and starts again. The result is a local optimum: no step up, no pair, and no exchange of one for one both
/// fits and gains `least_gain`. At the end every parameter steps down as long as no speed is lost. Returns
/// the fastest result; among equals, the one with the fewest pipelines. Returns nothing if interrupted.
/// `best()` does not fit if no first machine fits.
std::optional<SearchResult> search(const Config& base, const chip::Use& room, const Evaluator& evaluator);

}   // namespace rayclock::balance
