#pragma once
#include "model/accel/memory_image.hpp"
#include "model/core/channels.hpp"
#include "model/mem/decoder.hpp"
#include "model/mem/memport.hpp"
#include "sim/rtl/rtl_module.hpp"

namespace rayclock {

/// rtl/rc_top.sv under Verilator with the same memory ports and sink as the model's Machine has.
class RtlMachine {
public:
    RtlMachine(const MemoryImage& image, const Frame& frame, const Config& config, Traffic traffic = {}, int seed = 1);

    /// First half of a cycle: drives memory answers and the sink's ready; then valid_mask(), fire_mask() and data() tell
    /// what the cycle moves. Second half: the clock edge. step() does both.
    void settle();
    void clock();
    void step() { settle(); clock(); }

    bool done() const { return hits_ == pixels_; }
    std::uint64_t cycle() const { return now_; }
    std::uint64_t hits() const { return hits_; }
    std::uint32_t valid_mask() const { return valid_; }
    std::uint32_t fire_mask() const { return fire_; }
    /// Packed payload that channel `c` offers in this cycle.
    const std::uint32_t* data(Channel c) const { return links_[index(c)]->data; }
    HitOut last_hit() const { return hit_; }
    ChannelCounts counts() const { return counter_.counts(); }
    std::uint64_t box_tests() const { return box_tests_; }

private:
    bool fires(Channel c) const { return fire_ >> index(c) & 1; }
    void drive();

    Config config_;
    const MemoryImage& image_;
    Decoder decoder_;   // only to count what the box tests were made on
    RtlModule rtl_;
    std::array<const RcPort*, channel_count> links_{};
    const RcPort *node_rsp_, *prim_rsp_;
    int node_bits_, prim_bits_;
    Memport node_port_, prim_port_;
    Sink sink_;
    std::uint64_t now_ = 0, hits_ = 0, pixels_ = 0, box_tests_ = 0;
    std::uint32_t valid_ = 0, fire_ = 0;
    HitOut hit_{};
    ChannelCounter counter_;
};

} // namespace rayclock
