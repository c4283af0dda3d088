#pragma once
// Formats so small that every operand can be tested. They are below the limits of check_config(), but the
// units' formulas hold for them too.
#include <functional>

#include "sim/judge/oracle/overlap.hpp"
#include "model/engine/check.hpp"
#include "tests/support/cases/box_cases.hpp"

namespace rayclock::test {

inline Config small_format(int coord_bits, int dir_bits, int recip_bits, int t_frac_bits, int box_bits) {
    Config config;
    config.name =
        "small" + std::to_string(coord_bits) + std::to_string(dir_bits) + std::to_string(recip_bits);
    config.coord_bits = coord_bits;
    config.dir_bits = dir_bits;
    config.recip_bits = recip_bits;
    config.t_frac_bits = t_frac_bits;
    config.box_bits = box_bits;
    config.bary_bits = 3;
    config.contexts = 2;
    return config;
}

/// Streams `count` requests from make() at full rate. Calls judge(request, answer) for each. Omits the checks
/// and messages of stream(), which cost more time than the unit.
template <class Dut, class Make, class Judge>
void pour(Dut& dut, std::uint64_t count, Make make, Judge judge) {
    using Req = typename Dut::Unit::Req;
    std::deque<Req> waiting;
    std::uint64_t sent = 0, received = 0;
    dut.out.ready = true;
    for (std::uint64_t idle = 0; received < count; ++idle) {
        if (!dut.in.offer && sent < count) dut.in.offer = make(), ++sent;
        dut.eval();
        if (dut.out.fires()) {
            judge(waiting.front(), *dut.out.offer);
            waiting.pop_front();
            ++received;
            idle = 0;
        }
        const bool taken = dut.in.fires();
        if (taken) waiting.push_back(*dut.in.offer);
        dut.commit();
        if (taken) dut.in.offer.reset();
        if (idle > 1000) FAIL("no answer for 1000 cycles");
    }
}

// ---- Boxes. On one axis: origin, the node's corner and exponent, and a direction; then the planes lo <= hi
// of a child.
struct AxisCase {
    std::int32_t o = 0, org = 0, d = 0;
    std::uint32_t exp = 0;
    bool is_long = false;   ///< d fills ray_dir_bits, on all three axes or on none
};
using PlanePair = std::pair<std::uint32_t, std::uint32_t>;

/// Returns all cases that fit the format. Exponents go to the largest that a node needs, and one more.
inline std::vector<AxisCase> all_axis_cases(const Config& c) {
    std::vector<AxisCase> all;
    const int n = 1 << (c.coord_bits - 1), from = 1 << (c.origin_width() - 1), m = 1 << (c.dir_bits - 1);
    for (int o = -from; o < from; ++o)
        for (int org = -n; org < n; ++org)
            for (int d = -m; d < m; ++d)
                for (int e = 0; e <= c.coord_bits - c.box_bits + 1; ++e)
                    all.push_back({o, org, d, std::uint32_t(e)});
    return all;
}
/// Returns all cases with directions of shadow rays, from lattice points.
inline std::vector<AxisCase> all_shadow_cases(const Config& c) {
    std::vector<AxisCase> all;
    const int n = 1 << (c.coord_bits - 1), m = 1 << (c.ray_dir_bits() - 1);
    for (int o = -n; o < n; ++o)
        for (int org = -n; org < n; ++org)
            for (int d = -m; d < m; ++d)
                for (int e = 0; e <= c.coord_bits - c.box_bits + 1; ++e)
                    all.push_back({o << c.origin_frac(), org, d, std::uint32_t(e), true});
    return all;
}
inline std::vector<PlanePair> all_planes(const Config& c) {
    std::vector<PlanePair> all;
    for (std::uint32_t lo = 0; lo < 1u << c.box_bits; ++lo)
        for (std::uint32_t hi = lo; hi < 1u << c.box_bits; ++hi) all.emplace_back(lo, hi);
    return all;
}

/// The cases of a test: the product of the three axes' cases and of their planes.
struct BoxSpace {
    std::array<std::vector<AxisCase>, 3> axes;
    std::array<std::vector<PlanePair>, 3> planes;
    std::size_t children() const { return planes[0].size() * planes[1].size() * planes[2].size(); }
};
/// The axes in `which` (bit k) take all values. On the others the ray is constant inside every box.
inline BoxSpace box_space(const Config& c, unsigned which) {
    BoxSpace space;
    for (std::size_t k = 0; k < 3; ++k) {
        const bool all = which >> k & 1;
        space.axes[k] = all ? all_axis_cases(c) : std::vector<AxisCase>{{}};
        space.planes[k] = all ? all_planes(c) : std::vector<PlanePair>{{0, 1}};
    }
    return space;
}

/// Makes the requests of a space one by one, each with up to eight children, all inner nodes.
class BoxRequests {
public:
    BoxRequests(BoxSpace space, const Config& config) : space_(std::move(space)), config_(config) {
        BoxCase c;
        const int m = 1 << (config.ray_dir_bits() - 1);
        for (const bool is_long : {false, true})
            for (int d = -m; d < m; ++d) {
                c.is_long = is_long;
                set_direction(c, {d, 0, 0}, config);
                recip_[is_long].push_back({c.req.recip[0], c.req.len[0]});
            }
    }
    std::uint64_t size() const {
        std::uint64_t n = (space_.children() + max_width - 1) / max_width;
        for (const auto& axis : space_.axes) n *= axis.size();
        return n;
    }
    std::uint64_t boxes() const {
        return space_.axes[0].size() * space_.axes[1].size() * space_.axes[2].size() * space_.children();
    }

