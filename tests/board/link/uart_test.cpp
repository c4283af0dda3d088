// The UART alone, and the host link from pin to pin: rates that do not divide the clock, clocks that differ
// by two in a hundred, glitches, breaks, and the host's library over a line of bits.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/board/link/link_board.hpp"
#include "sim/board/serial_line.hpp"
#include "tests/support/machine/build_all.hpp"
#include <catch2/catch.hpp>

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Rate {
    int khz, baud;
    double bit() const { return khz * 1000.0 / baud; }   ///< cycles
    int quiet() const { return 200'000'000 / baud; }     ///< microseconds: twenty bytes
    std::string text() const { return " ClkKhz=" + std::to_string(khz) + " Baud=" + std::to_string(baud); }
};
/// The board's clocks and rates, and a fast one for tests of packets.
const Rate rates[] = {{75'000, 3'000'000}, {62'500, 3'000'000}, {50'000, 115'200}};
const Rate fast{75'000, 15'000'000};

/// rc_host_link with a serial line. The host is the other end of the channel.
class UartBoard : public LinkBoard, public Channel {
public:
    static std::string parameters(const Rate& rate) {
        return rate.text() + " QuietUs=" + std::to_string(rate.quiet()) + " ConfigHash=64'hfedcba9876543210";
    }

    /// The host's clock is faster by this fraction.
    UartBoard(const Rate& rate, double faster, int seed)
        : LinkBoard("rc_host_link", parameters(rate), seed),
          sender(rate.bit() / (1 + faster)),
          receiver(rate.bit() / (1 + faster)),
          rate_(rate),
          rx_(&rtl.port("rx")),
          tx_(&rtl.port("tx")),
          arm_(&rtl.port("arm")) {
        in("init_done", 1);
        in("flushed", 0);
        in("armed", 0);
        in("underruns", 7);
        const std::uint64_t cycles = 0x1234'5678'9abcu;
        std::memcpy(rtl.port("cycles").data, &cycles, sizeof cycles);
        set(*rx_, 1);
        rtl.reset();
        for (int i = 0; i < 4; ++i) step();   // the receiver sees that the line is idle
    }
    LinkSettings settings() const {
        LinkSettings s;
        s.name = "test";
        s.baud = std::uint32_t(rate_.baud);
        s.patience = LinkTime(3 * rate_.quiet() + 20);
        s.hello = 5;
        s.tries = 50;
        return s;
    }

    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> into, LinkTime most) override {
        const auto space = [&] { return buffer - std::min(buffer, sender.bytes.size()); };
        Moved moved;
        moved.written = std::min(out.size(), space());
        sender.bytes.insert(sender.bytes.end(), out.begin(), out.begin() + std::ptrdiff_t(moved.written));
        const std::uint64_t end = cycle + std::uint64_t(most.count()) * std::uint64_t(rate_.khz) / 1000;
        while (cycle < end && receiver.bytes.empty() && moved.written == 0 && (out.empty() || space() == 0))
            step();
        while (moved.read < into.size() && !receiver.bytes.empty()) {
            into[moved.read++] = receiver.bytes.front();
            receiver.bytes.pop_front();
        }
        return moved;
    }
    LinkTime now() override { return LinkTime(cycle * 1000 / std::uint64_t(rate_.khz)); }

    SerialSender sender;
    SerialReceiver receiver;
    int armed = 0;      ///< cycles in which a frame was armed
    int glitches = 0;   ///< in a million cycles, on each wire; each lasts up to two bits

private:
    static constexpr std::size_t buffer = 4096;   // bytes that wait in the host's system

    void drive_sides() override {
        const bool sent = sender.level(cycle), received = get(*tx_);
        set(*rx_, sent != glitch(0));
        receiver.see(cycle, received != glitch(1));
        armed += get(*arm_);
    }
    bool glitch(int wire) {
        if (glitches == 0) return false;
        if (left_[wire] > 0) return --left_[wire] >= 0;
        if (rng.below(1'000'000) < glitches) left_[wire] = 1 + rng.below(int(2 * rate_.bit()));
        return false;
    }

    Rate rate_;
    const RcPort *rx_, *tx_, *arm_;
    int left_[2] = {0, 0};
};

