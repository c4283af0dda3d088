#pragma once
// Triangles near a way between any two points: for ways that begin beside the lattice, where Surface cannot
// look.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "model/oracle/cross.hpp"

namespace rayclock::oracle {

/// A binary tree of boxes, split at the median.
///
/// No triangle that meets the way is skipped: boxes are a whole lattice step wider on every side than their
/// triangles, and a way is passed by only if on an axis, or seen along one, it is apart from that box.
/// Coordinates are below 2^21, so doubles err by less than 2^-30 of a step there, and by less than 2^-30 of
/// the step's share in the comparisons of products.
class Around {
public:
    using Point = std::array<double, 3>;

    explicit Around(std::vector<Corners> triangles)
        : triangles_(std::move(triangles)), order_(triangles_.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        nodes_.reserve(2 * triangles_.size() + 1);
        nodes_.resize(1);
        if (!triangles_.empty()) build(0, 0, std::uint32_t(triangles_.size()));
    }

    /// Calls meet(number) for triangles that may meet the way, until it returns false.
    template <class Meet> void along(const Point& from, const Point& to, const Meet& meet) const {
        if (triangles_.empty()) return;
        const Way way(from, to);
        std::array<std::uint32_t, 64> stack;
        std::size_t depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            if (way.passes_by(node.lo, node.hi)) continue;
            if (node.count == 0) {
                stack[depth++] = node.first;
                stack[depth++] = node.first + 1;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                if (!meet(order_[i])) return;
        }
    }

    const std::vector<Corners>& triangles() const { return triangles_; }

private:
    struct Node {
        std::array<float, 3> lo{}, hi{};   ///< whole numbers below 2^21: exact
        std::uint32_t first = 0, count = 0;
    };
    struct Way {
        Point middle, half, size;
        Way(const Point& from, const Point& to) {
            for (std::size_t k = 0; k < 3; ++k) {
                middle[k] = from[k] + to[k];
                half[k] = to[k] - from[k];
                size[k] = std::abs(half[k]);
            }
        }
        /// All lengths doubled.
        bool passes_by(const std::array<float, 3>& lo, const std::array<float, 3>& hi) const {
            Point gap, reach;
            for (std::size_t k = 0; k < 3; ++k) {
                gap[k] = middle[k] - (double(lo[k]) + double(hi[k]));
                reach[k] = double(hi[k]) - double(lo[k]);
                if (std::abs(gap[k]) > size[k] + reach[k]) return true;
            }
            const auto beside = [&](std::size_t i, std::size_t j) {
                return std::abs(gap[i] * half[j] - gap[j] * half[i]) >
                       reach[i] * size[j] + reach[j] * size[i];
            };
            return beside(0, 1) || beside(1, 2) || beside(2, 0);
        }
    };

    void build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
        constexpr std::int32_t most = 1 << 21;
        std::array<std::int32_t, 3> lo{most, most, most}, hi{-most, -most, -most};
        for (std::uint32_t i = first; i < first + count; ++i)
            for (const Vec3i* p :
                 {&triangles_[order_[i]].a, &triangles_[order_[i]].b, &triangles_[order_[i]].c})
                for (std::size_t k = 0; k < 3; ++k) {
                    lo[k] = std::min(lo[k], (*p)[k] - 1);
                    hi[k] = std::max(hi[k], (*p)[k] + 1);
                }
        for (std::size_t k = 0; k < 3; ++k) {
            nodes_[node].lo[k] = float(lo[k]);
            nodes_[node].hi[k] = float(hi[k]);
        }
        nodes_[node].first = first;
        nodes_[node].count = count;
        if (count <= 2) return;
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
        const auto middle = [&](std::uint32_t i) {
            return std::int64_t(triangles_[i].a[axis]) + triangles_[i].b[axis] + triangles_[i].c[axis];
        };
        const auto begin = order_.begin() + first;
        std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t i, std::uint32_t j) {
            return std::pair(middle(i), i) < std::pair(middle(j), j);
        });
        const auto child = std::uint32_t(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[node].first = child;
        nodes_[node].count = 0;
        build(child, first, count / 2);
        build(child + 1, first + count / 2, count - count / 2);
    }

    std::vector<Corners> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}   // namespace rayclock::oracle
