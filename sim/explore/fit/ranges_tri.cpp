// Tri's signals: rtl/unit/tri/rc_edges.sv, rc_tri.sv and rc_hitdiv.sv, which have the widths; and those of
// list and trav. s1 to s4 are a relaxed chip's stages.
#include "sim/explore/fit/ranges.hpp"

namespace rayclock::fit {

namespace {

Interval all(const Extremes::Axes& axes) { return hull(hull(axes[0], axes[1]), axes[2]); }

/// The distance of any hit, before it saturates. It lies on its triangle, so no component of hit - eye is
/// larger than that of a vertex, and d's largest component takes it there: t |d| / 2^(M-1+F) <= reach,
/// rounded up.
Interval hit_distance(const Extremes& e, const Config& c) {
    const Int128 least = std::max(Int128(1), Int128(e.least_direction));
    return {1, ((e.reach.hi << (c.dir_bits - 1 + c.t_frac_bits)) + least - 1) / least};
}

}   // namespace

void tri_ranges(const Extremes& e, const Config& c, std::vector<Signal>& out) {
    const auto add = [&](const char* name, const Interval& range, bool is_signed, int there,
                         Excess excess = Excess::never) {
        out.push_back({"tri", name, range, is_signed, there, excess});
    };
    const int d = c.coord_bits + 1, cross = c.dir_bits + d + 1, x = 2 * d + 1, edge = c.edge_bits(),
              num = c.num_bits();
    add("a, b, c", all(e.vertex), true, c.coord_bits);
    add("s1_e1, s1_e2", all(e.edge), true, d);
    add("s1_s", all(e.to_eye), true, d);
    add("s2_p1", all(e.p1), true, cross);
    add("s2_p2", all(e.p2), true, cross);
    add("s2_n", all(e.normal), true, x);
    add("terms of det, u, v", e.edge_term, true, edge, Excess::wraps);
    add("terms of num", e.num_term, true, num, Excess::wraps);
    add("s3_det", e.det, true, edge);
    add("s3_u", e.u, true, edge);
    add("s3_v", hull(e.v, -e.v), true, edge);             // the sum, and its negative
    add("s3_w", hull(e.w, e.w - point(1)), true, edge);   // one less if a zero counts as negative
    add("s3_num", e.num, true, num);
    // Turned so that det > 0, of hits.
    const Interval size{1, std::max(Int128(1), magnitude(e.det).hi)},
        far{1, std::max(Int128(1), magnitude(e.num).hi)};
    add("s4_det", magnitude(e.det), true, edge);
    add("s4_num", hull(e.num, -e.num), true, num);
    add("f1_mine, f1_theirs", far * size, false, num + edge);
    const int lift = std::max(c.dir_bits - c.coord_bits - 3, 0);
    add("num_wide", left(far, lift), false, std::max(num + lift, edge) + 1);
    const Interval t = hit_distance(e, c);
    add("t", t, false, c.t_bits(), Excess::saturates);
    add("u, v", {0, Int128(1) << c.bary_bits}, false, c.bary_bits + 1);
    add("prim", e.prim, false, c.prim_bits);
}

void walk_ranges(const Extremes& e, const CompileReport& report, const Config& c, std::vector<Signal>& out) {
    const auto add = [&](const char* unit, const char* name, const Interval& range, int there) {
        out.push_back({unit, name, range, false, there, Excess::never});
    };
    const Interval t{0, (Int128(1) << c.t_bits()) - 1};   // all ones: nothing is hit yet
    add("list", "base", e.base, c.addr_bits);
    add("list", "inner", e.inner, c.group_bits());
    add("list", "leaves", e.leaves, c.group_bits());
    add("list", "offset", e.offset, offset_bits);
    add("list", "count", not_negative(e.kind - point(1)), count_bits);
    add("list", "prim addr", e.half_line, c.addr_bits + 1);
    add("list", "t_best", t, c.t_bits());
    add("trav", "node addr", e.node, c.addr_bits);
    add("trav", "slot", hull(point(0), e.slot), c.slot_bits());
    add("trav", "height", {0, report.stack_need}, c.stack_bits());
    add("trav", "ray", {0, Int128(c.contexts) - 1}, c.ray_bits());
    add("mem", "addr", {0, Int128(report.bytes / line_bytes) - 1}, c.addr_bits);
}

}   // namespace rayclock::fit
