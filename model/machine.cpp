#include "model/machine.hpp"

#include "model/isect/tri.hpp"
#include "model/raygen/raygen.hpp"

namespace rayclock {

Machine::Machine(const MemoryImage& image, const Frame& frame, const Config& config, Traffic traffic)
    : config_(config), frame_(frame), image_(image), decoder_(image, config),
      sched_(frame, config),
      raygen_(config.raygen_latency(), config.raygen_queue),
      trav_(frame, config),
      node_port_(config, node_traffic(traffic)),
      box_(config.box_latency(), config.box_queue),
      list_(config),
      prim_port_(config, prim_traffic(traffic)),
      tri_(config.tri_latency(), config.tri_queue),
      sink_(traffic),
      pixels_(std::uint64_t(frame.width) * frame.height) {}

void Machine::settle(Moves& m) {
    const std::uint32_t valid = std::uint32_t(sched_.slot_valid()) << index(Channel::slot)
        | std::uint32_t(raygen_.valid(now_)) << index(Channel::ray)
        | std::uint32_t(trav_.node_valid()) << index(Channel::node_req)
        | std::uint32_t(node_port_.valid()) << index(Channel::box_req)
        | std::uint32_t(box_.valid(now_)) << index(Channel::box_rsp)
        | std::uint32_t(list_.prim_valid()) << index(Channel::prim_req)
        | std::uint32_t(prim_port_.valid()) << index(Channel::tri_req)
        | std::uint32_t(tri_.valid(now_)) << index(Channel::tri_rsp)
        | std::uint32_t(list_.step_valid()) << index(Channel::step)
        | std::uint32_t(trav_.done_valid()) << index(Channel::hit);
    const std::uint32_t ready = std::uint32_t(raygen_.ready()) << index(Channel::slot)
        | std::uint32_t(trav_.ray_ready()) << index(Channel::ray)
        | std::uint32_t(node_port_.ready()) << index(Channel::node_req)
        | std::uint32_t(box_.ready()) << index(Channel::box_req)
        | bit(Channel::box_rsp)
        | std::uint32_t(prim_port_.ready()) << index(Channel::prim_req)
        | std::uint32_t(tri_.ready()) << index(Channel::tri_req)
        | bit(Channel::tri_rsp)
        | std::uint32_t(trav_.step_ready()) << index(Channel::step)
        | std::uint32_t(sink_.ready()) << index(Channel::hit);
    valid_ = valid;
    fire_ = valid & ready;
    counter_.add(valid_, fire_);

    if (fires(Channel::slot)) m.slot = sched_.slot();
    if (fires(Channel::ray)) m.ray = &raygen_.front();
    if (fires(Channel::node_req)) m.node_req = {trav_.node().ray, trav_.node().addr};
    if (fires(Channel::box_req)) m.node = node_port_.answer();
    if (fires(Channel::box_rsp)) m.boxes = &box_.front();
    if (fires(Channel::prim_req)) m.prim_req = {list_.prim().ray, list_.prim().addr};
    if (fires(Channel::tri_req)) m.prim = prim_port_.answer();
    if (fires(Channel::tri_rsp)) m.tri = &tri_.front();
    if (fires(Channel::step)) m.step = list_.step();
    if (fires(Channel::hit)) {
        hit_ = sched_.hit(list_.closest(trav_.done()));
        ++hits_;
    }
}

// A ray has one request under way: what trav and list keep about it does not change in the cycle of its test, so that it
// does not matter whether they have had their clock edge.
void Machine::admit_box(const Memport::Answer& from) {
    const WideNode& node = decoder_.node(from.addr);
    BoxRsp& answer = box_.admit(now_);
    answer.ray = from.ray;
    box_children(trav_.box_ray(from.ray), node, config_, answer);
    box_tests_ += std::uint64_t(node.children);
}

void Machine::admit_tri(const Memport::Answer& from) {
    const Ray& ray = list_.ray(from.ray);
    TriRsp& answer = tri_.admit(now_);
    answer.ray = from.ray;
    tri_test(ray.o, ray.d, decoder_.prim(from.addr), list_.best(from.ray), config_, answer);
}

void Machine::clock_sched() {
    sched_.clock(fires(Channel::slot), fires(Channel::hit) ? &hit_.closest.ray : nullptr);
    sink_.clock();
}

void Machine::clock_raygen(const Moves& m) {
    if (fires(Channel::ray)) raygen_.leave();
    if (fires(Channel::slot)) raygen_.admit(now_) = raygen(m.slot, frame_, config_);
}

void Machine::clock_trav(const Moves& m) {
    trav_.clock(fires(Channel::ray) ? m.ray : nullptr, fires(Channel::step) ? &m.step : nullptr, fires(Channel::node_req),
                fires(Channel::hit));
}

void Machine::clock_memory(const Moves& m) {
    node_port_.clock(fires(Channel::node_req) ? &m.node_req : nullptr, fires(Channel::box_req));
    prim_port_.clock(fires(Channel::prim_req) ? &m.prim_req : nullptr, fires(Channel::tri_req));
}

void Machine::clock_box(const Moves& m) {
    if (fires(Channel::box_rsp)) box_.leave();
    if (fires(Channel::box_req)) admit_box(m.node);
}

void Machine::clock_list(const Moves& m) {
    list_.clock(fires(Channel::ray) ? m.ray : nullptr, fires(Channel::box_rsp) ? m.boxes : nullptr,
                fires(Channel::tri_rsp) ? m.tri : nullptr, fires(Channel::prim_req), fires(Channel::step));
}

void Machine::clock_tri(const Moves& m) {
    if (fires(Channel::tri_rsp)) tri_.leave();
    if (fires(Channel::tri_req)) admit_tri(m.prim);
}

void Machine::clock_all(const Moves& m) {
    clock_sched();
    clock_raygen(m);
    clock_trav(m);
    clock_memory(m);
    clock_box(m);
    clock_list(m);
    clock_tri(m);
    ++now_;
}

void Machine::step() {
    Moves m;
    settle(m);
    clock_all(m);
}

void Machine::step_in_order(const std::array<int, 7>& order) {
    Moves m;
    settle(m);
    for (const int unit : order) switch (unit) {
        case 0: clock_sched(); break;
        case 1: clock_raygen(m); break;
        case 2: clock_trav(m); break;
        case 3: clock_memory(m); break;
        case 4: clock_box(m); break;
        case 5: clock_list(m); break;
        default: clock_tri(m); break;
        }
    ++now_;
}

} // namespace rayclock