/// A module of the UART alone.
struct UartModule {
    UartModule(const char* module, const Rate& rate) : rtl(Config{}, module + rate.text()) {}
    std::uint32_t get(const char* name) { return LinkBoard::get(rtl.port(name)); }
    void set(const char* name, std::uint32_t value) { LinkBoard::set(rtl.port(name), value); }
    void clock() {
        rtl.settle();
        rtl.clock();
        ++cycle;
    }
    RtlModule rtl;
    std::uint64_t cycle = 0;
};

/// rc_uart_rx and what it receives.
struct Receiver : UartModule {
    explicit Receiver(const Rate& rate) : UartModule("rc_uart_rx", rate) {
        set("rx", 1);
        rtl.reset();
        hold(true, 4);   // it waits until the line is high
    }
    void step(bool level) {
        set("rx", level);
        rtl.settle();
        if (get("valid")) bytes.push_back(std::uint8_t(get("data")));
        faults += get("fault");
        REQUIRE_FALSE((get("valid") && get("fault")));
        rtl.clock();
        ++cycle;
    }
    void hold(bool level, double cycles) {
        for (int i = 0; i < int(cycles); ++i) step(level);
    }
    std::vector<std::uint8_t> bytes;
    int faults = 0;
};

std::vector<std::uint8_t> random_bytes(std::size_t count, std::uint64_t seed) {
    Rng rng(seed);
    std::vector<std::uint8_t> bytes(count);
    for (std::uint8_t& byte : bytes) byte = std::uint8_t(rng.next());
    return bytes;
}

}   // namespace

TEST_CASE("the RTL of the UART builds", "[.build]") {
    std::vector<RtlJob> jobs;
    for (const Rate& rate : {rates[0], rates[1], rates[2], fast}) {
        jobs.push_back({"rc_uart_rx" + rate.text(), "uart", {}});
        jobs.push_back({"rc_uart_tx" + rate.text(), "uart", {}});
        jobs.push_back({"rc_host_link LineBits=10 " + UartBoard::parameters(rate), "uart", {}});
    }
    build_all(jobs);
    SUCCEED("all are there");
}

TEST_CASE("every byte is received from a sender whose clock differs by two in a hundred", "[uart]") {
    for (const Rate& rate : rates)
        for (const double faster : {-0.02, -0.01, 0.0, 0.01, 0.02}) {
            INFO(rate.khz << " kHz, " << rate.baud << " baud, sender faster by " << faster);
            Receiver receiver(rate);
            SerialSender sender(rate.bit() / (1 + faster));
            const std::vector<std::uint8_t> bytes = random_bytes(rate.baud < 1'000'000 ? 40 : 600, 3);
            sender.bytes.assign(bytes.begin(), bytes.end());
            while (!sender.is_idle(receiver.cycle)) receiver.step(sender.level(receiver.cycle));
            receiver.hold(true, rate.bit());
            CHECK((receiver.bytes == bytes));
            CHECK(receiver.faults == 0);
        }
}

TEST_CASE("a byte without a stop bit is rejected, and so is a glitch", "[uart]") {
    for (const Rate& rate : {rates[0], rates[1]}) {
        Receiver receiver(rate);
        const double bit = rate.bit();
        const auto send = [&](std::uint32_t frame, int bits) {
            for (int i = 0; i < bits; ++i) receiver.hold(frame >> i & 1, std::round(bit));
        };
        receiver.hold(true, 3 * bit);
        receiver.hold(false, bit / 2 - 3);   // a glitch shorter than half a bit
        receiver.hold(true, 12 * bit);
        CHECK(receiver.bytes.empty());
        CHECK(receiver.faults == 0);
        send(0x0aau << 1, 10);   // the stop bit is low
        receiver.hold(true, 2 * bit);
        CHECK(receiver.bytes.empty());
        CHECK(receiver.faults == 1);
        send(0x200u | 0x55u << 1, 10);
        receiver.hold(true, 2 * bit);
        CHECK(receiver.bytes == std::vector<std::uint8_t>{0x55});
        receiver.hold(false, 50 * bit);   // a break is one fault, however long it is
        CHECK(receiver.faults == 2);
        receiver.hold(true, bit);
        send(0x200u | 0x31u << 1, 10);
        receiver.hold(true, 2 * bit);
        CHECK(receiver.bytes == std::vector<std::uint8_t>{0x55, 0x31});
        CHECK(receiver.faults == 2);
    }
}

