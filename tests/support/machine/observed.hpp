#pragma once
// The actual values of the units' signals while rays are walked: the stages of the RTL, written again from
// the links' payloads.
#include <map>
#include <string>

#include "model/engine/bvh/decode.hpp"
#include "model/layout/words.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/trace/walk.hpp"
#include "sim/explore/fit/interval.hpp"

namespace rayclock::test {

/// The extremes by "unit.signal", with the names of sim/explore/fit/ranges.hpp.
class Observed {
public:
    using Int128 = fit::Int128;

    std::map<std::string, fit::Interval> seen;

    Observed(const MemoryImage& image, const Frame& frame, const Config& config)
        : image_(image), frame_(frame), c_(config), decoder_(image, config) {}

    void frame() {
        std::uint32_t ray = 0;
        for (std::uint32_t y = 0; y < frame_.height; ++y)
            for (std::uint32_t x = 0; x < frame_.width; ++x, ray = (ray + 1) % std::uint32_t(c_.contexts))
                pixel({ray, x, y});
    }

private:
    void see(const std::string& name, Int128 value) { seen[name] = fit::hull(seen[name], fit::point(value)); }

    void pixel(const Slot& slot) {
        Walk walk(frame_, c_, decoder_);
        const Ray& ray = walk.start(slot);
        raygen(slot, ray);
        for (bool done = false; !done;) {
            see("trav.node addr", walk.node());
            see("mem.addr", walk.node());
            for (std::size_t k = 0; k < 3; ++k) slab(k, ray, bvh::read_node(image_, walk.node(), c_));
            bool more = walk.visit_node();
            const NodeAnswer boxes = walk.node_answer();
            list(boxes);
            for (; more; more = walk.advance()) {
                see("list.prim addr", walk.prim());
                see("mem.addr", walk.prim() / 2);
                triangle(ray, read_primitive(image_, walk.prim(), c_), walk.best(), walk);
            }
            const Tested tested = walk.tested();
            see("list.t_best", tested.t_best);
            see("trav.ray", tested.ray);
            walk.decide(done);
            see("trav.height", walk.stack_height());
        }
    }

    void raygen(const Slot& slot, const Ray& ray) {
        see("raygen.frame.width", frame_.width);
        see("raygen.frame.height", frame_.height);
        see("raygen.x", slot.x);
        see("raygen.y", slot.y);
        for (std::size_t k = 0; k < 3; ++k) {
            see("raygen.eye", ray.o[k]);
            see("raygen.corner", frame_.corner[k]);
            see("raygen.right", frame_.right[k]);
            see("raygen.down", frame_.down[k]);
            see("raygen.s1_right", Int128(frame_.right[k]) * slot.x);
            see("raygen.s1_down", Int128(frame_.down[k]) * slot.y);
            see("raygen.s1_sum",
                Int128(frame_.right[k]) * slot.x + Int128(frame_.down[k]) * slot.y + frame_.corner[k]);
            see("raygen.d", ray.d[k]);
            const std::int64_t size = ray.d[k] < 0 ? -std::int64_t(ray.d[k]) : ray.d[k];
            see("raygen.s0_mag", size);
            see("raygen.s0_m", size << (std::uint32_t(c_.dir_bits) - ray.len[k]));
            see("raygen.recip", ray.recip[k]);
            see("raygen.len", ray.len[k]);
        }
    }

    /// Repeats rc_slab stage by stage, for every child.
    void slab(std::size_t k, const Ray& ray, const Node& node) {
        const bool neg = ray.d[k] < 0, zero = ray.len[k] == 0;
        const Int128 distance = neg ? Int128(ray.o[k]) - node.org[k] : Int128(node.org[k]) - ray.o[k];
        const Int128 r = ray.recip[k], up = r + (zero ? 0 : 1);
        see("box.org", node.org[k]);
        see("box.exp", node.exp[k]);
        see("box.s1_distance", distance);
        see("box.s1_near", distance * r);
        see("box.s1_far", distance * up);
        const Int128 near = (distance * r) >> node.exp[k], far = -((-distance * up) >> node.exp[k]);
        see("box.s2_near", near);
        see("box.s2_far", far);
        const int shift = c_.t_frac_bits + c_.dir_bits - c_.recip_bits - int(ray.len[k]) + int(node.exp[k]);
        const int left = std::clamp(shift, 0, c_.t_bits()), right = shift < 0 ? -shift : 0;
        for (std::size_t i = 0; i < std::size_t(c_.node_width) && node.kind[i] != 0; ++i) {
            const Int128 lo = node.lo[3 * i + k], hi = node.hi[3 * i + k];
            see("box.kind", node.kind[i]);
            see("box.plane", lo);
            see("box.plane", hi);
            see("box.step", (neg ? hi : lo) * r);
            see("box.step", (neg ? lo : hi) * up);
            const Int128 near_sum = neg ? near - hi * r : near + lo * r,
                         far_sum = neg ? far - lo * up : far + hi * up;
            see("box.s3_near", near_sum);
            see("box.s3_far", far_sum);
            if (zero) continue;
            see("box.s3_left", left);
            see("box.s3_right", right);
            see("box.s3_up", (Int128(1) << right) - 1);
            if (far_sum >= 0) moved("far", far_sum + (Int128(1) << right) - 1, left, right);
            moved("near", near_sum < 0 ? 0 : near_sum, left, right);
        }
    }
    void moved(const std::string& name, Int128 value, int left, int right) {
        if (name == "far") see("box.s3_far + s3_up", value);
        const Int128 down = value >> right;
        see("box." + name + ", moved", (down & ((Int128(1) << c_.t_bits()) - 1)) << left);
        see("box." + name, down << left);
    }

