#pragma once
// The SDRAM controller of the board in RTL, its model and a behavioural SDRAM, in lockstep.
#include <deque>
#include <map>
#include <optional>

#include "model/board/sdram.hpp"
#include "sim/board/sdram_chip.hpp"
#include "sim/board/sdram_ports.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "sim/run/rtl/signal.hpp"
#include "tests/support/cases/draw.hpp"
#include "tests/support/dut/dut.hpp"
#include <catch2/catch.hpp>

namespace rayclock::test {

/// Fails if an output of the RTL differs from the model's. REQUIRE would take longer than the cycle.
inline void same(std::uint64_t cycle, const char* what, std::uint64_t rtl, std::uint64_t model) {
    if (rtl != model) FAIL("cycle " << cycle << ", " << what << ": got " << rtl << ", not " << model);
}

/// Pins that the model drives. It has no data, so all bytes are written with 0.
inline SdramChipPins chip_pins(const SdramPins& pins) {
    const int code = int(pins.command);
    return {pins.cke,        !pins.selected,
            (code & 4) != 0, (code & 2) != 0,
            (code & 1) != 0, pins.bank,
            pins.address,    0,
            pins.drives,     0};
}

/// Compares the pins of RTL and model.
inline void require_same_pins(std::uint64_t cycle, const SdramChipPins& rtl, const Sdram& sdram) {
    const SdramPins& model = sdram.pins();
    same(cycle, "cke", rtl.cke, model.cke);
    same(cycle, "cs", rtl.cs_n, !model.selected);
    same(cycle, "command", std::uint64_t(rtl.ras_n << 2 | rtl.cas_n << 1 | int(rtl.we_n)),
         std::uint64_t(model.command));
    same(cycle, "oe", rtl.driven, model.drives);
    same(cycle, "ba", rtl.ba, model.bank);
    if (model.command != SdramCommand::nop || sdram.init_done()) same(cycle, "a", rtl.a, model.address);
}

using LineBeats = std::array<std::uint16_t, 32>;

/// The expected content of the memory, by line. Unknown lines come from the chip, by the order of addresses
/// that the controller promises: row, bank, line of the row.
class ExpectedMemory {
public:
    ExpectedMemory(const SdramPart& part, SdramChip& chip) : part_(part), chip_(chip) {}
    LineBeats& line(std::uint32_t number) {
        const auto [at, is_new] = lines_.try_emplace(number);
        if (is_new) {
            const std::uint32_t in_row = 1u << (part_.column_bits - 5);
            for (std::uint32_t i = 0; i < 32; ++i)
                at->second[i] =
                    chip_.peek(number / in_row % 4, number / in_row / 4, number % in_row * 32 + i);
        }
        return at->second;
    }
    void forget() { lines_.clear(); }   ///< takes the content from the chip again
    /// True if the chip holds everything that was written.
    bool chip_agrees() {
        const std::uint32_t in_row = 1u << (part_.column_bits - 5);
        for (const auto& [number, beats] : lines_)
            for (std::uint32_t i = 0; i < 32; ++i)
                if (beats[i] !=
                    chip_.peek(number / in_row % 4, number / in_row / 4, number % in_row * 32 + i))
                    return false;
        return true;
    }

private:
    SdramPart part_;
    SdramChip& chip_;
    std::map<std::uint32_t, LineBeats> lines_;
};

/// A line to write, with a mask for each beat.
struct WriteLine {
    LineBeats beats{};
    std::array<std::uint8_t, 32> masks{};
    void apply(LineBeats& line) const {
        for (std::size_t i = 0; i < 32; ++i)
            for (int byte = 0; byte < 2; ++byte)
                if (!(masks[i] >> byte & 1)) {
                    const std::uint16_t part = std::uint16_t(0xff << (8 * byte));
                    line[i] = std::uint16_t((line[i] & ~part) | (beats[i] & part));
                }
    }
};
inline WriteLine random_line(Draw& draw, bool masked) {
    WriteLine w;
    for (std::uint16_t& b : w.beats) b = std::uint16_t(draw.bits(16));
    if (masked)
        for (std::uint8_t& m : w.masks) m = std::uint8_t(draw.bits(2));
    return w;
}

/// rc_sdram, its model and a chip. Each step() is one cycle, in which all outputs are compared and the data
/// of reads are checked.
class SdramRig {
public:
    static constexpr int tag_bits = 8;
    static std::string module(const SdramPart& part, int khz, int read_delay = 0) {
        return "rc_sdram " + sdram_parameters(part, khz, read_delay) + " TagW=" + std::to_string(tag_bits);
    }
    SdramRig(const SdramPart& part, int khz, unsigned seed = 1, int read_delay = 0)
        : part(part),
          model(sdram_clocks(part, khz, read_delay)),
          chip(part, khz),
          expected(part, chip),
          draw(seed),
          rtl_(format("default"), module(part, khz, read_delay), int(seed)),
          pins_(rtl_),
          khz_(khz),
          read_delay_(read_delay) {
        req_valid_ = 0, align_ = 0;
        rtl_.reset();
    }
    int align_every = 0;   ///< cycles between two alignments, at random; 0: none

