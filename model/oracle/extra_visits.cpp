#include "model/oracle/extra_visits.hpp"

#include <algorithm>
#include <mutex>
#include <unordered_map>

#include <tbb/parallel_for.h>

#include "model/accel/tree.hpp"
#include "model/base/axes.hpp"
#include "model/isect/tri.hpp"
#include "model/raygen/raygen.hpp"

namespace rayclock {

namespace {

using oracle::Fraction;
using oracle::LatticeVec;

LatticeVec wide(const Vec3i& v) { return {v[0], v[1], v[2]}; }

/// Boxes of the children of every node, by the node's line.
using Boxes = std::unordered_map<std::uint32_t, std::array<LatticeBox, max_width>>;

/// The real ones: of the triangles below.
LatticeBox real_boxes(const Decoder& decoder, std::uint32_t line, Boxes& boxes) {
    const WideNode& node = decoder.node(line);
    LatticeBox all;
    std::array<LatticeBox, max_width> mine{};
    for (std::size_t i = 0; i < node.children; ++i) {
        if (node.inner_mask >> i & 1) mine[i] = real_boxes(decoder, node.base + std::uint32_t(i), boxes);
        for (std::uint32_t n = 0; n < node.count[i]; ++n) {
            const PrimData& t = decoder.prim(2 * node.base + node.offset[i] + n);
            for (const Vec3i& point : {t.a, t.b, t.c}) mine[i].add(point);
        }
        all.add(mine[i]);
    }
    boxes.emplace(line, mine);
    return all;
}

/// A child that the box test took, and where the ray enters it.
template <class Time> struct Taken {
    Time near;
    std::uint32_t child = 0;
};

/// The machine's own decisions: t_near and t in its units.
struct ByMachine {
    using Time = std::uint32_t;
    const Config& config;
    const Ray& ray;
    ExtraVisits& count;

    static bool less(Time a, Time b) { return a < b; }
    Time beyond() const { return (1u << config.t_bits()) - 1; }
    static Time time(const TriRsp& hit) { return hit.t; }

    void children(const WideNode& node, std::uint32_t, std::vector<Taken<Time>>& out) {
        BoxRsp rsp;
        box_children({ray.o, {ray.d[0] < 0, ray.d[1] < 0, ray.d[2] < 0}, ray.recip, ray.len}, node, config,
                     rsp);
        std::uint32_t mask = 0;
        for (std::uint32_t i = 0; i < rsp.inner + rsp.leaves; ++i) {
            std::uint32_t child = 0;
            while (node.offset[child] != rsp.offset[i]) ++child;
            out.push_back({rsp.t_near[i], child});
            mask |= 1u << child;
        }
        judge(node, out, mask);
    }

    /// Against exact arithmetic, child by child. With unit = 2^(M-1+F) a t_near is late if t_near / unit >
    /// enter.
    void judge(const WideNode& node, const std::vector<Taken<Time>>& taken, std::uint32_t mask) {
        count.boxes += node.children;
        const auto entry = [&](std::uint32_t child) {
            const auto [lo, hi] = quantised(node, child);
            return oracle::overlap(wide(ray.o), wide(ray.d), lo, hi);
        };
        for (const Taken<Time>& t : taken) {
            const auto enter = entry(t.child);
            count.boxes_extra += !enter;
            const Fraction said{std::int64_t(t.near), std::int64_t(1)
                                                          << (config.dir_bits - 1 + config.t_frac_bits)};
            count.t_late += enter && oracle::less(*enter, said);
        }
        for (std::uint32_t i = 0; i < node.children; ++i)
            count.boxes_lost += (mask >> i & 1) == 0 && entry(i).has_value();
    }
};

/// Exact entries and exact hits; `real`: the boxes to test, or null for those of the node.
struct ByOracle {
    using Time = Fraction;
    const Ray& ray;
    const Boxes* real;

    static bool less(const Time& a, const Time& b) { return oracle::less(a, b); }
    static Time beyond() { return {std::int64_t(1) << 62, 1}; }
    static Time time(const TriRsp& hit) { return {std::int64_t(hit.num), std::int64_t(hit.det)}; }

