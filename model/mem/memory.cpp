#include "model/mem/memory.hpp"

namespace rayclock {

namespace {
// In the order of DramCause.
constexpr MemoryDeed deed_of[] = {MemoryDeed::busy, MemoryDeed::refresh, MemoryDeed::latency,
                                  MemoryDeed::starved};
}   // namespace

Memory::Memory(const Config& config, int khz, Traffic traffic)
    : ideal_(config, 1 << config.mem_id_bits()),
      traffic_(traffic),
      rng_(traffic.seed * 16 + 1),
      disturbed_(!traffic.none()) {
    if (const DramPart* part = config.dram_part())
        dram_.emplace(*part, config.dram_channels, khz, 1 << config.mem_id_bits());
}

void Memory::write(const std::vector<std::uint32_t>& lines) {
    written_.erase(written_.begin(), written_.end() - std::ptrdiff_t(left_));
    written_.insert(written_.end(), lines.begin(), lines.end());
    left_ = written_.size();
    if (left_ > 0 && dram_) pay(), sleeping_ = false;
}

void Memory::work(const Answer* request) {
    // The host has the cycles that the chip leaves.
    const bool writes = left_ > 0 && !request && (dram_ ? dram_->ready() : ideal_.ready());
    const std::uint32_t line = writes ? written_[written_.size() - left_--] : 0;
    if (disturbed_) {
        if (offer_ >= 0) late_.erase(late_.begin() + offer_);
        if (comes())
            late_.push_back(
                {coming(), now_ + std::uint64_t(traffic_.jitter > 0 ? rng_.below(traffic_.jitter + 1) : 0)});
    }
    if (dram_) {
        pay();
        const Dram::Answer asked{request ? request->id : 0, request ? request->addr : line, writes};
        dram_->clock(request || writes ? &asked : nullptr);
        sleeping_ = !disturbed_ & dram_->rests() & (written_.empty() || !this->writes());
    } else {
        if (writes) ideal_.write();
        writes_ += writes;
        ++ideal_deeds_[std::size_t(ideal_.valid()   ? MemoryDeed::busy
                                   : ideal_.waits() ? MemoryDeed::latency
                                                    : MemoryDeed::starved)];
        reads_ += request != nullptr;
        ideal_.clock(request);
    }
    if (disturbed_) disturb();
}

void Memory::pay() {
    if (owed_ > 0) dram_->skip(owed_);
    owed_ = 0;
}

/// The oldest answer that is due is on offer.
void Memory::disturb() {
    offer_ = -1;
    for (std::size_t i = 0; i < late_.size() && offer_ < 0; ++i)
        if (late_[i].due <= now_) offer_ = int(i);
    ready_ = traffic_.stall_percent == 0 || rng_.below(100) >= traffic_.stall_percent;
}

void Memory::skip(std::uint64_t cycles) {
    now_ += cycles;
    if (sleeping_) {
        owed_ += cycles;
    } else if (dram_) {
        dram_->skip(cycles);
    } else {
        ideal_deeds_[std::size_t(ideal_.waits() ? MemoryDeed::latency : MemoryDeed::starved)] += cycles;
        ideal_.skip(cycles);
    }
}

std::array<std::uint64_t, 8> Memory::deeds() const {
    std::array<std::uint64_t, 8> sums{};
    for (std::size_t i = 0; i < memory_deeds; ++i) {
        if (dram_)
            sums[std::size_t(deed_of[i])] = dram_->cycles(DramCause(i));
        else
            sums[i] = ideal_deeds_[i];
    }
    sums[std::size_t(MemoryDeed::starved)] += owed_;
    return sums;
}

MemoryStats Memory::stats() const {
    if (!dram_) return {reads_, 0, 0, 0, writes_};
    const DramStatistics s = dram_->statistics();
    return {s.reads, s.row_hits, s.row_conflicts, s.refreshes, s.writes};
}

}   // namespace rayclock
