// The decisions of the controller, in the order of rtl/board/memory/rc_sdram.sv.
#include "model/board/sdram.hpp"

#include <algorithm>
#include <cassert>

namespace rayclock {

namespace {

constexpr std::uint32_t all_banks = 0x400;   // A10

void count_down(int& clocks) { clocks -= clocks > 0; }

}   // namespace

Sdram::Sdram(const SdramClocks& clocks)
    : clocks_(clocks),
      init_wait_(clocks.initial_wait),
      refi_(clocks.refi - 1),
      reads_(std::size_t(1 + clocks.cl + clocks.read_delay)) {}

Sdram::Held Sdram::decode(const Request& request) const {
    const int in_row = clocks_.column_bits - 5;
    Held held;
    held.is_write = request.is_write;
    held.tag = request.tag;
    held.column = (request.line & ((1u << in_row) - 1)) << 5;
    held.bank = request.line >> in_row & 3;
    held.row = request.line >> (in_row + 2) & ((1u << clocks_.row_bits) - 1);
    return held;
}

/// Returns the activation or precharge that the selected request needs, if its timings allow it in this
/// cycle.
Sdram::Decision Sdram::decide_row(const Held& request) const {
    const Bank& bank = banks_[request.bank];
    Decision d{SdramCommand::nop, request.bank, request.row, false};
    if (!bank.open && bank.wait == 0) d.command = SdramCommand::activate;
    if (bank.open && known_ && !equal_ && bank.precharge == 0) d.command = SdramCommand::precharge;
    return d;
}

Sdram::Decision Sdram::decide_refresh() const {
    const bool open = std::ranges::any_of(banks_, [](const Bank& b) { return b.open; });
    const auto ends = [](const Bank& b) { return b.precharge == 0; };
    const auto waits = [](const Bank& b) { return b.wait != 0; };
    if (open && std::ranges::all_of(banks_, ends)) return {SdramCommand::precharge, 0, 0, true};
    if (!open && std::ranges::none_of(banks_, waits)) return {SdramCommand::refresh, 0, 0, false};
    return {};
}

Sdram::Decision Sdram::decide() const {
    if (!runs_) return {};
    const SdramCommand column = current_.is_write ? SdramCommand::write : SdramCommand::read;
    if (bursts_ > 0) {   // row commands serve the next request, between the column commands of this one
        if (beats_ == 0) return {column, current_.bank, 0, false};
        return next_valid_ && !due_ ? decide_row(next_) : Decision{};
    }
    if (due_) return decide_refresh();
    if (!current_valid_) return {};
    const Bank& bank = banks_[current_.bank];
    if (known_ && equal_ && bank.open && bank.wait == 0 && beats_ == 0 && (!current_.is_write || turn_ == 0))
        return {column, current_.bank, 0, false};
    return decide_row(current_);
}

/// Compares the row of the selected request with the row that its bank had open last, for the next cycle.
void Sdram::compare_row() {
    const bool first = bursts_ == 0;
    const Held& selected = first ? current_ : next_;
    known_ = first ? current_valid_ : next_valid_;
    equal_ = decision_.command == SdramCommand::activate || banks_[selected.bank].row == selected.row;
}

Sdram::Beat Sdram::write_beat() const {
    if (beats_ > 0) return {beats_write_, beats_write_ && beats_last_ && beats_ == 1, beats_tag_};
    return {decision_.command == SdramCommand::write, false, current_.tag};
}

SdramPins Sdram::pins_of_decision() const {
    SdramPins pins;
    pins.cke = pins.selected = true;
    pins.command = decision_.command;
    pins.drives = write_beat().valid;
    if (decision_.command == SdramCommand::nop) return pins;
    pins.bank = decision_.bank;
    if (reads_or_writes()) pins.address = current_.column + std::uint32_t(burst * bursts_);
    if (decision_.command == SdramCommand::activate) pins.address = decision_.row;
    if (decision_.all) pins.address = all_banks;
    return pins;
}

/// A step of the initialisation: its commands replace the decision's.
void Sdram::initialise() {
    if (init_wait_ > 0) {
        --init_wait_;
        return;
    }
    const int mode = clocks_.initial_refreshes + 1;
    if (init_step_ > mode) {
        runs_ = true;
    } else if (init_step_ == mode) {
        pins_.command = SdramCommand::mode;
        pins_.address = std::uint32_t(clocks_.cl << 4 | 3);   // burst of 8, sequential
        init_wait_ = clocks_.mrd - 1;
    } else {
        pins_.command = init_step_ == 0 ? SdramCommand::precharge : SdramCommand::refresh;
        pins_.address = all_banks;
        init_wait_ = (init_step_ == 0 ? clocks_.rp : clocks_.rfc) - 1;
    }
    ++init_step_;
}

void Sdram::change_banks() {
    for (std::uint32_t b = 0; b < banks_.size(); ++b) {
        Bank& bank = banks_[b];
        const bool is_meant = decision_.bank == b;
        count_down(bank.wait);
        count_down(bank.precharge);
        switch (decision_.command) {
            case SdramCommand::refresh: bank.wait = clocks_.rfc - 1; break;
            case SdramCommand::precharge:
                if (is_meant || decision_.all) bank.open = false, bank.wait = clocks_.rp - 1;
                break;
            case SdramCommand::activate:
                if (is_meant) bank = {true, decision_.row, clocks_.rcd - 1, clocks_.ras - 1};
                break;
            case SdramCommand::read:
                if (is_meant) bank.precharge = burst - 1;
                break;
            case SdramCommand::write:
                if (is_meant) bank.precharge = burst + clocks_.wr - 2;
                break;
            default: break;
        }
    }
}

void Sdram::move_beats() {
    std::rotate(reads_.rbegin(), reads_.rbegin() + 1, reads_.rend());
    const bool is_read = beats_ > 0 ? !beats_write_ : decision_.command == SdramCommand::read;
    reads_.front() = {is_read, is_read && beats_ == 1 && beats_last_, beats_ > 0 ? beats_tag_ : current_.tag};
    count_down(beats_);
    count_down(turn_);
    if (!reads_or_writes()) return;
    beats_ = burst - 1;
    beats_write_ = current_.is_write;
    beats_last_ = bursts_ == 3;
    beats_tag_ = current_.tag;
    if (!current_.is_write) turn_ = clocks_.cl + burst;
}

void Sdram::take(const Request* request) {
    assert(!request || ready());
    const bool ends = reads_or_writes() && bursts_ == 3;
    if (reads_or_writes()) bursts_ = (bursts_ + 1) % 4;
    if (!current_valid_ || ends) {
        current_valid_ = next_valid_ || request;
        if (next_valid_)
            current_ = next_;
        else if (request)
            current_ = decode(*request);
        next_valid_ = false;
    } else if (request) {
        next_ = decode(*request);
        next_valid_ = true;
    }
}

/// Row commands serve the current line until its first burst, and the next line from then on.
void Sdram::count_lines() {
    Held& served = bursts_ == 0 ? current_ : next_;
    served.activated |= decision_.command == SdramCommand::activate;
    served.precharged |= decision_.command == SdramCommand::precharge && !decision_.all;
    if (!reads_or_writes() || bursts_ > 0) return;
    row_hits_ += !current_.activated;
    row_conflicts_ += current_.precharged;
}

void Sdram::clock(const Request* request) {
    pins_ = pins_of_decision();
    if (!runs_) {
        initialise();
        return;
    }
    move_beats();
    compare_row();
    change_banks();
    count_lines();
    const bool refreshes = decision_.command == SdramCommand::refresh;
    refreshes_ += refreshes;
    refresh_left_ = refreshes ? clocks_.rfc : std::max(0, refresh_left_ - 1);
    due_ = aligns_ || refi_ == 0 || (due_ && !refreshes);
    refi_ = aligns_ || refi_ == 0 ? clocks_.refi - 1 : refi_ - 1;
    aligns_ = false;
    take(request);
    decision_ = decide();
}

bool Sdram::is_quiet() const {
    return runs_ && !current_valid_ && !due_ && beats_ == 0 && pins_.command == SdramCommand::nop &&
           !pins_.drives && std::ranges::none_of(reads_, &Beat::valid);
}

void Sdram::skip(std::uint64_t cycles) {
    assert(cycles <= quiet_cycles());
    const auto reduce = [&](int& clocks) {
        clocks = std::uint64_t(clocks) > cycles ? clocks - int(cycles) : 0;
    };
    for (Bank& bank : banks_) reduce(bank.wait), reduce(bank.precharge);
    reduce(turn_), reduce(refresh_left_);
    refi_ -= int(cycles);
}

}   // namespace rayclock
