// The board: what it refuses before any work, and Ctrl-C while a board is awaited.
#include <chrono>
#include <thread>

#include <pty.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;

namespace {

/// A port behind which nothing answers.
struct SilentPort {
    SilentPort() {
        char path[128] = "";
        REQUIRE(openpty(&outer, &inner, path, nullptr, nullptr) == 0);
        name = path;
    }
    ~SilentPort() { close(outer), close(inner); }
    int outer = -1, inner = -1;
    std::string name;
};

std::vector<std::string> tiny(const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> words{command, "gears:1", "--config", "ulx3s-board", "--size", "16x12"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}   // namespace

TEST_CASE("clocks that the board's memory does not allow are refused") {
    for (const char* command : {"simulate", "verify", "board"}) {
        INFO(command);
        check_refused(run_program(tiny(command, {"--clock", "143"})),
                      {"as4c32m16sb", "at most 142.857 MHz, not 143"});
        check_refused(run_program(tiny(command, {"--clock", "24.999"})), {"at least 25 MHz"});
    }
    check_refused(run_program(tiny("simulate", {})), {"--clock 200: ", "at most 142.857 MHz"});
    check_refused(run_program(tiny("board", {"--clock", "66.667"})),
                  {"--clock 66.667: ", "a multiple of 0.005 MHz"});
    check_refused(run_program(tiny("board", {"--clock", "50,75"})), {"takes one clock"});
}

TEST_CASE("a sample reports the reads of the board's screen, and no underruns") {
    const Folder folder;
    const std::string out = folder.name("out.json");
    CHECK(run_program({"simulate", "gears:1", "--config", "ulx3s-board", "--clock", "75", "--size", "320x240",
                       "--sample", "10%", "--json", out})
              .code == 0);
    const auto report = nlohmann::json::parse(bytes_of(out));
    for (const auto& memory : {report["memory"], report["clocks"][0]["memory"]}) {
        const auto& screen = memory["dram"]["scan_out"];
        CHECK(screen["reads"] > 0);
        CHECK(screen["underruns"].is_null());
        CHECK(screen.size() == 2);
    }
}

TEST_CASE("parts of the board cannot be left out, and its screen has a size") {
    for (const char* set :
         {"scan_out=0", "pixel_writes=0", "source=stream", "pipelines=2", "dram_channels=2"}) {
        INFO(set);
        check_refused(run_program(tiny("simulate", {"--clock", "75", "--set", set})), {"ulx3s-board: "});
    }
    check_refused(
        run_program({"simulate", "gears:1", "--config", "ulx3s-board", "--clock", "75", "--size", "641x480"}),
        {"641x480", "640x480"});
}

TEST_CASE("boards, ports and memories that are not there are refused before the work") {
    const Folder folder;
    const std::string file = folder.write("file", "text");
    check_refused(run_program(tiny("board", {"--sdram", "is42s"})),
                  {"no SDRAM is called 'is42s'; there are ", "is42s16160g"});
    check_refused(run_program(tiny("board", {"--port", folder.name("none")})), {"there is no such port"});
    check_refused(run_program(tiny("board", {"--port", file})), {"this is not a serial port"});
    check_refused(run_program(tiny("board", {"-o", file + "/out"})), {file});
    check_refused(run_program({"board", "gears:1", "--config", "ulx3s", "--size", "16x12"}),
                  {"dram=board", "ulx3s-board"});
}

TEST_CASE("a port where nothing answers ends within seconds") {
    const SilentPort port;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    check_refused(run_program(tiny("board", {"--port", port.name})),
                  {port.name, "no rayclock board answers"});
    CHECK(std::chrono::duration<double>(Clock::now() - begin).count() < 10);
}

TEST_CASE("Ctrl-C ends the wait for a board, and a simulated board", "[slow]") {
    const SilentPort port;
    using Clock = std::chrono::steady_clock;
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--port", port.name}, {"--dark"}, {}}) {
        Clock::time_point at;
        // The first run builds the board's RTL; the wait on the port lasts two seconds.
        const int wait = more.size() == 2 ? 1000 : 5000;
        const Outcome outcome = run_and_stop(tiny("board", more), {}, 2, [&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(wait));
            at = Clock::now();
            return true;
        });
        INFO(outcome.err);
        CHECK(outcome.code == 1);
        CHECK(outcome.err.find("interrupted") != std::string::npos);
        CHECK(std::chrono::duration<double>(Clock::now() - at).count() < 1.5);
    }
}
