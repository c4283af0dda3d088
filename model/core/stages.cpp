#include "model/core/stages.hpp"

#include <algorithm>

namespace rayclock {

namespace {
/// Levels of compare and exchange that put n children in order (Batcher 1968).
int exchange_levels(int n) {
    const int halvings = index_bits(n);
    return halvings * (halvings + 1) / 2;
}
}   // namespace

Stages::Stages(const Config& config) {
    const bool fast = Timing(config.timing) == Timing::fast;
    cut = fast ? 1 : 0;
    multiply = fast ? 3 : 0;
    slab_planes = 2 + 2 * cut;
    slab = slab_planes + multiply + 1 + 2 * cut;
    meet = 1 + 2 * cut;
    rank = 2 + exchange_levels(config.node_width) * cut;
    arrive = 2 * cut;
    stack = 3 * cut;
    cache = cut;
}

// Two quotient bits a stage, see rtl/raygen/rc_raygen.sv, rtl/isect/rc_tri.sv.
int Config::raygen_latency() const {
    return 4 + (supersampling ? 4 : 0) + std::max((recip_bits + 1) / 2, is_sheared() ? dir_bits / 2 : 0);
}
int Config::box_latency() const {
    const Stages stages(*this);
    return stages.cut + stages.slab + stages.meet + stages.rank;
}
int Config::tri_latency() const {
    const int triangle = (is_sheared() ? 8 : 6) + (std::max(t_bits(), uv_bits() - 1) + 1) / 2;
    return spheres ? std::max(triangle, 8 + root_bits / 2 + (t_bits() + 1) / 2) : triangle;
}
int Config::shade_latency() const { return 28; }   // rtl/shade/rc_pass.sv

}   // namespace rayclock
