#pragma once
// list's model and RTL, with the same links.
#include "model/core/stages.hpp"
#include "model/unit/list/list.hpp"
#include "model/unit/list/ray_tests.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// The links of list's model and RTL. `start`, `ray` and `leaves` are only observed. A triangle from memory
/// goes to tri in the same cycle, and a finished ray to its hit.
struct ListLinks {
    std::optional<Start> start;
    std::optional<Ray> ray;
    std::optional<Leaves> leaves;
    Wire<PrimRsp> prim_rsp;
    Wire<TriRsp> tri_rsp;
    Wire<Done> done;
    Wire<PrimReq> prim_req;
    Wire<TriReq> tri_req;
    Wire<Tested> tested;
    Wire<Closest> closest;
};

/// List decides when, the RayTests of each context what.
class ListModel : public ListLinks {
public:
    explicit ListModel(const Config& config, int = 1)
        : list_(config),
          rays_(std::size_t(config.contexts)),
          tests_(rays_.size(), RayTests(config)),
          tri_answer_delay_(Stages(config).tri_answer_delay) {}
    void eval() {
        tri_rsp.ready = true;
        prim_req.offer.reset();
        if (list_.prim_valid()) prim_req.offer = PrimReq{list_.prim_ray(), tests_[list_.prim_ray()].prim()};
        tested.offer.reset();
        if (list_.tested_valid()) tested.offer = tests_[list_.tested_ray()].tested();
        prim_rsp.ready = tri_req.ready;
        tri_req.offer.reset();
        if (prim_rsp.offer) {
            const Ray& r = rays_[prim_rsp.offer->ray];
            tri_req.offer = TriReq{r.ray,
                                   r.o,
                                   r.d,
                                   prim_rsp.offer->triangle,
                                   tests_[r.ray].best(),
                                   r.shear,
                                   r.kind,
                                   r.self,
                                   r.is_inside,
                                   r.is_partial};
        }
        done.ready = closest.ready;
        closest.offer.reset();
        if (done.offer) closest.offer = tests_[done.offer->ray].closest();
    }
    void commit() {
        const std::optional<TriRsp> tried = tri_answer_delay_.out(tri_rsp.offer);
        const LinkRay answered = ray_of(tried);
        const bool another = tried && tests_[tried->ray].advance(*tried);
        list_.clock_prims(ray_of(leaves), {answered.valid && another, answered.ray}, prim_req.fires());
        list_.clock_tested({answered.valid && !another, answered.ray}, tested.fires());
        tri_answer_delay_.clock(tri_rsp.offer);
        if (leaves) tests_[leaves->ray].begin(*leaves);
        if (ray) rays_[ray->ray] = *ray;
        if (start) tests_[start->ray].start(*start);
    }

private:
    List list_;
    std::vector<Ray> rays_;
    std::vector<RayTests> tests_;
    DelayedLink<TriRsp> tri_answer_delay_;
};

class ListRtl : public ListLinks {
public:
    explicit ListRtl(const Config& config, int seed = 1) : links_(config, "rc_list", seed) {
        drive();
        links_.reset();
    }
    void eval() {
        links_.pass_edge([&] {
            links_.drive_next("prim_next", prim_rsp);
            links_.drive_next("done_next", done);
        });
        drive();
        links_.settle();
        links_.read_in("prim_rsp", prim_rsp);
        links_.read_in("tri_rsp", tri_rsp);
        links_.read_in("done", done);
        links_.read_out("prim_req", prim_req);
        links_.read_out("tri_req", tri_req);
        links_.read_out("tested", tested);
        links_.read_out("closest", closest);
    }
    void commit() { links_.clock_later(); }

private:
    void drive() {
        links_.drive_listen("start", start);
        links_.drive_listen("ray", ray);
        links_.drive_listen("leaves", leaves);
        links_.drive_in("prim_rsp", prim_rsp);
        links_.drive_in("tri_rsp", tri_rsp);
        links_.drive_in("done", done);
        links_.drive_out("prim_req", prim_req);
        links_.drive_out("tri_req", tri_req);
        links_.drive_out("tested", tested);
        links_.drive_out("closest", closest);
    }
    RtlLinks links_;
};

}   // namespace rayclock::test
