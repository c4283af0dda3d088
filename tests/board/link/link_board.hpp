#pragma once
// A board of the test's own around rc_link or rc_host_link: the chip's registers, the board's registers, and
// a memory. It keeps a list of all writes, so that a test sees what was executed, how often and in which
// order.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "model/base/rng.hpp"
#include "sim/board/link.hpp"
#include "sim/run/rtl/rtl_module.hpp"

namespace rayclock::test {

/// The module of the RTL and its surroundings, cycle by cycle. All outputs of the module are registers, so
/// inputs may depend on outputs of the same cycle.
class LinkBoard {
public:
    static constexpr std::uint32_t registers = 48;   ///< of the chip; higher numbers are an error on the bus
    static constexpr std::uint32_t lines = 1 << 10;

    struct Write {
        std::uint32_t address, value;
        bool operator==(const Write&) const = default;
    };

    LinkBoard(const std::string& module, const std::string& parameters, int seed)
        : rng(std::uint64_t(seed)),
          memory(lines),
          chip(registers),
          board(16),
          rtl(Config{}, module + " LineBits=10 " + parameters, seed) {
        for (const char* name : {"wb_ack", "wb_err", "host_req_ready", "host_next", "host_rd_valid"})
            in(name, 0);
        wb_ = {&rtl.port("wb_cyc"), &rtl.port("wb_we"), &rtl.port("wb_adr"), &rtl.port("wb_dat_out")};
        memory_ = {&rtl.port("host_req_valid"), &rtl.port("host_req_write"), &rtl.port("host_req_addr"),
                   &rtl.port("host_wr_data")};
        ack_ = &rtl.port("wb_ack"), err_ = &rtl.port("wb_err"), read_ = &rtl.port("wb_dat");
        ready_ = &rtl.port("host_req_ready"), next_ = &rtl.port("host_next");
        rd_valid_ = &rtl.port("host_rd_valid"), rd_data_ = &rtl.port("host_rd_data");
    }
    virtual ~LinkBoard() = default;

    static std::uint32_t get(const RcPort& port) {
        std::uint32_t value = 0;
        std::memcpy(&value, port.data, port.bytes < 4 ? port.bytes : 4);
        return value;
    }
    static void set(const RcPort& port, std::uint32_t value) {
        std::memcpy(port.data, &value, port.bytes < 4 ? port.bytes : 4);
    }
    void in(const char* name, std::uint32_t value) { set(rtl.port(name), value); }
    std::uint32_t out(const char* name) { return get(rtl.port(name)); }

    /// One clock cycle of everything.
    void step() {
        drive_bus();
        drive_memory();
        drive_sides();
        rtl.settle();
        rtl.clock();
        ++cycle;
    }

    std::uint64_t cycle = 0;
    Rng rng;
    std::vector<MemoryLine> memory;
    std::vector<std::uint32_t> chip, board;
    std::vector<Write> writes;     ///< of registers of the chip (address) and lines (2^31 + line)
    std::uint64_t reads = 0;       ///< of registers of the chip
    bool chip_is_silent = false;   ///< the chip answers no access
    int memory_pause = 4;          ///< at most so many cycles between events of the memory

    RtlModule rtl;

protected:
    virtual void drive_sides() = 0;   ///< sets the module's other inputs, after a look at its outputs

private:
    struct Bus {
        const RcPort *cyc, *we, *adr, *dat;
    };
    struct Port4 {
        const RcPort *valid, *write, *addr, *data;
    };

    /// As rc_host answers: two cycles after the request.
    void drive_bus() {
        const bool asks = get(*wb_.cyc) && !chip_is_silent;
        const bool answers = asks && bus_wait_ == 2;
        set(*ack_, 0);
        set(*err_, 0);
        if (answers) {
            const std::uint32_t address = get(*wb_.adr);
            const bool good = address < registers;
            set(good ? *ack_ : *err_, 1);
            set(*read_, good ? chip[address] : 0xbad);
            if (good && get(*wb_.we)) {
                chip[address] = get(*wb_.dat);
                writes.push_back({address, chip[address]});
            }
            reads += good && !get(*wb_.we);
        }
        bus_wait_ = asks && !answers ? bus_wait_ + 1 : 0;
    }