    void children(const WideNode& node, std::uint32_t line, std::vector<Taken<Time>>& out) const {
        const std::array<LatticeBox, max_width>* boxes = real ? &real->at(line) : nullptr;
        for (std::uint32_t i = 0; i < node.children; ++i) {
            const auto [lo, hi] =
                boxes ? std::pair{wide((*boxes)[i].lo), wide((*boxes)[i].hi)} : quantised(node, i);
            if (const auto enter = oracle::overlap(wide(ray.o), wide(ray.d), lo, hi))
                out.push_back({*enter, i});
        }
    }
};

/// One ray's walk by one rule.
template <class Rule> class Walker {
public:
    using Time = typename Rule::Time;
    Walker(const Decoder& decoder, const Config& config, const Ray& ray, Rule rule, WalkWork& work)
        : decoder_(decoder), config_(config), ray_(ray), rule_(rule), work_(work), t_best_(rule.beyond()) {}

    Best run(std::uint32_t root) {
        stack_.push_back({Time{}, root});
        while (!stack_.empty()) {
            const auto [near, line] = stack_.back();
            stack_.pop_back();
            if (!Rule::less(t_best_, near)) visit(line);
        }
        return best_;
    }

private:
    void visit(std::uint32_t line) {
        const WideNode& node = decoder_.node(line);
        taken_.clear();
        rule_.children(node, line, taken_);
        ++work_.visits;
        work_.taken += taken_.size();
        std::sort(taken_.begin(), taken_.end(), [](const Taken<Time>& a, const Taken<Time>& b) {
            return Rule::less(a.near, b.near) || (!Rule::less(b.near, a.near) && a.child < b.child);
        });
        for (const auto& [near, child] : taken_) {
            if (Rule::less(t_best_, near)) break;
            for (std::uint32_t n = 0; n < node.count[child]; ++n)
                test(2 * node.base + node.offset[child] + n);
        }
        for (std::size_t i = taken_.size(); i-- > 0;)
            if (node.inner_mask >> taken_[i].child & 1)
                stack_.push_back({taken_[i].near, node.base + taken_[i].child});
    }

    void test(std::uint32_t half_line) {
        ++work_.triangles;
        TriRsp rsp;
        tri_test(ray_.o, ray_.d, decoder_.prim(half_line), best_, config_, rsp);
        if (!rsp.closer) return;
        best_ = {1, rsp.num, rsp.det, rsp.prim};
        t_best_ = Rule::time(rsp);
    }

    const Decoder& decoder_;
    const Config& config_;
    const Ray& ray_;
    Rule rule_;
    WalkWork& work_;
    std::vector<std::pair<Time, std::uint32_t>> stack_;
    std::vector<Taken<Time>> taken_;   // of the node that is visited
    Best best_;
    Time t_best_;
};

bool same(const Best& a, const Best& b) { return a.found == b.found && (!a.found || a.prim == b.prim); }

void add(WalkWork& sum, const WalkWork& part) {
    sum.visits += part.visits;
    sum.triangles += part.triangles;
    sum.taken += part.taken;
}

}   // namespace

std::pair<LatticeVec, LatticeVec> quantised(const WideNode& node, std::size_t child) {
    const auto corner = [&](std::size_t first) {
        return by_axis([&](std::size_t k) {
            return node.org[k] + (std::int64_t(node.planes[(first + k) * max_width + child]) << node.exp[k]);
        });
    };
    return {corner(0), corner(3)};
}

ExtraVisits extra_visits(const MemoryImage& image, const Frame& frame, const Config& config, int every) {
    const Decoder decoder(image, config);
    Boxes real;
    real_boxes(decoder, frame.root, real);
    const std::uint64_t pixels = std::uint64_t(frame.width) * frame.height, step = std::uint64_t(every);
    ExtraVisits sum;
    std::mutex lock;
    tbb::parallel_for(
        tbb::blocked_range<std::uint64_t>(0, (pixels + step - 1) / step, 1024), [&](const auto& range) {
            ExtraVisits part;
            for (std::uint64_t i = range.begin(); i < range.end(); ++i) {
                const std::uint64_t pixel = i * step;
                const Ray ray =
                    raygen({0, std::uint32_t(pixel % frame.width), std::uint32_t(pixel / frame.width)}, frame,
                           config);
                const Best first = Walker<ByMachine>(decoder, config, ray, {config, ray, part}, part.machine)
                                       .run(frame.root);
                const Best second =
                    Walker<ByOracle>(decoder, config, ray, {ray, nullptr}, part.exact).run(frame.root);
                const Best third =
                    Walker<ByOracle>(decoder, config, ray, {ray, &real}, part.real).run(frame.root);
                part.other_hits += !same(first, second) || !same(first, third);
                ++part.rays;
            }
            const std::scoped_lock hold(lock);
            sum.rays += part.rays;
            sum.boxes += part.boxes;
            sum.boxes_extra += part.boxes_extra;
            sum.boxes_lost += part.boxes_lost;
            sum.t_late += part.t_late;
            sum.other_hits += part.other_hits;
            add(sum.machine, part.machine);
            add(sum.exact, part.exact);
            add(sum.real, part.real);
        });
    return sum;
}

}   // namespace rayclock