TEST_CASE("a line that is low at the reset is not a byte", "[uart]") {
    Receiver receiver(rates[0]);
    receiver.set("rx", 0);
    receiver.rtl.reset();
    receiver.hold(false, 30 * rates[0].bit());
    receiver.hold(true, 30 * rates[0].bit());
    CHECK(receiver.bytes.empty());
    CHECK(receiver.faults == 0);
}

TEST_CASE("every edge of the transmitter is within a cycle of its time", "[uart]") {
    for (const Rate& rate : {rates[0], rates[1], rates[2], fast}) {
        INFO(rate.khz << " kHz, " << rate.baud << " baud");
        UartModule sender("rc_uart_tx", rate);
        sender.set("valid", 0);
        sender.rtl.reset();
        SerialReceiver receiver(rate.bit());
        const std::vector<std::uint8_t> bytes = random_bytes(60, 4);
        for (const std::uint8_t byte : bytes) {
            sender.set("valid", 1);
            sender.set("data", byte);
            while (!sender.get("ready")) {
                receiver.see(sender.cycle, sender.get("tx"));
                sender.clock();
            }
            receiver.see(sender.cycle, sender.get("tx"));
            sender.clock();   // the byte is accepted
            sender.set("valid", 0);
            const std::uint64_t start = sender.cycle;
            const std::uint32_t frame = 0x200u | std::uint32_t(byte) << 1;
            // The rounding of the divider adds up to 0.5 % of ten bits, less than a tenth of a cycle in these
            // rates.
            for (int bit = 0; bit < 10; ++bit)
                while (double(sender.cycle - start) < std::floor((bit + 1) * rate.bit() - 0.1)) {
                    const double in_bit = double(sender.cycle - start) - bit * rate.bit();
                    if (in_bit >= 1.1) REQUIRE(sender.get("tx") == (frame >> bit & 1));
                    REQUIRE_FALSE(sender.get("ready"));   // until the stop bit is over
                    receiver.see(sender.cycle, sender.get("tx"));
                    sender.clock();
                }
        }
        for (int i = 0; i < int(2 * rate.bit()); ++i) {
            receiver.see(sender.cycle, sender.get("tx"));
            sender.clock();
        }
        CHECK(std::ranges::equal(receiver.bytes, bytes));
    }
}