    void list(const NodeAnswer& boxes) {
        see("list.base", boxes.base);
        see("list.inner", boxes.inner);
        see("list.leaves", boxes.leaves);
        for (std::size_t i = 0; i < boxes.inner + boxes.leaves; ++i) {
            see("list.offset", boxes.offset[i]);
            see("list.count", boxes.count[i]);
            if (i < boxes.inner) see("trav.slot", boxes.offset[i] / 2);
        }
    }

    using Vec = std::array<Int128, 3>;
    static Vec cross(const Vec& a, const Vec& b) {
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
    static Int128 dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

    /// Repeats rc_edges, rc_tri and rc_hitdiv, and steps the walk.
    void triangle(const Ray& ray, const PrimData& t, const Best& best, Walk& walk) {
        const auto minus = [](const Vec3i& a, const Vec3i& b) {
            return Vec{Int128(a[0]) - b[0], Int128(a[1]) - b[1], Int128(a[2]) - b[2]};
        };
        const Vec e1 = minus(t.b, t.a), e2 = minus(t.c, t.a), s = minus(ray.o, t.a),
                  d{ray.d[0], ray.d[1], ray.d[2]};
        const Vec p1 = cross(d, e1), p2 = cross(d, e2), n = cross(e1, e2);
        for (std::size_t k = 0; k < 3; ++k) {
            for (const Vec3i& corner : {t.a, t.b, t.c}) see("tri.a, b, c", corner[k]);
            for (const Int128 e : {e1[k], e2[k]}) see("tri.s1_e1, s1_e2", e);
            see("tri.s1_s", s[k]);
            see("tri.s2_p1", p1[k]);
            see("tri.s2_p2", p2[k]);
            see("tri.s2_n", n[k]);
            for (const Int128 term : {p2[k] * e1[k], p2[k] * s[k], p1[k] * s[k]})
                see("tri.terms of det, u, v", term);
            see("tri.terms of num", n[k] * s[k]);
        }
        const Int128 det = dot(p2, e1), u = dot(p2, s), v = -dot(p1, s), num = dot(n, s);
        see("tri.s3_det", det);
        see("tri.s3_u", u);
        see("tri.s3_v", v);
        see("tri.s3_w", det - u - v);
        see("tri.s3_w", det - u - v - 1);
        see("tri.s3_num", num);
        see("tri.s4_det", det < 0 ? -det : det);
        see("tri.s4_num", det < 0 ? -num : num);
        see("tri.prim", t.prim);
        const Best to_beat = best;
        const TriRsp& rsp = walk.test_triangle();
        if (!rsp.closer) return;
        if (to_beat.found) {
            see("tri.f1_mine, f1_theirs", Int128(rsp.num) * to_beat.det);
            see("tri.f1_mine, f1_theirs", Int128(to_beat.num) * rsp.det);
        }
        see("tri.num_wide", Int128(rsp.num)
                                << (c_.dir_bits > c_.coord_bits + 3 ? c_.dir_bits - c_.coord_bits - 3 : 0));
        see("tri.t", ((Int128(rsp.num) << (c_.dir_bits - 1 + c_.t_frac_bits)) + rsp.det - 1) / rsp.det);
        see("tri.u, v", rsp.u);
        see("tri.u, v", rsp.v);
    }

    const MemoryImage& image_;
    const Frame& frame_;
    Config c_;
    Decoder decoder_;
};

}   // namespace rayclock::test