    BoxCase next() {
        BoxCase c;
        for (std::size_t k = 0; k < 3; ++k) {
            const AxisCase& a = space_.axes[k][at_[k]];
            c.req.o[k] = a.o;
            c.d[k] = a.d;
            c.is_long |= a.is_long;
            c.req.neg[k] = a.d < 0;
            std::tie(c.req.recip[k], c.req.len[k]) =
                recip_[a.is_long][std::size_t(a.d + (1 << (config_.ray_dir_bits() - 1)))];
            c.req.node.org[k] = a.org;
            c.req.node.exp[k] = a.exp;
        }
        for (std::size_t i = 0; i < max_width && child_ < space_.children(); ++i, ++child_) {
            c.req.node.kind[i] = 1;
            std::size_t rest = child_;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [lo, hi] = space_.planes[k][rest % space_.planes[k].size()];
                c.req.node.lo[3 * i + k] = lo;
                c.req.node.hi[3 * i + k] = hi;
                rest /= space_.planes[k].size();
            }
        }
        if (child_ == space_.children()) step();
        return c;
    }

private:
    void step() {
        child_ = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (++at_[k] < space_.axes[k].size()) return;
            at_[k] = 0;
        }
    }

    BoxSpace space_;
    Config config_;
    // Of short and of long directions.
    std::array<std::vector<std::pair<std::uint32_t, std::uint32_t>>, 2> recip_;
    std::array<std::size_t, 3> at_{};
    std::size_t child_ = 0;
};

/// The counts of a test. A box is lost if the ray meets it and the answer lacks it. It is late if t_near is
/// beyond the entry.
struct BoxVerdict {
    std::uint64_t boxes = 0, met = 0, taken = 0, lost = 0, late = 0;
};
inline void judge_small(const BoxCase& c, const NodeAnswer& rsp, const Config& config, BoxVerdict& verdict) {
    const std::int64_t parts = std::int64_t(1) << config.origin_frac();   // all lengths are in steps of 2^-B
    const int bits = c.is_long ? config.ray_dir_bits() : config.dir_bits;
    std::array<std::int64_t, max_width> said;
    said.fill(-1);
    for (std::size_t i = 0; i < rsp.inner; ++i) said[rsp.offset[i] / 2] = rsp.t_near[i];
    verdict.taken += rsp.inner;
    for (std::size_t i = 0; i < max_width && c.req.node.kind[i] != 0; ++i) {
        oracle::LatticeVec o, d, lo, hi;
        for (std::size_t k = 0; k < 3; ++k) {
            o[k] = c.req.o[k];
            d[k] = c.d[k];
            lo[k] =
                (c.req.node.org[k] + (std::int64_t(c.req.node.lo[3 * i + k]) << c.req.node.exp[k])) * parts;
            hi[k] =
                (c.req.node.org[k] + (std::int64_t(c.req.node.hi[3 * i + k]) << c.req.node.exp[k])) * parts;
        }
        ++verdict.boxes;
        const auto enter = oracle::overlap(o, d, lo, hi);
        if (!enter) continue;
        ++verdict.met;
        verdict.lost += said[i] < 0;
        verdict.late += said[i] * enter->den * parts > enter->num << (bits - 1 + config.t_frac_bits);
    }
}

// ---- Triangles.

/// Returns the `number`-th vector of n-bit components.
inline Vec3i vector_of(std::uint64_t number, int n) {
    const auto part = [&](int k) {
        return std::int32_t(number >> (n * k) & ((1u << n) - 1)) - (1 << (n - 1));
    };
    return {part(0), part(1), part(2)};
}
/// Returns the `number`-th of all requests: b, c, o, d, and a last.
inline TriReq tri_request(std::uint64_t number, const Config& config) {
    const int n = config.coord_bits;
    const auto take = [&](int bits) {
        const Vec3i v = vector_of(number, bits);
        number >>= 3 * bits;
        return v;
    };
    TriReq req;
    req.triangle.prim = 5;
    req.triangle.b = take(n);
    req.triangle.c = take(n);
    req.o = take(n);
    req.d = take(config.dir_bits);
    req.triangle.a = take(n);
    return req;
}
inline std::uint64_t tri_requests(const Config& config) {
    return std::uint64_t(1) << (3 * (4 * config.coord_bits + config.dir_bits));
}

}   // namespace rayclock::test
