#pragma once
#include "model/trav/trav.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// What both machines of trav show. A node's answer goes on to box in the same cycle.
struct TravLinks {
    Link<Ray> ray;
    Link<Step> step;
    Link<NodeRsp> node_rsp;
    Link<NodeReq> node_req;
    Link<BoxReq> box_req;
    Link<Done> done;
};

/// Trav says when, a Stack for each context where to.
class TravModel : public TravLinks {
public:
    TravModel(const Frame& frame, const Config& config, int = 1)
        : root_(frame.root),
          trav_(config),
          contexts_(std::size_t(config.contexts), Context{{}, {}, Stack(config), 0}) {}
    void eval() {
        ray.ready = trav_.ray_ready();
        step.ready = trav_.step_ready();
        node_req.offer.reset();
        if (trav_.node_valid()) {
            const std::uint32_t number = trav_.node_ray();
            node_req.offer = NodeReq{number, trav_.spawning() ? root_ : contexts_[number].addr};
        }
        done.offer.reset();
        if (trav_.done_valid()) done.offer = Done{trav_.done_ray()};
        node_rsp.ready = box_req.ready;
        box_req.offer.reset();
        if (!node_rsp.offer) return;
        const Ray& r = contexts_[node_rsp.offer->ray].ray;
        box_req.offer =
            BoxReq{r.ray, r.o, {r.d[0] < 0, r.d[1] < 0, r.d[2] < 0}, r.recip, r.len, node_rsp.offer->node};
    }
    void commit() {
        trav_.clock(ray.fires() ? &ray.offer->ray : nullptr, step.fires() ? &step.offer->ray : nullptr,
                    node_req.fires(), done.fires(), [&](std::uint32_t number) {
                        Context& c = contexts_[number];
                        const Turn turn = c.stack.decide(c.step);
                        c.addr = turn.addr;
                        c.step.inner = 0;   // in another turn there are no new children
                        return turn.kind;
                    });
        if (step.fires()) contexts_[step.offer->ray].step = *step.offer;
        if (ray.fires()) {
            contexts_[ray.offer->ray].ray = *ray.offer;
            contexts_[ray.offer->ray].stack.clear();
        }
    }

private:
    struct Context {
        Ray ray;
        Step step;
        Stack stack;
        std::uint32_t addr;   // of the next node
    };
    std::uint32_t root_;
    Trav trav_;
    std::vector<Context> contexts_;
};

class TravRtl : public TravLinks {
public:
    TravRtl(const Frame& frame, const Config& config, int seed = 1) : links_(config, "rc_trav", seed) {
        links_.fix("frame", frame);
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_in("ray", ray);
        links_.read_in("step", step);
        links_.read_in("node_rsp", node_rsp);
        links_.read_out("node_req", node_req);
        links_.read_out("box_req", box_req);
        links_.read_out("done", done);
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_in("ray", ray);
        links_.drive_in("step", step);
        links_.drive_in("node_rsp", node_rsp);
        links_.drive_out("node_req", node_req);
        links_.drive_out("box_req", box_req);
        links_.drive_out("done", done);
    }
    RtlLinks links_;
};

}   // namespace rayclock::test
