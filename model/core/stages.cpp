// Computes the number of stages of each pipeline, and the latencies of the units.
#include "model/core/stages.hpp"

#include <algorithm>
#include <bit>

namespace rayclock {

namespace {
/// Returns the levels of compare-exchange that sort n children (Batcher 1968).
int exchange_levels(int n) {
    const int halvings = index_bits(n);
    return halvings * (halvings + 1) / 2;
}

/// Returns the levels of the barrel shift that leaves a sphere's discriminant 2 root_bits bits. It shifts by
/// pairs of bits.
int shift_levels(const Config& config) {
    const int half = std::max(config.dir_bits + config.origin_width(), root_bits);
    return std::bit_width(unsigned(half - root_bits));
}

/// Returns the stages of a divider that makes `in_each` quotient bits in each.
int stages_of_quotient(int bits, int in_each) { return (bits + in_each - 1) / in_each; }
}   // namespace

Stages::Stages(const Config& config) {
    const bool fast = config.timing == Timing::fast;
    cut = fast ? 1 : 0;
    shading_cut = config.shading ? cut : 0;
    multiply = fast ? 3 : 0;
    // A chip that shades fills the device; two bits per stage halve the registers.
    quotient_bits = fast && !config.shading ? 1 : 2;
    slab_planes = 2 + 2 * cut;
    slab = slab_planes + multiply + 1 + 2 * cut;
    meet = 1 + 2 * cut + config.box_interval() - 1;
    rank = 2 + exchange_levels(config.node_width) * cut;
    node_answer_delay = 2 * cut;
    tri_answer_delay = 3 * cut;
    stack_delay = config.is_list() ? 0 : 3 * cut;
    plane = 3 + multiply + 3 * cut;
    exits = 2 + 2 * cut;
    globe = 7 + 3 * multiply + 10 * cut;
    crossing = 4 + multiply + 7 * cut + divide(crossing_bits);
    closest_delay = cut + shading_cut;
    cache_delay = cut;

    cross_share = std::min(config.tri_interval, 3);
    dot_share = config.tri_interval;
    pair_parts = config.tri_interval >= 4;
    pair_share = std::min(config.tri_interval, pair_parts ? 4 : 2);
    pair = pair_share + (pair_parts ? cut : 0);
    edges = 2 + 2 * multiply + cross_share + dot_share + cut;
    shear = 6;
    compare = multiply + 1 + pair + cut;
    sphere_levels = shift_levels(config);
    const int decide = 1 + (multiply + cross_share) + (multiply + pair) + 1 + cut;
    const int root = sphere_levels * cut + 1 + divide(root_bits) + 1 + 2 * cut;
    const int compare_t = multiply + 1 + (pair_parts ? 1 + cut : 0) + 1 + cut;
    sphere = decide + root + divide(config.t_bits()) + 2 * cut + compare_t;
    hit_bits = fast ? 1 : 2;
    hit_divide = stages_of_quotient(std::max(config.t_bits(), config.uv_bits() - 1), hit_bits) + 2 * cut;

    pixel = 1 + (fast ? multiply - 1 : 0);
    direction = 1 + 2 * cut;
    recip = 1 + 3 * cut + divide(config.recip_bits);
    slope = 1 + config.dir_bits / 2;

    map_share = config.xform_interval;
    recip_share = std::min(config.xform_interval, 3);
    map = cut + multiply + map_share - 1 + 2;

    tex_address = 7;
    tex_filter = 4;

    pass_cut = config.shade_interval >= 8 ? cut : 0;
    pass_out = pass - (pass_cut ? 1 : 0);
    pass_parts = pass_cut ? 4 : 1;
    pass_read = config.shade_interval == 1 ? 0 : pass_cut ? pass_cut + pass_parts + 1 : 1;
}
int Stages::divide(int bits) const { return stages_of_quotient(bits, quotient_bits); }

int Config::raygen_latency() const {
    const Stages stages(*this);
    if (is_stream()) return 1 + stages.recip;
    return (supersampling ? stages.sample : 0) + stages.pixel + stages.direction + 1 +
           std::max(stages.recip, is_sheared() ? stages.slope : 0);
}
int Config::tri_latency() const {
    const Stages stages(*this);
    const int test = is_sheared() ? stages.shear : stages.edges;
    const int triangle = test + stages.compare + stages.hit_divide;
    return stages.cut + stages.shading_cut + (spheres ? std::max(triangle, stages.sphere) : triangle);
}
int Config::xform_latency() const {
    const Stages stages(*this);
    return stages.map + stages.recip + stages.recip_share - 1;
}
// With an interval above 1, the inputs are held for several cycles and start in a register.
int Config::pass_latency() const { return Stages(*this).pass * shade_interval + (shade_interval > 1); }
int Config::tex_address_latency() const { return Stages(*this).tex_address; }
int Config::tex_filter_latency() const { return Stages(*this).tex_filter; }
int Config::shade_latency() const { return pass_latency() + Stages(*this).pass_read; }

}   // namespace rayclock
