#include "model/accel/kd/build.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_invoke.h>

namespace rayclock::kd {

namespace {

constexpr double visit_cost = 15, test_cost = 20, empty_factor = 0.8;
constexpr std::size_t few = 512;         // up to here all ends are tried
constexpr std::size_t parallel = 4096;   // from here on both sides are worked on at once
constexpr std::int32_t bins = 64;        // planes that are tried beyond that

struct Split : Cut {
    double cost = 0;
};

/// The cost of planes on one axis of a cell.
class AxisCost {
public:
    AxisCost(const LatticeBox& cell, std::size_t axis) : cell_(cell), axis_(axis), area_(cell.area()) {}
    void consider(std::int32_t plane, std::size_t below, std::size_t above, bool flat_above,
                  Split& best) const {
        if (plane <= cell_.lo[axis_] || plane >= cell_.hi[axis_]) return;
        LatticeBox lower = cell_, upper = cell_;
        lower.hi[axis_] = upper.lo[axis_] = plane;
        const double tests =
            test_cost * (lower.area() * double(below) + upper.area() * double(above)) / area_;
        const double cost = (visit_cost + tests) * (below == 0 || above == 0 ? empty_factor : 1);
        if (cost < best.cost) best = {{axis_, plane, flat_above}, cost};
    }

private:
    const LatticeBox& cell_;
    std::size_t axis_;
    double area_;
};

/// Coordinates of items on one axis, sorted.
struct Ends {
    std::vector<std::int32_t> lo, hi, flat;
};
std::size_t less(const std::vector<std::int32_t>& v, std::int32_t x) {
    return std::size_t(std::lower_bound(v.begin(), v.end(), x) - v.begin());
}
std::size_t not_more(const std::vector<std::int32_t>& v, std::int32_t x) {
    return std::size_t(std::upper_bound(v.begin(), v.end(), x) - v.begin());
}

/// Both ends of every item, and what is next to those without thickness.
void try_ends(const Items& items, const LatticeBox& cell, std::size_t axis, Ends& ends, Split& best) {
    ends.lo.clear(), ends.hi.clear(), ends.flat.clear();
    for (const Item& item : items) {
        ends.lo.push_back(item.box.lo[axis]), ends.hi.push_back(item.box.hi[axis]);
        if (item.box.lo[axis] == item.box.hi[axis]) ends.flat.push_back(item.box.lo[axis]);
    }
    for (std::vector<std::int32_t>* list : {&ends.lo, &ends.hi, &ends.flat})
        std::sort(list->begin(), list->end());
    const AxisCost cost(cell, axis);
    const auto consider = [&](std::int32_t plane) {
        const std::size_t below = less(ends.lo, plane), above = items.size() - not_more(ends.hi, plane),
                          flat = not_more(ends.flat, plane) - less(ends.flat, plane);
        cost.consider(plane, below + flat, above, false, best);
        if (flat > 0) cost.consider(plane, below, above + flat, true, best);
    };
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i == 0 || ends.lo[i] != ends.lo[i - 1]) consider(ends.lo[i]);
        if (i == 0 || ends.hi[i] != ends.hi[i - 1]) consider(ends.hi[i]);
    }
    for (std::size_t i = 0; i < ends.flat.size(); ++i)
        if (i == 0 || ends.flat[i] != ends.flat[i - 1])
            consider(ends.flat[i] - 1), consider(ends.flat[i] + 1);
}

