// A node's planes round outwards by less than a step, with the finest possible exponent, for every pair of
// children on a small lattice.
#include <catch2/catch.hpp>

#include "model/engine/bvh/encode.hpp"

using namespace rayclock;

namespace {

struct Interval {
    std::int32_t lo = 0, hi = 0;
};
std::vector<Interval> all_intervals(int bits) {
    std::vector<Interval> all;
    const int n = 1 << (bits - 1);
    for (int lo = -n; lo < n; ++lo)
        for (int hi = lo; hi < n; ++hi) all.push_back({lo, hi});
    return all;
}

/// Returns true if the quantised planes of a child along an axis enclose the real ones by less than a step.
bool outward(const Node& node, std::size_t child, std::size_t axis, const Interval& real) {
    const std::int64_t step = std::int64_t(1) << node.exp[axis];
    const std::int64_t lo = bvh::dequantised(node, node.lo[3 * child + axis], axis),
                       hi = bvh::dequantised(node, node.hi[3 * child + axis], axis);
    return lo <= real.lo && real.lo - lo < step && hi >= real.hi && hi - real.hi < step;
}

}   // namespace

TEST_CASE("a node's boxes are outward by less than a step, for every two intervals") {
    Config config;
    config.coord_bits = 5;
    config.box_bits = GENERATE(1, 2, 4);
    const auto all = all_intervals(5);
    const std::size_t n = all.size();
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            // Three pairs at once, one per axis.
            const std::array<Interval, 3> first{all[i], all[j], all[(i + j) % n]},
                second{all[j], all[(2 * i + j) % n], all[i]};
            std::array<bvh::NodeChild, 2> children;
            for (std::size_t k = 0; k < 3; ++k) {
                children[0].box.lo[k] = first[k].lo, children[0].box.hi[k] = first[k].hi;
                children[1].box.lo[k] = second[k].lo, children[1].box.hi[k] = second[k].hi;
            }
            const Node node = bvh::encode_node(children, 0, config);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t extent =
                    std::max(first[k].hi, second[k].hi) - std::min(first[k].lo, second[k].lo);
                const std::int32_t most = (1 << config.box_bits) - 1;
                wrong += !outward(node, 0, k, first[k]) || !outward(node, 1, k, second[k]);
                wrong += node.hi[k] > std::uint32_t(most) || node.hi[3 + k] > std::uint32_t(most) ||
                         node.org[k] != std::min(first[k].lo, second[k].lo);
                // A finer exponent would have been enough.
                wrong += node.exp[k] > 0 && most << (node.exp[k] - 1) >= extent;
            }
        }
    REQUIRE(n == 528);
    REQUIRE(wrong == 0);
}
