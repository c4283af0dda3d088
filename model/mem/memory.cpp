// Arbitrates between chip, picture and host, and applies the tests' disturbance.
#include "model/mem/memory.hpp"

namespace rayclock {

namespace {
// In the order of DramCause.
constexpr MemoryOutcome outcome_of[] = {MemoryOutcome::busy, MemoryOutcome::refresh, MemoryOutcome::latency,
                                        MemoryOutcome::starved};
}   // namespace

Memory::Memory(const Config& config, int khz, Disturbance disturbance)
    : first_screen_id_(1U << config.mem_id_bits()),
      ideal_(config, int(first_screen_id_) + FrameBuffer::ids),
      disturbance_(disturbance),
      rng_(disturbance.seed * 16 + 1),
      disturbed_(!disturbance.none()) {
    if (config.is_board()) {
        board_.emplace(config, khz);
        return;
    }
    if (const DramPart* part = config.dram_part())
        dram_.emplace(*part, config.dram_channels, khz, int(first_screen_id_) + FrameBuffer::ids);
    if (config.scan_out || (config.pixel_writes && !config.writes_hits())) frame_buffer_.emplace(config, khz);
}

void Memory::write(const std::vector<std::uint32_t>& lines) {
    if (board_) return;   // the host writes over its link before the frame, in time that does not count
    written_.erase(written_.begin(), written_.end() - std::ptrdiff_t(left_));
    written_.insert(written_.end(), lines.begin(), lines.end());
    left_ = written_.size();
    if (left_ > 0 && dram_) catch_up(), sleeping_ = false;
}

/// Chooses the next request: the chip's if it was accepted, then the picture's, then the host's.
Memory::BusUser Memory::take_turn(const Answer* request, Dram::Answer& what) {
    if (request) {
        what = {request->id, request->addr, request->is_write};
        return BusUser::chip;
    }
    if (!has_room()) return BusUser::none;
    if (frame_buffer_ && frame_buffer_->wants_read()) {
        const FrameBuffer::Read read = frame_buffer_->read();
        what = {first_screen_id_ + read.id, read.addr};
        return BusUser::picture;
    }
    if (frame_buffer_ && frame_buffer_->wants_write()) {
        what = {0, frame_buffer_->write(), true};
        return BusUser::picture;
    }
    if (left_ == 0) return BusUser::none;
    what = {0, written_[written_.size() - left_--], true};
    return BusUser::host;
}

void Memory::clock_awake(const Answer* request, std::uint32_t pixels, const PixelPlace* place) {
    if (is_for_screen()) frame_buffer_->answered(coming().id - first_screen_id_);
    Dram::Answer asked;
    const bool had_room = has_room();
    const BusUser user = take_turn(request, asked);
    const bool is_used = user != BusUser::none;
    if (user == BusUser::chip) ++(asked.is_write ? hit_writes_ : reads_);
    if (disturbed_) {
        if (offer_ >= 0) late_.erase(late_.begin() + offer_);
        if (comes())
            late_.push_back(
                {coming(),
                 now_ + std::uint64_t(disturbance_.jitter > 0 ? rng_.below(disturbance_.jitter + 1) : 0)});
    }
    if (board_) {
        const BoardMemory::Line line{asked.id, asked.addr};
        board_->clock(is_used ? &line : nullptr, place);
    } else if (dram_) {
        catch_up();
        dram_->clock(is_used ? &asked : nullptr);
        fall_asleep();
    } else {
        const bool writes = is_used && asked.is_write;
        if (writes) ideal_.write();
        writes_ += writes;
        ++ideal_outcomes_[std::size_t(ideal_outcome())];
        const Answer read{asked.id, asked.addr};
        ideal_.clock(is_used && !writes ? &read : nullptr);
    }
    if (frame_buffer_) frame_buffer_->clock(pixels, user == BusUser::picture, had_room);
    if (disturbed_) disturb();
}

std::uint64_t Memory::picture_is_quiet_until() const {
    if (frame_buffer_->wants_read() || frame_buffer_->wants_write() || is_for_screen()) return 0;
    const std::uint64_t quiet = frame_buffer_->quiet();
    return quiet > ~std::uint64_t(0) - now_ ? quiet : now_ + quiet;
}

void Memory::catch_up() {
    if (skipped_cycles_ > 0) dram_->skip(skipped_cycles_);
    skipped_cycles_ = 0;
}

/// Offers the oldest answer that is due.
void Memory::disturb() {
    offer_ = -1;
    for (std::size_t i = 0; i < late_.size() && offer_ < 0; ++i)
        if (late_[i].due <= now_) offer_ = int(i);
    ready_ = disturbance_.stall_percent == 0 || rng_.below(100) >= disturbance_.stall_percent;
}

void Memory::skip(std::uint64_t cycles) {
    now_ += cycles;
    if (frame_buffer_) frame_buffer_->skip(cycles, has_room());
    if (sleeping_) {
        skipped_cycles_ += cycles;
    } else if (dram_) {
        dram_->skip(cycles);
    } else {
        ideal_outcomes_[std::size_t(ideal_outcome())] += cycles;
        ideal_.skip(cycles);
    }
}

void Memory::pass(std::uint64_t cycles) {
    now_ += cycles;
    while (!dram_ && cycles > 0) {
        const bool comes = ideal_.valid();
        const std::uint64_t alike = comes ? 1 : std::min(cycles, ideal_.quiet_until() - ideal_.now());
        ideal_outcomes_[std::size_t(ideal_outcome())] += alike;
        if (comes)
            ideal_.clock(nullptr);
        else
            ideal_.skip(alike);
        cycles -= alike;
    }
    while (!sleeping_ && cycles > 0) {
        const std::uint64_t before = dram_->now();
        dram_->pass(cycles);
        cycles -= dram_->now() - before;
        fall_asleep();
    }
    skipped_cycles_ += cycles;
}

std::array<std::uint64_t, 8> Memory::outcomes() const {
    std::array<std::uint64_t, 8> sums{};
    for (std::size_t i = 0; i < memory_outcomes; ++i) {
        if (board_)
            sums[i] = board_->cycles(BoardMemory::Outcome(i));
        else if (dram_)
            sums[std::size_t(outcome_of[i])] = dram_->cycles(DramCause(i));
        else
            sums[i] = ideal_outcomes_[i];
    }
    sums[std::size_t(MemoryOutcome::starved)] += skipped_cycles_;
    return sums;
}

void Memory::start_frame(std::uint32_t width, std::uint32_t height) {
    if (!board_) return;
    const MemoryStats counted = stats();
    board_->start(width, height);
    before_frames_ = board_totals() - counted;
}

MemoryStats Memory::board_totals() const {
    const Sdram& sdram = board_->sdram();
    MemoryStats s;
    s.reads = board_->reads() + board_->scanned();
    s.row_hits = sdram.row_hits(), s.row_conflicts = sdram.row_conflicts(), s.refreshes = sdram.refreshes();
    s.writes = board_->written();
    s.scanned = board_->scanned(), s.pixel_writes = board_->written();
    s.underruns = board_->underruns();
    return s;
}

MemoryStats Memory::stats() const {
    if (board_) return board_totals() - before_frames_;
    const std::uint64_t scanned = frame_buffer_ ? frame_buffer_->scanned() : 0,
                        pixels = frame_buffer_ ? frame_buffer_->written() : hit_writes_;
    const std::uint32_t backlog = frame_buffer_ ? frame_buffer_->backlog() : 0;
    if (!dram_) return {reads_ + scanned, 0, 0, 0, writes_, scanned, pixels, backlog};
    const DramStatistics s = dram_->statistics();
    return {reads_ + scanned, s.row_hits, s.row_conflicts, s.refreshes, s.writes, scanned, pixels, backlog};
}

}   // namespace rayclock
