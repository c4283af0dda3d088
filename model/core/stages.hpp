#pragma once
// Stages of the pipelines, in relaxed and fast chips.
#include "model/core/config.hpp"

namespace rayclock {

/// The number of stages of each pipeline in the chip: the single source for model and RTL. A relaxed chip has
/// few stages. A fast chip has a register wherever a path would be longer than one addition and a choice
/// (`rtl/cells/delays/rc_path_register.sv`), and three in every product (`rtl/fixed/multipliers/rc_mul.sv`).
struct Stages {
    int cut = 0;   ///< stages of rc_path_register
    /// Stages of additional registers between units of a chip that shades, which fills the device.
    int shading_cut = 0;
    int multiply = 0;        ///< stages of rc_mul
    int quotient_bits = 0;   ///< quotient bits per stage of rc_divide
    int hit_bits = 0;        ///< the same for rc_hitdiv, whose operands are the widest
    // The box test, rtl/engine/bvh/rc_slab.sv, rc_box.sv, rc_rank.sv.
    int slab_planes = 0;   ///< before a child's planes are multiplied
    int slab = 0;          ///< from a node to its children's intervals on an axis
    int meet = 0;          ///< from these, of the first children, to the intersections of all children
    int rank = 0;          ///< from the intersections to the children's order
    // The treelet, rtl/engine/kd/rc_treelet.sv, rc_plane.sv. It orders its exits as box does.
    int plane = 0;   ///< from a treelet to the times of its planes
    int exits = 0;   ///< from these to the exits' intervals
    /// Stages from a node of globes to the globes that are met (rtl/engine/spheres/rc_globe.sv). The order
    /// takes as many as in box.
    int globe = 0;
    /// Stages from a slant to the times of its planes (rtl/engine/bsp/rc_crossing.sv). Exits and order take
    /// as many as in treelet.
    int crossing = 0;
    // Products and quotients that share a multiplier or divider in turn, if tri accepts a primitive only
    // every few cycles (rtl/fixed/multipliers/rc_mul_shared.sv): of three cross products (cross_share), of
    // the four sums of products that are edge functions (dot_share), of a pair (pair_share). Each product of
    // a pair may be made in two parts (pair_parts, rtl/fixed/multipliers/rc_mul_parts.sv). `pair` is a pair's
    // latency without the stages of a product.
    int cross_share = 1;
    int dot_share = 1;
    int pair_share = 1;
    bool pair_parts = false;
    int pair = 1;
    // Primitives, rtl/unit/tri/rc_tri.sv: rc_edges, rc_shear, the comparison, rc_hitdiv, rc_sphere.
    int edges = 0;
    int shear = 0;
    int compare = 0;
    int hit_divide = 0;
    int sphere_levels = 0;   ///< levels of a shift, each with a register in a fast chip
    int sphere = 0;
    // Rays, rtl/unit/raygen/rc_raygen.sv: rc_sample, the pixel's steps, rc_direction, rc_recip, rc_slope.
    int sample = 4;   ///< if the chip supersamples
    int pixel = 0;
    int direction = 0;
    int recip = 0;
    int slope = 0;
    // Instances, rtl/unit/xform/rc_xform.sv: products that share a multiplier (map_share), reciprocals that
    // share a divider (recip_share), and the stages from a ray to its place in the mesh's space, without its
    // reciprocals (map).
    int map_share = 1;
    int recip_share = 1;
    int map = 0;
    // A pass of shade, rtl/unit/shade/pass/rc_pass.sv. A pass stays in each of its stages for shade_interval
    // cycles.
    int pass = 28;
    int pass_cut = 0;    ///< registers within a stage, if a pass stays in it long enough
    int pass_out = 28;   ///< stage at whose end the outcome of a pass is accepted
    /// Number of parts in which values that accompany a pass are written and read, one per cycle.
    int pass_parts = 1;
    int pass_read = 0;   ///< cycles until a context's state has been read
    // Unit tex, rtl/unit/tex: from a texture record to the address of texels, and from these to a colour.
    int tex_address = 0;
    int tex_filter = 0;
    // Units that keep state per ray.
    int node_answer_delay = 0;   ///< additional stages of trav, from a node unit's answer to its leaves
    int tri_answer_delay = 0;    ///< additional stages of list, after tri's answer
    int stack_delay = 0;         ///< additional stages of trav, from a step to its stack's decision
    int closest_delay = 0;       ///< additional stages of shade, from a ray's answer to its request
    int cache_delay = 0;   ///< additional stages of a cache, before a look-up, and again after the data are
                           ///< read

    explicit Stages(const Config& config);
    int divide(int bits) const;   ///< stages that make this many quotient bits
};

}   // namespace rayclock