    /// One cycle with a request on offer, or none. Returns true if it was accepted.
    bool step(const Sdram::Request* request, const WriteLine* data = nullptr) {
        req_valid_ = request != nullptr;
        if (request) {
            req_write_ = request->is_write;
            req_addr_ = request->line;
            req_tag_ = request->tag;
        } else {
            // Often the row that is open: the controller must not take it for the next request's.
            req_addr_ = draw.coin() ? last_line_ : draw.bits(20);
            req_write_ = draw.bits(1);
        }
        const bool aligns = align_every > 0 && model.init_done() && draw.below(align_every) == 0;
        align_ = aligns;
        if (aligns) model.align();
        rtl_.settle();
        same(cycle, "init_done", init_done_, model.init_done());
        same(cycle, "req_ready", req_ready_, model.ready());
        const bool accepted = request && model.ready();
        if (accepted) accept(*request, data);
        take_write_beat();
        check_read_beat();
        const SdramChipPins pins = pins_.get();
        require_same_pins(cycle, pins, model);
        std::optional<std::uint16_t> dq = chip.dq();
        chip.clock(pins);
        if (read_delay_ == 0) dq = chip.dq();
        pins_.set_dq(dq ? *dq : std::uint16_t(draw.bits(16)));
        for (; judged_ < chip.violations().size(); ++judged_)
            if (chip.violations()[judged_].fault != allowed) FAIL(chip.violations()[judged_].text);
        rtl_.clock();
        model.clock(accepted ? request : nullptr);
        ++cycle;
        return accepted;
    }
    void idle(int cycles) {
        for (int i = 0; i < cycles; ++i) step(nullptr);
    }
    void initialise() {
        while (!model.init_done()) step(nullptr);
    }
    /// Offers until it is accepted.
    void send(const Sdram::Request& request, const WriteLine* data = nullptr) {
        while (!step(&request, data)) {}
    }
    /// Steps until all beats have come.
    void drain() {
        while (!reads_.empty() || !writes_.empty()) step(nullptr);
        idle(4);
    }

    /// Resets controller and model with requests and beats in flight. The chip sees the pins of this cycle,
    /// and then no command and masked bytes.
    void reset() {
        req_valid_ = 0;
        rtl_.settle();
        chip.clock(pins_.get());
        rtl_.reset();
        model = Sdram(sdram_clocks(part, khz_, read_delay_));
        SdramChipPins masked;
        masked.dqm = 3;
        for (int i = 0; i < 10; ++i) chip.clock(masked);
        reads_.clear();
        writes_.clear();
    }

