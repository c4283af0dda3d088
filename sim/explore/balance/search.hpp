#pragma once
// The fastest machine that fits a device: parameters of shape go up step by step as long as the scene gains
// by it and there is room.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/core/config.hpp"
#include "sim/silicon/chip/device.hpp"

namespace rayclock::balance {

/// A parameter of shape and its values, from the least hardware to the most.
struct Ladder {
    const char* key;
    int Config::*member;
    std::vector<int> rungs;
};
const std::vector<Ladder>& ladders();

/// Each number of pipelines is searched by itself: to double them costs so much at once that no step after
/// the other would lead from one to the other.
constexpr int pipeline_counts[] = {1, 2, 4, 8};

/// One step on a ladder, up or down.
struct Step {
    const Ladder* ladder = nullptr;
    int from = 0, to = 0;
};

/// A machine, with what is known of it.
struct Machine {
    std::vector<Step> steps;   ///< from the machine that it was made of
    Config config;
    std::optional<double> fps;      ///< nothing if the configuration is illegal, or cannot draw the scene
    std::optional<chip::Use> use;   ///< nothing if nobody had to know it
};

/// What the search asks about machines, many at once. Each fills in one member of every machine, or leaves it
/// empty; false if interrupted.
struct Doors {
    std::function<bool(std::vector<Machine>&)> fps;
    std::function<bool(std::vector<Machine>&)> use;
};

struct Found {
    Machine first;               ///< all parameters at their least
    std::vector<Machine> path;   ///< from there, each with the steps that led to it
    std::vector<Machine> next;   ///< one step further in each parameter that would make it faster: none fits
    std::vector<Machine> others;   ///< what was found, or is least, with other numbers of pipelines
    std::size_t machines = 0;      ///< whose speed was asked for
    const Machine& best() const { return path.empty() ? first : path.back(); }
};

/// Less than this share of speed is no gain, and no reason for hardware.
constexpr double least_gain = 0.005;

bool fits(const chip::Use& use, const chip::Use& room);

/// The search, for each number of pipelines: the first machine has the least value of each ladder. The step
/// up, or the pair of them, that gains most per step and fits is taken, until none is left; then a step down
/// in one parameter for steps up in another, if that is faster, and so on. What is found is a local best: no
/// step up, no pair, and no exchange of one for one both fits and gains `least_gain`. At last every parameter
/// goes down as long as nothing is lost. The fastest is found, of equal ones that with the fewest pipelines.
/// Nothing if interrupted; `best()` does not fit if no first machine does.
std::optional<Found> search(const Config& base, const chip::Use& room, const Doors& doors);

}   // namespace rayclock::balance
