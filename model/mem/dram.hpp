#pragma once
// A DRAM with its controller, in real time.
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/core/ring.hpp"
#include "model/mem/dram_banks.hpp"

namespace rayclock {

/// The DRAM's activity in a cycle of the chip, the first that holds. `row`: a request waits for a row, its
/// turn or the controller. `refresh`: a request waits while a refresh is due or in progress. Without a
/// waiting request the cycle is `starved`.
enum class DramCause { busy, refresh, row, starved };
constexpr int dram_causes = 4;

struct DramStatistics {
    /// Requests whose last read was given. Each of these, and each write, counts in one of the next three.
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
    /// The row was open; the bank was closed; another row was open.
    std::uint64_t row_hits = 0, row_misses = 0, row_conflicts = 0;
    std::uint64_t refreshes = 0;
    std::uint64_t bytes = 0;    ///< requested or written
    std::uint64_t bus_ps = 0;   ///< time with data on the bus
    friend bool operator==(const DramStatistics&, const DramStatistics&) = default;
};

/// A DRAM and its controller, in real time: chip cycle c begins at floor(c * 1e9 / khz) ps. DramPart gives
/// its latency; it accepts at most one request and gives at most one answer per chip cycle. The same class
/// serves the model and the RTL. It holds ids and addresses only; its owner reads and changes the memory
/// image. The chip only reads; writes come from the host. A write has no id and no answer, but waits, opens
/// rows and takes its turn as a read does. writes() is false when all are done.
///
/// An address counts words of 64 bytes: row : bank : word of the row, lowest last. So consecutive addresses
/// stay in a row and continue in the next bank. With bank groups they go round the groups first, as
/// controllers do: row : bank in its group : word of the row : group. The class does not check the rows'
/// number: the loader of the image checks capacity_bytes().
///
/// Rows stay open. Among the commands that can be given first, a read of an open row has priority, then the
/// oldest request's command (FR-FCFS). A row stays open while a request for it waits, and a request that has
/// begun its reads finishes them. At most age_cap later requests overtake a request; then all later ones wait
/// for it. When a refresh is due, requests wait: all banks are precharged as soon as the gates allow, and
/// refreshed.
///
/// The consumer must accept an answer in the cycle in which it is on offer. Each id may be in flight once.
class Dram {
public:
    Dram(const DramPart& part, int khz, int ids);

    struct Answer {
        std::uint32_t id = 0, addr = 0;   // addr: words of 64 bytes
        bool is_write = false;            // of a request; the id is then ignored
    };
    bool ready() const { return ready_; }
    bool valid() const { return valid_; }
    Answer answer() const { return answer_; }

    /// One clock edge of the chip, with the request accepted in this cycle, or null.
    void clock(const Answer* request);

    /// True if idle: ready() and valid() stay the same until a request comes.
    bool is_idle() const { return !valid_ & queue_.empty() & answers_.empty(); }
    /// True if a write waits or its data are in flight.
    bool writes() const { return writing_ > 0 || (last_write_ps_ > time_); }
    /// True if no request and no data are in flight: it stays starved until a request comes.
    bool idle() const { return queue_.empty() && data_.empty() && answers_.empty() && !valid_; }
    /// The current chip cycle, from 0.
    std::uint64_t now() const { return now_; }
    /// Returns a cycle before which ready() and valid() stay the same unless a request comes.
    std::uint64_t quiet_until() const;
    /// Has the effect of that many calls of clock(nullptr); must not go beyond quiet_until().
    void skip(std::uint64_t cycles);

    /// Has the effect of that many calls of clock(nullptr). Events and answers may occur in them. Stops early
    /// when the DRAM becomes idle. Jumps over cycles in which nothing changes.
    void pass(std::uint64_t cycles);

