// Binning of centroids, and the choice of the cheapest cut.
#include "sim/judge/reference/split.hpp"

#include <array>
#include <cstddef>

namespace rayclock {
namespace {

constexpr int max_bins = 32;
constexpr float block_test_cost = 1.0f;     // one block of two triangles against one box of a binary node
constexpr float smallest_extent = 1e-12f;   // below this, centroids (within -2..2) count as one point

float centroid(const RefBox& box, int axis) { return box.lo[axis] + box.hi[axis]; }

struct Bin {
    RefExtent extent;
    std::size_t count = 0;
};

/// Maps a centroid to its bin along one axis. The same expression fills the bins and divides the boxes.
struct Binning {
    int axis = 0;
    int bins = 0;
    float origin = 0;
    float scale = 0;
    int operator()(const RefBox& box) const {
        return std::min(static_cast<int>((centroid(box, axis) - origin) * scale), bins - 1);
    }
};

struct Cut {
    Binning binning;
    int bin = 0;   // boxes of bins below this one go left
    float cost = RefExtent::inf;
};

/// Sweeps the bins from the right, then from the left, and keeps the cheapest cut between two of them.
void find_cut(const Binning& binning, std::span<const Bin> bins, Cut& best) {
    std::array<float, max_bins> right_cost;
    Bin right;
    for (std::size_t i = bins.size() - 1; i > 0; --i) {
        right.extent.add(bins[i].extent.lo, bins[i].extent.hi);
        right.count += bins[i].count;
        right_cost[i] = right.count == 0 ? RefExtent::inf : right.extent.area() * leaf_cost(right.count);
    }
    Bin left;
    for (std::size_t i = 1; i < bins.size(); ++i) {
        left.extent.add(bins[i - 1].extent.lo, bins[i - 1].extent.hi);
        left.count += bins[i - 1].count;
        if (left.count == 0) continue;
        const float cost = left.extent.area() * leaf_cost(left.count) + right_cost[i];
        if (cost < best.cost) best = {binning, static_cast<int>(i), cost};
    }
}

/// Returns the cheapest cut over the three axes. Its cost is infinite if all centroids coincide.
Cut cheapest_cut(std::span<const RefBox> boxes, const RefExtent& centroids) {
    const int bins = static_cast<int>(std::clamp<std::size_t>(boxes.size(), 4, max_bins));
    std::array<Binning, 3> binnings;
    std::array<std::array<Bin, max_bins>, 3> filled;
    for (int a = 0; a < 3; ++a) {
        const float width = centroids.hi[a] - centroids.lo[a];
        const float scale = width > smallest_extent ? static_cast<float>(bins) / width : 0;
        binnings[a] = {a, bins, centroids.lo[a], scale};
    }
    for (const RefBox& box : boxes)
        for (int a = 0; a < 3; ++a) {
            Bin& bin = filled[a][binnings[a](box)];
            bin.extent.add(box.lo, box.hi);
            ++bin.count;
        }
    Cut best;
    for (int a = 0; a < 3; ++a)
        if (binnings[a].scale > 0) find_cut(binnings[a], std::span(filled[a]).first(bins), best);
    return best;
}

}   // namespace

float leaf_cost(std::size_t primitives) {
    return block_test_cost * static_cast<float>((primitives + ref_block_size - 1) / ref_block_size);
}

RefSummary summarise(std::span<const RefBox> boxes) {
    RefSummary summary;
    for (const RefBox& box : boxes) {
        const float c[3] = {centroid(box, 0), centroid(box, 1), centroid(box, 2)};
        summary.bounds.add(box.lo, box.hi);
        summary.centroids.add(c, c);
    }
    return summary;
}

std::size_t split_by_area(std::span<RefBox> boxes, const RefSummary& summary) {
    const Cut cut = cheapest_cut(boxes, summary.centroids);
    if (boxes.size() <= ref_max_leaf) {
        const float area = summary.bounds.area();
        if (!(area + cut.cost < area * leaf_cost(boxes.size()))) return 0;
    }
    if (!(cut.cost < RefExtent::inf)) return split_by_count(boxes, summary);
    const auto middle = std::partition(boxes.begin(), boxes.end(),
                                       [&](const RefBox& box) { return cut.binning(box) < cut.bin; });
    return static_cast<std::size_t>(middle - boxes.begin());
}

std::size_t split_by_count(std::span<RefBox> boxes, const RefSummary& summary) {
    int axis = 0;
    const auto width = [&](int a) { return summary.centroids.hi[a] - summary.centroids.lo[a]; };
    for (int a = 1; a < 3; ++a)
        if (width(a) > width(axis)) axis = a;
    const std::size_t half = boxes.size() / 2;
    // The primitive's number breaks ties, so that the order does not depend on the library's algorithm.
    std::nth_element(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(half), boxes.end(),
                     [axis](const RefBox& a, const RefBox& b) {
                         const float ca = centroid(a, axis), cb = centroid(b, axis);
                         return ca != cb ? ca < cb : a.primitive < b.primitive;
                     });
    return half;
}

}   // namespace rayclock