    SdramPart part;
    Sdram model;
    SdramChip chip;
    ExpectedMemory expected;
    Draw draw;
    std::uint64_t cycle = 0;
    std::optional<SdramFault> allowed;                    ///< a violation that does not fail the test
    std::vector<std::uint64_t> first_beats, last_beats;   ///< cycles of the first and last beat of each read

private:
    struct Read {
        std::uint32_t tag;
        LineBeats beats;
        std::size_t at = 0;
    };
    struct Write {
        std::uint32_t tag;
        WriteLine line;
        std::size_t at = 0;
    };
    void accept(const Sdram::Request& request, const WriteLine* data) {
        LineBeats& line = expected.line(request.line);
        last_line_ = request.line;
        if (request.is_write) {
            data->apply(line);
            writes_.push_back({request.tag, *data});
        } else {
            reads_.push_back({request.tag, line});
        }
    }
    void take_write_beat() {
        const Sdram::Beat beat = model.write_beat();
        same(cycle, "wr_next", wr_next_, beat.valid);
        wr_data_ = draw.bits(16);
        wr_mask_ = draw.bits(2);
        if (!beat.valid) return;
        same(cycle, "wr_tag", wr_tag_, beat.tag);
        if (writes_.empty()) FAIL("a beat is taken without a write");
        Write& write = writes_.front();
        same(cycle, "the tag of the oldest write", beat.tag, write.tag);
        wr_data_ = write.line.beats[write.at];
        wr_mask_ = write.line.masks[write.at];
        same(cycle, "the last beat of a write", write.at == 31, beat.last);
        if (++write.at == 32) writes_.pop_front();
    }
    void check_read_beat() {
        const Sdram::Beat beat = model.read_beat();
        same(cycle, "rd_valid", rd_valid_, beat.valid);
        if (!beat.valid) {
            if (!reads_.empty() && reads_.front().at != 0) FAIL("the beats of a line do not come in a row");
            return;
        }
        same(cycle, "rd_last", rd_last_, beat.last);
        same(cycle, "rd_tag", rd_tag_, beat.tag);
        if (reads_.empty()) FAIL("a beat comes without a read");
        Read& read = reads_.front();
        same(cycle, "the tag of the oldest read", beat.tag, read.tag);
        same(cycle, "rd_data", rd_data_, read.beats[read.at]);
        same(cycle, "the last beat of a read", read.at == 31, beat.last);
        if (read.at == 0) first_beats.push_back(cycle);
        if (++read.at < 32) return;
        last_beats.push_back(cycle);
        reads_.pop_front();
    }

    RtlModule rtl_;
    SdramPorts pins_;
    int khz_, read_delay_;
    std::size_t judged_ = 0;
    Signal align_{rtl_, "align"}, req_valid_{rtl_, "req_valid"}, req_write_{rtl_, "req_write"},
        req_addr_{rtl_, "req_addr"}, req_tag_{rtl_, "req_tag"}, wr_data_{rtl_, "wr_data"},
        wr_mask_{rtl_, "wr_mask"}, init_done_{rtl_, "init_done"}, req_ready_{rtl_, "req_ready"},
        wr_next_{rtl_, "wr_next"}, wr_tag_{rtl_, "wr_tag"}, rd_valid_{rtl_, "rd_valid"},
        rd_last_{rtl_, "rd_last"}, rd_tag_{rtl_, "rd_tag"}, rd_data_{rtl_, "rd_data"};
    std::deque<Read> reads_;
    std::deque<Write> writes_;
    std::uint32_t last_line_ = 0;   ///< of the last accepted request
};

/// Addresses in all relations of bank and row to the last one.
inline std::uint32_t next_address(Draw& draw, const SdramPart& part, std::uint32_t last) {
    const std::uint32_t in_row = 1u << (part.column_bits - 5), lines = 1u << part.line_bits();
    switch (draw.below(7)) {
        case 0: return std::uint32_t(draw.bits(part.line_bits()));
        case 1: return (last ^ std::uint32_t(draw.below(int(in_row)))) % lines;          // the same row
        case 2: return (last + in_row * std::uint32_t(1 + draw.below(3))) % lines;       // another bank
        case 3: return (last + 4 * in_row * std::uint32_t(1 + draw.below(3))) % lines;   // another row
        case 4: return last;
        case 5: return draw.coin() ? 0 : lines - 1;
        default: return (last + 1) % lines;
    }
}

}   // namespace rayclock::test
