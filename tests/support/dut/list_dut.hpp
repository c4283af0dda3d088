#pragma once
#include "model/list/leaves.hpp"
#include "model/list/list.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// What both machines of list show. `ray` is only listened to. A triangle from memory goes on to tri, and a
/// finished ray to its hit, in the same cycle.
struct ListLinks {
    std::optional<Ray> ray;
    Link<BoxRsp> box_rsp;
    Link<PrimRsp> prim_rsp;
    Link<TriRsp> tri_rsp;
    Link<Done> done;
    Link<PrimReq> prim_req;
    Link<TriReq> tri_req;
    Link<Step> step;
    Link<Closest> closest;
};

/// List says when, the Leaves of each context what.
class ListModel : public ListLinks {
public:
    explicit ListModel(const Config& config, int = 1)
        : list_(config), rays_(std::size_t(config.contexts)), leaves_(rays_.size(), Leaves(config)) {}
    void eval() {
        box_rsp.ready = tri_rsp.ready = true;
        prim_req.offer.reset();
        if (list_.prim_valid()) prim_req.offer = PrimReq{list_.prim_ray(), leaves_[list_.prim_ray()].prim()};
        step.offer.reset();
        if (list_.step_valid()) step.offer = leaves_[list_.step_ray()].step(list_.step_ray());
        prim_rsp.ready = tri_req.ready;
        tri_req.offer.reset();
        if (prim_rsp.offer) {
            const Ray& r = rays_[prim_rsp.offer->ray];
            tri_req.offer = TriReq{
                r.ray,  r.o,      r.d,     prim_rsp.offer->triangle, leaves_[r.ray].best(), r.shear, r.kind,
                r.self, r.inside, r.finite};
        }
        done.ready = closest.ready;
        closest.offer.reset();
        if (done.offer) closest.offer = leaves_[done.offer->ray].closest(done.offer->ray);
    }
    void commit() {
        const bool boxed = box_rsp.fires(), tested = tri_rsp.fires();
        list_.clock(
            boxed ? &box_rsp.offer->ray : nullptr, boxed && leaves_[box_rsp.offer->ray].begin(*box_rsp.offer),
            tested ? &tri_rsp.offer->ray : nullptr,
            tested && leaves_[tri_rsp.offer->ray].advance(*tri_rsp.offer), prim_req.fires(), step.fires());
        if (!ray) return;
        rays_[ray->ray] = *ray;
        leaves_[ray->ray].clear(RayKind(ray->kind));
    }

private:
    List list_;
    std::vector<Ray> rays_;
    std::vector<Leaves> leaves_;
};

class ListRtl : public ListLinks {
public:
    explicit ListRtl(const Config& config, int seed = 1) : links_(config, "rc_list", seed) {
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_in("box_rsp", box_rsp);
        links_.read_in("prim_rsp", prim_rsp);
        links_.read_in("tri_rsp", tri_rsp);
        links_.read_in("done", done);
        links_.read_out("prim_req", prim_req);
        links_.read_out("tri_req", tri_req);
        links_.read_out("step", step);
        links_.read_out("closest", closest);
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_in("ray", Link<Ray>{ray, true});
        links_.drive_in("box_rsp", box_rsp);
        links_.drive_in("prim_rsp", prim_rsp);
        links_.drive_in("tri_rsp", tri_rsp);
        links_.drive_in("done", done);
        links_.drive_out("prim_req", prim_req);
        links_.drive_out("tri_req", tri_req);
        links_.drive_out("step", step);
        links_.drive_out("closest", closest);
    }
    RtlLinks links_;
};

}   // namespace rayclock::test
