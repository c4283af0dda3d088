#pragma once
// What surrounds trav in a test: rays with invented trees, and a plain description of the nodes each ray must
// visit.
#include <map>

#include "tests/support/world/traffic.hpp"
#include "tests/support/dut/trav_dut.hpp"

namespace rayclock::test {

/// The walk of one ray, told simply: children left for later lie on a pile, nearest on top; the next node is
/// the topmost that is not beyond the best hit.
class Walk {
public:
    struct Place {
        std::uint32_t near, addr;
        int level;   ///< how many groups may lie under it
    };
    /// The next place after `step`, or nothing: the ray is done. `level` is that of the node that was just
    /// tested.
    std::optional<Place> next(const Step& step, int level) {
        if (step.stop) return std::nullopt;
        for (std::size_t i = step.inner; i-- > 0;)
            pile_.push_back({step.t_near[i], step.base + step.slot[i], level + 1});
        while (!pile_.empty()) {
            const Place top = pile_.back();
            pile_.pop_back();
            if (top.near <= step.t_best) return top;
        }
        return std::nullopt;
    }

private:
    std::vector<Place> pile_;
};

/// Rays in all contexts, each with one thing under way: spawn -> node -> step -> node ... -> done. Steps are
/// invented, siblings in order of t_near, t_best never growing. Checks every node and every end against Walk.
class TravWorld {
public:
    TravWorld(const Frame& frame, const Config& config, unsigned seed, const Flow& flow, int rays)
        : frame_(frame),
          config_(config),
          flow_(flow),
          draw_(seed),
          left_(rays),
          contexts_(std::size_t(config.contexts)) {}

    bool finished() const { return ended_ == started_ && left_ == 0; }
    int nodes() const { return nodes_; }
    int stopped() const { return stopped_; }   ///< rays

    /// Sets the inputs of one cycle; the same for every machine that gets them.
    void drive(TravLinks& dut) {
        if (!ray_ && left_ > 0 && go()) start_ray();
        if (!step_ && !tested_.empty() && go()) make_step();
        if (!node_rsp_ && !fetched_.empty() && go()) answer_node();
        dut.ray.offer = ray_;
        dut.step.offer = step_;
        dut.node_rsp.offer = node_rsp_;
        dut.node_req.ready = take();
        dut.box_req.ready = take();
        dut.done.ready = take();
    }

    /// Looks at what moved and checks it.
    void watch(const TravLinks& dut) {
        if (dut.ray.fires()) {
            Context& c = contexts_[ray_->ray];
            c.awaited = Walk::Place{0, frame_.root, 0};
            ray_.reset();
        }
        if (dut.step.fires()) {
            Context& c = contexts_[step_->ray];
            c.awaited = c.walk.next(*step_, c.level);
            c.ending = !c.awaited;
            step_.reset();
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
        if (dut.box_req.offer) check_box(*dut.box_req.offer);
        if (dut.box_req.fires()) {
            tested_.push_back(node_rsp_->ray);
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
        std::optional<Walk::Place> awaited;
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

    void start_ray() {
        const std::size_t first = std::size_t(draw_.below(config_.contexts));
        for (std::size_t i = 0; i < contexts_.size(); ++i) {
            const std::size_t ray = (first + i) % contexts_.size();
            Context& c = contexts_[ray];
            if (c.busy) continue;
            c = {};
            c.busy = true;
            c.t_best = (1u << config_.t_bits()) - 1;
            c.most_nodes = draw_.between(0, 30);
            c.ray = random_payload<Ray>(draw_, config_);
            c.ray.ray = std::uint32_t(ray);
            ray_ = c.ray;
            --left_;
            ++started_;
            return;
        }
    }

    void make_step() {
        Step step;
        step.ray = pick(tested_);
        Context& c = contexts_[step.ray];
        if (draw_.below(4) == 0) c.t_best = std::uint32_t(draw_.below(int(std::min(c.t_best, 1u << 20)) + 1));
        step.t_best = c.t_best;
        step.stop = config_.shading && draw_.below(12) == 0;   // whatever else the step says
        stopped_ += int(step.stop);
        step.base = std::uint32_t(draw_.bits(max_addr_bits - 1));
        c.reached_bottom |= c.level == config_.stack_depth;
        const bool deep = step.ray % 3 == 0 && !c.reached_bottom;   // straight down to the stack's last place
        int most = c.level < config_.stack_depth ? config_.node_width : 1;
        if (++c.nodes > c.most_nodes && !deep) most = 0;
        step.inner = std::uint32_t(deep && most > 1 ? 2 : draw_.between(0, most));
        std::vector<std::uint32_t> nears;
        const std::uint32_t about = std::min(c.t_best, 1u << 20);
        for (int i = 0; i < config_.node_width; ++i) nears.push_back(draw_near(about, deep));
        std::sort(nears.begin(), nears.begin() + step.inner);
        for (std::size_t i = 0; i < std::size_t(config_.node_width); ++i) {
            step.t_near[i] = nears[i];
            step.slot[i] = std::uint32_t(draw_.below(config_.node_width));
        }
        step_ = step;
    }

    /// Half of them around the best hit; on the way down, always nearer.
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

    /// The ray's own numbers and the node from memory, nothing else.
    void check_box(const BoxReq& req) const {
        const Ray& ray = contexts_[node_rsp_->ray].ray;
        const BoxReq expected{ray.ray,   ray.o,   {ray.d[0] < 0, ray.d[1] < 0, ray.d[2] < 0},
                              ray.recip, ray.len, node_rsp_->node};
        REQUIRE(same(req, expected, config_));
    }

    Frame frame_;
    Config config_;
    Flow flow_;
    Draw draw_;
    int left_, started_ = 0, ended_ = 0, nodes_ = 0, stopped_ = 0;
    std::vector<Context> contexts_;
    std::vector<std::uint32_t> fetched_, tested_;   // rays whose node is on its way, rays whose boxes are
    std::optional<Ray> ray_;
    std::optional<Step> step_;
    std::optional<NodeRsp> node_rsp_;
};

}   // namespace rayclock::test
