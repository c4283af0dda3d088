// Sums the multipliers, dividers and memory bits of a configuration.
#include "sim/explore/fit/cost.hpp"

#include <algorithm>

#include "model/core/payloads.hpp"
#include "model/engine/bvh/node.hpp"
#include "model/unit/trav/children.hpp"

namespace rayclock::fit {

namespace {

/// Returns the adders in multipliers of rc_raygen, rc_slab, rc_edges and rc_tri.
std::uint64_t multipliers(const Config& c) {
    const int d = c.coord_bits + 1, r1 = c.recip_bits + 1, cross = c.dir_bits + d + 1, x = 2 * d + 1;
    const int raygen = 3 * 2 * c.guard_dir_bits() * c.pixel_bits;
    const int box = 3 * (2 * d * r1 + 2 * c.node_width * c.box_bits * r1);
    const int edges = 12 * c.dir_bits * d + 6 * d * d + 9 * cross * d + 3 * x * d;
    return std::uint64_t(raygen + box + edges + 2 * c.num_bits() * c.edge_bits());
}

/// Returns the adders in dividers of rc_recip and rc_hitdiv.
std::uint64_t dividers(const Config& c) {
    const auto even = [](int bits) { return (bits + 1) / 2 * 2; };
    const int quotients = even(std::max(c.t_bits(), c.bary_bits)) + 2 * even(c.bary_bits);
    return std::uint64_t(3 * c.dir_bits * even(c.recip_bits) + c.edge_bits() * quotients);
}

int log2(int power) { return index_bits(power + 1) - 1; }

/// Returns the bits of a cache: tags with a valid bit, and words in the form that the units read.
std::uint64_t cache(const Config& c, int sets, int ways, int line, int word_bits) {
    const int words = line / line_bytes, tag = c.addr_bits - log2(words) - log2(sets);
    return std::uint64_t(sets) * std::uint64_t(ways) * std::uint64_t(tag + 1 + words * word_bits);
}

}   // namespace

Cost cost_of(const Config& c) {
    const int w = c.node_width, t = c.t_bits();
    const auto contexts = std::uint64_t(c.contexts);
    Cost cost;
    cost.multiplier_adders = multipliers(c);
    cost.divider_adders = dividers(c);
    const int group = t + c.addr_bits + c.group_bits() + (w - 1) * (t + c.slot_bits());
    cost.stack_bits = contexts * std::uint64_t(c.stack_depth * group);
    const int leaves = bits_of<Leaves>(c) - c.ray_bits(), children = bits_of<Children>(c);
    const int best = c.num_bits() + c.edge_bits() + c.prim_bits,
              found = bits_of<Closest>(c) - c.ray_bits() - 1;
    const int list = t + leaves + c.slot_bits() + count_bits + 3 * (c.coord_bits + c.dir_bits) + best + found;
    const int trav = t + children + 3 * (c.coord_bits + 1 + c.recip_bits + 1 + exp_bits) + c.stack_bits();
    cost.ray_bits = cost.stack_bits + contexts * std::uint64_t(list + trav + 2 * c.pixel_bits);
    cost.cache_bits = cache(c, c.node_sets, c.node_ways, c.node_line, bits_of<Node>(c)) +
                      cache(c, c.prim_sets, c.prim_ways, c.prim_line, 2 * bits_of<PrimData>(c));
    return cost;
}

}   // namespace rayclock::fit