TEST_CASE("the host reads and writes the board from pin to pin at every rate", "[uart]") {
    for (const Rate& rate : rates)
        for (const double faster : {-0.02, 0.02}) {
            INFO(rate.khz << " kHz, " << rate.baud << " baud, host faster by " << faster);
            UartBoard board(rate, faster, 1);
            BoardLink link(board, board.settings());
            LinkTwin twin(board, link, 1);
            const BoardIdentity identity = link.hello();
            CHECK(identity.config_hash == 0xfedc'ba98'7654'3210u);
            CHECK(identity.lines == LinkBoard::lines);
            const int acts = rate.baud < 1'000'000 ? 8 : 60;
            for (int i = 0; i < acts; ++i) REQUIRE(twin.act(rate.baud < 1'000'000 ? 2 : 24));
            CHECK(twin.agrees());
            CHECK(link.counts().repeated == 0);
            CHECK(link.read(BoardRegister::faults) == 0);
        }
}

TEST_CASE("the board's registers have their values and their effects", "[uart]") {
    UartBoard board(fast, 0, 2);
    BoardLink link(board, board.settings());
    link.hello();
    CHECK(link.read(BoardRegister::status) == 1);
    board.in("flushed", 1);
    CHECK(link.read(BoardRegister::status) == 3);
    board.in("armed", 1);
    CHECK(link.read(BoardRegister::status) == 7);
    CHECK(link.read(BoardRegister::underruns) == 7);
    CHECK(link.read(BoardRegister::cycles) == 0x5678'9abc);
    const std::uint64_t later = 0xffff'0000'0000u;   // the upper word belongs to the lower one
    std::memcpy(board.rtl.port("cycles").data, &later, sizeof later);
    CHECK(link.read(BoardRegister::underruns) == 7);
    CHECK(link.read(BoardRegister::cycles_high) == 0x1234);
    CHECK(link.read(BoardRegister::cycles) == 0);
    CHECK(link.read(BoardRegister::cycles_high) == 0xffff);
    const std::tuple<BoardRegister, const char*, std::uint32_t, std::uint32_t> writable[] = {
        {BoardRegister::draw_base, "draw_base", 0xffff'f15a, 0x15a},
        {BoardRegister::base, "base", 0xffff'f2a5, 0x2a5},
        {BoardRegister::width, "width", 640, 640},
        {BoardRegister::height, "height", 0x1'01e0, 480},
        {BoardRegister::doubled, "double", 3, 1}};
    for (const auto& [number, port, written, value] : writable) {
        CHECK(link.read(number) == 0);
        link.write(number, written);
        CHECK(link.read(number) == value);
        CHECK(board.out(port) == value);
    }
    link.write(BoardRegister::control, 1);
    CHECK((board.out("chip_reset") == 1 && board.armed == 0));
    link.write(BoardRegister::control, 2);
    CHECK((board.out("chip_reset") == 0 && board.armed == 1));   // for one cycle
    CHECK(link.read(BoardRegister::control) == 0);
    for (const BoardRegister fixed : {BoardRegister::magic, BoardRegister::status, BoardRegister::cycles,
                                      BoardRegister::cycles_high, BoardRegister::faults})
        CHECK_THROWS_AS(link.write(fixed, 0), LinkRefused);
    CHECK_THROWS_AS(link.read(BoardRegister(16)), LinkRefused);
}

TEST_CASE("glitches of the line and clocks that differ lose nothing", "[uart][faults]") {
    for (int seed = 1; seed <= 4; ++seed) {
        INFO("seed " << seed);
        UartBoard board(fast, seed % 2 ? 0.02 : -0.02, seed);
        BoardLink link(board, board.settings());
        LinkTwin twin(board, link, seed);
        link.hello();
        board.glitches = 60;
        while (link.counts().packets < 200) REQUIRE(twin.act(6));
        board.glitches = 0;
        CHECK(twin.agrees());
        CHECK(link.counts().repeated > 0);
        CHECK(link.read(BoardRegister::faults) > 0);
    }
}

TEST_CASE("a host that sends too far ahead loses bytes, which are counted, and nothing else", "[uart]") {
    UartBoard board(fast, 0, 3);
    BoardLink link(board, board.settings());
    LinkTwin twin(board, link, 3);
    link.hello();   // its last packet has the number 5
    // An answer takes as long as 19 requests, and the FIFO holds 73.
    for (int i = 0; i < 300; ++i) {
        const std::vector<std::uint8_t> request =
            packet_bytes({LinkKind::read_lines, std::uint8_t(6 + i), 0, 4});
        board.sender.bytes.insert(board.sender.bytes.end(), request.begin(), request.end());
    }
    while (!board.sender.is_idle(board.cycle)) board.step();
    for (int i = 0; i < 2'000'000; ++i) board.step();
    AnswerDecoder decoder;
    const std::vector<std::uint8_t> got(board.receiver.bytes.begin(), board.receiver.bytes.end());
    decoder.push(got);
    int in_order = 0;
    while (const std::optional<LinkAnswer> answer = decoder.next()) {
        if (answer->reason == LinkReason::gap) continue;
        CHECK(answer->sequence == std::uint8_t(6 + in_order++));
        CHECK(std::equal(answer->lines.begin(), answer->lines.end(), board.memory.begin()));
    }
    CHECK((in_order >= 73 && in_order < 300));
    board.receiver.bytes.clear();
    link.hello();
    CHECK(link.read(BoardRegister::faults) >> 16 > 0);
    for (int i = 0; i < 20; ++i) REQUIRE(twin.act(3));
    CHECK(twin.agrees());
}

TEST_CASE("an upload takes the time of its bytes on the wire", "[uart]") {
    // 75 MHz, 3 Mbaud: 320 lines in 20 packets.
    UartBoard board(rates[0], 0, 9);
    BoardLink link(board, board.settings());
    LinkTwin twin(board, link, 9);
    link.hello();
    const std::vector<MemoryLine> lines = twin.random_lines(320);
    const std::uint64_t begin = board.cycle;
    link.write_lines(0, lines);
    const double seconds = double(board.cycle - begin) / 75e6,
                 bound = double(link_packet_most) * 10 / 3e6 / 16;
    WARN(std::uint64_t(double(lines.size()) / seconds)
         << " lines a second; the wire's bound is " << std::uint64_t(1 / bound));
    CHECK(seconds / double(lines.size()) < 1.03 * bound);   // the last acknowledgement comes after all bytes
    CHECK(std::equal(lines.begin(), lines.end(), board.memory.begin()));
}
