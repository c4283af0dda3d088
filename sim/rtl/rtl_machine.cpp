#include "sim/rtl/rtl_machine.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace rayclock {

RtlMachine::RtlMachine(const MemoryImage& image, const Config& config, int khz, Traffic traffic, int seed)
    : config_(config),
      image_(image),
      decoder_(image, config),
      rtl_(config, "rc_top", seed),
      links_(std::size_t(config.pipelines)),
      start_(&rtl_.port("start")),
      mem_req_(&rtl_.port("mem_req")),
      mem_rsp_(&rtl_.port("mem_rsp")),
      hit_ready_(&rtl_.port("hit_ready")),
      memory_(config, khz, traffic),
      valid_(links_.size()),
      fire_(links_.size()),
      under_way_(std::size_t(1) << config.mem_id_bits()) {
    for (std::size_t c = 0; c < pipeline_channels; ++c)
        if (is_there(Channel(c), config)) there_.push_back(c);
    for (int p = 0; p < config.pipelines; ++p) {
        auto& links = links_[std::size_t(p)];
        links.fill(nullptr);
        for (const std::size_t c : there_)
            links[c] = &rtl_.port(fmt::format("{}[{}]", channels[c].name, p));
        sinks_.emplace_back(traffic, p);
    }
    for (std::size_t c = pipeline_channels; c < channel_count; ++c)
        if (is_there(Channel(c), config)) links_[0][c] = &rtl_.port(channels[c].name);
    std::memset(start_->data, 0, start_->bytes);
    std::memset(hit_ready_->data, 0, hit_ready_->bytes);
    *mem_req_->ready = *mem_rsp_->valid = 0;
    rtl_.reset();
}

void RtlMachine::start(const Frame& frame) {
    set_data(rtl_.port("frame"), frame, config_);
    const unsigned char on = 1, off = 0;
    std::memcpy(start_->data, &on, 1);
    *mem_req_->ready = *mem_rsp_->valid = 0;
    rtl_.settle();
    rtl_.clock();
    std::memcpy(start_->data, &off, 1);
    pixels_ = std::uint64_t(frame.width) * frame.height;
    width_ = frame.width;
    given_.assign(pixels_, 0);
    hits_ = box_tests_ = 0;
    rays_ = {};
    at_start_ = read_counters();
    at_start_.units[index(Unit::memory)] = memory_.deeds();
}

void RtlMachine::drive() {
    unsigned char ready = 0;
    for (std::size_t p = 0; p < sinks_.size(); ++p)
        ready |= static_cast<unsigned char>(unsigned(sinks_[p].ready()) << p);
    std::memcpy(hit_ready_->data, &ready, 1);
    *mem_req_->ready = memory_.ready();
    *mem_rsp_->valid = memory_.valid();
    if (!memory_.valid()) return;
    const Memory::Answer answer = memory_.answer();
    std::memcpy(mem_rsp_->data, image_.line(answer.addr),
                line_bytes);   // MemRsp: the line at the bottom, the id above
    mem_rsp_->data[line_bytes / 4] = answer.id;
}

void RtlMachine::settle() {
    drive();
    rtl_.settle();
    moved_ = false;
    for (std::size_t p = 0; p < links_.size(); ++p) {
        std::uint32_t valid = 0, fire = 0;
        for (const std::size_t c : there_) {
            const RcPort& link = *links_[p][c];
            valid |= std::uint32_t(*link.valid) << c;
            fire |= std::uint32_t(link.ready ? *link.valid & *link.ready : *link.valid) << c;
        }
        valid_[p] = valid;
        fire_[p] = fire;
        moved_ = moved_ || fire;
    }
    shared_valid_ = shared_fire_ = 0;
    for (std::size_t c = pipeline_channels; c < channel_count; ++c) {
        const RcPort* link = links_[0][c];
        if (!link) continue;
        shared_valid_ |= std::uint32_t(*link->valid) << c;
        shared_fire_ |= std::uint32_t(link->ready ? *link->valid & *link->ready : *link->valid) << c;
    }
    moved_ = moved_ || shared_fire_;
}

void RtlMachine::complain(int pipeline, Channel channel, const std::string& what) {
    if (!nonsense_) nonsense_ = {pipeline, channel, what};
}

