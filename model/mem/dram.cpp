// The DRAM's controller, driven by events: the next arrival, refresh or command.
#include "model/mem/dram.hpp"

#include <algorithm>
#include <cassert>

namespace rayclock {

Dram::Dram(const DramPart& part, int khz, int ids)
    : part_(part),
      khz_(std::uint64_t(khz)),
      tck_(std::uint64_t(part.tck)),
      period_(giga / khz_),
      answer_ps_(std::uint64_t(part.cl + part.burst_clocks()) * tck_ + std::uint64_t(part.answer_ps)),
      trefi_(part.trefi / part.tck),
      banks_(part),
      refresh_at_(trefi_),
      answers_(ids),
      data_(2 * (part.cl / part.burst_clocks() + 2)),
      under_way_(std::size_t(ids)) {
    assert(khz >= 1000 && "a cycle of the chip is shorter than the time between refreshes");
    assert(part.banks <= 32 && "a set of banks fits 32 bits");
    queue_.reserve(std::size_t(part.queue));
    plan();
}

// No product exceeds 64 bits for hours of simulated time.
std::uint64_t Dram::begin_of(std::uint64_t cycle) const {
    return cycle * (giga / khz_) + cycle * (giga % khz_) / khz_;
}
std::uint64_t Dram::cycle_from(std::uint64_t ps) const {
    return ps / giga * khz_ + (ps % giga * khz_ + giga - 1) / giga;
}

void Dram::clock(const Answer* request) {
    const std::uint64_t begin = time_;
    while (!data_.empty() && data_.front().until <= begin) data_.pop();
    ++now_;
    time_ += period_;
    rest_ += giga % khz_;
    const bool carry = rest_ >= khz_;
    rest_ -= carry * khz_;
    time_ += carry;
    if (request) accept(*request);
    if (event_ps_ <= time_) run();
    last_cause_ = cause(begin);
    ++causes_[std::size_t(last_cause_)];
    valid_ = !answers_.empty() && answers_.front().cycle <= now_;
    if (valid_) {
        answer_ = answers_.front().what;
        answers_.pop();
        under_way_[answer_.id] = 0;
    }
    ready_ = queue_.size() < std::size_t(part_.queue);
    waiting_ = !queue_.empty();
}

std::uint64_t Dram::quiet_until() const {
    if (valid_) return now_ + 1;
    std::uint64_t until = answers_.empty() ? never : answers_.front().cycle;
    if (queue_.empty()) return until;
    // The data of a future read come no earlier than the next event.
    until = std::min(until, cycle_from(event_ps_ + answer_ps_));
    return ready_ ? until : std::min(until, cycle_from(event_ps_));
}

/// Returns how many of the next cycles, at most `cycles`, are alike: no event, no answer, and the same
/// cause.
std::uint64_t Dram::still(std::uint64_t cycles) const {
    if (valid_ || busy_) return 0;
    if (!answers_.empty()) cycles = std::min(cycles, answers_.front().cycle - now_ - 1);
    std::uint64_t until = event_ps_ - 1;
    if (!data_.empty()) {
        const Data& data = data_.front();
        if (data.until <= time_) return 0;
        until = std::min(until, data.from < time_ + period_ ? data.until : data.from);
    }
    if (refresh_.until > time_) until = std::min(until, refresh_.until);
    return std::min(cycles, (until - time_) / (period_ + 1));
}

void Dram::pass(std::uint64_t cycles) {
    const std::uint64_t end = now_ + cycles;
    while (now_ < end) {
        const std::uint64_t alike = still(end - now_);
        if (alike < 2) {
            clock(nullptr);
            if (is_idle()) return;   // from an answer or a write on
            continue;
        }
        const std::uint64_t begin = time_;
        time_ += period_;   // of the first one
        last_cause_ = cause(begin);
        causes_[std::size_t(last_cause_)] += alike;
        time_ += period_ * (alike - 1);
        for (rest_ += giga % khz_ * alike; rest_ >= khz_; rest_ -= khz_) ++time_;
        now_ += alike;
    }
}

void Dram::skip(std::uint64_t cycles) {
    assert(cycles <= quiet_until() - now_ && "no cycle is skipped in which something could change");
    for (; cycles > 0 && !idle(); --cycles) clock(nullptr);
    if (cycles == 0) return;
    now_ += cycles;
    time_ = begin_of(now_);
    rest_ = now_ * (giga % khz_) % khz_;
    causes_[std::size_t(DramCause::starved)] += cycles;
    run();
}

void Dram::accept(const Answer& request) {
    assert(ready_ && "a request is accepted only when there is room");
    assert((request.is_write || !under_way_[request.id]) && "a request's id is under way once");
    if (request.is_write)
        ++writing_;
    else
        under_way_[request.id] = 1;
    Entry entry;
    entry.what = request;
    const std::uint32_t words = std::uint32_t(part_.row_bytes() / line_bytes),
                        groups = std::uint32_t(part_.bank_groups),
                        banks = std::uint32_t(part_.banks) / groups;   // banks per group
    const bool has_groups = groups > 1;
    const std::uint32_t group = has_groups ? request.addr % groups : 0,
                        word = has_groups ? request.addr / groups : request.addr;
    const std::uint32_t page = word / words;
    entry.bank = int(page % banks * groups + group);
    entry.row = page / banks;
    entry.left = part_.bursts();
    const std::uint64_t arrival = (time_ + std::uint64_t(part_.request_ps) + tck_ - 1) / tck_;
    entry.arrival = std::int64_t(arrival);
    queue_.push_back(entry);
    event_ps_ = std::min(event_ps_, arrival * tck_);
}

// The order of events in one clock of the DRAM: a request arrives, a refresh falls due, a command is given.
void Dram::run() {
    while (event_ps_ <= time_) {
        clock_ = std::int64_t(event_ps_ / tck_);
        if (arrived_ < queue_.size() && queue_[arrived_].arrival <= clock_) {
            ++arrived_;
        } else if (!refreshing_ && refresh_at_ <= clock_) {
            refreshing_ = true;
            refresh_ = {event_ps_, never};
            refresh_at_ += trefi_;
        } else {
            issue();
        }
        plan();
    }
}

void Dram::plan() {
    choice_ = Choice{};
    if (current_ >= 0)
        consider(column_command(queue_[std::size_t(current_)]), queue_[std::size_t(current_)].bank, current_);
    if (!refreshing_ && arrived_ > std::size_t(current_ >= 0))
        choose();
    else if (refreshing_ && current_ < 0)
        consider(banks_.has_open() ? DramCommand::precharge_all : DramCommand::refresh, 0, -1);
    std::int64_t clock = choice_.clock;
    if (arrived_ < queue_.size()) clock = std::min(clock, queue_[arrived_].arrival);
    if (!refreshing_) clock = std::min(clock, refresh_at_);
    event_ps_ = std::uint64_t(clock) * tck_;
}

/// Proposes a command. The earliest one wins; among equals, the one considered first.
void Dram::consider(DramCommand command, int bank, int entry) {
    const std::int64_t clock = std::max(banks_.earliest(command, bank), clock_);
    if (clock < choice_.clock) choice_ = {clock, command, bank, entry};
}

/// Considers reads and writes first, then other commands, each by age. All requests of a bank that read its
/// open row could have their command at the same time. The same holds for those that write it, and for those
/// that need another row. So only the oldest of each kind is considered.
void Dram::choose() {
    std::array<std::uint32_t, 2> wanted{};   // banks with a request to read, or to write, their open row
    std::uint32_t turned = 0;                // banks with a request to open or to close them
    std::array<int, 32> turns;               // the oldest such request of each bank, by age
    std::size_t n = 0;
    for (std::size_t i = 0; i < arrived_; ++i) {
        const Entry& e = queue_[i];
        const std::uint32_t bit = 1u << e.bank;
        if (banks_.is_open(e.bank) && banks_.row(e.bank) == e.row) {
            if (current_ < 0 && !(wanted[e.what.is_write] & bit)) consider(column_command(e), e.bank, int(i));
            wanted[e.what.is_write] |= bit;
        } else if (!(turned & bit)) {
            turned |= bit;
            turns[n++] = int(i);
        }
        if (e.overtaken >= part_.age_cap) break;   // later requests wait
    }
    for (std::size_t k = 0; k < n; ++k) {
        const int bank = queue_[std::size_t(turns[k])].bank;
        if (!banks_.is_open(bank))
            consider(DramCommand::activate, bank, turns[k]);
        else if (!((wanted[0] | wanted[1]) & 1u << bank))
            consider(DramCommand::precharge, bank, turns[k]);
    }
}

void Dram::issue() {
    Entry* const entry = choice_.entry < 0 ? nullptr : &queue_[std::size_t(choice_.entry)];
    const std::uint32_t row = entry ? entry->row : 0;
    banks_.issue(choice_.command, choice_.bank, row, choice_.clock);
    if (log_) log_->push_back({choice_.clock, choice_.command, choice_.bank, row});
    if (choice_.command == DramCommand::refresh) {
        ++statistics_.refreshes;
        refreshing_ = false;
        refresh_.until = std::uint64_t(choice_.clock) * tck_ + std::uint64_t(part_.trfc);
    }
    if (!entry) return;
    if (entry->row_outcome == RowOutcome::none) {
        const bool opens = choice_.command == DramCommand::activate;
        const bool hits = choice_.command == column_command(*entry);
        entry->row_outcome = hits ? RowOutcome::hit : opens ? RowOutcome::miss : RowOutcome::conflict;
    }
    if (choice_.command == column_command(*entry)) transfer(*entry);
}

void Dram::transfer(Entry& entry) {
    if (current_ < 0) {
        current_ = choice_.entry;
        for (int i = 0; i < current_; ++i) ++queue_[std::size_t(i)].overtaken;
    }
    const int latency = entry.what.is_write ? part_.cwl : part_.cl;
    const std::uint64_t from = (std::uint64_t(choice_.clock) + std::uint64_t(latency)) * tck_;
    const std::uint64_t until = from + std::uint64_t(part_.burst_clocks()) * tck_;
    statistics_.bus_ps += until - from;
    if (until > time_)
        data_.push({from, until});
    else
        busy_ = true;   // all in the cycle that is ending
    if (--entry.left > 0) return;
    ++(entry.what.is_write ? statistics_.writes : statistics_.reads);
    if (entry.row_outcome == RowOutcome::hit)
        ++statistics_.row_hits;
    else if (entry.row_outcome == RowOutcome::miss)
        ++statistics_.row_misses;
    else
        ++statistics_.row_conflicts;
    statistics_.bytes += line_bytes;
    if (entry.what.is_write) {
        --writing_;
        last_write_ps_ = until;
    } else {
        answers_.push({entry.what, cycle_from(until + std::uint64_t(part_.answer_ps))});
    }
    queue_.erase(queue_.begin() + current_);
    --arrived_;
    current_ = -1;
}

/// Returns the cause of the cycle that ends at time_.
DramCause Dram::cause(std::uint64_t begin) {
    // Without branches, because the cause changes often.
    const bool busy = busy_ | (!data_.empty() & (data_.front().from < time_));
    const bool starved = !waiting_ & data_.empty();
    const bool refresh = (refresh_.from < time_) & (refresh_.until > begin);
    busy_ = false;
    constexpr std::array<DramCause, 4> causes{DramCause::row, DramCause::refresh, DramCause::starved,
                                              DramCause::starved};
    const std::size_t waits = std::size_t(refresh + 2 * starved);
    return std::array{causes[waits], DramCause::busy}[busy];
}

}   // namespace rayclock
