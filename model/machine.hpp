#pragma once
// The machine, cycle by cycle: mirror of rtl/rc_top.sv with the memory ports that lie under both.
#include <memory>
#include <vector>

#include "model/accel/memory_image.hpp"
#include "model/core/channels.hpp"
#include "model/core/ring.hpp"
#include "model/list/list.hpp"
#include "model/mem/decoder.hpp"
#include "model/mem/memport.hpp"
#include "model/sched/sched.hpp"
#include "model/trav/trav.hpp"

namespace rayclock {

class Machine {
public:
    /// The image must outlive the machine. `traffic` disturbs memory and sink, for tests.
    Machine(const MemoryImage& image, const Frame& frame, const Config& config, Traffic traffic = {});

    /// One clock cycle.
    void step();

    /// One clock cycle; `observe(Channel, payload)` sees every transfer before the clock edge, in channel order.
    template <class Observer> void step(Observer&& observe) {
        Moves m;
        settle(m);
        show(m, observe);
        clock_all(m);
    }

    /// One clock cycle with the units' clock edges taken in the given order (a permutation of 0..6), for the test that
    /// it does not matter.
    void step_in_order(const std::array<int, 7>& order);

    bool done() const { return hits_ == pixels_; }
    std::uint64_t cycle() const { return now_; }
    std::uint64_t hits() const { return hits_; }
    std::uint32_t valid_mask() const { return valid_; }   ///< of the last cycle
    std::uint32_t fire_mask() const { return fire_; }
    /// The hit that left in the last cycle, if bit(Channel::hit) is set in fire_mask().
    const HitOut& last_hit() const { return hit_; }
    ChannelCounts counts() const { return counter_.counts(); }
    std::uint64_t box_tests() const { return box_tests_; }
    std::uint64_t recirculations() const { return trav_.recirculations(); }
    const Sched& sched() const { return sched_; }

private:
    /// What moves in this cycle, settled from registered state before any unit sees the clock edge.
    struct Moves {
        Slot slot;
        const Ray* ray;
        Memport::Answer node_req, prim_req, node, prim;
        const BoxRsp* boxes;
        const TriRsp* tri;
        Step step;
    };

    void settle(Moves& m);
    void clock_all(const Moves& m);
    void clock_sched();
    void clock_raygen(const Moves& m);
    void clock_trav(const Moves& m);
    void clock_memory(const Moves& m);
    void clock_box(const Moves& m);
    void clock_list(const Moves& m);
    void clock_tri(const Moves& m);
    void admit_box(const Memport::Answer& from);
    void admit_tri(const Memport::Answer& from);
    template <class Observer> void show(const Moves& m, Observer& observe) const;
    bool fires(Channel c) const { return fire_ >> index(c) & 1; }

    Config config_;
    Frame frame_;
    const MemoryImage& image_;
    Decoder decoder_;
    Sched sched_;
    Pipe<Ray> raygen_;
    Trav trav_;
    Memport node_port_;
    Pipe<BoxRsp> box_;
    List list_;
    Memport prim_port_;
    Pipe<TriRsp> tri_;
    Sink sink_;

    std::uint64_t now_ = 0, hits_ = 0, pixels_ = 0, box_tests_ = 0;
    std::uint32_t valid_ = 0, fire_ = 0;
    HitOut hit_{};
    ChannelCounter counter_;
};

template <class Observer> void Machine::show(const Moves& m, Observer& observe) const {
    if (fires(Channel::slot)) observe(Channel::slot, m.slot);
    if (fires(Channel::ray)) observe(Channel::ray, *m.ray);
    if (fires(Channel::node_req)) observe(Channel::node_req, trav_.node());
    if (fires(Channel::box_req)) {
        const BoxRay& r = trav_.box_ray(m.node.ray);
        observe(Channel::box_req, BoxReq{m.node.ray, r.o, r.neg, r.recip, r.len, unpack<Node>(image_.line(m.node.addr), config_)});
    }
    if (fires(Channel::box_rsp)) observe(Channel::box_rsp, *m.boxes);
    if (fires(Channel::prim_req)) observe(Channel::prim_req, list_.prim());
    if (fires(Channel::tri_req))
        observe(Channel::tri_req, list_.tri_req(m.prim.ray, unpack<PrimData>(image_.half_line(m.prim.addr), config_)));
    if (fires(Channel::tri_rsp)) observe(Channel::tri_rsp, *m.tri);
    if (fires(Channel::step)) observe(Channel::step, m.step);
    if (fires(Channel::hit)) observe(Channel::hit, hit_);
}

} // namespace rayclock
