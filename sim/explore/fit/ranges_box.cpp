// Box's signals: rtl/engine/bvh/rc_slab.sv, which has the widths, for every exponent of a node with every
// sign and bit length of a direction.
#include "sim/explore/fit/ranges.hpp"

namespace rayclock::fit {

namespace {

struct Slab {
    Interval distance, near, far, near_shifted, far_shifted, step, near_sum, far_sum, up, far_up, left, right,
        near_moved, far_moved, near_all, far_all;
};

/// One axis of a node with one class of directions: s1 to s3 of rc_slab.
void slab(const Extremes::Group& node, int exp, const Interval& eye, const RecipClass& ray, const Config& c,
          Slab& all) {
    const auto add = [](Interval& range, const Interval& more) { range = hull(range, more); };
    const Interval distance = ray.negative ? eye - node.origin : node.origin - eye;
    const Interval up = ray.len == 0 ? ray.recip : ray.recip + point(1);
    const Interval near = distance * ray.recip, far = distance * up;
    const Interval near_shifted = right(near, exp), far_shifted = right_up(far, exp);
    const Interval near_step = (ray.negative ? node.hi : node.lo) * ray.recip,
                   far_step = (ray.negative ? node.lo : node.hi) * up;
    const Interval near_sum = ray.negative ? near_shifted - near_step : near_shifted + near_step;
    const Interval far_sum = ray.negative ? far_shifted - far_step : far_shifted + far_step;
    const int shift = c.t_frac_bits + c.dir_bits - c.recip_bits - ray.len + exp;
    // A shift by T, and all beyond it, saturates.
    const int to_left = std::clamp(shift, 0, c.t_bits()), to_right = std::max(-shift, 0);
    add(all.distance, distance);
    add(all.near, near);
    add(all.far, far);
    add(all.near_shifted, near_shifted);
    add(all.far_shifted, far_shifted);
    add(all.step, hull(near_step, far_step));
    add(all.near_sum, near_sum);
    add(all.far_sum, far_sum);
    if (ray.len == 0) return;   // only the signs of both are used
    add(all.left, point(to_left));
    add(all.right, point(to_right));
    // A value below zero is not moved: near is zero then, and far a miss.
    const Interval round_up = point((Int128(1) << to_right) - 1), far_up = not_negative(far_sum) + round_up;
    add(all.up, round_up);
    add(all.far_up, far_up);
    const Interval near_down = right(not_negative(near_sum), to_right), far_down = right(far_up, to_right);
    add(all.near_moved, left(low_bits(near_down, c.t_bits()), to_left));
    add(all.far_moved, left(low_bits(far_down, c.t_bits()), to_left));
    add(all.near_all, left(near_down, to_left));
    add(all.far_all, left(far_down, to_left));
}

}   // namespace

void box_ranges(const Extremes& e, const Config& c, std::vector<Signal>& out) {
    Interval origin, exponent, plane;
    Slab s;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<RecipClass> rays = recip_classes(e.direction[k], c);
        for (int exp = 0; exp < 1 << exp_bits; ++exp) {
            const Extremes::Group& group = e.groups[k][std::size_t(exp)];
            if (group.origin.empty()) continue;
            origin = hull(origin, group.origin);
            exponent = hull(exponent, point(exp));
            plane = hull(plane, hull(group.lo, group.hi));
            for (const RecipClass& ray : rays) slab(group, exp, e.eye[k], ray, c, s);
        }
    }
    const auto add = [&](const char* name, const Interval& range, bool is_signed, int there,
                         Excess excess = Excess::never) {
        out.push_back({"box", name, range, is_signed, there, excess});
    };
    const int r1 = c.recip_bits + 1, d = c.coord_bits + 1, p = d + r1 + 1, v = p + 1;
    add("org", origin, true, c.coord_bits);
    add("exp", exponent, false, exp_bits);
    add("kind", e.kind, false, count_bits);
    add("plane", plane, false, c.box_bits);
    add("s1_distance", s.distance, true, d);
    add("s1_near", s.near, true, p);
    add("s1_far", s.far, true, p);
    add("s2_near", s.near_shifted, true, p);
    add("s2_far", s.far_shifted, true, p);
    add("step", s.step, true, v);
    add("s3_near", s.near_sum, true, v);
    add("s3_far", s.far_sum, true, v);
    add("s3_left", s.left, false, 5);
    add("s3_right", s.right, false, 5);
    add("s3_up", s.up, false, r1);
    add("s3_far + s3_up", s.far_up, false, v);
    add("near, moved", s.near_moved, false, 2 * c.t_bits());
    add("far, moved", s.far_moved, false, 2 * c.t_bits());
    add("near", s.near_all, false, c.t_bits(), Excess::saturates);
    add("far", s.far_all, false, c.t_bits(), Excess::saturates);
}

}   // namespace rayclock::fit
