#pragma once
// trav's model and RTL, with the same links.
#include "model/engine/bvh/box.hpp"
#include "model/unit/trav/trav.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// The links of trav's model and RTL. `start` is only observed, and `leaves` are always accepted. A node's
/// answer goes to box in the same cycle. Box's answer, if it has leaves to test, goes to list.
struct TravLinks {
    std::optional<Start> start;
    Wire<Ray> ray;
    Wire<NodeRsp> node_rsp;
    Wire<NodeAnswer> box_rsp;
    Wire<Tested> tested;
    Wire<NodeReq> node_req;
    Wire<BoxReq> box_req;
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
        node_rsp.ready = box_req.ready;
        box_req.offer.reset();
        if (node_rsp.offer) {
            const Ray& r = contexts_[node_rsp.offer->ray].ray;
            const BoxRay from = box_ray(r);
            box_req.offer =
                BoxReq{r.ray, from.o, from.neg, from.recip, from.len, node_rsp.offer->of<bvh::Engine>().node};
        }
        box_rsp.ready = true;
        leaves.reset();
        const std::optional<NodeAnswer>& boxed = node_answer_delay_.out(box_rsp.offer);
        if (boxed && boxed->leaves > 0 && boxed->t_near[boxed->inner] <= contexts_[boxed->ray].reach)
            leaves = leaves_of(*boxed);
    }
    void commit() {
        const std::optional<NodeAnswer> boxed = node_answer_delay_.out(box_rsp.offer);
        const LinkRay leafless = leaves ? LinkRay{} : ray_of(boxed);
        trav_.clock({ray_of(ray), leafless, ray_of(tested.offer), node_req.fires(), done.fires()},
                    [&](std::uint32_t number, bool valid) {
                        if (!valid) return Decision::Flags{};
                        Context& c = contexts_[number];
                        const Decision decision = c.stack.decide(c.tested, c.children);
                        c.addr = decision.addr;
                        c.children = {};   // another decision has no new children
                        return decision.flags();
                    });
        if (boxed) {
            Context& c = contexts_[boxed->ray];
            c.children = children_of(*boxed);
            c.tested = {boxed->ray, 0, c.reach};   // the default if no other answer comes
        }
        node_answer_delay_.clock(box_rsp.offer);
        if (tested.fires()) {
            Context& c = contexts_[tested.offer->ray];
            c.tested = *tested.offer;
            c.reach = tested.offer->t_best;
        }
        if (start) contexts_[start->ray].reach = reach_of(start->kind, config_);
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
        std::uint32_t addr;    // address of the next node
        std::uint32_t reach;   // the distance to beat
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
        links_.read_in("decide_rsp", box_rsp);
        links_.read_out("node_req", node_req);
        links_.read_out("decide_req", box_req);
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
        links_.drive_in("decide_rsp", box_rsp);
        links_.drive_out("node_req", node_req);
        links_.drive_out("decide_req", box_req);
        links_.drive_out("done", done);
    }
    RtlLinks links_;
};

}   // namespace rayclock::test
