// Ports: what cannot be opened, and the host's library over a pseudo-terminal with the RTL behind it.
#include <atomic>
#include <cerrno>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include "sim/board/port.hpp"
#include "sim/files/scratch.hpp"
#include "tests/board/link/link_board.hpp"
#include <catch2/catch.hpp>

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// A pseudo-terminal: the port has a name, and the test holds the other end.
struct Terminal {
    Terminal() {
        char path[128] = "";
        int inner = -1;
        REQUIRE(openpty(&outer, &inner, path, nullptr, nullptr) == 0);
        name = path;
        fcntl(outer, F_SETFL, O_NONBLOCK);
        held = inner;   // else the other end reads errors until the port is opened
    }
    ~Terminal() { cut(); }
    void cut() {
        if (held >= 0) close(held);
        if (outer >= 0) close(outer);
        held = outer = -1;
    }
    int outer = -1, held = -1;
    std::string name;
};

/// rc_link behind a pseudo-terminal, in a thread of its own.
class Pump {
public:
    Pump(ByteBoard& board, int file) : thread_([this, &board, file] { run(board, file); }) {}
    ~Pump() { stop(); }
    void stop() {
        ends_ = true;
        if (thread_.joinable()) thread_.join();
    }

private:
    void run(ByteBoard& board, int file) {
        std::vector<std::uint8_t> out;
        while (!ends_) {
            std::uint8_t in[4096];
            const ssize_t got = read(file, in, sizeof in);
            if (got > 0) board.to_board.insert(board.to_board.end(), in, in + got);
            for (int i = 0; i < 2000; ++i) board.step();
            out.insert(out.end(), board.to_host.begin(), board.to_host.end());
            board.to_host.clear();
            const ssize_t sent = out.empty() ? 0 : write(file, out.data(), out.size());
            if (sent > 0) out.erase(out.begin(), out.begin() + sent);
        }
    }

    std::atomic<bool> ends_ = false;
    std::thread thread_;
};

LinkSettings settings_of(const Port& port) {
    LinkSettings settings;
    settings.name = port.name();
    settings.hello = 3;
    return settings;
}

std::string refusal(const std::filesystem::path& path, std::uint32_t baud = 3'000'000) {
    try {
        const Port port(path, baud);
    } catch (const UserError& error) {
        return error.what();
    }
    return "opened";
}

}   // namespace

TEST_CASE("a port that cannot be opened is one sentence", "[port]") {
    const TemporaryFolder folder("rayclock-port");
    const std::string missing = (folder.path() / "missing").string(),
                      file = (folder.path() / "file").string();
    std::ofstream(file) << "text";
    CHECK(refusal(missing) == missing + ": there is no such port; is the board plugged in?");
    CHECK(refusal(file) == file + ": this is not a serial port");
    CHECK(refusal(folder.path()) == folder.path().string() + ": this is not a serial port");
    CHECK(refusal(file + "/inside") == file + "/inside: there is no such port; is the board plugged in?");
    CHECK(port_problem("p", EACCES) ==
          "p: no permission to open this port; on many systems the group dialout may open it");
    CHECK(port_problem("p", EIO).starts_with("p: this port cannot be opened ("));

    Terminal terminal;
    CHECK(refusal(terminal.name, 12'345) ==
          terminal.name + ": no serial port has 12345 baud; 115200 and 3000000 are usual");
    {
        const Port port(terminal.name, 115'200);
        CHECK(refusal(terminal.name) == terminal.name + ": another program uses this port");
    }
    CHECK(refusal(terminal.name) == "opened");
}

TEST_CASE("a terminal passes every byte as it is, at each rate", "[port]") {
    Terminal terminal;
    for (const std::uint32_t baud : {9600u, 115'200u, 3'000'000u}) {
        Port port(terminal.name, baud);
        std::vector<std::uint8_t> bytes(256), got;
        for (int i = 0; i < 256; ++i) bytes[std::size_t(i)] = std::uint8_t(i);
        std::uint8_t in[300];
        CHECK(port.exchange(bytes, in, LinkTime(0)).written == 256);
        REQUIRE(read(terminal.outer, in, sizeof in) == 256);
        CHECK(std::equal(bytes.begin(), bytes.end(), in));
        REQUIRE(write(terminal.outer, bytes.data(), bytes.size()) == 256);
        while (got.size() < 256) {
            const std::size_t more = port.exchange({}, in, LinkTime(1'000'000)).read;
            REQUIRE(more > 0);
            got.insert(got.end(), in, in + more);
        }
        CHECK(got == bytes);
        const LinkTime begin = port.now();
        CHECK(port.exchange({}, in, LinkTime(3000)).read == 0);
        CHECK(port.now() - begin >= LinkTime(3000));
    }
}

TEST_CASE("another device is one sentence, and so is a port that is gone", "[port]") {
    Terminal terminal;
    Port port(terminal.name, 3'000'000);
    LinkSettings settings = settings_of(port);
    settings.patience = LinkTime(2000);
    settings.tries = 3;
    const std::string noise = "login: \xc5\x3a\x81 and more";
    REQUIRE(write(terminal.outer, noise.data(), noise.size()) == ssize_t(noise.size()));
    BoardLink link(port, settings);
    REQUIRE_THROWS_WITH(link.hello(), terminal.name +
                                          ": no rayclock board answers; is it plugged in, loaded with "
                                          "a bitstream of rayclock, and set to 3000000 baud?");
    terminal.cut();
    REQUIRE_THROWS_WITH(link.hello(), Catch::Contains(terminal.name + ": the port is gone ("));
}

TEST_CASE("an upload over a terminal goes on after the cable was cut and plugged in again", "[port]") {
    ByteBoard board(60, 1'500'000);   // half a second of this simulation

    Rng rng(60);
    std::vector<MemoryLine> lines(700);
    for (MemoryLine& line : lines)
        for (std::uint8_t& byte : line) byte = std::uint8_t(rng.next());
    std::uint64_t done = 0;
    {
        Terminal terminal;
        Port port(terminal.name, 3'000'000);
        BoardLink link(port, settings_of(port));
        Pump pump(board, terminal.outer);
        CHECK(link.hello().lines == LinkBoard::lines);
        const Progress progress = [&](std::string_view, std::uint64_t now, std::uint64_t) {
            if (now < 300 || terminal.outer < 0) return;
            pump.stop();
            terminal.cut();
        };
        REQUIRE_THROWS_WITH(link.upload(10, lines, done, progress), Catch::Contains("the port is gone"));
    }
    CHECK((done >= 300 && done < lines.size()));
    Terminal terminal;
    Port port(terminal.name, 3'000'000);
    BoardLink link(port, settings_of(port));
    Pump pump(board, terminal.outer);
    link.hello();
    CHECK(link.lines_that_hold(10, lines) >= done);
    link.upload(10, lines, done);
    std::vector<MemoryLine> back(lines.size());
    link.read_lines(10, back);
    CHECK(back == lines);
    pump.stop();
    CHECK(std::equal(lines.begin(), lines.end(), board.memory.begin() + 10));
}
