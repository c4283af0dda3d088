// The host, memory and sinks around the verilated chip.
#include "sim/run/rtl/rtl_machine.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "sim/run/gen/registers.hpp"

namespace rayclock {

RtlMachine::RtlMachine(const MemoryImage& image, const Config& config, int khz, Disturbance disturbance,
                       int seed, Waves waves)
    : config_(config),
      image_(&image),
      decoder_(std::in_place, image, config),
      rtl_(config, "rc_chip", seed, waves),
      links_(std::size_t(config.pipelines)),
      bus_{&rtl_.port("wb_cyc"), &rtl_.port("wb_stb"), &rtl_.port("wb_we"),  &rtl_.port("wb_adr"),
           &rtl_.port("wb_dat"), &rtl_.port("wb_ack"), &rtl_.port("wb_err"), &rtl_.port("wb_read")},
      running_(&rtl_.port("running")),
      done_(&rtl_.port("done")),
      mem_req_(&rtl_.port("mem_req")),
      mem_rsp_(&rtl_.port("mem_rsp")),
      hit_ready_(&rtl_.port("hit_ready")),
      memory_(config, khz, disturbance),
      disturbance_(disturbance),
      valid_(links_.size()),
      fire_(links_.size()),
      under_way_(std::size_t(1) << config.mem_id_bits()) {
    for (std::size_t c = 0; c < pipeline_links; ++c)
        if (is_there(Link(c), config)) there_.push_back(c);
    for (int p = 0; p < config.pipelines; ++p) {
        auto& links = links_[std::size_t(p)];
        links.fill(nullptr);
        for (const std::size_t c : there_)
            links[c] = &rtl_.port(fmt::format("{}[{}]", link_infos[c].name, p));
        ends_.push_back({&rtl_.port(fmt::format("done[{}]", p)), &rtl_.port(fmt::format("pixel[{}]", p))});
        sinks_.emplace_back(disturbance, p);
    }
    for (std::size_t c = pipeline_links; c < link_count; ++c)
        if (is_there(Link(c), config)) links_[0][c] = &rtl_.port(link_infos[c].name);
    for (const RcPort* port : {bus_.cyc, bus_.stb}) std::memset(port->data, 0, port->bytes);
    quiet_ports();
    rtl_.reset();
}

/// Makes memory and sinks idle.
void RtlMachine::quiet_ports() {
    std::memset(hit_ready_->data, 0, hit_ready_->bytes);
    *mem_req_->ready = *mem_rsp_->valid = 0;
}

namespace {
constexpr int patience_of_bus = 100;   // cycles
void set_flag(const RcPort& port, bool value) {
    const auto flag = static_cast<unsigned char>(value);
    std::memcpy(port.data, &flag, 1);
}
bool is_set(const RcPort& port) {
    unsigned char flag = 0;
    std::memcpy(&flag, port.data, 1);
    return flag != 0;
}
}   // namespace

bool RtlMachine::running() const { return is_set(*running_); }
bool RtlMachine::done_signal() const { return is_set(*done_) || (kept_done_ && now_ == started_); }

/// Performs a classic Wishbone cycle. Returns false if it ends with err or does not end.
bool RtlMachine::access(bool writes, std::uint32_t address, std::uint32_t value) {
    set_flag(*bus_.cyc, true);
    set_flag(*bus_.stb, true);
    set_flag(*bus_.we, writes);
    std::memcpy(bus_.adr->data, &address, std::min(bus_.adr->bytes, 4u));
    std::memcpy(bus_.dat->data, &value, 4);
    bool answered = false, good = false;
    for (int i = 0; !answered && i < patience_of_bus; ++i) {
        rtl_.settle();
        good = is_set(*bus_.ack);
        answered = good || is_set(*bus_.err);
        clock_bus();
    }
    set_flag(*bus_.cyc, false);
    set_flag(*bus_.stb, false);
    return good;
}

/// Ends a cycle in which memory's time does not advance.
void RtlMachine::clock_bus() {
    if (see_) {
        sample_links();
        see_();
    }
    rtl_.clock();
}

void RtlMachine::write_register(std::uint32_t address, std::uint32_t value) { access(true, address, value); }

/// Returns all ones if the register cannot be read.
std::uint32_t RtlMachine::read_register(std::uint32_t address) {
    std::uint32_t value = ~0u;
    if (access(false, address, 0)) std::memcpy(&value, bus_.read->data, 4);
    return value;
}

void RtlMachine::start(const Frame& frame) {
    quiet_ports();
    for (int i = 0; i < patience_of_bus && (read_register(register_address("Status")) & 1); ++i) {}
    std::uint32_t address = frame_base;
    for (const std::uint32_t value : frame_values(frame, config_)) write_register(address++, value);
    write_register(register_address("Count"), 1);
    write_register(register_address("Start"), 1);
    pixels_ = frame.pixels();
    kept_done_ = false;
    for (int i = 0; i < patience_of_bus; ++i) {   // up to the frame's cycle 0
        rtl_.settle();
        if (is_set(*running_)) break;
        kept_done_ = kept_done_ || is_set(*done_);
        clock_bus();
    }
    width_ = frame.width;
    given_.assign(pixels_, 0);
    if (config_.writes_hits()) {   // unwritten memory holds ones
        const std::uint64_t room = std::uint64_t(hits_of_line(config_));
        hit_lines_.assign(std::size_t((pixels_ + room - 1) / room) * words_per_line, ~0u);
        first_hit_line_ = frame.first_hit_line;
    }
    finished_pixels_ = box_tests_ = 0;
    rays_ = {};
    accounts_.reset();
    started_ = now_;
    memory_.start_frame(frame.width, frame.height);
    memory_at_start_ = memory_.outcomes();
}

void RtlMachine::reset() {
    quiet_ports();
    rtl_.reset();
    for (std::size_t p = 0; p < sinks_.size(); ++p) sinks_[p] = Sink(disturbance_, int(p));
    const int cycles = reset_cycles(config_);
    for (int i = 0; i < cycles; ++i) memory_.clock(nullptr);
    now_ += std::uint64_t(cycles);
}

void RtlMachine::finish_writes() {
    for (; memory_.writes(); ++now_) memory_.clock(nullptr);
}

void RtlMachine::change(const Upload& upload) {
    if (upload.image_lines == 0) return;
    if (image_ != &changed_) changed_ = *image_;
    apply(upload, changed_);
    image_ = &changed_;
    decoder_.emplace(changed_, config_);
}

void RtlMachine::drive() {
    sinks_[0].open(memory_.accepts_pixel());
    std::uint32_t ready = 0;   // one bit per sink, in as many bytes as the signal has
    for (std::size_t p = 0; p < sinks_.size(); ++p) ready |= std::uint32_t(sinks_[p].ready()) << p;
    std::memcpy(hit_ready_->data, &ready, std::min<std::size_t>(hit_ready_->bytes, sizeof ready));
    *mem_req_->ready = memory_.ready();
    *mem_rsp_->valid = memory_.valid();
    if (!memory_.valid()) return;
    const Memory::Answer answer = memory_.answer();
    std::memcpy(mem_rsp_->data, image_->line(answer.addr),
                line_bytes);   // MemRsp: the line in the lower bits, the id above
    mem_rsp_->data[line_bytes / 4] = answer.id;
}

void RtlMachine::settle() {
    drive();
    rtl_.settle();
    sample_links();
}

/// Reads which links offer and make a transfer.
void RtlMachine::sample_links() {
    moved_ = false;
    for (std::size_t p = 0; p < links_.size(); ++p) {
        LinkMask valid = 0, fire = 0;
        for (const std::size_t c : there_) {
            const RcPort& link = *links_[p][c];
            valid |= LinkMask(*link.valid) << c;
            fire |= LinkMask(link.ready ? *link.valid & *link.ready : *link.valid) << c;
        }
        valid_[p] = valid;
        fire_[p] = fire;
        moved_ = moved_ || fire;
    }
    shared_valid_ = shared_fire_ = 0;
    for (std::size_t c = pipeline_links; c < link_count; ++c) {
        const RcPort* link = links_[0][c];
        if (!link) continue;
        shared_valid_ |= LinkMask(*link->valid) << c;
        shared_fire_ |= LinkMask(link->ready ? *link->valid & *link->ready : *link->valid) << c;
    }
    moved_ = moved_ || shared_fire_;
}

void RtlMachine::complain(int pipeline, Link link, const std::string& what) {
    if (!invalid_value_) invalid_value_ = {pipeline, link, what, now_};
}

/// Returns the RTL's request in this cycle, if it is valid.
std::optional<Memory::Answer> RtlMachine::request() {
    if (!(shared_fire_ & bit(Link::mem_req))) return {};
    const MemReq req = get_data<MemReq>(*mem_req_, config_);
    if (req.is_write) {
        store(req);
        return Memory::Answer{0, req.addr, true};
    }
    // Long lines end at the next multiple of their length.
    const auto line = std::uint32_t(config_.longest_line() / line_bytes);
    if (req.addr / line > (image_->end() - 1) / line)
        complain(0, Link::mem_req,
                 fmt::format("line {}, and the memory image has {}", req.addr, image_->end()));
    if (under_way_[req.id]) {
        complain(0, Link::mem_req, fmt::format("id {}, whose last request is not answered yet", req.id));
        return {};
    }
    under_way_[req.id] = 1;
    return Memory::Answer{req.id, req.addr};
}

/// Writes a line of hits into memory, and counts its records.
void RtlMachine::store(const MemReq& request) {
    const std::size_t at = std::size_t(request.addr - first_hit_line_) * words_per_line;
    const auto in_line = std::size_t(hits_of_line(config_)), room = words_per_line / in_line;
    if (request.addr < first_hit_line_ || at >= hit_lines_.size())
        complain(0, Link::mem_req,
                 fmt::format("a write of line {}, and the hits have lines {} to {}", request.addr,
                             first_hit_line_, first_hit_line_ + hit_lines_.size() / words_per_line - 1));
    else
        std::copy(request.line.begin(), request.line.end(), &hit_lines_[at]);
    for (std::size_t k = 0; k < in_line; ++k)
        finished_pixels_ += unpack<HitRecord>(&request.line[k * room], config_).valid;
}

/// Returns true if the hit is a pixel of the picture that has not arrived yet. Removes a primitive that the
/// scene lacks.
bool RtlMachine::check_hit(int pipeline, HitOut& hit) {
    const auto refuse = [&](const std::string& what) {
        complain(pipeline, Link::hit, what);
        return false;
    };
    const std::size_t at = std::size_t(hit.y) * width_ + hit.x;
    if (hit.x >= width_ || at >= pixels_)
        return refuse(fmt::format("pixel ({}, {}) outside the picture", hit.x, hit.y));
    std::uint8_t& given = given_[at];
    if (given) return refuse(fmt::format("pixel ({}, {}) for the second time", hit.x, hit.y));
    given = 1;
    if (hit.closest.found && hit.closest.prim >= image_->primitives) {
        complain(pipeline, Link::hit,
                 fmt::format("primitive {}, and the scene has {}", hit.closest.prim, image_->primitives));
        hit.closest = {};
    }
    return true;
}

void RtlMachine::count_boxes(int pipeline) {
    const std::uint32_t line =
        get_data<NodeReq>(*links_[std::size_t(pipeline)][index(Link::node_req)], config_).addr;
    if (line < image_->lines())
        box_tests_ += decoder_->children(line);
    else
        complain(pipeline, Link::node_req,
                 fmt::format("line {}, and the memory image has {}", line, image_->lines()));
}

void RtlMachine::clock() {
    if (memory_.valid()) under_way_[memory_.answer().id] = 0;
    const std::optional<Memory::Answer> asked = request();
    std::uint32_t finished = 0;
    for (std::size_t p = 0; p < links_.size(); ++p) {
        finished += std::uint32_t(fire_[p] >> index(Link::hit) & 1);
        if (!config_.is_stream()) rays_.primary += fire_[p] >> index(Link::slot) & 1;
        if (fire_[p] & bit(Link::record)) {
            const RayKind kind = get_data<StreamRsp>(*links_[p][index(Link::record)], config_).record.kind;
            ++(ends_at_any(kind) ? rays_.shadow : rays_.primary);
        }
        if (fire_[p] & bit(Link::spawn)) {
            const RayKind kind = get_data<Spawn>(*links_[p][index(Link::spawn)], config_).kind;
            ++(kind == RayKind::camera ? rays_.primary : ends_at_any(kind) ? rays_.shadow : rays_.reflection);
        }
        if (fire_[p] & bit(Link::node_req)) count_boxes(int(p));
    }
    if (!config_.writes_hits()) finished_pixels_ += finished;
    Memory::PixelPlace place;
    if (memory_.draws() && finished > 0) {
        const HitOut hit = get_data<HitOut>(*links_[0][index(Link::hit)], config_);
        place = {hit.x, hit.y};
    }
    rtl_.clock();
    memory_.clock(asked ? &*asked : nullptr, finished, finished > 0 ? &place : nullptr);
    for (Sink& sink : sinks_) sink.clock();
    ++now_;
}

std::uint64_t RtlMachine::read_counter(std::uint32_t address) {
    const std::uint64_t low = read_register(address);
    return low | std::uint64_t(read_register(address + 1)) << 32;
}

void RtlMachine::read_counters() {
    quiet_ports();
    if (is_set(*running_) && !done()) write_register(register_address("Count"), 0);
    for (int i = 0; done() && i < patience_of_bus && (read_register(register_address("Status")) & 1); ++i) {}
    Accounts sums;
    for (std::size_t u = 0; u < pipeline_units + shared_units; ++u)
        for (int p = 0; is_there(Unit(u), config_) && p < (u < pipeline_units ? config_.pipelines : 1); ++p)
            for (std::size_t c = 0; c < cause_count; ++c)
                sums.units[u][c] += read_counter(counter_address(Unit(u), p, c));
    counted_cycles_ = read_counter(register_address("Cycles"));
    const std::uint64_t ran = now_ - started_;
    for (int i = 0; !done() && i < patience_of_bus && ran + std::uint64_t(i) < counted_cycles_; ++i)
        memory_.clock(nullptr);
    for (std::size_t c = 0; c < cause_count; ++c)
        sums.units[index(Unit::memory)][c] = memory_.outcomes()[c] - memory_at_start_[c];
    accounts_ = sums;
}

const Accounts& RtlMachine::accounts() {
    if (!accounts_) read_counters();
    return *accounts_;
}

std::uint64_t RtlMachine::counted_cycles() {
    if (!accounts_) read_counters();
    return counted_cycles_;
}

}   // namespace rayclock
