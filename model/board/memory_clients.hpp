#pragma once
// The arbiter of the clients of the board's memory, with its controller.
#include <cstdint>

#include "model/board/sdram.hpp"

namespace rayclock {

/// What the clients offer in a cycle. Addresses are numbers of lines.
struct ClientOffers {
    struct Chip {
        bool valid = false;
        std::uint32_t id = 0, addr = 0;
    } chip;   ///< reads
    struct Scan {
        bool valid = false;
        std::uint32_t addr = 0;
        bool urgent = false;
    } scan;   ///< reads
    struct Pixels {
        bool valid = false;
        std::uint32_t addr = 0;
    } pixels;   ///< writes
    struct Host {
        bool valid = false, is_write = false;
        std::uint32_t addr = 0;
    } host;
};

/// Grants one client per cycle, and sends the controller's beats back to the clients. Mirror of
/// rtl/board/memory/rc_board_memory.sv, which states the priorities. It has no data: an answer to the chip is
/// an id, a beat is a flag.
///
/// A request of the chip is held here until it is granted. The other clients hold their own requests: they
/// offer the same request up to the cycle in which it is accepted, the one after the grant.
class MemoryClients {
public:
    /// id_bits: width of the chip's ids.
    MemoryClients(const SdramClocks& clocks, int id_bits);

    /// Returns the clients whose request is accepted in this cycle, if they have one.
    struct Ready {
        bool chip = false, scan = false, pixels = false, host = false;
        friend bool operator==(const Ready&, const Ready&) = default;
    };
    const Ready& ready() const { return ready_; }

    /// As Sdram::align(). It also gives the chip the next turn.
    void align() { sdram_.align(), aligns_ = true; }

    bool init_done() const { return sdram_.init_done(); }
    /// The answer to the chip in this cycle; it is valid for one cycle.
    bool answers() const { return answers_; }
    std::uint32_t answer_id() const { return answer_id_; }
    bool scan_beat() const { return reads(of_scan); }        ///< a beat of the scan-out's oldest line
    bool host_beat() const { return reads(of_host); }        ///< a beat of the host's oldest line
    bool pixels_next() const { return writes(of_pixels); }   ///< a beat of the pixels' data is taken
    bool host_next() const { return writes(of_host); }       ///< a beat of the host's data is taken

    /// One clock edge, with the offers of this cycle.
    void clock(const ClientOffers& offers);

    /// As in Sdram: cycles in which nothing changes without an offer.
    std::uint64_t quiet_cycles() const { return answers_ || chip_.valid ? 0 : sdram_.quiet_cycles(); }
    void skip(std::uint64_t cycles);

    const Sdram& sdram() const { return sdram_; }
    /// True if a request of the chip is held, or the controller holds a request.
    bool holds() const { return chip_.valid || sdram_.holds(); }

private:
    enum Client : std::uint32_t { of_chip, of_scan, of_pixels, of_host };
    static constexpr int host_cap = 15;   // requests that may overtake a waiting host

    bool is_of(const Sdram::Beat& beat, Client client) const {
        return beat.valid && beat.tag >> id_bits_ == client;
    }
    bool reads(Client client) const { return is_of(sdram_.read_beat(), client); }
    bool writes(Client client) const { return is_of(sdram_.write_beat(), client); }

    Sdram sdram_;
    int id_bits_;
    ClientOffers::Chip chip_;   // held
    Ready ready_{.chip = true};
    bool pixels_turn_ = false, aligns_ = false;
    int overtaken_ = 0;
    bool answers_ = false;
    std::uint32_t answer_id_ = 0;
};

}   // namespace rayclock
