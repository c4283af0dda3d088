// Records the rays of a pixel on the machine as a tree.
#include "sim/judge/cause/machine_path.hpp"

namespace rayclock {

int MachinePath::add(const Ray& ray, int parent) {
    visits.push_back({});
    visits.back().ray = ray;
    visits.back().parent = parent;
    return int(visits.size()) - 1;
}

void MachinePath::sent(const Ray& ray) {
    asks_light_ = ends_at_any(ray.kind);
    if (asks_light_) {
        visits[std::size_t(at_)].lights.back().ray = ray;
    } else if (ray.kind == RayKind::camera) {
        at_ = add(ray, MachineVisit::none);
        samples.push_back(at_);
    } else if (last_ == ShadeEvent::reflect) {
        const int from = at_;
        at_ = add(ray, from);
        visits[std::size_t(from)].reflected = at_;
    } else if (last_ == ShadeEvent::texture) {
        const int from = at_;
        at_ = add(ray, from);
        visits[std::size_t(from)].onward = at_;
    } else {
        const int from = waiting_.back();
        waiting_.pop_back();
        at_ = add(ray, from);
        visits[std::size_t(from)].refracted = at_;
    }
}

void MachinePath::answered(const Closest& hit) {
    MachineVisit& visit = visits[std::size_t(at_)];
    if (asks_light_)
        visit.lights.back().is_lit = hit.found == 0;
    else
        visit.hit = hit;
}

void MachinePath::filtered(const TexReq& hit, const TexRecord&, const TexelPlace& place,
                           const TexRsp& answer) {
    if (asks_cutout_) return;   // the last ray to the light tells whether it is hidden
    MachineVisit& visit = visits[std::size_t(at_)];
    visit.texture = MachineTexture{place.level, answer.hole != 0, hit.u, hit.v, visit.state.albedo};
}

void MachinePath::passed(const PassIn& in, const PassOut& out) {
    MachineVisit& visit = visits[std::size_t(at_)];
    asks_cutout_ = meets_cutout(in);
    if (asks_cutout_) return;
    last_ = event_of(in);
    switch (last_) {
        case ShadeEvent::arrive:
            visit.surface = in.surface, visit.placement = in.placement, visit.state = out.state;
            break;
        case ShadeEvent::transform: visit.state = out.state; break;
        case ShadeEvent::texture: visit.state.albedo = out.state.albedo; break;
        case ShadeEvent::light:
            if (passes_hole(in)) break;   // another ray to the same light
            visit.lights.push_back(
                {out.leave == PassOut::Leave::spawn, out.state.pending == Pending::sure, {}});
            break;
        case ShadeEvent::refract:
            visit.state.total = out.state.total;
            visit.is_refracted_past = out.passes_by;
            if (out.push) waiting_.push_back(at_);
            break;
        case ShadeEvent::reflect: visit.is_reflected_past = out.passes_by; break;
        case ShadeEvent::pop: break;
    }
}

}   // namespace rayclock
