// Sweeps planes over the items of a cell.
#include "model/engine/space_cells/split.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace rayclock::space_cells {

namespace {

constexpr std::size_t parallel_sweep = 4096;   // fewest items to sweep the three axes in parallel
constexpr std::size_t linear_to = 16;          // up to this number, items cost one test each
using Coordinates = std::vector<std::int32_t>;

/// Returns the number of tests that n items count as: linear_to (n / linear_to)^(13/16). The power uses only
/// square roots, which give the same doubles on every machine.
double weight(std::size_t n) {
    if (n <= linear_to) return double(n);
    const double half = std::sqrt(double(n) / double(linear_to)), quarter = std::sqrt(half),
                 sixteenth = std::sqrt(std::sqrt(quarter));
    return double(linear_to) * half * quarter * sixteenth;
}

/// Returns weight(), from a table where it reaches.
double weight_of(std::size_t n) {
    static const std::vector<double> table = [] {
        std::vector<double> all(1 << 12);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = weight(i);
        return all;
    }();
    return n < table.size() ? table[n] : weight(n);
}

/// Sorts by digits in O(n), as coordinates have at most 20 bits.
void sort(Coordinates& all, Coordinates& room) {
    constexpr int digit = 11;
    if (all.size() < 512) return std::sort(all.begin(), all.end());
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    const std::int32_t first = *least;
    const auto extent = std::uint32_t(*most - first);
    room.resize(all.size());
    for (int shift = 0; shift < 32 && extent >> shift > 0; shift += digit) {
        std::array<std::size_t, (1 << digit) + 1> begin{};
        const auto place = [&](std::int32_t x) {
            return std::uint32_t(x - first) >> shift & ((1 << digit) - 1);
        };
        for (const std::int32_t x : all) ++begin[place(x) + 1];
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        for (const std::int32_t x : all) room[begin[place(x)]++] = x;
        all.swap(room);
    }
}

/// A cursor in a sorted list while a plane sweeps over it.
class Next {
public:
    Next(const Coordinates& list, std::int32_t offset) : list_(list), offset_(offset) {}
    /// Returns the first entry that is not yet behind the plane.
    std::int32_t operator()(std::int32_t behind) {
        while (at_ < list_.size() && list_[at_] + offset_ <= behind) ++at_;
        return at_ < list_.size() ? list_[at_] + offset_ : LatticeBox::far;
    }

private:
    const Coordinates& list_;
    std::int32_t offset_;
    std::size_t at_ = 0;
};

/// Planes across one axis of a cell.
class Sweep {
public:
    Sweep(const Items& items, const LatticeBox& cell, std::size_t axis, std::size_t most)
        : axis_(axis), most_(most), from_(cell.lo[axis]), to_(cell.hi[axis]), area_(cell.area()) {
        const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
        const double u = cell.hi[j] - cell.lo[j], v = cell.hi[k] - cell.lo[k];
        face_ = u * v, around_ = u + v;
        lo_.reserve(items.size()), hi_.reserve(items.size());
        for (const Item& item : items) {
            lo_.push_back(item.box.lo[axis]), hi_.push_back(item.box.hi[axis]);
            if (lo_.back() == hi_.back()) flat_.push_back(lo_.back());
        }
        Coordinates room;
        sort(lo_, room), sort(hi_, room), sort(flat_, room);
    }

    /// Tries planes at both ends of every item, and next to items without thickness.
    void run(Split& best) const {
        Next lo(lo_, 0), hi(hi_, 0), before(flat_, -1), after(flat_, 1);
        std::size_t begun = 0, ended = 0, lie = 0;
        for (std::int32_t plane = from_;;) {
            plane = std::min({lo(plane), hi(plane), before(plane), after(plane)});
            if (plane >= to_) return;
            while (begun < lo_.size() && lo_[begun] < plane) ++begun;
            while (ended < hi_.size() && hi_[ended] <= plane) ++ended;
            while (lie < flat_.size() && flat_[lie] < plane) ++lie;
            std::size_t flat = 0;
            while (lie + flat < flat_.size() && flat_[lie + flat] == plane) ++flat;
            const std::size_t above = hi_.size() - ended;
            consider(plane, begun + flat, above, false, best);
            if (flat > 0) consider(plane, begun, above + flat, true, best);
        }
    }

private:
    void consider(std::int32_t plane, std::size_t below, std::size_t above, bool flat_above,
                  Split& best) const {
        if (below + above > most_) return;
        const double lower = face_ + around_ * double(plane - from_),
                     upper = face_ + around_ * double(to_ - plane);
        const double cost = cost_of(lower / area_, below, upper / area_, above);
        if (cost < best.cost) best = {{axis_, plane, flat_above}, cost, below, above};
    }

    std::size_t axis_, most_;
    std::int32_t from_, to_;
    double area_, face_ = 0, around_ = 0;
    Coordinates lo_, hi_, flat_;   // of items on the axis, sorted; flat_: items whose two ends coincide
};

}   // namespace

double cost_of(double lower, std::size_t below, double upper, std::size_t above) {
    const double tests = test_cost * (lower * weight_of(below) + upper * weight_of(above));
    return (cut_cost + tests) * (below == 0 || above == 0 ? empty_factor : 1);
}

void try_axes(const Items& items, const LatticeBox& cell, std::size_t most, Split& best) {
    std::array<Split, 3> found{best, best, best};
    const auto try_axis = [&](std::size_t axis) { Sweep(items, cell, axis, most).run(found[axis]); };
    if (items.size() >= parallel_sweep)
        tbb::parallel_for(std::size_t(0), found.size(), try_axis);
    else
        for (std::size_t axis = 0; axis < found.size(); ++axis) try_axis(axis);
    for (const Split& split : found)
        if (split.cost < best.cost) best = split;
}

}   // namespace rayclock::space_cells
