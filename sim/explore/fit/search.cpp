// The search for the smallest formats: bisection, then descent.
#include "sim/explore/fit/search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/core/parameters.hpp"
#include "model/engine/check.hpp"
#include "model/scene/folded.hpp"

namespace rayclock::fit {

namespace {

// In dB: the loss that bary_bits may cause, and the PSNR above which any loss is allowed.
constexpr double colour_loss = 0.1, colour_enough = 60;

int most(int Config::*member) { return parameter(member).hi; }
int least(int Config::*member) { return parameter(member).lo; }

/// Returns the least value that is enough, by bisection. `top` is enough, `low` is not.
template <class Enough> int least_of(int low, int top, const Enough& enough) {
    while (top - low > 1) {
        const int middle = (low + top) / 2;
        (enough(middle) ? top : low) = middle;
    }
    return top;
}

std::string broken_rule(const Config& config) {
    try {
        check_config(config, "");
        return {};
    } catch (const UserError& e) {
        return std::string(e.what()).substr(2);   // behind ": "
    }
}

}   // namespace

const char* purpose_name(Purpose purpose) {
    switch (purpose) {
        case Purpose::correctness: return "correctness";
        case Purpose::accuracy: return "accuracy";
        case Purpose::work: return "work";
    }
    return "";
}

Search::Search(Measurer& measure, const Config& base, const Goal& goal)
    : measure_(measure), given_(base), base_(base), goal_(goal) {
    base_.addr_bits = max_addr_bits;
    base_.prim_bits = max_prim_bits;
    base_.pixel_bits = max_pixel_bits;
    base_.stack_depth = most(&Config::stack_depth);
}

Config Search::widest(const Config& config) const {
    Config wide = config;
    for (int Config::*member :
         {&Config::recip_bits, &Config::box_bits, &Config::bary_bits, &Config::t_frac_bits})
        wide.*member = most(member);
    if (wide.planes) wide.bary_bits = std::min(wide.bary_bits, 31 - plane_bits);
    // The widest distances may not fit with wide coordinates: rc_box has 64 bits.
    if (wide.shading)   // the minimum for shadow rays and bounces beyond the lattice
        wide.origin_bits = std::max(
            {least(&Config::origin_bits), wide.dir_bits - wide.coord_bits - 1, wide.horizon ? far_drop : 0});
    while (wide.t_frac_bits > 0 && !broken_rule(wide).empty()) --wide.t_frac_bits;
    if (!wide.shading) return wide;
    for (Config more = wide; more.origin_bits < most(&Config::origin_bits);) {
        ++more.origin_bits;
        if (!broken_rule(more).empty()) break;
        wide = more;
    }
    return wide;
}
Config Search::widest(int coord_bits, int dir_bits) const {
    Config config = base_;
    config.coord_bits = coord_bits;
    config.dir_bits = dir_bits;
    return widest(config);
}

std::string Search::violation(const Config& config) {
    if (std::string rule = broken_rule(config); !rule.empty()) return rule;
    const Measurement& o = measure_(config);
    if (!o.refused.empty()) return o.refused;
    if (100 * double(o.other) > goal_.max_error * double(o.pixels))
        return fmt::format("{:.3f} % of the pixels hold another primitive", o.other_percent());
    if (goal_.min_psnr && o.psnr_db < *goal_.min_psnr) return fmt::format("PSNR {:.2f} dB", o.psnr_db);
    const Config widest_fields = widest(config);
    const Measurement& wide = measure_(widest_fields);
    if (!goal_.min_psnr && o.psnr_db < std::min(wide.psnr_db, colour_enough) - colour_loss)
        return fmt::format("PSNR {:.2f} dB, of {:.2f}", o.psnr_db, wide.psnr_db);
    const double more = 100 * (double(o.work) / double(wide.work) - 1);
    if (more > goal_.max_work) return fmt::format("{:.2f} % more nodes and triangles", more);
    if (double(o.direction_squares) > std::ldexp(1.0, 2 * (config.dir_bits - 1 + config.t_frac_bits)))
        return "t is rounded by more than a lattice step";
    return {};
}

std::optional<int> Search::smallest_coord_bits() {
    const auto widest_at = [&](int n) { return widest(n, std::min(most(&Config::dir_bits), 62 - 2 * n)); };
    // Above about 62 / 3 bits a wider N needs a narrower M, so the widest N may not be the best.
    int top = 0;
    for (int n = most(&Config::coord_bits); n >= least(&Config::coord_bits) && top == 0; --n) {
        const Config config = widest_at(n);
        if (keeps(config))
            top = n;
        else if (closest_.name.empty() || measure_(config).other < measure_(closest_).other)
            closest_ = config;
        if (config.dir_bits == most(&Config::dir_bits)) break;
    }
    if (top == 0) return {};
    return least_of(least(&Config::coord_bits) - 1, top, [&](int n) { return keeps(widest_at(n)); });
}

/// Finds the smallest M for this N, if the pair costs less than the best one so far.
void Search::find_directions(int n) {
    const bool known = !best_.name.empty();
    int top = std::min(most(&Config::dir_bits), 62 - 2 * n), low = least(&Config::dir_bits) - 1;
    while (known && top > low && cost_of(widest(n, top)).total() >= cost_of(best_).total()) --top;
    if (top == low || !keeps(widest(n, top))) return;
    best_ = widest(n, least_of(low, top, [&](int m) { return keeps(widest(n, m)); }));
}

bool Search::find_lattice_and_directions() {
    closest_.name.clear();
    const std::optional<int> smallest = smallest_coord_bits();
    if (!smallest) return false;
    best_.name.clear();
    for (int n = *smallest; n <= most(&Config::coord_bits); ++n) find_directions(n);
    return true;
}

void Search::bisect(int Config::*member) {
    best_.*member = least_of(least(member) - 1, best_.*member, [&](int value) {
        Config config = best_;
        config.*member = value;
        return keeps(config);
    });
}

void Search::descend() {
    for (bool moved = true; moved;) {
        moved = false;
        for (int Config::*member :
             {&Config::coord_bits, &Config::dir_bits, &Config::recip_bits, &Config::box_bits,
              &Config::t_frac_bits, &Config::bary_bits, &Config::origin_bits}) {
            if (member == &Config::origin_bits && !base_.shading) continue;
            Config lower = best_;
            --(lower.*member);
            if (!keeps(lower)) continue;
            best_ = lower;
            moved = true;
        }
    }
}

/// Sets the widths and the stack depth that this scene, picture and caches need.
void Search::fit_to_scene() {
    const Measurement& outcome = measure_(best_);
    const auto bits_for = [](std::uint64_t count) { return int(std::bit_width(count - 1)); };
    best_.stack_depth = int(std::bit_ceil(unsigned(std::max(1, outcome.compile.stack_need))));
    best_.addr_bits = std::max(
        {least(&Config::addr_bits), best_.least_addr_bits(), bits_for(outcome.compile.bytes / line_bytes)});
    best_.prim_bits = std::max(least(&Config::prim_bits), bits_for(numbered_primitives(measure_.scene())));
    best_.pixel_bits =
        std::max(least(&Config::pixel_bits),
                 bits_for(std::uint64_t(std::max(measure_.size().width, measure_.size().height))));
}

/// Reports why descend() stopped at this width. The measurement is cached.
Fitted Search::fitted(int Config::*member, Purpose purpose) {
    Fitted f{&parameter(member), purpose, best_.*member, "this is the minimum"};
    if (f.value == f.parameter->lo) return f;
    Config lower = best_;
    --(lower.*member);
    f.below = violation(lower);
    if (f.below.empty())
        throw std::logic_error(std::string("fit: ") + f.parameter->key + " can be lowered, and was not");
    return f;
}

/// A width that must number all items: one bit fewer, or half the places, leaves some without a number.
Fitted Search::needed(int Config::*member, const std::string& why) const {
    Fitted f{&parameter(member), Purpose::correctness, best_.*member, why};
    Config lower = best_;
    lower.*member = f.parameter->power_of_two() ? f.value / 2 : f.value - 1;
    if (f.value == f.parameter->lo)
        f.below = "this is the minimum";
    else if (const std::string rule = broken_rule(lower); !rule.empty())
        f.below = rule;
    return f;
}

std::optional<Fit> Search::run() {
    if (!find_lattice_and_directions()) return {};
    for (int Config::*member :
         {&Config::recip_bits, &Config::box_bits, &Config::t_frac_bits, &Config::bary_bits})
        bisect(member);
    if (base_.shading) bisect(&Config::origin_bits);
    descend();
    Fit fit;
    fit.widest = measure_(widest(best_));
    for (int Config::*member :
         {&Config::coord_bits, &Config::dir_bits, &Config::t_frac_bits, &Config::bary_bits})
        fit.parameters.push_back(fitted(member, Purpose::accuracy));
    if (base_.shading) fit.parameters.push_back(fitted(&Config::origin_bits, Purpose::accuracy));
    for (int Config::*member : {&Config::recip_bits, &Config::box_bits})
        fit.parameters.push_back(fitted(member, Purpose::work));
    fit_to_scene();
    fit.config = best_;
    fit.outcome = measure_(best_);
    if (!fit.outcome.refused.empty()) throw std::logic_error("fit: " + fit.outcome.refused);
    const CompileReport& report = fit.outcome.compile;
    fit.parameters.push_back(needed(
        &Config::stack_depth, fmt::format("a ray keeps up to {} groups of siblings", report.stack_need)));
    fit.parameters.push_back(
        needed(&Config::addr_bits, fmt::format("the memory image has {} lines", report.bytes / line_bytes)));
    fit.parameters.push_back(needed(&Config::prim_bits, fmt::format("the scene has {} primitives",
                                                                    numbered_primitives(measure_.scene()))));
    fit.parameters.push_back(
        needed(&Config::pixel_bits,
               fmt::format("the picture has {} x {} pixels", measure_.size().width, measure_.size().height)));
    fit.cost = cost_of(best_);
    fit.base_cost = cost_of(given_);
    return fit;
}

}   // namespace rayclock::fit
