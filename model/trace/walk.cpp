// Starts a ray's walk.
#include "model/trace/walk.hpp"

#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

const Ray& Walk::start(const Slot& slot) { return start_at(raygen(slot, frame_, way_.config)); }

const Ray& Walk::start_at(const Ray& ray) {
    way_.start(ray);
    steps_.start(frame_.root);
    return way_.ray;
}

}   // namespace rayclock
