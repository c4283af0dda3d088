#pragma once
#include <array>
#include <optional>
#include <vector>

#include "model/mem/dram_channels.hpp"
#include "model/core/dram_parts.hpp"
#include "model/mem/frame_buffer.hpp"
#include "model/mem/memport.hpp"

namespace rayclock {

/// What the memory did in a cycle of the chip.
enum class MemoryDeed : std::uint8_t {
    busy,      ///< moved data
    latency,   ///< has requests, and waits for rows and columns
    refresh,
    starved,   ///< has no request
};
constexpr std::size_t memory_deeds = 4;

/// What the memory has done.
struct MemoryStats {
    std::uint64_t reads = 0;                         ///< of 64 bytes, the screen's too
    std::uint64_t row_hits = 0, row_conflicts = 0;   ///< of these and the writes: the row was open; another
                                                     ///< row was
    std::uint64_t refreshes = 0;
    std::uint64_t writes = 0;                      ///< of 64 bytes, by the host and of pixels
    std::uint64_t scanned = 0, pixel_writes = 0;   ///< of the reads, the screen's; of the writes, pixels'
    std::uint32_t backlog = 0;   ///< most words that the screen waited for at once, from the beginning
    friend MemoryStats operator-(MemoryStats a, const MemoryStats& b) {
        return {a.reads - b.reads,
                a.row_hits - b.row_hits,
                a.row_conflicts - b.row_conflicts,
                a.refreshes - b.refreshes,
                a.writes - b.writes,
                a.scanned - b.scanned,
                a.pixel_writes - b.pixel_writes,
                a.backlog};
    }
    friend bool operator==(const MemoryStats&, const MemoryStats&) = default;
};

/// The memory beside the chip as a configuration names it, with the traffic that a test puts on it. The same
/// class lies under the model and under the RTL. Answers are always taken; at most one comes in a cycle.
class Memory {
public:
    Memory(const Config& config, int khz, Traffic traffic);

    using Answer = Memport::Answer;
    bool ready() const { return has_room() && ready_ && !(frame_buffer_ && frame_buffer_->goes_first()); }
    bool valid() const { return disturbed_ ? offer_ >= 0 : comes(); }
    Answer answer() const { return disturbed_ ? late_[std::size_t(offer_)].what : coming(); }

    /// The host begins to write these lines, one after the other: one in every cycle in which the memory has
    /// room for it and takes no request of the chip. So the chip's reads go first.
    void write(const std::vector<std::uint32_t>& lines);
    /// Some of them are not written yet.
    bool writes() const { return left_ > 0 || (dram_ && dram_->writes()); }

    /// One clock edge: the request that was accepted, null if none, and how many pixels were finished.
    void clock(const Answer* request, std::uint32_t pixels = 0) {
        ++now_;
        if (!request && sleeping_)
            ++owed_;
        else
            work(request, pixels);
    }
    /// Cycles by deed.
    std::array<std::uint64_t, 8> deeds() const;

    MemoryStats stats() const;

    std::uint64_t quiet_until() const {
        if (disturbed_ || left_ > 0) return 0;
        const std::uint64_t until = sleeping_ ? ~std::uint64_t(0)
                                    : dram_   ? dram_->quiet_until()
                                              : ideal_.quiet_until();
        return frame_buffer_ ? std::min(until, picture_is_quiet_until()) : until;
    }
    /// The same as so many clock(nullptr), not beyond quiet_until().
    void skip(std::uint64_t cycles);

private:
    struct Late {
        Answer what;
        std::uint64_t due = 0;
    };
    bool has_room() const { return dram_ ? dram_->ready() : ideal_.ready(); }
    bool answers() const { return dram_ ? dram_->valid() : ideal_.valid(); }
    /// An answer for the chip.
    bool comes() const { return answers() && !is_for_screen(); }
    bool is_for_screen() const { return frame_buffer_ && answers() && coming().id >= first_screen_id_; }
    std::uint64_t picture_is_quiet_until() const;
    enum class Turn { nobody, chip, picture, host };
    Turn take_turn(const Answer* request, Dram::Answer& what);
    Answer coming() const {
        return dram_ ? Answer{dram_->answer().id, dram_->answer().addr} : ideal_.answer();
    }
    void work(const Answer* request, std::uint32_t pixels);
    void pay();
    void disturb();

    std::uint32_t first_screen_id_;   // ids from here on are the frame buffer's
    Memport ideal_;
    std::optional<DramChannels> dram_;   // what lies there, if not the ideal memory
    std::optional<FrameBuffer> frame_buffer_;
    Traffic traffic_;
    Rng rng_;
    bool disturbed_, ready_ = true;
    std::uint64_t now_ = 0;
    bool sleeping_ = false;    // the DRAM has nothing to do, and is told of the cycles that pass when it has
                               // again:
    std::uint64_t owed_ = 0;   // so many
    std::uint64_t reads_ = 0;
    std::array<std::uint64_t, memory_deeds> ideal_deeds_{};
    std::vector<std::uint32_t> written_;   // lines that the host writes, and how many of them are left
    std::size_t left_ = 0;
    std::uint64_t writes_ = 0;   // of the ideal memory
    std::vector<Late> late_;     // answers that traffic holds back, oldest first
    int offer_ = -1;             // of these, the one on offer
};

}   // namespace rayclock
