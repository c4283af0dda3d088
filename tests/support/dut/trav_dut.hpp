#pragma once
// trav's model and RTL, with the same links.
#include "model/engine/bvh/box.hpp"
#include "model/unit/trav/trav.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// The links of trav's model and RTL. `start` is only observed, and `leaves` are always accepted. A node's
/// answer goes to the node unit in the same cycle. That unit's answer, if it has leaves to test, goes to
/// list.
struct TravLinks {
    std::optional<Start> start;
    Wire<Ray> ray;
    Wire<NodeRsp> node_rsp;
    Wire<NodeAnswer> node_unit_rsp;
    Wire<Tested> tested;
    Wire<NodeReq> node_req;
    Wire<BoxReq> node_unit_req;
    std::optional<Leaves> leaves;
    Wire<Done> done;
    std::uint32_t cause = 0;
};

/// Trav decides when; a Stack for each context decides where.
class TravModel : public TravLinks {
public:
    TravModel(const Frame& frame, const Config& config, int = 1)
        : config_(config),
          root_(frame.root),
          trav_(config),
          contexts_(std::size_t(config.contexts), Context{{}, {}, {}, Stack(config), 0, 0}),
          node_answer_delay_(Stages(config).node_answer_delay) {}
    void eval() {
        const bool offered = tested.offer.has_value();
        ray.ready = trav_.ray_ready();
        tested.ready = trav_.tested_ready(offered);
        cause = trav_.step_valid(offered) ? (trav_.step_ready() ? 0 : 2) : trav_.step_ready();
        node_req.offer.reset();
        if (trav_.node_valid()) {
            const std::uint32_t number = trav_.node_ray();
            node_req.offer = NodeReq{number, trav_.spawning() ? root_ : contexts_[number].addr};
        }
        done.offer.reset();
        if (trav_.done_valid()) done.offer = Done{trav_.done_ray()};
        node_rsp.ready = node_unit_req.ready;
        node_unit_req.offer.reset();
        if (node_rsp.offer) {
            const Ray& r = contexts_[node_rsp.offer->ray].ray;
            const BoxRay from = box_ray(r);
            node_unit_req.offer =
                BoxReq{r.ray, from.o, from.neg, from.recip, from.len, node_rsp.offer->of<bvh::Engine>().node};
        }
        node_unit_rsp.ready = true;
        leaves.reset();
        const std::optional<NodeAnswer>& answered = node_answer_delay_.out(node_unit_rsp.offer);
        if (answered && answered->leaves > 0 &&
            answered->t_near[answered->inner] <= contexts_[answered->ray].t_best)
            leaves = leaves_of(*answered);
    }
    void commit() {
        const std::optional<NodeAnswer> answered = node_answer_delay_.out(node_unit_rsp.offer);
        const LinkRay leafless = leaves ? LinkRay{} : ray_of(answered);
        trav_.clock({ray_of(ray), leafless, ray_of(tested.offer), node_req.fires(), done.fires()},
                    [&](std::uint32_t number, bool valid) {
                        if (!valid) return Decision::Flags{};
                        Context& c = contexts_[number];
                        const Decision decision = c.stack.decide(c.tested, c.children);
                        c.addr = decision.addr;
                        c.children = {};   // another decision has no new children
                        return decision.flags();
                    });
        if (answered) {
            Context& c = contexts_[answered->ray];
            c.children = children_of(*answered);
            c.tested = {answered->ray, 0, c.t_best};   // the default if no other answer comes
        }
        node_answer_delay_.clock(node_unit_rsp.offer);
        if (tested.fires()) {
            Context& c = contexts_[tested.offer->ray];
            c.tested = *tested.offer;
            c.t_best = tested.offer->t_best;
        }
        if (start) contexts_[start->ray].t_best = t_max_of(start->kind, config_);
        if (ray.fires()) {
            contexts_[ray.offer->ray].ray = *ray.offer;
            contexts_[ray.offer->ray].stack.clear();
        }
    }

private:
    struct Context {
        Ray ray;
        Children children;
        Tested tested;
        Stack stack;
        std::uint32_t addr;     // address of the next node
        std::uint32_t t_best;   // the distance to beat
    };
    Config config_;
    std::uint32_t root_;
    Trav trav_;
    std::vector<Context> contexts_;
    DelayedLink<NodeAnswer> node_answer_delay_;
};

class TravRtl : public TravLinks {
public:
    TravRtl(const Frame& frame, const Config& config, int seed = 1) : links_(config, "rc_trav", seed) {
        links_.fix("frame", frame);
        drive();
        links_.reset();
    }
    void eval() {
        links_.pass_edge([&] { links_.drive_next("node_next", node_rsp); });
        drive();
        links_.settle();
        links_.read_in("ray", ray);
        links_.read_in("tested", tested);
        links_.read_in("node_rsp", node_rsp);
        links_.read_in("node_unit_rsp", node_unit_rsp);
        links_.read_out("node_req", node_req);
        links_.read_out("node_unit_req", node_unit_req);
        links_.read_told("leaves", leaves);
        links_.read_out("done", done);
        cause = links_.plain("cause");
    }
    void commit() { links_.clock_later(); }

private:
    void drive() {
        links_.drive_listen("start", start);
        links_.drive_in("ray", ray);
        links_.drive_in("tested", tested);
        links_.drive_in("node_rsp", node_rsp);
        links_.drive_in("node_unit_rsp", node_unit_rsp);
        links_.drive_out("node_req", node_req);
        links_.drive_out("node_unit_req", node_unit_req);
        links_.drive_out("done", done);
    }
    RtlLinks links_;
};

}   // namespace rayclock::test
