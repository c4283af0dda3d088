// A simulated board behind a pseudo-terminal: the terminal itself, and programs that use the board one after
// the other.
#include <atomic>
#include <fstream>
#include <thread>

#include <termios.h>

#include <catch2/catch.hpp>

#include "sim/board/host.hpp"
#include "sim/board/port.hpp"
#include "sim/board/server.hpp"
#include "sim/files/scratch.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock::test::server_test {

using namespace rayclock;
namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t port_baud = 3'000'000;
constexpr int slower = 5000;

/// The smallest board of simulated_board_test.cpp.
Config chip() { return load_config({"ulx3s", {"dram=board", "scan_out=1", "pixel_writes=1"}}); }
BoardShape shape() {
    return {.khz = 30'000, .baud = 6'000'000, .sdram = "as4c32m16sb", .initial_wait_us = 5, .is_lit = false};
}

/// A board that a thread simulates.
class Served {
public:
    explicit Served(ServeLimits limits = {})
        : terminal(), board(chip(), shape()), thread_([this, limits] {
              serve(
                  board, terminal, [this] { return ends_.load(); }, limits);
              is_over = true;
          }) {}
    ~Served() { stop(); }
    void stop() {
        ends_ = true;
        if (thread_.joinable()) thread_.join();
    }

    PseudoTerminal terminal;
    SimulatedBoard board;   ///< not to be used before stop()
    std::atomic<bool> is_over = false;

private:
    std::atomic<bool> ends_ = false;
    std::thread thread_;
};

LinkSettings settings_of(const Port& port) {
    LinkSettings settings;
    settings.name = port.name();
    settings.slower = slower;
    return settings;
}

void wait_until(const std::function<bool()>& is_true) {
    for (int i = 0; i < 3000 && !is_true(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(is_true());
}

}   // namespace

TEST_CASE("a terminal passes bytes between programs, and its link lasts as long as it", "[server]") {
    const TemporaryFolder folder("rayclock-server");
    const fs::path link = folder.path() / "board.tty";
    {
        PseudoTerminal terminal(link);
        CHECK(fs::read_symlink(link) == terminal.name());
        CHECK_FALSE(terminal.is_left());
        // Nothing is echoed before a program has set the terminal.
        const std::uint8_t bytes[] = {0xc5, 0x0a, 0x0d, 0x03, 0x11};
        std::uint8_t in[16];
        CHECK(terminal.write(bytes) == sizeof bytes);
        CHECK(terminal.read(in) == 0);
        CHECK_FALSE(terminal.was_flushed());
        for (int program = 0; program < 2; ++program) {
            {
                Port port(link, port_baud);
                CHECK(port.is_pseudo_terminal());
                CHECK_FALSE(terminal.is_left());
                CHECK(terminal.read(in) == 0);
                CHECK(terminal.was_flushed());
                CHECK(port.exchange(bytes, {}, LinkTime(0)).written == sizeof bytes);
                terminal.wait(LinkTime(1'000'000));
                REQUIRE(terminal.read(in) == sizeof bytes);
                CHECK(std::equal(std::begin(bytes), std::end(bytes), in));
                CHECK(terminal.write(bytes) == sizeof bytes);
                REQUIRE(port.exchange({}, in, LinkTime(1'000'000)).read == sizeof bytes);
                CHECK(std::equal(std::begin(bytes), std::end(bytes), in));
            }
            CHECK(terminal.is_left());
        }
        CHECK_THROWS_WITH(PseudoTerminal(link), Catch::Contains("this exists already"));
        CHECK(fs::is_symlink(fs::symlink_status(link)));
    }
    CHECK_FALSE(fs::exists(fs::symlink_status(link)));
    std::ofstream(link) << "a file of the user";
    CHECK_THROWS_WITH(PseudoTerminal(link), Catch::Contains("this exists already"));
    CHECK(fs::is_regular_file(link));
    CHECK_THROWS_WITH(PseudoTerminal(folder.path() / "no" / "link"), Catch::Contains("No such file"));
}

TEST_CASE("time-outs of a real board are too short for a simulated one, and longer ones are not",
          "[server][long]") {
    Served served;
    Port port(served.terminal.name(), port_baud);
    // The time-outs of three tries are 1.5 s. The simulation needs about seven million cycles.
    constexpr std::uint16_t many = 65'535, lines = 4096;
    LinkSettings settings = settings_of(port);
    settings.tries = 3;
    settings.slower = 1;
    {
        BoardLink link(port, settings);
        CHECK(link.hello().config_hash != 0);
        CHECK_THROWS_AS(link.check_lines(0, many), LinkLost);
    }
    settings = settings_of(port);
    settings.tries = 400;   // the board still computes
    BoardLink link(port, settings);
    link.hello();
    const std::uint32_t checksum = link.check_lines(0, lines);
    CHECK(link.check_lines(0, lines) == checksum);
    CHECK(link.counts().repeated == 0);
}

TEST_CASE("a program that was cut off does not disturb the next one", "[server]") {
    Served served;
    for (int program = 0; program < 3; ++program) {
        Port port(served.terminal.name(), port_baud);
        BoardLink link(port, settings_of(port));
        BoardHost host(link, chip(), sdram_part("as4c32m16sb"));
        CHECK(host.read_lines(0, 1).size() == 1);
        const std::vector<MemoryLine> lines(link_lines_most);
        std::vector<std::uint8_t> half =
            packet_bytes({LinkKind::write_lines, 0, 0, link_lines_most, 0, lines});
        half.resize(100);
        CHECK(port.exchange(half, {}, LinkTime(0)).written == half.size());
        std::this_thread::sleep_for(std::chrono::seconds(1));   // the board has begun to receive it
    }
}

TEST_CASE("a served board stands still without its host, and ends at its last cycle", "[server]") {
    {
        Served served({.linger = LinkTime(500)});   // 15,000 cycles
        std::this_thread::sleep_for(std::chrono::seconds(2));
        {
            Port port(served.terminal.name(), port_baud);
            BoardLink link(port, settings_of(port));
            link.hello();   // wakes it
        }
        std::this_thread::sleep_for(std::chrono::seconds(2));
        served.stop();
        CHECK(served.board.cycle() > 60'000);
        CHECK(served.board.cycle() < 150'000);
    }
    Served served({.last_cycle = 40'000, .linger = LinkTime(0)});
    wait_until([&] { return served.is_over.load(); });
    served.stop();
    CHECK(served.board.cycle() >= 40'000);
    CHECK(served.board.cycle() < 42'000);
}

}   // namespace rayclock::test::server_test
