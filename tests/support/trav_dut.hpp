#pragma once
#include "model/trav/trav.hpp"
#include "tests/support/dut.hpp"

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

class TravModel : public TravLinks {
public:
    TravModel(const Frame& frame, const Config& config, int = 1) : trav_(frame, config) {}
    void eval() {
        ray.ready = trav_.ray_ready();
        step.ready = trav_.step_ready();
        node_req.offer.reset();
        if (trav_.node_valid()) node_req.offer = trav_.node();
        done.offer.reset();
        if (trav_.done_valid()) done.offer = Done{trav_.done()};
        node_rsp.ready = box_req.ready;
        box_req.offer.reset();
        if (!node_rsp.offer) return;
        const BoxRay& r = trav_.box_ray(node_rsp.offer->ray);
        box_req.offer = BoxReq{node_rsp.offer->ray, r.o, r.neg, r.recip, r.len, node_rsp.offer->node};
    }
    void commit() {
        trav_.clock(ray.fires() ? &*ray.offer : nullptr, step.fires() ? &*step.offer : nullptr, node_req.fires(), done.fires());
    }

private:
    Trav trav_;
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

} // namespace rayclock::test
