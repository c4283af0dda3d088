#include "sim/rtl/rtl_machine.hpp"

#include <cstring>

namespace rayclock {

namespace {

/// Puts a memory answer on its port: the line as it lies in memory, and the ray's number above it.
void offer(const RcPort& port, const std::uint32_t* line, int bits, std::uint32_t ray) {
    const std::size_t whole = std::size_t(bits / 32);
    std::memcpy(port.data, line, whole * 4);
    const int rest = bits % 32;
    const std::uint64_t top = (std::uint64_t(rest ? line[whole] : 0) & ((std::uint64_t(1) << rest) - 1)) | std::uint64_t(ray) << rest;
    port.data[whole] = std::uint32_t(top);
    if (port.bytes > 4 * (whole + 1)) port.data[whole + 1] = std::uint32_t(top >> 32);
}

} // namespace

RtlMachine::RtlMachine(const MemoryImage& image, const Frame& frame, const Config& config, Traffic traffic, int seed)
    : config_(config), image_(image), decoder_(image, config), rtl_(config, "rc_top", seed),
      node_rsp_(&rtl_.port("node_rsp")), prim_rsp_(&rtl_.port("prim_rsp")),
      node_bits_(bits_of<Node>(config)), prim_bits_(bits_of<PrimData>(config)),
      node_port_(config, node_traffic(traffic)), prim_port_(config, prim_traffic(traffic)), sink_(traffic),
      pixels_(std::uint64_t(frame.width) * frame.height) {
    for (std::size_t c = 0; c < channel_count; ++c) links_[c] = &rtl_.port(channels[c].name);
    set_data(rtl_.port("frame"), frame, config);
    *node_rsp_->valid = *prim_rsp_->valid = 0;
    *links_[index(Channel::node_req)]->ready = *links_[index(Channel::prim_req)]->ready = *links_[index(Channel::hit)]->ready = 0;
    rtl_.reset();
}

void RtlMachine::drive() {
    *links_[index(Channel::node_req)]->ready = node_port_.ready();
    *links_[index(Channel::prim_req)]->ready = prim_port_.ready();
    *links_[index(Channel::hit)]->ready = sink_.ready();
    *node_rsp_->valid = node_port_.valid();
    if (node_port_.valid()) offer(*node_rsp_, image_.line(node_port_.answer().addr), node_bits_, node_port_.answer().ray);
    *prim_rsp_->valid = prim_port_.valid();
    if (prim_port_.valid()) offer(*prim_rsp_, image_.half_line(prim_port_.answer().addr), prim_bits_, prim_port_.answer().ray);
}

void RtlMachine::settle() {
    drive();
    rtl_.settle();
    valid_ = fire_ = 0;
    for (std::size_t c = 0; c < channel_count; ++c) {
        const std::uint32_t valid = *links_[c]->valid;
        valid_ |= valid << c;
        fire_ |= (valid & *links_[c]->ready) << c;
    }
    counter_.add(valid_, fire_);
}

void RtlMachine::clock() {
    Memport::Answer node{}, prim{};
    if (fires(Channel::node_req)) {
        const NodeReq req = get_data<NodeReq>(*links_[index(Channel::node_req)], config_);
        node = {req.ray, req.addr};
    }
    if (fires(Channel::prim_req)) {
        const PrimReq req = get_data<PrimReq>(*links_[index(Channel::prim_req)], config_);
        prim = {req.ray, req.addr};
    }
    if (fires(Channel::box_req)) box_tests_ += std::uint64_t(decoder_.node(node_port_.answer().addr).children);
    if (fires(Channel::hit)) {
        hit_ = get_data<HitOut>(*links_[index(Channel::hit)], config_);
        ++hits_;
    }
    rtl_.clock();
    node_port_.clock(fires(Channel::node_req) ? &node : nullptr, fires(Channel::box_req));
    prim_port_.clock(fires(Channel::prim_req) ? &prim : nullptr, fires(Channel::tri_req));
    sink_.clock();
    ++now_;
}

} // namespace rayclock
