#include "model/trace/walk.hpp"

#include "model/isect/any.hpp"
#include "model/raygen/raygen.hpp"

namespace rayclock {

Walk::Walk(const Frame& frame, const Config& config, const Decoder& decoder)
    : frame_(&frame),
      config_(&config),
      decoder_(&decoder),
      test_(tri_test_of(config)),
      tests_(config),
      stack_(config) {}

const Ray& Walk::start(const Slot& slot) { return start_at(raygen(slot, *frame_, *config_)); }

const Ray& Walk::start_at(const Ray& ray) {
    ray_ = ray;
    box_ray_ = {ray_.o, {ray_.d[0] < 0, ray_.d[1] < 0, ray_.d[2] < 0}, ray_.recip, ray_.len};
    tests_.start({ray.ray, ray.kind});
    stack_.clear();
    node_ = frame_->root;
    return ray_;
}

bool Walk::test_node() {
    boxes_.ray = ray_.ray;
    box_children(box_ray_, decoder_->node(node_), *config_, boxes_);
    has_leaves_ = boxes_.leaves > 0 && boxes_.t_near[boxes_.inner] <= tests_.t_best();
    if (has_leaves_) tests_.begin(leaves_ = leaves_of(boxes_));
    return has_leaves_;
}

const TriRsp& Walk::test_triangle() {
    tri_.ray = ray_.ray;
    const PrimData& prim = decoder_->prim(tests_.prim());
    if (config_->shading)
        any_test(ray_, prim, tests_.best(), *config_, tri_);
    else
        test_(ray_.o, ray_.d, prim, tests_.best(), *config_, tri_);
    return tri_;
}

int Walk::decide(bool& done) {
    const Tested tested = tests_.tested();
    Turn turn = stack_.decide(tested, children_of(boxes_));
    int dropped = 0;
    for (; turn.kind == Turn::Kind::again; ++dropped) turn = stack_.decide(tested);
    done = turn.kind == Turn::Kind::done;
    if (!done) node_ = turn.addr;
    return dropped;
}

}   // namespace rayclock
