// The rules of the data sheet, command by command.
#include "sim/board/sdram_chip.hpp"

#include <algorithm>

namespace rayclock {

namespace {

constexpr std::int64_t giga = 1'000'000'000;
constexpr std::uint32_t burst_length = 8;
enum Code {
    mode = 0,
    refresh_code = 1,
    precharge_code = 2,
    activate_code = 3,
    write_code = 4,
    read_code = 5,
    stop = 6,
    nop = 7
};
constexpr std::uint32_t a10 = 0x400;

}   // namespace

SdramChip::SdramChip(const SdramPart& part, int khz)
    : part_(part), khz_(khz), refreshed_(std::size_t(1) << part.row_bits) {}

void SdramChip::fail(SdramFault fault, const std::string& text) {
    violations_.push_back({now_, fault, "Cycle " + std::to_string(now_) + ": " + text + "."});
}

/// Checks that `ps` and `clocks` have passed since an edge.
void SdramChip::gate(SdramFault fault, const char* name, std::int64_t since, std::int64_t ps, int clocks,
                     const std::string& what) {
    if (since == never) return;
    const std::int64_t edges = std::int64_t(now_) - since;
    if (edges >= clocks && edges * giga >= ps * khz_) return;
    const std::string bound =
        edges * giga < ps * khz_ ? std::to_string(ps) + " ps" : std::to_string(clocks) + " clocks";
    fail(fault, what + " comes " + std::to_string(edges) + " clocks (" + std::to_string(edges * giga / khz_) +
                    " ps) after the event that " + name + " counts from, and " + name + " is " + bound);
}

void SdramChip::clock(const SdramChipPins& pins) {
    if (!pins.cke && (all_precharged_ || !pins.cs_n))
        fail(SdramFault::unsupported, "CKE is low, and this model has no power-down or self refresh");
    if (pins.cke && !pins.cs_n) command(pins);
    move_data(pins);
    check_bus(pins);
    const std::uint64_t oldest = refreshed_[refreshes_ % refreshed_.size()];
    if (ready_ && !told_retention_ && std::int64_t(now_ - oldest) * giga > part_.retention * khz_) {
        told_retention_ = true;
        fail(SdramFault::retention, "a row was not refreshed for 64 ms");
    }
    last_mask_ = pins.dqm;
    ++now_;
}

/// Checks the order of commands after power-up.
void SdramChip::check_start(int code, const SdramChipPins& pins) {
    if (std::int64_t(now_) * giga < part_.initial_wait * khz_)
        fail(SdramFault::early_command, "a command comes before the initial wait of " +
                                            std::to_string(part_.initial_wait) + " ps has ended");
    const bool closes_all = code == precharge_code && (pins.a & a10);
    if (!all_precharged_ && !closes_all)
        fail(SdramFault::initial_order, "the first command is not a precharge of all banks");
    if (code == activate_code || code == read_code || code == write_code)
        fail(SdramFault::initial_order, "a bank is used before " + std::to_string(part_.initial_refreshes) +
                                            " refreshes and the mode register");
    all_precharged_ = true;
}

void SdramChip::command(const SdramChipPins& pins) {
    const int code = pins.ras_n << 2 | pins.cas_n << 1 | int(pins.we_n);
    if (code == nop) return;
    if (!ready_) check_start(code, pins);
    gate(SdramFault::trfc, "tRFC", last_refresh_, part_.trfc, 0, "a command");
    gate(SdramFault::tmrd, "tMRD", last_mode_, 0, part_.tmrd_clocks, "a command");
    switch (code) {
        case mode: set_mode(pins); break;
        case refresh_code: refresh(); break;
        case precharge_code:
            for (std::uint32_t b = 0; b < 4; ++b)
                if (pins.ba == b || (pins.a & a10)) precharge(b);
            break;
        case activate_code: activate(pins); break;
        case read_code:
        case write_code: column(pins, code == write_code); break;
        default: fail(SdramFault::unsupported, "this model has no burst stop");
    }
}

void SdramChip::activate(const SdramChipPins& pins) {
    Bank& bank = banks_[pins.ba];
    const std::string what = "an activation of bank " + std::to_string(pins.ba);
    if (bank.open) fail(SdramFault::bank_open, what + " meets an open row");
    gate(SdramFault::trp, "tRP", bank.precharged, part_.trp, 0, what);
    gate(SdramFault::trc, "tRC", bank.activated, part_.trc, 0, what);
    if (last_activated_bank_ != pins.ba)
        gate(SdramFault::trrd, "tRRD", last_activation_, part_.trrd, 0, what);
    last_activation_ = bank.activated = std::int64_t(now_);
    last_activated_bank_ = pins.ba;
    bank.open = true;
    bank.row = pins.a & ((1u << part_.row_bits) - 1);
    bank.written = never;
}

void SdramChip::column(const SdramChipPins& pins, bool write) {
    Bank& bank = banks_[pins.ba];
    const std::string what =
        std::string(write ? "a write" : "a read") + " of bank " + std::to_string(pins.ba);
    if (!bank.open) fail(SdramFault::bank_closed, what + " meets a closed bank");
    if (pins.a & a10)
        fail(SdramFault::unsupported, what + " requests auto precharge, which this model does not support");
    const std::uint32_t column = (pins.a & 0x3ff) | (pins.a >> 1 & ~0x3ffu);   // without A10
    if (column >> part_.column_bits)
        fail(SdramFault::column, what + " names column " + std::to_string(column) + ", which does not exist");
    gate(SdramFault::trcd, "tRCD", bank.activated, part_.trcd, 0, what);
    burst_ = Burst{write, pins.ba, bank.row, column & ((1u << part_.column_bits) - 1), 0};
}

void SdramChip::precharge(std::uint32_t b) {
    Bank& bank = banks_[b];
    const std::string what = "a precharge of bank " + std::to_string(b);
    if (bank.open) {
        gate(SdramFault::tras, "tRAS", bank.activated, part_.tras, 0, what);
        gate(SdramFault::twr, "tWR", bank.written, part_.twr, part_.twr_clocks, what);
        if ((std::int64_t(now_) - bank.activated) * giga > part_.tras_longest * khz_)
            fail(SdramFault::tras_longest, what + " comes after the longest tRAS");
        bank.precharged = std::int64_t(now_);
        if (burst_ && burst_->bank == b) burst_.reset();
    } else if (bank.precharged == never) {
        bank.precharged = std::int64_t(now_);   // the first, after power-up
    }
    bank.open = false;
}

/// Checks that all banks are precharged. Read data of the last burst may still come.
void SdramChip::check_idle(const std::string& what) {
    for (const Bank& bank : banks_) {
        if (bank.open) fail(SdramFault::bank_open, what + " meets an open bank");
        gate(SdramFault::trp, "tRP", bank.precharged, part_.trp, 0, what);
    }
}

void SdramChip::refresh() {
    check_idle("a refresh");
    last_refresh_ = std::int64_t(now_);
    if (!ready_) {
        ++initial_refreshes_;
        return;
    }
    refreshed_[refreshes_ % refreshed_.size()] = now_;
    ++refreshes_;
}

void SdramChip::set_mode(const SdramChipPins& pins) {
    check_idle("a mode register command");
    last_mode_ = std::int64_t(now_);
    const std::uint32_t cl = pins.a >> 4 & 7;
    if (pins.ba != 0 || (pins.a & ~0x70u) != 3 || (cl != 2 && cl != 3)) {
        fail(SdramFault::mode, "the mode is not a burst of 8, sequential, with CAS latency 2 or 3");
        return;
    }
    cl_ = int(cl);
    if ((cl == 2 ? part_.tck_cl2 : part_.tck_cl3) * khz_ > giga)
        fail(SdramFault::clock, "the clock is too fast for CAS latency " + std::to_string(cl));
    if (initial_refreshes_ < part_.initial_refreshes)
        fail(SdramFault::initial_order,
             "the mode register comes before " + std::to_string(part_.initial_refreshes) + " refreshes");
    if (!ready_) std::ranges::fill(refreshed_, now_);
    ready_ = true;
}

SdramChip::Row& SdramChip::row_of(std::uint32_t bank, std::uint32_t row) {
    Row& r = rows_[key(bank, row)];
    if (r.words.empty()) {
        r.words.resize(std::size_t(1) << part_.column_bits);
        r.known.resize(r.words.size());
        for (std::size_t i = 0; i < r.words.size(); ++i)
            r.words[i] = std::uint16_t((key(bank, row) * 0x9e3779b1u + std::uint32_t(i) * 0x85ebca6bu) >> 11);
    }
    return r;
}

std::uint16_t SdramChip::peek(std::uint32_t bank, std::uint32_t row, std::uint32_t column) {
    return row_of(bank, row).words[column];
}

void SdramChip::move_data(const SdramChipPins& pins) {
    if (burst_) {
        Row& row = row_of(burst_->bank, burst_->row);
        const std::uint32_t first = burst_->column, beat = burst_->beat++,
                            at = (first & ~(burst_length - 1)) | ((first + beat) & (burst_length - 1));
        if (burst_->write) {
            if (!pins.driven && pins.dqm != 3)
                fail(SdramFault::undriven, "the controller does not drive the data of a write");
            for (std::uint32_t byte = 0; byte < 2; ++byte) {
                if (pins.dqm >> byte & 1) continue;
                const std::uint32_t part = 0xffu << (8 * byte);
                row.words[at] = std::uint16_t((row.words[at] & ~part) | (pins.dq & part));
                row.known[at] = std::uint8_t(row.known[at] | 1u << byte);
            }
            banks_[burst_->bank].written = std::int64_t(now_);
        } else {
            out_[(now_ + std::uint64_t(cl_)) % outs] = {true, row.words[at]};
            unwritten_reads_ += row.known[at] != 3;
        }
        ++beats_;
        if (burst_->beat == burst_length) burst_.reset();
    }
    // Launch the beat that is valid at the next edge. DQM masks reads two edges later.
    driven_.reset();
    Out& out = out_[(now_ + 1) % outs];
    if (!out.valid) return;
    const std::uint32_t mask = last_mask_;
    if (mask == 3)
        out.valid = false;
    else
        driven_ = std::uint16_t(out.data | (mask & 1 ? 0xff : 0) | (mask & 2 ? 0xff00 : 0));
}

/// The controller must not drive DQ when the chip does, nor in the clock after it.
void SdramChip::check_bus(const SdramChipPins& pins) {
    bool near = false;
    for (const std::uint64_t edge : {now_ + outs - 1, now_, now_ + 1}) near |= out_[edge % outs].valid;
    if (near && pins.driven)
        fail(SdramFault::contention, "the controller drives DQ in a clock of read data or next to one");
    out_[(now_ + outs - 1) % outs].valid = false;
}

}   // namespace rayclock
