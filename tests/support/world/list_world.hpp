#pragma once
// The environment of list in a test: trav with leaves, memory and tri, and a plain description of the
// triangles that list requests for a node.
#include "tests/support/dut/list_dut.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

/// A plain model of one ray at list: leaves from near to far, each triangle of a leaf in turn, and no leaf
/// that begins beyond the best hit. A shadow ray ignores its first cut-outs and stops after the next hit.
struct LeafWalk {
    Ray ray;
    TriRsp found;   ///< best hit so far; closer is 0 without one
    Leaves node;
    std::size_t leaf = 0;   ///< index in the node's leaves
    std::uint32_t triangle = 0;
    std::uint32_t beyond = 0;
    std::uint32_t holes = 0;   ///< number of cut-outs that it still ignores

    bool is_shadow_ray() const { return ends_at_any(ray.kind); }
    bool blocked() const { return is_shadow_ray() && found.closer; }
    std::uint32_t t_best() const { return found.closer ? found.t : beyond; }
    bool more() const {
        return !blocked() && leaf < node.leaves && (triangle > 0 || node.t_near[leaf] <= t_best());
    }
    std::uint32_t address() const { return 2 * node.base + node.offset[leaf] + triangle; }
    void next() {
        if (++triangle < node.count[leaf]) return;
        triangle = 0;
        ++leaf;
    }
};

class ListWorld {
public:
    ListWorld(const Config& config, unsigned seed, const Pace& pace, int rays)
        : config_(config), flow_(pace), draw_(seed), left_(rays), contexts_(std::size_t(config.contexts)) {}

    bool finished() const { return left_ == 0 && running_ == 0; }
    int triangles() const { return triangles_; }
    int stopped() const { return stopped_; }
    int passed() const { return passed_; }
    int cutouts() const { return cutouts_; }

    void drive(ListLinks& dut) {
        dut.start.reset();
        dut.ray.reset();
        dut.leaves.reset();
        if (!waiting_for_leaves_.empty() && go()) make_leaves(dut);
        if (!prim_ && !fetched_.empty() && go()) answer_triangle();
        if (!tri_ && !tested_.empty() && go()) answer_test();
        if (!done_ && !ending_.empty() && go()) done_ = Done{pick(ending_)};
        if (left_ > 0 && go()) start_ray(dut);   // the first leaves come later
        if (!dut.ray && !waiting_for_leaves_.empty() && draw_.below(8) == 0) change_ray(dut);
        dut.prim_rsp.offer = prim_;
        dut.tri_rsp.offer = tri_;
        dut.done.offer = done_;
        dut.prim_req.ready = take();
        dut.tri_req.ready = take();
        dut.tested.ready = take();
        dut.closest.ready = take();
    }

    void watch(const ListLinks& dut) {
        // One cycle later, like rc_list's requests.
        fetched_.insert(fetched_.end(), requested_.begin(), requested_.end());
        requested_.clear();
        if (dut.prim_req.fires()) see_fetch(*dut.prim_req.offer);
        if (dut.tri_req.offer) check_test(*dut.tri_req.offer);
        if (dut.tri_req.fires()) {
            tested_.push_back(prim_->ray);
            prim_.reset();
        }
        if (dut.tested.fires()) see_tested(*dut.tested.offer);
        if (dut.closest.offer) check_closest(*dut.closest.offer);
        if (dut.closest.fires()) {
            contexts_[done_->ray].busy = false;
            --running_;
            done_.reset();
        }
        if (dut.leaves) {
            Context& c = contexts_[dut.leaves->ray];
            c.here = true;
            c.walk.node = *dut.leaves;
            c.walk.leaf = 0;
            c.walk.triangle = 0;
        }
        if (dut.tri_rsp.fires()) {
            contexts_[tri_->ray].out = false;
            LeafWalk& walk = contexts_[tri_->ray].walk;
            if (tri_->closer && tri_->cutout && walk.holes > 0)
                --walk.holes, ++passed_;
            else if (tri_->closer)
                walk.found = *tri_, cutouts_ += tri_->cutout;
            walk.next();
            tri_.reset();
        }
    }

private:
    struct Context {
        bool busy = false;
        bool here = false;   ///< the ray's node is at list
        bool out = false;    ///< one of its triangles is at memory or tri
        int nodes = 0;
        LeafWalk walk;
    };

    bool go() { return !draw_.percent(flow_.idle_percent); }
    bool take() { return !draw_.percent(flow_.stall_percent); }
    std::uint32_t pick(std::vector<std::uint32_t>& from) {
        const auto at = from.begin() + draw_.below(int(from.size()));
        const std::uint32_t ray = *at;
        from.erase(at);
        return ray;
    }

    void start_ray(ListLinks& dut) {
        const std::size_t first = std::size_t(draw_.below(config_.contexts));
        for (std::size_t i = 0; i < contexts_.size(); ++i) {
            const std::size_t number = (first + i) % contexts_.size();
            Context& c = contexts_[number];
            if (c.busy) continue;
            c = {};
            c.busy = true;
            c.nodes = draw_.between(1, 8);
            c.walk.ray = random_payload<Ray>(draw_, config_);
            c.walk.ray.ray = std::uint32_t(number);
            // To the surface: t = 2^-B, in units of 2^-F of a direction of N + B bits.
            c.walk.beyond = c.walk.ray.kind == RayKind::shadow
                                ? 1u << (config_.coord_bits + config_.t_frac_bits)
                                : (1u << config_.t_bits()) - 1;
            c.walk.ray.holes = draw_.coin() ? 0 : std::uint32_t(draw_.below(4));
            c.walk.holes = c.walk.ray.holes;
            dut.start = Start{c.walk.ray.ray, c.walk.ray.kind, c.walk.ray.holes};
            dut.ray = c.walk.ray;
            waiting_for_leaves_.push_back(std::uint32_t(number));
            --left_;
            ++running_;
            return;
        }
    }

