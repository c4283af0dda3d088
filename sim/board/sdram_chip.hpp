#pragma once
// A behavioural SDR SDRAM at its pins, which checks the rules of the data sheet.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/board/sdram_parts.hpp"

namespace rayclock {

/// The pins as the chip samples them at a clock edge. `_n`: active low.
struct SdramChipPins {
    bool cke = true, cs_n = true, ras_n = true, cas_n = true, we_n = true;
    std::uint32_t ba = 0, a = 0;
    std::uint32_t dqm = 0;   ///< 2 bits
    bool driven = false;     ///< the controller drives DQ
    std::uint16_t dq = 0;    ///< its data
    friend bool operator==(const SdramChipPins&, const SdramChipPins&) = default;
};

/// A kind of violation.
enum class SdramFault {
    clock,           ///< period too short for the CAS latency
    early_command,   ///< a command before the end of the initial wait
    initial_order,   ///< precharge of all banks, refreshes, mode register: one is missing
    mode,            ///< a mode that the chip or this model does not have
    trcd,
    trp,
    tras,
    tras_longest,
    trc,
    trrd,
    twr,
    trfc,
    tmrd,
    bank_open,     ///< an activation of an open bank; refresh or mode register with an open bank
    bank_closed,   ///< a read or a write of a closed bank
    column,        ///< a column that does not exist
    retention,     ///< a row was not refreshed in time
    contention,    ///< both drive DQ, or they change without an idle clock
    undriven,      ///< write data that are not driven
    unsupported,   ///< a command or state that this model does not have
};
constexpr int sdram_faults = int(SdramFault::unsupported) + 1;

/// A 16-bit SDR SDRAM with four banks. It is written from the data sheet's rules, as an independent judge of
/// rtl/board/memory/rc_sdram.sv and model/board/sdram.hpp. Gates are compared in ps: clock edge n is at n
/// times the period. It does not model: auto precharge, power-down, self refresh, suspended clocks, single
/// writes.
class SdramChip {
public:
    /// The clock has `khz`. Edges count from 0, the first with stable power and clock.
    SdramChip(const SdramPart& part, int khz);

    /// One rising edge of the chip's clock.
    void clock(const SdramChipPins& pins);

    /// The two bytes that the chip drives on DQ from the last edge until the next; std::nullopt: not driven.
    /// A masked byte is not driven, and reads as 0xff.
    std::optional<std::uint16_t> dq() const { return driven_; }

    struct Violation {
        std::uint64_t cycle;   ///< edge
        SdramFault fault;
        std::string text;   ///< one sentence with cycle and gate
    };
    const std::vector<Violation>& violations() const { return violations_; }

    /// The word at a column, in any state of the bank. Words that were never written are arbitrary, but
    /// the same in every run.
    std::uint16_t peek(std::uint32_t bank, std::uint32_t row, std::uint32_t column);
    /// Reads of bytes that were never written.
    std::uint64_t unwritten_reads() const { return unwritten_reads_; }
    std::uint64_t refreshes() const { return refreshes_; }
    std::uint64_t edges() const { return now_; }
    /// Beats that the chip has read or written.
    std::uint64_t beats() const { return beats_; }

private:
    static constexpr std::int64_t never = -1;
    struct Bank {
        bool open = false;
        std::uint32_t row = 0;
        std::int64_t activated = never, precharged = never, written = never;   // edges
    };
    struct Row {
        std::vector<std::uint16_t> words;
        std::vector<std::uint8_t> known;   // a bit for each byte
    };
    struct Burst {
        bool write = false;
        std::uint32_t bank = 0, row = 0, column = 0;
        std::uint32_t beat = 0;
    };

    void fail(SdramFault fault, const std::string& text);
    void gate(SdramFault fault, const char* name, std::int64_t since, std::int64_t ps, int clocks,
              const std::string& what);
    void check_start(int code, const SdramChipPins& pins);
    void command(const SdramChipPins& pins);
    void activate(const SdramChipPins& pins);
    void column(const SdramChipPins& pins, bool write);
    void precharge(std::uint32_t bank);
    void refresh();
    void set_mode(const SdramChipPins& pins);
    void check_idle(const std::string& what);
    void check_bus(const SdramChipPins& pins);
    void move_data(const SdramChipPins& pins);
    std::uint32_t key(std::uint32_t bank, std::uint32_t row) const { return row << 2 | bank; }
    Row& row_of(std::uint32_t bank, std::uint32_t row);

    SdramPart part_;
    std::int64_t khz_;
    std::uint64_t now_ = 0;
    std::array<Bank, 4> banks_{};
    int cl_ = 0;   // 0: no mode yet
    bool all_precharged_ = false, ready_ = false, told_retention_ = false;
    int initial_refreshes_ = 0;
    std::int64_t last_activation_ = never, last_refresh_ = never, last_mode_ = never;
    std::uint32_t last_activated_bank_ = 0;
    std::optional<Burst> burst_;
    struct Out {   // a beat of read data
        bool valid = false;
        std::uint16_t data = 0;
    };
    static constexpr std::uint64_t outs = 8;
    std::array<Out, outs> out_{};   // by the edge at which it is valid, modulo 8; launched an edge earlier
    std::uint32_t last_mask_ = 0;   // DQM of the last edge
    std::optional<std::uint16_t> driven_;
    std::vector<std::uint64_t> refreshed_;   // edges of the last refreshes, a ring over the rows
    std::uint64_t refreshes_ = 0, unwritten_reads_ = 0, beats_ = 0;
    std::unordered_map<std::uint32_t, Row> rows_;
    std::vector<Violation> violations_;
};

}   // namespace rayclock
