// Priorities of the clients.
#include "model/board/memory_clients.hpp"

namespace rayclock {

MemoryClients::MemoryClients(const SdramClocks& clocks, int id_bits) : sdram_(clocks), id_bits_(id_bits) {}

void MemoryClients::clock(const ClientOffers& o) {
    // A client that was granted in the last cycle still offers the same request.
    const bool of_scan_out = o.scan.valid && !ready_.scan, of_writer = o.pixels.valid && !ready_.pixels,
               of_link = o.host.valid && !ready_.host;
    const bool host_is_due = overtaken_ == host_cap, free = sdram_.ready(),
               open = free && !(of_link && host_is_due), urgent = of_scan_out && o.scan.urgent,
               none = !chip_.valid && !of_writer;
    const bool chip = chip_.valid && open && !urgent && !(of_writer && pixels_turn_),
               pixels = of_writer && open && !urgent && !(chip_.valid && !pixels_turn_),
               scan = of_scan_out && open && (urgent || none),
               host = of_link && free && (host_is_due || (none && !of_scan_out));
    answers_ = reads(of_chip) && sdram_.read_beat().last;
    if (reads(of_chip)) answer_id_ = sdram_.read_beat().tag & ((1u << id_bits_) - 1);

    if (aligns_)
        pixels_turn_ = false;
    else if (chip || pixels)
        pixels_turn_ = chip;
    aligns_ = false;
    if (!of_link || host)
        overtaken_ = 0;
    else
        overtaken_ += chip || scan || pixels;

    const auto tag = [&](Client client, std::uint32_t id) { return std::uint32_t(client) << id_bits_ | id; };
    Sdram::Request request;
    if (chip) request = {false, chip_.addr, tag(of_chip, chip_.id)};
    if (scan) request = {false, o.scan.addr, tag(of_scan, 0)};
    if (pixels) request = {true, o.pixels.addr, tag(of_pixels, 0)};
    if (host) request = {o.host.is_write, o.host.addr, tag(of_host, 0)};
    sdram_.clock(chip || scan || pixels || host ? &request : nullptr);

    if (chip)
        chip_.valid = false;
    else if (ready_.chip)
        chip_ = o.chip;
    ready_ = {!chip_.valid, scan, pixels, host};
}

void MemoryClients::skip(std::uint64_t cycles) {
    if (cycles > 0) overtaken_ = 0;
    sdram_.skip(cycles);
}

}   // namespace rayclock
