#pragma once
// The memory outside the chip, and its account.
#include <array>
#include <optional>
#include <vector>

#include "model/board/board_memory.hpp"
#include "model/core/dram_parts.hpp"
#include "model/mem/dram_channels.hpp"
#include "model/mem/frame_buffer.hpp"
#include "model/mem/ideal_memory.hpp"

namespace rayclock {

/// The memory's activity in a cycle of the chip.
enum class MemoryOutcome : std::uint8_t {
    busy,      ///< moved data
    latency,   ///< has requests, and waits for rows and columns
    refresh,
    starved,   ///< has no request
};
constexpr std::size_t memory_outcomes = 4;

/// Totals of the memory.
struct MemoryStats {
    std::uint64_t reads = 0;   ///< of 64 bytes, including the screen's
    /// Reads and writes that found their row open, and that found another row open.
    std::uint64_t row_hits = 0, row_conflicts = 0;
    std::uint64_t refreshes = 0;
    std::uint64_t writes = 0;                      ///< of 64 bytes, by the host and of pixels or hits
    std::uint64_t scanned = 0, pixel_writes = 0;   ///< reads by the screen; writes of pixels or hits
    /// The largest number of words for which the screen waited at the same time, since the beginning.
    std::uint32_t backlog = 0;
    /// Pixels that the screen of a board showed black, because their word came too late.
    std::uint32_t underruns = 0;
    friend MemoryStats operator-(MemoryStats a, const MemoryStats& b) {
        return {a.reads - b.reads,
                a.row_hits - b.row_hits,
                a.row_conflicts - b.row_conflicts,
                a.refreshes - b.refreshes,
                a.writes - b.writes,
                a.scanned - b.scanned,
                a.pixel_writes - b.pixel_writes,
                a.backlog,
                a.underruns - b.underruns};
    }
    friend bool operator==(const MemoryStats&, const MemoryStats&) = default;
};

/// The memory outside the chip, as a configuration names it, with the disturbance that a test adds. The same
/// class serves the model and the RTL of the chip. Answers must be accepted; at most one comes per cycle.
/// With dram=board it also accepts the chip's pixels, and is not always ready for them.
class Memory {
public:
    Memory(const Config& config, int khz, Disturbance disturbance);

    using Answer = IdealMemory::Answer;
    using PixelPlace = BoardMemory::PixelPlace;

    /// Prepares a frame with this picture. Call it once before the frame's cycle 0. With dram=board it takes
    /// time that counts neither in outcomes() nor in stats().
    void start_frame(std::uint32_t width, std::uint32_t height);
    /// True if the places of pixels matter: clock() then needs them.
    bool draws() const { return board_.has_value(); }
    bool accepts_pixel() const { return !board_ || board_->accepts_pixel(); }
    bool ready() const { return has_room() && ready_ && !(frame_buffer_ && frame_buffer_->goes_first()); }
    bool valid() const { return disturbed_ ? offer_ >= 0 : comes(); }
    Answer answer() const { return disturbed_ ? late_[std::size_t(offer_)].what : coming(); }

    /// Begins to write these lines for the host, in order. It writes one in every cycle in which the memory
    /// has room and accepts no request of the chip, so the chip's reads have priority.
    void write(const std::vector<std::uint32_t>& lines);
    /// True until all these lines are written.
    bool writes() const { return left_ > 0 || (dram_ && dram_->writes()); }

    /// One clock edge, with the accepted request (or null) and the number of pixels finished. With draws()
    /// at most one pixel is finished in a cycle, at `place`.
    void clock(const Answer* request, std::uint32_t pixels = 0, const PixelPlace* place = nullptr) {
        ++now_;
        if (!request && sleeping_)
            ++skipped_cycles_;
        else
            clock_awake(request, pixels, place);
    }
    /// Cycles by outcome.
    std::array<std::uint64_t, 8> outcomes() const;

    MemoryStats stats() const;

