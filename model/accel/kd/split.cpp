#include "model/accel/kd/split.hpp"

#include <algorithm>

namespace rayclock::kd {

namespace {

constexpr std::size_t few = 512;    // up to here all ends are tried
constexpr std::int32_t bins = 64;   // planes that are tried beyond that

/// The cost of planes on one axis of a cell.
class AxisCost {
public:
    AxisCost(const LatticeBox& cell, std::size_t axis, std::size_t most)
        : cell_(cell), axis_(axis), most_(most), area_(cell.area()) {}
    void consider(std::int32_t plane, std::size_t below, std::size_t above, bool flat_above,
                  Split& best) const {
        if (plane <= cell_.lo[axis_] || plane >= cell_.hi[axis_] || below + above > most_) return;
        LatticeBox lower = cell_, upper = cell_;
        lower.hi[axis_] = upper.lo[axis_] = plane;
        const double cost = cost_of(lower.area() / area_, below, upper.area() / area_, above);
        if (cost < best.cost) best = {{axis_, plane, flat_above}, cost, below, above};
    }

private:
    const LatticeBox& cell_;
    std::size_t axis_, most_;
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
void try_ends(const Items& items, const LatticeBox& cell, std::size_t axis, std::size_t most, Ends& ends,
              Split& best) {
    ends.lo.clear(), ends.hi.clear(), ends.flat.clear();
    for (const Item& item : items) {
        ends.lo.push_back(item.box.lo[axis]), ends.hi.push_back(item.box.hi[axis]);
        if (item.box.lo[axis] == item.box.hi[axis]) ends.flat.push_back(item.box.lo[axis]);
    }
    for (std::vector<std::int32_t>* list : {&ends.lo, &ends.hi, &ends.flat})
        std::sort(list->begin(), list->end());
    const AxisCost cost(cell, axis, most);
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
void try_bins(const Items& items, const LatticeBox& cell, std::size_t axis, std::size_t most, Split& best) {
    std::int32_t first = items[0].box.lo[axis], last = items[0].box.hi[axis];
    for (const Item& item : items)
        first = std::min(first, item.box.lo[axis]), last = std::max(last, item.box.hi[axis]);
    const AxisCost cost(cell, axis, most);
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

}   // namespace

double cost_of(double lower, std::size_t below, double upper, std::size_t above) {
    const double tests = test_cost * (lower * double(below) + upper * double(above));
    return (visit_cost + tests) * (below == 0 || above == 0 ? empty_factor : 1);
}

void try_axes(const Items& items, const LatticeBox& cell, std::size_t most, Split& best) {
    Ends ends;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (items.size() <= few)
            try_ends(items, cell, axis, most, ends, best);
        else
            try_bins(items, cell, axis, most, best);
}

}   // namespace rayclock::kd
