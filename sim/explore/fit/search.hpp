#pragma once
// The smallest formats that keep a bound.
#include <optional>

#include "model/core/parameters.hpp"
#include "sim/explore/fit/cost.hpp"
#include "sim/explore/fit/measure.hpp"

namespace rayclock::fit {

struct Goal {
    double max_error = 0.1;   ///< allowed percentage of pixels with another primitive than the reference's
    std::optional<double> min_psnr;   ///< dB, against the reference's picture
    double max_work = 2;   ///< allowed percentage of additional nodes and triangles, over the widest fields
};

/// The purpose of a parameter's width.
enum class Purpose {
    correctness,   ///< a smaller width loses an address, a number or a sibling
    accuracy,      ///< a smaller width makes the picture worse than the bound
    work,          ///< a smaller width makes rays meet more boxes; the picture stays the same
};
const char* purpose_name(Purpose purpose);

/// A fitted parameter, and the effect of one step less.
struct Fitted {
    const Parameter* parameter = nullptr;
    Purpose purpose = Purpose::accuracy;
    int value = 0;
    std::string below;
};

struct Fit {
    Config config;
    Measurement outcome;    ///< the outcome of `config`
    Measurement widest;     ///< the outcome with the same N and M and all other fields at their widest
    Cost cost, base_cost;   ///< base: the given configuration
    std::vector<Fitted> parameters;
};

/// Searches the smallest formats that keep a goal. N and M alone decide which pixels hold another primitive,
/// because all later steps are exact or conservative. So the search starts with the cheapest pair (N, M) that
/// keeps the goal, with all other fields at their widest. It finds the smallest N by bisection. For each
/// larger N it finds the smallest M, while the pair becomes cheaper. Then it fits R, box_bits, F and
/// bary_bits, each by bisection. Bisection assumes that more bits are never worse, which is nearly true. So
/// finally it lowers every parameter by one step, again and again, until none can be lowered.
class Search {
public:
    Search(Measurer& measure, const Config& base, const Goal& goal);

    /// Returns nothing if no width keeps the goal. closest() is then the best attempt.
    std::optional<Fit> run();
    const Config& closest() const { return closest_; }

    /// Returns the smallest N that keeps the goal with all other fields at their widest, if any does.
    std::optional<int> smallest_coord_bits();

    /// Returns the rule or bound that a configuration breaks, as a sentence; empty if none.
    std::string violation(const Config& config);
    /// Returns the configuration with the same N, M and shape, and all other fields at their widest.
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

    Measurer& measure_;
    Config given_, base_;     ///< base: the given one with the widest addresses and the deepest stack
    Config best_, closest_;   ///< none yet if the name is empty
    Goal goal_;
};

}   // namespace rayclock::fit
