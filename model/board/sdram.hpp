#pragma once
// The controller of the board's SDRAM, cycle by cycle.
#include <array>
#include <cstdint>
#include <vector>

#include "model/board/sdram_parts.hpp"

namespace rayclock {

/// A command on the pins, with the code {RAS, CAS, WE}, active low.
enum class SdramCommand : std::uint8_t {
    mode = 0,
    refresh = 1,
    precharge = 2,
    activate = 3,
    write = 4,
    read = 5,
    nop = 7
};

/// The pins of a cycle, without data and masks. Without a command `bank` and `address` are 0, except that the
/// RTL drives an address throughout the initialisation.
struct SdramPins {
    bool cke = true, selected = false;   ///< CKE; chip select, active high here
    SdramCommand command = SdramCommand::nop;
    std::uint32_t bank = 0, address = 0;
    bool drives = false;   ///< the controller drives DQ
};

/// The controller of a 16-bit SDRAM: when it accepts requests, gives commands and moves beats. Mirror of
/// rtl/board/memory/rc_sdram.sv, which explains its decisions and its timing. It has no data.
///
/// A request is a line of 64 bytes, by its number, with a tag. Requests are served in order. All outputs of a
/// cycle are functions of the state, so they are known before the cycle's request.
class Sdram {
public:
    explicit Sdram(const SdramClocks& clocks);

    struct Request {
        bool is_write = false;
        std::uint32_t line = 0, tag = 0;
    };
    struct Beat {
        bool valid = false, last = false;   ///< last: of a line
        std::uint32_t tag = 0;
        friend bool operator==(const Beat&, const Beat&) = default;
    };
    bool init_done() const { return runs_; }
    bool ready() const { return runs_ && !next_valid_; }
    /// The beat of write data that is taken in this cycle.
    Beat write_beat() const;
    /// The beat of read data on offer in this cycle.
    const Beat& read_beat() const { return reads_.back(); }
    const SdramPins& pins() const { return pins_; }

    /// One clock edge, with the request accepted in this cycle, or null. Accept only if ready().
    void clock(const Request* request);

    /// Makes a refresh due in this cycle, and counts the interval to the next one from here. Call it before
    /// clock().
    void align() { aligns_ = true; }

    bool holds() const { return current_valid_; }   ///< a request that is not finished
    /// True while a refresh is due or in progress.
    bool refreshing() const { return due_ || refresh_left_ > 0; }

    /// True if no request is held, no beat is in flight, and no refresh is due.
    bool is_quiet() const;
    /// Returns the number of cycles, from 0, in which a quiet controller stays so without a request.
    std::uint64_t quiet_cycles() const { return is_quiet() ? std::uint64_t(refi_) : 0; }
    /// Has the effect of that many calls of clock(nullptr), at most quiet_cycles().
    void skip(std::uint64_t cycles);

    std::uint64_t refreshes() const { return refreshes_; }   ///< since the initialisation
    /// Lines that found their row open, and lines that found another row open, of those that have begun.
    std::uint64_t row_hits() const { return row_hits_; }
    std::uint64_t row_conflicts() const { return row_conflicts_; }

private:
    struct Held {   // a request, decoded
        bool is_write = false;
        std::uint32_t row = 0, bank = 0, column = 0, tag = 0;
        bool activated = false, precharged = false;   // for it
    };
    struct Bank {
        bool open = false;
        std::uint32_t row = 0;
        int wait = 0, precharge = 0;   // clocks until an activation or column command; until a precharge
    };
    struct Decision {
        SdramCommand command = SdramCommand::nop;
        std::uint32_t bank = 0, row = 0;
        bool all = false;   // a precharge of all banks
    };
    static constexpr int burst = 8;

    Held decode(const Request& request) const;
    Decision decide() const;
    Decision decide_row(const Held& request) const;
    Decision decide_refresh() const;
    void compare_row();
    bool reads_or_writes() const {
        return decision_.command == SdramCommand::read || decision_.command == SdramCommand::write;
    }
    void initialise();
    void move_beats();
    void change_banks();
    void count_lines();
    void take(const Request* request);
    SdramPins pins_of_decision() const;

    SdramClocks clocks_;
    bool runs_ = false;
    int init_wait_, init_step_ = 0;
    Held current_, next_;
    bool current_valid_ = false, next_valid_ = false;
    int bursts_ = 0;                       // column commands given of the current line
    bool known_ = false, equal_ = false;   // the selected request's row was compared; it is the bank's last
    std::array<Bank, 4> banks_{};
    int turn_ = 0, refi_;
    bool due_ = false, aligns_ = false;
    int beats_ = 0;   // beats of the burst after this cycle's
    bool beats_write_ = false, beats_last_ = false;
    std::uint32_t beats_tag_ = 0;
    std::vector<Beat> reads_;   // from the decision to the data
    Decision decision_;         // of this cycle
    SdramPins pins_;
    int refresh_left_ = 0;   // clocks of the refresh in progress
    std::uint64_t refreshes_ = 0, row_hits_ = 0, row_conflicts_ = 0;
};

}   // namespace rayclock
