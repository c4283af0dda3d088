// Distributes requests over channels and merges their answers.
#include "model/mem/dram_channels.hpp"

#include <algorithm>
#include <cassert>

namespace rayclock {

DramChannels::DramChannels(const DramPart& part, int channels, int khz, int ids)
    : channels_(std::size_t(channels), Dram(part, khz, ids)),
      count_(std::uint32_t(channels)),
      waiting_(ids) {}

void DramChannels::clock(const Answer* request) {
    if (count_ == 1) {
        channels_[0].clock(request);
        mirror();
        return;
    }
    const std::uint32_t channel = request ? request->addr % count_ : 0;
    DramCause cause = DramCause::starved;
    for (std::uint32_t c = 0; c < count_; ++c) {
        const bool takes = request && c == channel;
        const Answer own{takes ? request->id : 0, takes ? request->addr / count_ : 0,
                         takes && request->is_write};
        channels_[c].clock(takes ? &own : nullptr);
        cause = std::min(cause, channels_[c].last_cause());
    }
    ++causes_[std::size_t(cause)];
    gather();
}

void DramChannels::mirror() {
    ready_ = channels_[0].ready();
    valid_ = channels_[0].valid();
    answer_ = channels_[0].answer();
}

void DramChannels::gather() {
    ready_ = true;
    for (std::uint32_t c = 0; c < count_; ++c) {
        ready_ &= channels_[c].ready();
        if (!channels_[c].valid()) continue;
        const Answer own = channels_[c].answer();
        waiting_.push({own.id, own.addr * count_ + c});
    }
    valid_ = !waiting_.empty();
    if (!valid_) return;
    answer_ = waiting_.front();
    waiting_.pop();
}

bool DramChannels::is_idle() const {
    if (count_ == 1) return channels_[0].is_idle();
    return !valid_ && waiting_.empty() &&
           std::all_of(channels_.begin(), channels_.end(), [](const Dram& d) { return d.is_idle(); });
}

bool DramChannels::writes() const {
    return std::any_of(channels_.begin(), channels_.end(), [](const Dram& d) { return d.writes(); });
}

bool DramChannels::idle() const {
    return !valid_ && waiting_.empty() &&
           std::all_of(channels_.begin(), channels_.end(), [](const Dram& d) { return d.idle(); });
}

std::uint64_t DramChannels::quiet_until() const {
    if (count_ == 1) return channels_[0].quiet_until();
    if (valid_ || !waiting_.empty()) return now() + 1;
    std::uint64_t until = channels_[0].quiet_until();
    for (const Dram& channel : channels_) until = std::min(until, channel.quiet_until());
    return until;
}

void DramChannels::skip(std::uint64_t cycles) {
    if (count_ == 1) {
        channels_[0].skip(cycles);
        mirror();
        return;
    }
    assert(cycles <= quiet_until() - now() && "no cycle is skipped in which something could change");
    for (; cycles > 0 && !idle(); --cycles) clock(nullptr);
    if (cycles == 0) return;
    for (Dram& channel : channels_) channel.skip(cycles);
    causes_[std::size_t(DramCause::starved)] += cycles;
}

DramStatistics DramChannels::statistics() const {
    DramStatistics sum;
    for (const Dram& channel : channels_) {
        const DramStatistics& s = channel.statistics();
        sum.reads += s.reads;
        sum.writes += s.writes;
        sum.row_hits += s.row_hits;
        sum.row_misses += s.row_misses;
        sum.row_conflicts += s.row_conflicts;
        sum.refreshes += s.refreshes;
        sum.bytes += s.bytes;
        sum.bus_ps += s.bus_ps;
    }
    return sum;
}

}   // namespace rayclock