    /// One request at a time. Beats of a write have gaps between them, beats of a read have none.
    void drive_memory() {
        set(*ready_, 0);
        set(*next_, 0);
        set(*rd_valid_, 0);
        if (beat_ < 0) {   // idle
            if (!get(*memory_.valid) || rng.below(memory_pause) != 0) return;
            set(*ready_, 1);
            line_ = get(*memory_.addr);
            is_write_ = get(*memory_.write);
            beat_ = 0;
            wait_ = rng.below(memory_pause);
            if (!is_write_ || wait_ > 0) return;   // else the first beat is taken with the request
        }
        if (wait_ > 0) {
            --wait_;
            return;
        }
        std::uint8_t* const bytes = memory.at(line_).data() + 2 * beat_;
        if (is_write_) {
            if (rng.below(memory_pause) > 1) return;
            set(*next_, 1);
            const std::uint32_t data = get(*memory_.data);
            bytes[0] = std::uint8_t(data), bytes[1] = std::uint8_t(data >> 8);
        } else {
            set(*rd_valid_, 1);
            set(*rd_data_, std::uint32_t(bytes[0] | bytes[1] << 8));
        }
        if (++beat_ < 32) return;
        beat_ = -1;
        if (is_write_) writes.push_back({0x8000'0000u + line_, link_checksum(memory[line_])});
    }

    Bus wb_{};
    Port4 memory_{};
    const RcPort *ack_, *err_, *read_, *ready_, *next_, *rd_valid_, *rd_data_;
    int bus_wait_ = 0, beat_ = -1, wait_ = 0;
    std::uint32_t line_ = 0;
    bool is_write_ = false;
};

/// The faults of a wire: each byte has a chance of each, in parts of a million.
struct Faults {
    int lost = 0, doubled = 0, damaged = 0, inserted = 0;
    static Faults all(int each) { return {each, each, each, each}; }

    /// Sends a byte over the wire.
    void pass(std::uint8_t byte, std::deque<std::uint8_t>& to, Rng& rng) const {
        const auto happens = [&](int chance) { return chance > 0 && rng.below(1'000'000) < chance; };
        while (happens(inserted)) to.push_back(std::uint8_t(rng.next()));
        if (happens(lost)) return;
        if (happens(damaged)) byte ^= std::uint8_t(1 << rng.below(8));
        to.push_back(byte);
        if (happens(doubled)) to.push_back(byte);
    }
};

/// rc_link alone, with wires of bytes. The host is the other end of the channel. A cycle is a microsecond.
class ByteBoard : public LinkBoard, public Channel {
public:
    static constexpr int quiet = 300;   ///< cycles

    explicit ByteBoard(int seed, int quiet_cycles = quiet)
        : LinkBoard("rc_link", "QuietCycles=" + std::to_string(quiet_cycles), seed),
          rx_valid_(&rtl.port("rx_valid")),
          rx_data_(&rtl.port("rx_data")),
          rx_ready_(&rtl.port("rx_ready")),
          tx_valid_(&rtl.port("tx_valid")),
          tx_data_(&rtl.port("tx_data")),
          tx_ready_(&rtl.port("tx_ready")),
          reg_valid_(&rtl.port("reg_valid")),
          reg_write_(&rtl.port("reg_write")),
          reg_addr_(&rtl.port("reg_addr")),
          reg_in_(&rtl.port("reg_data")),
          reg_out_(&rtl.port("reg_data_out")),
          reg_good_(&rtl.port("reg_good")),
          bad_(&rtl.port("bad")) {
        board[0] = board_magic, board[1] = link_version;
        board[2] = 0x1234'5678, board[3] = 0x9abc'def0, board[4] = lines;
        reset();
    }
    void reset() {
        set(*rx_valid_, 0);
        set(*tx_ready_, 0);
        rtl.reset();
    }
    /// Settings of a link to this board: a byte takes a microsecond.
    static LinkSettings settings() {
        LinkSettings s;
        s.name = "test";
        s.baud = 10'000'000;
        s.patience = LinkTime(2 * quiet);
        s.line = LinkTime(150);
        s.hello = 77;
        s.tries = 20;
        return s;
    }

    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> into, LinkTime most) override {
        Moved moved{out.size(), 0};
        if (cut) throw LinkLost("test: the cable is cut");
        for (const std::uint8_t byte : out) {
            if (++bytes_sent != lose) to_board_faults.pass(byte, to_board, rng);
            if (bytes_sent == cut_after) cut = true;
        }
        const std::uint64_t end = cycle + std::uint64_t(most.count());
        if (!out.empty() && most.count() == 0) step();
        while (cycle < end) {
            for (int i = 0; i < 32 && cycle < end; ++i) step();
            if (!to_host.empty()) break;
        }
        while (moved.read < into.size() && !to_host.empty()) {
            into[moved.read++] = to_host.front();
            to_host.pop_front();
        }
        return moved;
    }
    LinkTime now() override { return LinkTime(cycle); }

    Faults to_board_faults, to_host_faults;
    std::deque<std::uint8_t> to_board, to_host;
    std::uint64_t bytes_sent = 0, cut_after = 0;   ///< the cable is cut after that byte; 0: never
    bool cut = false;
    std::uint64_t lose = 0;        ///< this byte to the board is lost; 0: none
    std::uint64_t lose_back = 0;   ///< this byte to the host is lost; 0: none
    std::uint64_t bytes_back = 0;
    std::uint64_t bad = 0;   ///< packets and parts that the board dropped
    int pace = 1;            ///< a byte comes once in so many cycles at random

private:
    void drive_sides() override {
        // Board registers are answered in the same cycle. Number 5 and 10 to 13 can be written.
        if (get(*reg_valid_)) {
            const std::uint32_t address = get(*reg_addr_);
            const bool good = address < board.size() &&
                              (!get(*reg_write_) || address == 5 || (address >= 10 && address <= 13));
            set(*reg_good_, good);
            set(*reg_in_, good ? board[address] : 0xbad);
            if (good && get(*reg_write_)) board[address] = get(*reg_out_);
        }
        bad += get(*bad_);
        // An offered byte stays until it is taken.
        const bool offers = !to_board.empty() && (was_offered_ || pace == 1 || rng.below(pace) == 0);
        set(*rx_valid_, offers);
        if (offers) set(*rx_data_, to_board.front());
        const bool taken = offers && get(*rx_ready_);
        was_offered_ = offers && !taken;
        if (taken) to_board.pop_front();
        const bool accepts = pace == 1 || rng.below(pace) == 0;
        set(*tx_ready_, accepts);
        if (accepts && get(*tx_valid_) && ++bytes_back != lose_back)
            to_host_faults.pass(std::uint8_t(get(*tx_data_)), to_host, rng);
    }

    const RcPort *rx_valid_, *rx_data_, *rx_ready_, *tx_valid_, *tx_data_, *tx_ready_;
    const RcPort *reg_valid_, *reg_write_, *reg_addr_, *reg_in_, *reg_out_, *reg_good_, *bad_;
    bool was_offered_ = false;
};

/// The expected contents of memory and registers. Writes go to them and to a link; reads are compared.
class LinkTwin {
public:
    LinkTwin(LinkBoard& board, BoardLink& link, int seed)
        : board_(board),
          link_(link),
          rng_(std::uint64_t(seed) + 1000),
          memory_(board.memory),
          chip_(board.chip) {}

