#pragma once
// The environment of trav in a test: rays with invented trees, and a plain description of the nodes that each
// ray must visit.
#include <map>

#include "tests/support/world/traffic.hpp"
#include "tests/support/dut/trav_dut.hpp"

namespace rayclock::test {

/// A plain model of one ray's walk. Children for later are on a stack, the nearest on top. The next node is
/// the topmost that is not beyond the best hit.
class Walk {
public:
    struct StackEntry {
        std::uint32_t near, addr;
        int level;   ///< number of groups that may lie below it
    };
    /// Returns the next place after a node, or nothing if the ray is done. `level` is the node's level.
    std::optional<StackEntry> next(const NodeAnswer& answer, const Tested& tested, int level) {
        if (tested.stop) return std::nullopt;
        for (std::size_t i = answer.inner; i-- > 0;)
            pile_.push_back({answer.t_near[i], answer.base + answer.offset[i] / 2, level + 1});
        while (!pile_.empty()) {
            const StackEntry top = pile_.back();
            pile_.pop_back();
            if (top.near <= tested.t_best) return top;
        }
        return std::nullopt;
    }

private:
    std::vector<StackEntry> pile_;
};

/// Rays in all contexts, each with one transfer in flight: start -> node -> answer -> tested -> node ... ->
/// done. `tested` comes only if the answer has leaves that matter. Answers are invented, with children in
/// order of t_near, and t_best never grows. Checks all leaves, every node and every end against Walk.
class TravWorld {
public:
    TravWorld(const Frame& frame, const Config& config, unsigned seed, const Pace& pace, int rays)
        : frame_(frame),
          config_(config),
          node_answer_delay_(Stages(config).node_answer_delay),
          flow_(pace),
          draw_(seed),
          left_(rays),
          contexts_(std::size_t(config.contexts)) {}

    bool finished() const { return ended_ == started_ && left_ == 0; }
    int nodes() const { return nodes_; }
    int stopped() const { return stopped_; }     ///< number of rays
    int listings() const { return listings_; }   ///< number of transfers of leaves to list

    /// Sets the inputs of one cycle, equal for every machine that receives them.
    void drive(TravLinks& dut) {
        dut.start.reset();
        if (!ray_ && left_ > 0 && go()) start_ray(dut);
        if (!answer_ && !testing_.empty() && go()) make_answer();
        if (!tested_ && !listed_.empty() && go()) make_tested();
        if (!node_rsp_ && !fetched_.empty() && go()) answer_node();
        dut.ray.offer = ray_;
        dut.node_unit_rsp.offer = answer_;
        dut.tested.offer = tested_;
        dut.node_rsp.offer = node_rsp_;
        dut.node_req.ready = take();
        dut.node_unit_req.ready = take();
        dut.done.ready = take();
    }

    /// Checks the transfers of the cycle.
    void watch(const TravLinks& dut) {
        if (dut.ray.fires()) {
            Context& c = contexts_[ray_->ray];
            c.awaited = Walk::StackEntry{0, frame_.root, 0};
            ray_.reset();
        }
        see_leaves(dut);
        if (dut.tested.fires()) {
            contexts_[tested_->ray].t_best = tested_->t_best;
            go_on(*tested_);
            tested_.reset();
        }
        if (dut.node_req.fires()) {
            const NodeReq& req = *dut.node_req.offer;
            CAPTURE(req.ray);
            Context& c = contexts_[req.ray];
            REQUIRE(c.awaited);
            REQUIRE(req.addr == c.awaited->addr);
            c.level = c.awaited->level;
            c.awaited.reset();
            fetched_.push_back(req.ray);
            ++nodes_;
        }
        if (dut.node_unit_req.offer) check_box(*dut.node_unit_req.offer);
        if (dut.node_unit_req.fires()) {
            testing_.push_back(node_rsp_->ray);
            node_rsp_.reset();
        }
        if (dut.done.fires()) {
            Context& c = contexts_[dut.done.offer->ray];
            REQUIRE(c.ending);
            c = {};
            ++ended_;
        }
    }

private:
    struct Context {
        bool busy = false, ending = false, reached_bottom = false;
        Ray ray;
        Walk walk;
        NodeAnswer answer;
        std::optional<Walk::StackEntry> awaited;
        int level = 0, nodes = 0, most_nodes = 0;
        std::uint32_t t_best = 0;
    };

    bool go() { return !draw_.percent(flow_.idle_percent); }
    bool take() { return !draw_.percent(flow_.stall_percent); }
    std::uint32_t pick(std::vector<std::uint32_t>& from) {   // memory and list answer in any order
        const auto at = from.begin() + draw_.below(int(from.size()));
        const std::uint32_t ray = *at;
        from.erase(at);
        return ray;
    }

    void start_ray(TravLinks& dut) {
        const std::size_t first = std::size_t(draw_.below(config_.contexts));
        for (std::size_t i = 0; i < contexts_.size(); ++i) {
            const std::size_t ray = (first + i) % contexts_.size();
            Context& c = contexts_[ray];
            if (c.busy) continue;
            c = {};
            c.busy = true;
            c.most_nodes = draw_.between(0, 30);
            c.ray = random_payload<Ray>(draw_, config_);
            c.ray.ray = std::uint32_t(ray);
            c.t_best = c.ray.kind == RayKind::shadow ? 1u << (config_.coord_bits + config_.t_frac_bits)
                                                     : (1u << config_.t_bits()) - 1;
            dut.start = Start{c.ray.ray, c.ray.kind};
            ray_ = c.ray;
            --left_;
            ++started_;
            return;
        }
    }