    /// Changes the direction of the ray but keeps its hit.
    void change_ray(ListLinks& dut) {
        Ray& ray = contexts_[waiting_for_leaves_.front()].walk.ray;
        const Ray old = ray;
        ray = random_payload<Ray>(draw_, config_);
        ray.ray = old.ray;
        ray.kind = old.kind;
        ray.holes = old.holes;
        dut.ray = ray;
    }

    void make_leaves(ListLinks& dut) {
        Leaves leaves;
        leaves.ray = pick(waiting_for_leaves_);
        leaves.base = std::uint32_t(draw_.bits(max_addr_bits - 1));
        leaves.leaves = std::uint32_t(draw_.between(1, config_.node_width));
        const std::uint32_t best = contexts_[leaves.ray].walk.t_best();
        std::uint32_t t = 0;
        for (std::size_t i = 0; i < leaves.leaves; ++i) {
            t = draw_.below(4) == 0 ? std::max(t, best + std::uint32_t(draw_.below(4) == 0))
                                    : t + std::uint32_t(draw_.below(40));   // exactly as far counts
            t = std::min(t, i == 0 ? best : (1u << config_.t_bits()) - 1);
            leaves.t_near[i] = t;
            leaves.offset[i] = std::uint32_t(draw_.bits(offset_bits));
            leaves.count[i] = std::uint32_t(draw_.between(1, 6));
        }
        dut.leaves = leaves;
    }

    void answer_triangle() {
        PrimRsp rsp = random_payload<PrimRsp>(draw_, config_);
        rsp.ray = pick(fetched_);
        prim_ = rsp;
    }

    void answer_test() {
        const std::uint32_t ray = pick(tested_);
        TriRsp rsp;
        if (draw_.below(3) == 0) {
            const std::uint32_t best = std::min(contexts_[ray].walk.t_best(), 150u);
            const bool is_shadow = contexts_[ray].walk.is_shadow_ray(),
                       is_cutout = config_.has_textures() && is_shadow && draw_.coin();
            if (!is_shadow || is_cutout) {
                rsp = random_payload<TriRsp>(draw_, config_);
                rsp.t = std::uint32_t(draw_.below(int(best) + 1));
            }
            rsp.closer = 1;
            rsp.cutout = is_cutout;
        }
        rsp.ray = ray;
        tri_ = rsp;
    }

    void see_fetch(const PrimReq& req) {
        CAPTURE(req.ray);
        Context& c = contexts_[req.ray];
        const LeafWalk& walk = c.walk;
        REQUIRE((c.here && !c.out));
        REQUIRE(walk.more());
        REQUIRE(req.addr == walk.address());
        c.out = true;
        requested_.push_back(req.ray);
        ++triangles_;
    }

    void check_test(const TriReq& req) const {
        const LeafWalk& walk = contexts_[prim_->ray].walk;
        TriReq expected{
            walk.ray.ray,   walk.ray.o,    walk.ray.d,    prim_->triangle,    {},
            walk.ray.shear, walk.ray.kind, walk.ray.self, walk.ray.is_inside, walk.ray.is_partial};
        if (walk.found.closer) expected.best = {1, walk.found.num, walk.found.det, walk.found.prim};
        REQUIRE(same(req, expected, config_));
    }

    void see_tested(const Tested& tested) {
        CAPTURE(tested.ray);
        Context& c = contexts_[tested.ray];
        const LeafWalk& walk = c.walk;
        REQUIRE((c.here && !c.out));
        REQUIRE_FALSE(walk.more());
        REQUIRE(tested.stop == walk.blocked());
        stopped_ += walk.blocked();
        REQUIRE((walk.blocked() || tested.t_best == walk.t_best()));
        c.here = false;
        if (--c.nodes > 0 && !walk.blocked())
            waiting_for_leaves_.push_back(tested.ray);
        else
            ending_.push_back(tested.ray);
    }

    void check_closest(const Closest& closest) const {
        const TriRsp& f = contexts_[done_->ray].walk.found;
        Closest expected{done_->ray, 0, 0, 0, 0, 0};
        if (f.closer) expected = {done_->ray, 1, f.prim, f.t, f.u, f.v, f.back, 0, f.cutout};
        REQUIRE(same(closest, expected, config_));
    }

    Config config_;
    Pace flow_;
    Draw draw_;
    int left_, running_ = 0, triangles_ = 0, stopped_ = 0, passed_ = 0, cutouts_ = 0;
    std::vector<Context> contexts_;
    std::vector<std::uint32_t> waiting_for_leaves_, requested_, fetched_, tested_, ending_;
    std::optional<PrimRsp> prim_;
    std::optional<TriRsp> tri_;
    std::optional<Done> done_;
};

}   // namespace rayclock::test