    /// Returns the number of cycles, from the current one on, whose answers do not depend on requests made in
    /// them. No answer comes earlier than `answer_ps_` after the next event, or after the arrival of a
    /// request that this cycle accepts.
    std::uint64_t known() const {
        const std::uint64_t arrival = period_ + std::uint64_t(part_.request_ps),
                            next = queue_.empty() ? arrival : std::min(arrival, event_ps_ - time_);
        return (next - 1 + answer_ps_) * khz_ / giga + 1;
    }
    /// Calls `f(cycle, id)` for the answers of the next `cycles` cycles, at most known().
    template <class F> void each_known(std::uint64_t cycles, F&& f) const {
        if (valid_) f(std::size_t(0), answer_.id);
        std::uint64_t at = now_ + 1;   // at most one answer in a cycle
        for (std::size_t i = 0; i < answers_.size(); ++i, ++at) {
            at = std::max(at, answers_.at(i).cycle);
            if (at >= now_ + cycles) return;
            f(std::size_t(at - now_), answers_.at(i).what.id);
        }
    }

    const DramStatistics& statistics() const { return statistics_; }
    DramCause last_cause() const { return last_cause_; }   ///< of the cycle that clock() ended
    /// Cycles with this cause; all causes together give now().
    std::uint64_t cycles(DramCause cause) const { return causes_[std::size_t(cause)]; }

    /// A command as issued, for tests.
    struct Issued {
        std::int64_t clock;   // of the DRAM
        DramCommand command;
        int bank;
        std::uint32_t row;
        friend bool operator==(const Issued&, const Issued&) = default;
    };
    void record(std::vector<Issued>* log) { log_ = log; }

private:
    static constexpr std::uint64_t giga = 1'000'000'000;   // ps * kHz
    static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
    enum class RowOutcome { none, hit, miss, conflict };
    struct Entry {
        Answer what;
        std::int64_t arrival = 0;   // first clock of the DRAM at which the controller sees it
        std::uint32_t row = 0;
        int bank = 0, left = 0, overtaken = 0;       // left: reads not yet given
        RowOutcome row_outcome = RowOutcome::none;   // of its first command
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
    std::uint64_t begin_of(std::uint64_t cycle) const;   // start in ps
    std::uint64_t cycle_from(std::uint64_t ps) const;    // first cycle that begins at or after
    std::uint64_t still(std::uint64_t cycles) const;
    void accept(const Answer& request);
    void run();    // handles events until time_
    void plan();   // next command and next event
    void consider(DramCommand command, int bank, int entry);
    void choose();   // among the requests
    void issue();
    void transfer(Entry& entry);
    DramCause cause(std::uint64_t begin);

    DramPart part_;
    std::uint64_t khz_, tck_;
    std::uint64_t period_;      // of the chip's clock, rounded down
    std::uint64_t answer_ps_;   // from a read to its answer
    std::int64_t trefi_;        // clocks, rounded down
    std::int64_t clock_ = 0;    // of the last event
    DramBanks banks_;
    std::vector<Entry> queue_;   // oldest first
    std::size_t arrived_ = 0;    // number of these that the controller sees
    int current_ = -1;           // request that has begun its reads, or -1
    std::int64_t refresh_at_;    // when the next one is due
    bool refreshing_ = false;    // a refresh is due and not given
    Choice choice_;
    std::uint64_t event_ps_ = 0;   // next command, arrival or due refresh
    Ring<Due> answers_;            // data given or in flight; in order, as on the bus
    Ring<Data> data_;              // on the bus from now on
    Data refresh_{};               // the last refresh, from its due time
    std::vector<char> under_way_;
    int writing_ = 0;                               // writes in the queue
    std::uint64_t last_write_ps_ = 0;               // end of the last write's data
    std::uint64_t now_ = 0, time_ = 0, rest_ = 0;   // now_ begins at time_ + rest_ / khz ps
    bool ready_ = true, valid_ = false, waiting_ = false, busy_ = false;
    Answer answer_{};
    DramCause last_cause_ = DramCause::starved;
    DramStatistics statistics_;
    std::array<std::uint64_t, dram_causes> causes_{};
    std::vector<Issued>* log_ = nullptr;
};

}   // namespace rayclock
