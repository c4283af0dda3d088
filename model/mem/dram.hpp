#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/core/ring.hpp"
#include "model/mem/dram_banks.hpp"

namespace rayclock {

/// What the memory did in a cycle of the chip, the first that holds. `row`: a request waits for a row, its
/// turn or the controller. `refresh`: a request waits while a refresh is due or under way; one that nobody
/// waits for is `starved`.
enum class DramCause { busy, refresh, row, starved };
constexpr int dram_causes = 4;

struct DramStatistics {
    std::uint64_t reads = 0;   ///< requests whose last read was given; each, and each write, is one of the
                               ///< next three
    std::uint64_t writes = 0;
    std::uint64_t row_hits = 0, row_misses = 0,
                  row_conflicts = 0;   ///< row was open; bank was closed; another row was open
    std::uint64_t refreshes = 0;
    std::uint64_t bytes = 0;    ///< that requests asked for or wrote
    std::uint64_t bus_ps = 0;   ///< time with data on the bus
    friend bool operator==(const DramStatistics&, const DramStatistics&) = default;
};

/// A DRAM and its controller, in real time: chip cycle c begins at floor(c * 1e9 / khz) ps. Latency: see
/// DramPart; at most one request and one answer per chip cycle. The same class lies under the model and under
/// the RTL. It keeps only who asked for which address; whoever owns it reads and changes the memory image.
/// The chip only reads; writes are the host's. A write has no id and no answer; writes() tells when all are
/// done. It waits, opens rows and takes its turn as a read does.
///
/// An address counts words of 64 bytes: row : bank : word of the row, lowest last, so that addresses in
/// sequence stay in a row and go on in the next bank. If there are bank groups they go round these first, as
/// controllers do: row : bank in its group : word of the row : group. Rows never run out: whoever loads the
/// image checks capacity_bytes().
///
/// Rows stay open. Of the commands that could be given first, a read of an open row goes before others, then
/// the oldest request's (FR-FCFS). A row is not closed while a request for it waits, and a request that has
/// begun its reads finishes them. No request is overtaken by more than age_cap later ones: when that many
/// have gone before it, all later ones wait for it. When a refresh is due, requests wait: all banks are
/// precharged as soon as the gates allow, and refreshed.
///
/// The consumer takes an answer in the cycle it is on offer; ids tell requests apart, each at most once under
/// way.
class Dram {
public:
    Dram(const DramPart& part, int khz, int ids);

    struct Answer {
        std::uint32_t id = 0, addr = 0;   // addr: words of 64 bytes
        bool is_write = false;            // of a request; the id then says nothing
    };
    bool ready() const { return ready_; }
    bool valid() const { return valid_; }
    Answer answer() const { return answer_; }

    /// One clock edge of the chip: the request that was accepted in this cycle, null if none.
    void clock(const Answer* request);

    /// It has nothing to do: ready() and valid() stay as they are until a request comes.
    bool rests() const { return !valid_ & queue_.empty() & answers_.empty(); }
    /// A write waits, or its data are on their way.
    bool writes() const { return writing_ > 0 || (last_write_ps_ > time_); }
    /// Nothing is under way in it or on its bus: until a request comes it is starved.
    bool idle() const { return queue_.empty() && data_.empty() && answers_.empty() && !valid_; }
    /// The chip cycle it is in, from 0.
    std::uint64_t now() const { return now_; }
    /// Until this cycle ready() and valid() stay as they are, unless a request comes in; then they may
    /// change.
    std::uint64_t quiet_until() const;
    /// The same as so many clock(nullptr), and not beyond quiet_until().
    void skip(std::uint64_t cycles);

    const DramStatistics& statistics() const { return statistics_; }
    DramCause last_cause() const { return last_cause_; }   ///< of the cycle that clock() ended
    /// Cycles with this cause; together they are now().
    std::uint64_t cycles(DramCause cause) const { return causes_[std::size_t(cause)]; }

    /// A command as it was given, for tests.
    struct Issued {
        std::int64_t clock;   // of the DRAM
        DramCommand command;
        int bank;
        std::uint32_t row;
        friend bool operator==(const Issued&, const Issued&) = default;
    };
    void record(std::vector<Issued>* log) { log_ = log; }

private:
    static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
    enum class Kind { none, hit, miss, conflict };
    struct Entry {
        Answer what;
        std::int64_t arrival = 0;   // first clock of the DRAM at which the controller knows of it
        std::uint32_t row = 0;
        int bank = 0, left = 0, overtaken = 0;   // left: reads still to be given
        Kind kind = Kind::none;                  // of its first command
    };
    struct Choice {
        std::int64_t clock = std::numeric_limits<std::int64_t>::max();
        DramCommand command = DramCommand::refresh;
        int bank = 0;
        int entry = -1;   // in queue_, -1: none
    };
    struct Due {
        Answer what;
        std::uint64_t cycle = 0;
    };
    struct Data {
        std::uint64_t from = 0, until = 0;   // ps
    };

    static DramCommand column_command(const Entry& entry) {
        return entry.what.is_write ? DramCommand::write : DramCommand::read;
    }
    std::uint64_t begin_of(std::uint64_t cycle) const;   // ps
    std::uint64_t cycle_from(std::uint64_t ps) const;    // first that begins at or after
    void accept(const Answer& request);
    void run();    // events until time_
    void plan();   // next command and next event
    void consider(DramCommand command, int bank, int entry);
    void choose();   // among the requests
    void issue();
    void transfer(Entry& entry);
    DramCause cause(std::uint64_t begin);

    DramPart part_;
    std::uint64_t khz_, tck_;
    std::int64_t trefi_;       // clocks, rounded down
    std::int64_t clock_ = 0;   // of the last event
    DramBanks banks_;
    std::vector<Entry> queue_;   // oldest first
    std::size_t arrived_ = 0;    // of them the controller knows
    int current_ = -1;           // has begun its reads
    std::int64_t refresh_at_;    // when the next one is due
    bool refreshing_ = false;    // due and not given
    Choice choice_;
    std::uint64_t event_ps_ = 0;   // next command, arrival or refresh due
    Ring<Due> answers_;            // data given or on their way; in order, as the bus is
    Ring<Data> data_;              // on the bus from now on
    Data refresh_{};               // the last refresh, from when it was due
    std::vector<char> under_way_;
    int writing_ = 0;                               // writes in the queue
    std::uint64_t last_write_ps_ = 0;               // end of the last data written
    std::uint64_t now_ = 0, time_ = 0, rest_ = 0;   // time_: begin of now_, rest_ / khz ps more
    bool ready_ = true, valid_ = false, waiting_ = false, busy_ = false;
    Answer answer_{};
    DramCause last_cause_ = DramCause::starved;
    DramStatistics statistics_;
    std::array<std::uint64_t, dram_causes> causes_{};
    std::vector<Issued>* log_ = nullptr;
};

}   // namespace rayclock
