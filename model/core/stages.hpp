#pragma once
#include "model/core/config.hpp"

namespace rayclock {

/// How many stages each pipeline of the chip has: the one place that says it, for model and RTL. A relaxed
/// chip has few, a fast one has a register wherever a path would be longer than one addition and a choice
/// (`rtl/cells/rc_path_register.sv`), and three in every product (`rtl/fixed/rc_mul.sv`).
struct Stages {
    int cut = 0;        ///< of rc_path_register
    int far = 0;        ///< of those beside it on the way between units of a chip that shades, which is full
    int multiply = 0;   ///< of rc_mul
    int quotient_bits = 0;   ///< that rc_divide makes in a stage
    int hit_bits = 0;        ///< likewise in rc_hitdiv, whose operands are the widest
    // The box test, rtl/engine/bvh/rc_slab.sv, rc_box.sv, rc_rank.sv.
    int slab_planes = 0;   ///< before a child's planes are multiplied
    int slab = 0;          ///< from a node to its children's intervals on an axis
    int meet = 0;          ///< from these, of the first children, to the intersections of all
    int rank = 0;          ///< from that to the children's order
    // The treelet, rtl/engine/kd/rc_treelet.sv, rc_plane.sv; its exits' order as in box.
    int plane = 0;      ///< from a treelet to the times of its planes
    int exits = 0;      ///< from these to the exits' intervals
    int globe = 0;      ///< from a node of globes to which are met, rtl/engine/globe/rc_globe.sv; order as in
                        ///< box
    int crossing = 0;   ///< from a slant to the times of its planes, rtl/engine/bsp/rc_crossing.sv; exits and
                        ///< order as of a treelet
    // Products and quotients that share a multiplier or divider, one after the other, if tri takes a
    // primitive only every few cycles (rtl/fixed/rc_mul_shared.sv): of three cross products, of the four sums
    // of products that are edge functions, of a pair, of which each may be made in two parts
    // (rtl/fixed/rc_mul_parts.sv); what a pair takes, but the stages of a product.
    int cross_share = 1;
    int dot_share = 1;
    int pair_share = 1;
    bool pair_parts = false;
    int pair = 1;
    // Primitives, rtl/unit/isect/rc_tri.sv: rc_edges, rc_shear, the comparison, rc_hitdiv, rc_sphere.
    int edges = 0;
    int shear = 0;
    int compare = 0;
    int hit_divide = 0;
    int sphere_levels = 0;   ///< of a shift, each with a register in a fast chip
    int sphere = 0;
    // Rays, rtl/unit/raygen/rc_raygen.sv: the pixel's steps, rc_direction, rc_recip, rc_slope.
    int pixel = 0;
    int direction = 0;
    int recip = 0;
    int slope = 0;
    // Instances, rtl/unit/xform/rc_xform.sv: products, and reciprocals, that share a multiplier or a divider;
    // from a ray to where it is in the mesh's space, before its reciprocals.
    int map_share = 1;
    int recip_share = 1;
    int map = 0;
    // A pass of shade, rtl/unit/shade/rc_pass.sv: a pass stays in each of so many stages for shade_interval
    // cycles.
    int pass = 28;
    int pass_cut = 0;     ///< registers on the way within a stage, where a pass stays long enough in it
    int pass_out = 28;    ///< at whose end what a pass leads to is taken: the last one's, or when it is over
    int pass_parts = 1;   ///< in which what waits beside a pass is written and read, a part a cycle
    int pass_read = 0;    ///< until what is kept of a context is there
    // Units that keep what they know of a ray.
    int arrive = 0;    ///< more of trav's, from box's answer to its leaves
    int tried = 0;     ///< more of list's, from tri's answer on
    int stack = 0;     ///< more of trav's, from a step to what its stack decides
    int closest = 0;   ///< more of shade's, from a ray's answer to what it wants
    int cache = 0;     ///< more of a cache's, before a look-up, and after the data are read

    explicit Stages(const Config& config);
    int divide(int bits) const;   ///< that make so many bits of a quotient
};

}   // namespace rayclock
