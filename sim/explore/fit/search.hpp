#pragma once
// The smallest formats that keep a bound.
#include <optional>

#include "sim/explore/fit/cost.hpp"
#include "model/core/parameters.hpp"
#include "sim/explore/fit/measure.hpp"

namespace rayclock::fit {

struct Goal {
    double max_error = 0.1;   ///< per cent of pixels that may hold another primitive than the reference's
    std::optional<double> min_psnr;   ///< dB, against the reference's picture
    double max_work = 2;              ///< per cent of nodes and triangles above what the widest fields need
};

/// What a parameter's width is for.
enum class Purpose {
    correctness,   ///< below it something is lost: an address, a number, a sibling
    accuracy,      ///< below it the picture is worse than the bound
    work,          ///< below it rays meet more boxes; the picture stays the same
};
const char* purpose_name(Purpose purpose);

/// A parameter that was fitted, and what happens one step below.
struct Fitted {
    const Parameter* parameter = nullptr;
    Purpose purpose = Purpose::accuracy;
    int value = 0;
    std::string below;
};

struct Fit {
    Config config;
    Outcome outcome;        ///< of this configuration
    Outcome widest;         ///< of the same N and M with all other fields at their widest
    Cost cost, base_cost;   ///< base: of the configuration that was given
    std::vector<Fitted> parameters;
};

/// How the search goes. Which pixels hold another primitive is decided by N and M alone: everything after
/// them is exact or conservative. So first the pair (N, M) of the least cost that keeps the goal, all else at
/// its widest: the smallest N by bisection, then for each larger N the smallest M, as long as that is
/// cheaper. Then R, box_bits, F and bary_bits one after the other, each by bisection. Bisection takes for
/// granted that more bits are never worse, and that is nearly true; so in the end every parameter is tried
/// one step lower, again and again, until none can be lowered any more.
class Search {
public:
    Search(Measure& measure, const Config& base, const Goal& goal);

    /// Nothing if no width keeps the goal: closest() is then the one that came closest.
    std::optional<Fit> run();
    const Config& closest() const { return closest_; }

    /// Smallest N that keeps the goal with the widest of all other fields, if any does.
    std::optional<int> smallest_coord_bits();

    /// Which rule or bound a configuration breaks, as a sentence; empty if none.
    std::string violation(const Config& config);
    /// The same N, M and shape with all other fields at their widest.
    Config widest(const Config& config) const;

private:
    Config widest(int coord_bits, int dir_bits) const;
    bool keeps(const Config& config) { return violation(config).empty(); }
    bool find_lattice_and_directions();
    void find_directions(int coord_bits);
    void bisect(int Config::*member);
    void descend();
    void fit_to_scene();
    Fitted fitted(int Config::*member, Purpose purpose);
    Fitted needed(int Config::*member, const std::string& why) const;

    Measure& measure_;
    Config given_, base_;     ///< base: with the widest addresses and the deepest stack
    Config best_, closest_;   ///< without a name: none yet
    Goal goal_;
};

}   // namespace rayclock::fit