    void make_answer() {
        NodeAnswer answer;
        answer.ray = pick(testing_);
        Context& c = contexts_[answer.ray];
        answer.base = std::uint32_t(draw_.bits(max_addr_bits - 1));
        c.reached_bottom |= c.level == config_.stack_depth;
        // Goes straight down to the stack's last place.
        const bool deep = answer.ray % 3 == 0 && !c.reached_bottom;
        int most = c.level < config_.stack_depth ? config_.node_width : 1;
        if (++c.nodes > c.most_nodes && !deep) most = 0;
        answer.inner = std::uint32_t(deep && most > 1 ? 2 : draw_.between(0, most));
        answer.leaves = std::uint32_t(draw_.between(0, config_.node_width - int(answer.inner)));
        std::vector<std::uint32_t> inner, leaves;
        const std::uint32_t about = std::min(c.t_best, 1u << 20);
        for (std::uint32_t i = 0; i < answer.inner; ++i) inner.push_back(draw_near(about, deep));
        for (std::uint32_t i = 0; i < answer.leaves; ++i) {
            const std::uint32_t most_t = (1u << config_.t_bits()) - 1;
            leaves.push_back(draw_.coin() ? draw_near(about, false)
                                          : std::min(c.t_best + std::uint32_t(draw_.below(2)), most_t));
        }
        std::sort(inner.begin(), inner.end());
        std::sort(leaves.begin(), leaves.end());
        for (std::size_t i = 0; i < answer.inner + answer.leaves; ++i) {
            const bool is_leaf = i >= answer.inner;
            answer.t_near[i] = is_leaf ? leaves[i - answer.inner] : inner[i];
            answer.offset[i] = is_leaf ? std::uint32_t(draw_.bits(offset_bits))
                                       : 2 * std::uint32_t(draw_.below(config_.node_width));
            answer.count[i] = is_leaf ? std::uint32_t(draw_.between(1, 6)) : 0;
        }
        answer_ = answer;
    }

    /// Leaves go to list in the cycle in which the node unit answers (in a fast chip some cycles later) if
    /// the nearest can matter. Other leaves are never sent.
    void see_leaves(const TravLinks& dut) {
        std::optional<NodeAnswer> taken;
        if (answer_ && dut.node_unit_rsp.fires()) taken.swap(answer_);
        const std::optional<NodeAnswer> seen = node_answer_delay_.out(taken);
        node_answer_delay_.clock(taken);
        if (!seen) {
            REQUIRE_FALSE(dut.leaves);
            return;
        }
        CAPTURE(seen->ray);
        Context& c = contexts_[seen->ray];
        c.answer = *seen;
        const bool matters = c.answer.leaves > 0 && c.answer.t_near[c.answer.inner] <= c.t_best;
        REQUIRE(dut.leaves.has_value() == matters);
        if (!matters) return go_on({c.answer.ray, 0, c.t_best});
        Leaves expected{c.answer.ray, c.answer.base, c.answer.leaves, {}, {}, {}};
        for (std::size_t i = 0; i < c.answer.leaves; ++i) {
            expected.t_near[i] = c.answer.t_near[c.answer.inner + i];
            expected.offset[i] = c.answer.offset[c.answer.inner + i];
            expected.count[i] = c.answer.count[c.answer.inner + i];
        }
        REQUIRE(same(*dut.leaves, expected, config_));
        listed_.push_back(c.answer.ray);
        ++listings_;
    }

    void make_tested() {
        Tested tested;
        tested.ray = pick(listed_);
        tested.t_best = contexts_[tested.ray].t_best;
        if (draw_.below(3) == 0)
            tested.t_best = std::uint32_t(draw_.below(int(std::min(tested.t_best, 1u << 20)) + 1));
        tested.stop = config_.shading && draw_.below(8) == 0;
        stopped_ += int(tested.stop);
        tested_ = tested;
    }

    void go_on(const Tested& tested) {
        Context& c = contexts_[tested.ray];
        c.awaited = c.walk.next(c.answer, tested, c.level);
        c.ending = !c.awaited;
    }

    /// Draws half of the values around the best hit; on the way down always nearer ones.
    std::uint32_t draw_near(std::uint32_t about, bool deep) {
        if (deep) return std::uint32_t(draw_.below(int(about) + 1)) / 2;
        if (draw_.coin()) return std::uint32_t(draw_.below(1 << 20));
        return about + std::uint32_t(draw_.below(4)) - std::min(about, std::uint32_t(draw_.below(3)));
    }

    void answer_node() {
        NodeRsp rsp = random_payload<NodeRsp>(draw_, config_);
        rsp.ray = pick(fetched_);
        node_rsp_ = rsp;
    }

    /// Requires that the request consists of the ray's numbers and the node from memory.
    void check_box(const BoxReq& req) const {
        const Ray& ray = contexts_[node_rsp_->ray].ray;
        const BoxReq expected{ray.ray,   ray.o,   {ray.d[0] < 0, ray.d[1] < 0, ray.d[2] < 0},
                              ray.recip, ray.len, node_rsp_->of<bvh::Engine>().node};
        REQUIRE(same(req, expected, config_));
    }

    Frame frame_;
    Config config_;
    DelayedLink<NodeAnswer> node_answer_delay_;   // answers that trav has accepted and not yet processed
    Pace flow_;
    Draw draw_;
    int left_, started_ = 0, ended_ = 0, nodes_ = 0, stopped_ = 0, listings_ = 0;
    std::vector<Context> contexts_;
    // Rays whose node is in flight, rays at the node unit, and rays whose leaves are at list.
    std::vector<std::uint32_t> fetched_, testing_, listed_;
    std::optional<Ray> ray_;
    std::optional<NodeAnswer> answer_;
    std::optional<Tested> tested_;
    std::optional<NodeRsp> node_rsp_;
};

}   // namespace rayclock::test