/// Planes at equal distances, and the ends of all items. What lies in a plane goes below.
void try_bins(const Items& items, const LatticeBox& cell, std::size_t axis, Split& best) {
    std::int32_t first = items[0].box.lo[axis], last = items[0].box.hi[axis];
    for (const Item& item : items)
        first = std::min(first, item.box.lo[axis]), last = std::max(last, item.box.hi[axis]);
    const AxisCost cost(cell, axis);
    cost.consider(first, 0, items.size(), true, best);
    cost.consider(last, items.size(), 0, false, best);
    const std::int64_t extent = std::max(1, last - first);
    std::array<std::int32_t, bins> plane;
    for (std::int32_t b = 0; b < bins; ++b)
        plane[std::size_t(b)] = std::int32_t(first + extent * (b + 1) / (bins + 1));
    const auto first_from = [&](std::int32_t x) {   // the first plane at x or above
        const std::int64_t guess = (std::int64_t(x) - first) * (bins + 1) / extent - 1;
        auto b = std::size_t(std::clamp<std::int64_t>(guess, 0, bins));
        while (b > 0 && plane[b - 1] >= x) --b;
        while (b < bins && plane[b] < x) ++b;
        return b;
    };
    // Of each item the first plane that it reaches below, and the first that it does not reach above.
    std::array<std::size_t, bins + 1> begins{}, ends{};
    for (const Item& item : items) {
        const bool flat = item.box.lo[axis] == item.box.hi[axis];
        ++begins[first_from(item.box.lo[axis] + (flat ? 0 : 1))];
        ++ends[first_from(item.box.hi[axis])];
    }
    std::size_t below = 0, ended = 0;
    for (std::size_t b = 0; b < bins; ++b) {
        below += begins[b], ended += ends[b];
        cost.consider(plane[b], below, items.size() - ended, false, best);
    }
}

class Builder {
public:
    Builder(const Pieces& pieces, const Config& config) : pieces_(pieces) {
        for (int width = config.node_width; width > 1; width /= 2) ++levels_;
    }

    /// `level` planes lie above it; below it at most `depth`.
    CellPtr cell(Items items, LatticeBox box, int level, int depth, double budget) const {
        auto cell = std::make_unique<Cell>();
        cell->bounds = bounds_of(items);
        if (level % levels_ == 0 && !items.empty()) box = cell->bounds;   // a treelet: nothing else is met
        const Split split = best_split(items, box, depth);
        Items lower, upper;
        if (split.axis != no_axis) pieces_.divide(items, box, split, lower, upper);
        const double given = double(lower.size() + upper.size());
        if (split.axis == no_axis || given > std::max(budget, double(items.size()))) return leaf_of(items);
        const bool both = items.size() >= parallel;
        Items().swap(items);
        cell->axis = std::uint32_t(split.axis);
        cell->at = split.plane;
        LatticeBox below = box, above = box;
        below.hi[split.axis] = above.lo[split.axis] = split.plane;
        const double share = given > 0 ? budget / given : 0, for_lower = share * double(lower.size()),
                     for_upper = share * double(upper.size());
        const auto go_lower = [&] {
            cell->lower = this->cell(std::move(lower), below, level + 1, depth - 1, for_lower);
        };
        const auto go_upper = [&] {
            cell->upper = this->cell(std::move(upper), above, level + 1, depth - 1, for_upper);
        };
        if (both)
            tbb::parallel_invoke(go_lower, go_upper);
        else
            go_lower(), go_upper();
        return cell;
    }

private:
    Split best_split(const Items& items, const LatticeBox& box, int depth) const {
        Split best{{}, test_cost * double(items.size())};
        if (depth == 0 || items.empty()) return best;
        Ends ends;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (items.size() <= few)
                try_ends(items, box, axis, ends, best);
            else
                try_bins(items, box, axis, best);
        return best;
    }

    const Pieces& pieces_;
    int levels_ = 0;   // of a treelet
};

}   // namespace

CellPtr build(const std::vector<PrimData>& prims, const Config& config) {
    const Pieces pieces(prims, config);
    Items items = pieces.all();
    const double n = double(items.size());
    const int depth = std::min(34, 8 + int(1.3 * std::log2(std::max(1.0, n))));
    return pieces.with_endless(Builder(pieces, config)
                                   .cell(std::move(items), pieces.space(), pieces.has_endless() ? 1 : 0,
                                         depth, most_references * n));
}

}   // namespace rayclock::kd