/// The request that the RTL makes in this cycle, if it can be meant.
std::optional<Memory::Answer> RtlMachine::request() {
    if (!(shared_fire_ & bit(Channel::mem_req))) return {};
    const MemReq req = get_data<MemReq>(*mem_req_, config_);
    // Long lines end at the next multiple of their length.
    const std::uint32_t line = std::uint32_t(
        std::max({config_.node_line, config_.prim_line, config_.surf_line, config_.l2_line}) / line_bytes);
    if (req.addr / line > (image_.lines() - 1) / line)
        complain(0, Channel::mem_req,
                 fmt::format("line {}, and the memory image has {}", req.addr, image_.lines()));
    if (under_way_[req.id]) {
        complain(0, Channel::mem_req, fmt::format("id {}, whose last request is not answered yet", req.id));
        return {};
    }
    under_way_[req.id] = 1;
    return Memory::Answer{req.id, req.addr};
}

/// Whether the hit is one of the picture that was not there yet. A primitive that the scene lacks is taken
/// from it.
bool RtlMachine::check_hit(int pipeline, HitOut& hit) {
    const auto refuse = [&](const std::string& what) {
        complain(pipeline, Channel::hit, what);
        return false;
    };
    if (hit.x >= width_ || hit.y >= pixels_ / width_)
        return refuse(fmt::format("pixel ({}, {}) outside the picture", hit.x, hit.y));
    std::uint8_t& given = given_[std::size_t(hit.y) * width_ + hit.x];
    if (given) return refuse(fmt::format("pixel ({}, {}) for the second time", hit.x, hit.y));
    given = 1;
    if (hit.closest.found && hit.closest.prim >= image_.primitives) {
        complain(pipeline, Channel::hit,
                 fmt::format("primitive {}, and the scene has {}", hit.closest.prim, image_.primitives));
        hit.closest = {};
    }
    return true;
}

void RtlMachine::count_boxes(int pipeline) {
    const std::uint32_t line =
        get_data<NodeReq>(*links_[std::size_t(pipeline)][index(Channel::node_req)], config_).addr;
    if (line < image_.lines())
        box_tests_ += std::uint64_t(decoder_.node(line).children);
    else
        complain(pipeline, Channel::node_req,
                 fmt::format("line {}, and the memory image has {}", line, image_.lines()));
}

void RtlMachine::clock() {
    if (memory_.valid()) under_way_[memory_.answer().id] = 0;
    const std::optional<Memory::Answer> asked = request();
    for (std::size_t p = 0; p < links_.size(); ++p) {
        hits_ += fire_[p] >> index(Channel::hit) & 1;
        rays_.primary += fire_[p] >> index(Channel::slot) & 1;
        if (fire_[p] & bit(Channel::spawn)) {
            const std::uint32_t kind = get_data<Spawn>(*links_[p][index(Channel::spawn)], config_).kind;
            ++(kind == std::uint32_t(RayKind::camera) ? rays_.primary
               : ends_at_any(kind)                    ? rays_.shadow
                                                      : rays_.reflection);
        }
        if (fire_[p] & bit(Channel::node_req)) count_boxes(int(p));
    }
    rtl_.clock();
    memory_.clock(asked ? &*asked : nullptr);
    for (Sink& sink : sinks_) sink.clock();
    ++now_;
}

Accounts RtlMachine::read_counters() const {
    Accounts sums;
    const auto add = [&](std::size_t unit, const std::string& name) {
        std::uint64_t counts[cause_count];
        std::memcpy(counts, rtl_.port(name).data, sizeof counts);
        for (std::size_t i = 0; i < cause_count; ++i) sums.units[unit][i] += counts[i];
    };
    for (std::size_t u = 0; u < pipeline_units; ++u)
        for (int p = 0; is_there(Unit(u), config_) && p < config_.pipelines; ++p)
            add(u, fmt::format("tally.{}[{}]", unit_infos[u].name, p));
    add(index(Unit::dispatch), "tally.dispatch");
    add(index(Unit::memport), "tally.memport");
    if (config_.l2_sets > 0) add(index(Unit::l2), "tally.l2");
    return sums;
}

Accounts RtlMachine::accounts() const {
    Accounts sums = read_counters();
    sums.units[index(Unit::memory)] = memory_.deeds();
    sums = sums - at_start_;
    // The counters have 40 bits and are never cleared.
    for (std::size_t u = 0; u < unit_count; ++u)
        for (std::uint64_t& count : sums.units[u]) count &= (std::uint64_t(1) << 40) - 1;
    return sums;
}

}   // namespace rayclock
