// Starts a ray's walk.
#include "model/trace/walk.hpp"

#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

const Ray& Walk::start(const Slot& slot) { return start_at(raygen(slot, frame_, policy_.config)); }

const Ray& Walk::start_at(const Ray& ray) {
    policy_.start(ray);
    steps_.start(frame_.root);
    return policy_.ray;
}

}   // namespace rayclock
