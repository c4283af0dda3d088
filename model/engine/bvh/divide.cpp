// Splits a range of boxes by the surface area heuristic, or in half.
#include "model/engine/bvh/divide.hpp"

#include <array>

namespace rayclock::bvh {

namespace {

constexpr std::size_t bin_count = 64;
constexpr std::size_t sweep_below = 128;   // number of boxes up to which every position is tried

/// The best split of a range so far. `cost` is the SAH's sum of area times count. `most`, the larger side,
/// breaks ties.
struct Split {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t axis = 0;
    std::size_t at = 0;     ///< bin, or number of items on the left
    std::size_t most = 0;   ///< items of the larger side

    void consider(const Split& other) {
        if (other.cost < cost || (other.cost == cost && other.most < most)) *this = other;
    }
};

struct Bin {
    LatticeBox box;
    std::size_t count = 0;
};

/// Maps centres of one axis to bins. With fewer values than bins it is exact: a bin per value.
struct Binning {
    std::int32_t lo;
    double scale;
    Binning(const LatticeBox& centres, std::size_t axis)
        : lo(centres.lo[axis]),
          scale(double(bin_count) / std::max(double(bin_count), double(centres.hi[axis] - lo) + 1)) {}
    std::size_t operator()(std::int32_t centre) const { return std::size_t(double(centre - lo) * scale); }
};

bool before(const BoxItem& a, const BoxItem& b, std::size_t axis) {
    return a.box.centre(axis) != b.box.centre(axis) ? a.box.centre(axis) < b.box.centre(axis)
                                                    : a.index < b.index;
}

std::size_t halve(std::span<BoxItem> part, const LatticeBox& centres) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (centres.hi[k] - centres.lo[k] > centres.hi[axis] - centres.lo[axis]) axis = k;
    const std::size_t half = part.size() / 2;
    std::nth_element(part.begin(), part.begin() + std::ptrdiff_t(half), part.end(),
                     [axis](const BoxItem& a, const BoxItem& b) { return before(a, b, axis); });
    return half;
}

Split best_bin(const std::array<Bin, bin_count>& bins, std::size_t axis, std::size_t total) {
    std::array<double, bin_count> right{};   // cost of bins i and above
    Bin above;
    for (std::size_t i = bin_count; i-- > 1;) {
        if (bins[i].count > 0) above.box.add(bins[i].box);
        above.count += bins[i].count;
        right[i] = above.count > 0 ? above.box.area() * double(above.count) : 0;
    }
    Split best;
    Bin below;
    for (std::size_t i = 1; i < bin_count; ++i) {
        if (bins[i - 1].count > 0) below.box.add(bins[i - 1].box);
        below.count += bins[i - 1].count;
        if (below.count == 0 || below.count == total) continue;
        const std::size_t most = std::max(below.count, total - below.count);
        best.consider({below.box.area() * double(below.count) + right[i], axis, i, most});
    }
    return best;
}

std::size_t bin(std::span<BoxItem> part, const LatticeBox& centres) {
    const std::array<Binning, 3> binning{Binning{centres, 0}, Binning{centres, 1}, Binning{centres, 2}};
    std::array<std::array<Bin, bin_count>, 3> bins;
    for (const BoxItem& item : part)
        for (std::size_t k = 0; k < 3; ++k) {
            Bin& bin = bins[k][binning[k](item.box.centre(k))];
            bin.box.add(item.box);
            ++bin.count;
        }
    Split best;
    for (std::size_t k = 0; k < 3; ++k) best.consider(best_bin(bins[k], k, part.size()));
    const auto middle = std::partition(part.begin(), part.end(), [&](const BoxItem& item) {
        return binning[best.axis](item.box.centre(best.axis)) < best.at;
    });
    return std::size_t(middle - part.begin());
}

void sort(std::span<const BoxItem> part, std::size_t axis, std::array<std::uint8_t, sweep_below>& order) {
    // Sort by centre, then by index. The low part of each pair is the place in the range.
    std::array<std::pair<std::uint64_t, std::uint8_t>, sweep_below> keys;
    for (std::size_t i = 0; i < part.size(); ++i)
        keys[i] = {std::uint64_t(part[i].box.centre(axis) + (1 << 24)) << 32 | part[i].index,
                   std::uint8_t(i)};
    std::sort(keys.begin(), keys.begin() + std::ptrdiff_t(part.size()));
    for (std::size_t i = 0; i < part.size(); ++i) order[i] = keys[i].second;
}

std::size_t sweep(std::span<BoxItem> part) {
    const std::size_t n = part.size();
    std::array<std::array<std::uint8_t, sweep_below>, 3> order;
    Split best;
    for (std::size_t k = 0; k < 3; ++k) {
        sort(part, k, order[k]);
        std::array<double, sweep_below> right;
        LatticeBox box;
        for (std::size_t i = n; i-- > 1;) {
            box.add(part[order[k][i]].box);
            right[i] = box.area() * double(n - i);
        }
        box = {};
        for (std::size_t i = 1; i < n; ++i) {
            box.add(part[order[k][i - 1]].box);
            best.consider({box.area() * double(i) + right[i], k, i, std::max(i, n - i)});
        }
    }
    std::array<BoxItem, sweep_below> sorted;
    for (std::size_t i = 0; i < n; ++i) sorted[i] = part[order[best.axis][i]];
    std::copy_n(sorted.begin(), n, part.begin());
    return best.at;
}

}   // namespace

std::size_t divide(std::span<BoxItem> part, const LatticeBox& centres, int depth) {
    if (centres.lo == centres.hi || depth > max_sah_depth) return halve(part, centres);
    return part.size() <= sweep_below ? sweep(part) : bin(part, centres);
}

}   // namespace rayclock::bvh