    std::uint64_t quiet_until() const {
        if (disturbed_ || left_ > 0 || board_) return 0;
        const std::uint64_t until = sleeping_ ? ~std::uint64_t(0)
                                    : dram_   ? dram_->quiet_until()
                                              : ideal_.quiet_until();
        return frame_buffer_ ? std::min(until, picture_is_quiet_until()) : until;
    }
    /// Has the effect of that many calls of clock(nullptr); must not go beyond quiet_until().
    void skip(std::uint64_t cycles);

    /// Returns the number of cycles, from the current one on, whose answers are known whatever is requested
    /// in them; at least 1.
    std::uint64_t known() const {
        if (disturbed_ || frame_buffer_ || board_ || left_ > 0) return 1;
        return dram_ ? dram_->known() : ideal_.known();
    }
    /// Calls `f(cycle, id)` for the answers of the next `cycles` cycles, at most known().
    template <class F> void each_known(std::uint64_t cycles, F&& f) const {
        if (dram_)
            dram_->each_known(cycles, f);
        else
            ideal_.each_known(cycles, f);
    }
    /// Has the effect of `cycles` calls of clock(nullptr), whatever is answered in them. Call it with known()
    /// above 1.
    void pass(std::uint64_t cycles);

private:
    struct DelayedAnswer {
        Answer what;
        std::uint64_t due = 0;
    };
    bool has_room() const { return dram_ ? dram_->ready() : board_ ? board_->ready() : ideal_.ready(); }
    bool answers() const { return dram_ ? dram_->valid() : board_ ? board_->answers() : ideal_.valid(); }
    /// True if there is an answer for the chip.
    bool comes() const { return answers() && !is_for_screen(); }
    bool is_for_screen() const { return frame_buffer_ && answers() && coming().id >= first_screen_id_; }
    MemoryStats board_totals() const;
    std::uint64_t picture_is_quiet_until() const;
    enum class BusUser { none, chip, picture, host };
    BusUser take_turn(const Answer* request, Dram::Answer& what);
    Answer coming() const {
        if (dram_) return {dram_->answer().id, dram_->answer().addr};
        if (board_) return {board_->answer().id, board_->answer().addr};
        return ideal_.answer();
    }
    void clock_awake(const Answer* request, std::uint32_t pixels, const PixelPlace* place);
    void catch_up();
    /// Returns the ideal memory's outcome in this cycle.
    MemoryOutcome ideal_outcome() const {
        return ideal_.valid()   ? MemoryOutcome::busy
               : ideal_.waits() ? MemoryOutcome::latency
                                : MemoryOutcome::starved;
    }
    void fall_asleep() {
        sleeping_ = !disturbed_ & !frame_buffer_ & dram_->is_idle() &
                    ((written_.empty() && hit_writes_ == 0) || !writes());
    }
    void disturb();

    std::uint32_t first_screen_id_;   // ids from here on belong to the frame buffer
    IdealMemory ideal_;
    // At most one of these two is present; the ideal memory needs neither.
    std::optional<DramChannels> dram_;
    std::optional<BoardMemory> board_;
    MemoryStats before_frames_;   // the board's counts during start_frame()
    std::optional<FrameBuffer> frame_buffer_;
    Disturbance disturbance_;
    Rng rng_;
    bool disturbed_, ready_ = true;
    std::uint64_t now_ = 0;
    // The DRAM is idle. It catches up on the cycles that it skips when it has work again.
    bool sleeping_ = false;
    std::uint64_t skipped_cycles_ = 0;
    std::uint64_t reads_ = 0, hit_writes_ = 0;   // of the chip
    std::array<std::uint64_t, memory_outcomes> ideal_outcomes_{};
    std::vector<std::uint32_t> written_;   // lines that the host writes; the last left_ of them remain
    std::size_t left_ = 0;
    std::uint64_t writes_ = 0;          // by the ideal memory
    std::vector<DelayedAnswer> late_;   // answers that the disturbance delays, oldest first
    int offer_ = -1;                    // the one of these on offer, or -1
};

}   // namespace rayclock
