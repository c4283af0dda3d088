// Priorities of the clients.
#include "model/board/memory_clients.hpp"

namespace rayclock {

MemoryClients::MemoryClients(const SdramClocks& clocks, int id_bits) : sdram_(clocks), id_bits_(id_bits) {}

MemoryClients::Ready MemoryClients::ready(const ClientOffers& o) const {
    const bool host_is_due = overtaken_ == host_cap, free = sdram_.ready(),
               open = free && !(o.host.valid && host_is_due), urgent = o.scan.valid && o.scan.urgent,
               none = !o.chip.valid && !o.pixels.valid;
    Ready r;
    r.chip = open && !urgent && !(o.pixels.valid && pixels_turn_);
    r.pixels = open && !urgent && !(o.chip.valid && !pixels_turn_);
    r.scan = open && (o.scan.urgent || none);
    r.host = free && (host_is_due || (none && !o.scan.valid));
    return r;
}

void MemoryClients::clock(const ClientOffers& o) {
    const Ready r = ready(o);
    const bool chip = o.chip.valid && r.chip, scan = o.scan.valid && r.scan,
               pixels = o.pixels.valid && r.pixels, host = o.host.valid && r.host;
    answers_ = reads(of_chip) && sdram_.read_beat().last;
    if (reads(of_chip)) answer_id_ = sdram_.read_beat().tag & ((1u << id_bits_) - 1);

    if (aligns_)
        pixels_turn_ = false;
    else if (chip || pixels)
        pixels_turn_ = chip;
    aligns_ = false;
    if (!o.host.valid || host)
        overtaken_ = 0;
    else
        overtaken_ += chip || scan || pixels;

    const auto tag = [&](Client client, std::uint32_t id) { return std::uint32_t(client) << id_bits_ | id; };
    Sdram::Request request;
    if (chip) request = {false, o.chip.addr, tag(of_chip, o.chip.id)};
    if (scan) request = {false, o.scan.addr, tag(of_scan, 0)};
    if (pixels) request = {true, o.pixels.addr, tag(of_pixels, 0)};
    if (host) request = {o.host.is_write, o.host.addr, tag(of_host, 0)};
    sdram_.clock(chip || scan || pixels || host ? &request : nullptr);
}

void MemoryClients::skip(std::uint64_t cycles) {
    if (cycles > 0) overtaken_ = 0;
    sdram_.skip(cycles);
}

}   // namespace rayclock