    std::vector<MemoryLine> random_lines(std::size_t count) {
        std::vector<MemoryLine> lines(count);
        for (MemoryLine& line : lines)
            for (std::uint8_t& byte : line)   // often a byte of the mark
                byte = rng_.below(8) == 0 ? link_mark[std::size_t(rng_.below(2))] : std::uint8_t(rng_.next());
        return lines;
    }

    /// One random operation. Returns false if it found an error.
    bool act(int max_lines) {
        const int what = rng_.below(16);
        const std::uint32_t number = std::uint32_t(rng_.below(LinkBoard::registers));
        const std::size_t count = std::size_t(1 + rng_.below(max_lines));
        const std::uint32_t first = std::uint32_t(rng_.below(int(LinkBoard::lines - count)));
        if (what < 7) {
            chip_[number] = std::uint32_t(rng_.next());
            link_.write_register(RegisterSpace::chip, number, chip_[number]);
            expected_.push_back({number, chip_[number]});
            return true;
        }
        if (what < 12) return link_.read_register(RegisterSpace::chip, number) == chip_[number];
        if (what < 14) {
            const std::vector<MemoryLine> lines = random_lines(count);
            link_.write_lines(first, lines);
            for (std::size_t i = 0; i < count; ++i) {
                memory_[first + i] = lines[i];
                expected_.push_back({0x8000'0000u + std::uint32_t(first + i), link_checksum(lines[i])});
            }
            return true;
        }
        const std::span<const MemoryLine> here = std::span(memory_).subspan(first, count);
        if (what == 14) {
            std::vector<MemoryLine> lines(count);
            link_.read_lines(first, lines);
            return std::ranges::equal(lines, here);
        }
        return link_.check_lines(first, std::uint16_t(count)) ==
               link_checksum({here.front().data(), here.size_bytes()});
    }

    /// Every write was executed once and in order, and everything holds what was written last.
    bool agrees() const {
        return board_.writes == expected_ && board_.memory == memory_ && board_.chip == chip_;
    }

private:
    LinkBoard& board_;
    BoardLink& link_;
    Rng rng_;
    std::vector<MemoryLine> memory_;
    std::vector<std::uint32_t> chip_;
    std::vector<LinkBoard::Write> expected_;
};

}   // namespace rayclock::test
