// The three traversals, which differ in their box test and in their type of distance.
#include "sim/judge/oracle/extra_visits.hpp"

#include <algorithm>
#include <bit>
#include <mutex>
#include <unordered_map>

#include <tbb/parallel_for.h>

#include "model/layout/tree.hpp"
#include "model/trace/decoder.hpp"
#include "model/trace/tree_walk.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

namespace {

using oracle::Fraction;
using oracle::LatticeVec;

/// The boxes of the children of every node, by the node's line.
using Boxes = std::unordered_map<std::uint32_t, std::array<LatticeBox, max_width>>;

/// Computes the boxes before quantisation: the bounds of the triangles below.
LatticeBox real_boxes(const Decoder& decoder, std::uint32_t line, Boxes& boxes) {
    const WideNode& node = decoder.node<bvh::Engine>(line);
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

/// The common part of the traversals: camera rays and the exact triangle test. Derived classes define the
/// type of distance.
struct CameraPolicy {
    const Decoder& decoder;
    const Config& config;
    const Ray& ray;
    Best best{};

    /// Tests a primitive. Returns true if it is the closest hit so far.
    bool meets(std::uint32_t half_line, TriRsp& rsp) {
        tri_test(ray.o, ray.d, decoder.prim(half_line), best, config, rsp);
        if (rsp.closer) best = {1, rsp.num, rsp.det, rsp.prim};
        return rsp.closer != 0;
    }
    static bool stop() { return false; }
};

/// The machine's own decisions: t_near and t in its units. Judges and counts its answers about boxes.
struct ByMachine : CameraPolicy {
    using Order = ByDistance;
    ExtraVisits* count;
    std::uint32_t t_best_ = beyond(config);

    static std::uint32_t beyond(const Config& config) { return (1u << config.t_bits()) - 1; }
    std::uint32_t t_best() const { return t_best_; }
    void test(std::uint32_t half_line) {
        TriRsp rsp;
        if (meets(half_line, rsp)) t_best_ = rsp.t;
    }
    const WideNode& boxes(std::uint32_t line, std::uint32_t* t_near, std::uint32_t& hits) const {
        const WideNode& node = decoder.node<bvh::Engine>(line);
        hits = box_children(box_ray(ray), node, config, t_near);
        count->boxes += node.children;
        for (std::uint32_t i = 0; i < node.children; ++i) judge(node, i, (hits >> i & 1) != 0, t_near[i]);
        return node;
    }
    /// Compares with exact arithmetic. With unit = 2^(M-1+F), a t_near is late if t_near / unit > enter.
    void judge(const WideNode& node, std::uint32_t child, bool taken, std::uint32_t t_near) const {
        const auto [lo, hi] = quantised_box(node, child);
        const auto enter = oracle::overlap(oracle::wide(ray.o), oracle::wide(ray.d), lo, hi);
        const Fraction said{std::int64_t(t_near), std::int64_t(1)
                                                      << (config.dir_bits - 1 + config.t_frac_bits)};
        count->boxes_extra += taken && !enter;
        count->boxes_lost += !taken && enter;
        count->t_late += taken && enter && oracle::less(*enter, said);
    }
};

/// Distances as fractions.
struct Exactly {
    struct Time : Fraction {
        friend bool operator<(const Time& a, const Time& b) { return oracle::less(a, b); }
    };
    struct Key {
        Time time;
        std::uint32_t place = 0;
    };
    static const Time& near(const Key& key) { return key.time; }
    static std::uint32_t child(const Key& key) { return key.place; }
    static std::uint32_t sort(std::uint32_t set, const Time* near, Key* sorted) {
        Key* end = sorted;
        for (std::uint32_t i = 0; i < max_width; ++i)
            if (set >> i & 1) *end++ = {near[i], i};
        std::sort(sorted, end, [](const Key& a, const Key& b) {
            return a.time < b.time || (!(b.time < a.time) && a.place < b.place);
        });
        return std::uint32_t(end - sorted);
    }
    static Time beyond() { return {{std::int64_t(1) << 62, 1}}; }
};

/// Exact entries and exact hits. `real` holds the boxes to test; null means those of the node.
struct ByOracle : CameraPolicy {
    using Order = Exactly;
    const Boxes* real;
    Exactly::Time t_best_ = Exactly::beyond();

    const Exactly::Time& t_best() const { return t_best_; }
    void test(std::uint32_t half_line) {
        TriRsp rsp;
        if (meets(half_line, rsp)) t_best_ = {{std::int64_t(rsp.num), std::int64_t(rsp.det)}};
    }
    const WideNode& boxes(std::uint32_t line, Exactly::Time* t_near, std::uint32_t& hits) const {
        const WideNode& node = decoder.node<bvh::Engine>(line);
        const std::array<LatticeBox, max_width>* boxes = real ? &real->at(line) : nullptr;
        hits = 0;
        for (std::uint32_t i = 0; i < node.children; ++i) {
            const auto [lo, hi] = boxes
                                      ? std::pair{oracle::wide((*boxes)[i].lo), oracle::wide((*boxes)[i].hi)}
                                      : quantised_box(node, i);
            if (const auto enter = oracle::overlap(oracle::wide(ray.o), oracle::wide(ray.d), lo, hi)) {
                t_near[i] = {*enter};
                hits |= 1u << i;
            }
        }
        return node;
    }
};

struct Counter {
    WalkWork& work;
    void visit(const auto& walk) {
        ++work.visits;
        work.taken += std::uint64_t(std::popcount(walk.hits()));
    }
    void test(std::uint32_t) { ++work.triangles; }
    static void decided(std::uint32_t, bool) {}
};

/// Traces a ray and returns its closest hit.
template <class Policy>
Best walked(Policy&& policy, GroupStack<typename Policy::Order>& stack, std::uint32_t root, WalkWork& work) {
    WalkRoom<typename Policy::Order> room;
    TreeWalk(policy, stack, room).run(root, Counter{work});
    return policy.best;
}

bool same(const Best& a, const Best& b) { return a.found == b.found && (!a.found || a.prim == b.prim); }

void add(WalkWork& sum, const WalkWork& part) {
    sum.visits += part.visits;
    sum.triangles += part.triangles;
    sum.taken += part.taken;
}

}   // namespace

std::pair<LatticeVec, LatticeVec> quantised_box(const WideNode& node, std::size_t child) {
    LatticeVec lo, hi;
    for (std::size_t k = 0; k < 3; ++k) {
        lo[k] = node.org[k] + (std::int64_t(node.planes[k * max_width + child]) << node.exp[k]);
        hi[k] = node.org[k] + (std::int64_t(node.planes[(3 + k) * max_width + child]) << node.exp[k]);
    }
    return {lo, hi};
}

ExtraVisits extra_visits(const MemoryImage& image, const Frame& frame, const Config& config, int every) {
    const Decoder decoder(image, config);
    const std::uint32_t root = frame.root;
    Boxes real;
    real_boxes(decoder, root, real);
    const std::uint64_t pixels = std::uint64_t(frame.width) * frame.height, step = std::uint64_t(every);
    ExtraVisits sum;
    std::mutex lock;
    tbb::parallel_for(
        tbb::blocked_range<std::uint64_t>(0, (pixels + step - 1) / step, 1024), [&](const auto& range) {
            ExtraVisits part;
            Stack stack(config);
            GroupStack<Exactly> exact_stack(config.stack_depth, Exactly::beyond());
            for (std::uint64_t i = range.begin(); i < range.end(); ++i) {
                const std::uint64_t pixel = i * step;
                const Ray ray =
                    raygen({0, std::uint32_t(pixel % frame.width), std::uint32_t(pixel / frame.width)}, frame,
                           config);
                const CameraPolicy camera{decoder, config, ray};
                const Best first = walked(ByMachine{camera, &part}, stack, root, part.machine);
                const Best second = walked(ByOracle{camera, nullptr}, exact_stack, root, part.exact);
                const Best third = walked(ByOracle{camera, &real}, exact_stack, root, part.real);
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
