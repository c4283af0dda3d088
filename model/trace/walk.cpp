#include "model/trace/walk.hpp"

#include "model/isect/any.hpp"
#include "model/raygen/raygen.hpp"

namespace rayclock {

Walk::Walk(const Frame& frame, const Config& config, const Decoder& decoder)
    : frame_(&frame),
      config_(&config),
      decoder_(&decoder),
      test_(tri_test_of(config)),
      leaves_(config),
      stack_(config) {}

const Ray& Walk::start(const Slot& slot) { return start_at(raygen(slot, *frame_, *config_)); }

const Ray& Walk::start_at(const Ray& ray) {
    ray_ = ray;
    box_ray_ = {ray_.o, {ray_.d[0] < 0, ray_.d[1] < 0, ray_.d[2] < 0}, ray_.recip, ray_.len};
    leaves_.clear(RayKind(ray.kind));
    stack_.clear();
    node_ = frame_->root;
    return ray_;
}

bool Walk::test_node() {
    leaves_.group().ray = ray_.ray;
    box_children(box_ray_, decoder_->node(node_), *config_, leaves_.group());
    return leaves_.begin();
}

const TriRsp& Walk::test_triangle() {
    tri_.ray = ray_.ray;
    const PrimData& prim = decoder_->prim(leaves_.prim());
    if (config_->shading)
        any_test(ray_, prim, leaves_.best(), *config_, tri_);
    else
        test_(ray_.o, ray_.d, prim, leaves_.best(), *config_, tri_);
    return tri_;
}

int Walk::decide(bool& done) {
    Step step = leaves_.step(ray_.ray);
    Turn turn = stack_.decide(step);
    int dropped = 0;
    for (step.inner = 0; turn.kind == Turn::Kind::again; ++dropped) turn = stack_.decide(step);
    done = turn.kind == Turn::Kind::done;
    if (!done) node_ = turn.addr;
    return dropped;
}

}   // namespace rayclock
