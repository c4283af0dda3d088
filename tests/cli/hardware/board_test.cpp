// The board: what it refuses before any work, its actions on a simulated board behind a port, and Ctrl-C
// while a board is awaited.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
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

std::vector<std::string> at_port(const std::string& action, const std::string& port,
                                 const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"board", action, "--port", port};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Adds the last names of all keys to `names`. The keys of `units` are names of units and causes, so only the
/// kinds of causes count.
void add_keys(const nlohmann::json& json, std::set<std::string>& names) {
    if (json.is_array())
        for (const auto& element : json) add_keys(element, names);
    if (!json.is_object()) return;
    for (const auto& [key, value] : json.items()) {
        names.insert(key);
        if (key == "units")
            for (const auto& unit : value)
                for (const auto& [kind, causes] : unit.items()) names.insert(kind);
        else
            add_keys(value, names);
    }
}

/// The last names of the keys that docs/guide/report.md explains for an action.
std::set<std::string> documented_keys(const std::string& action) {
    std::istringstream page(content_of(source_folder() + "/docs/guide/report.md"));
    std::set<std::string> names;
    std::string line, now;
    bool is_here = false;
    while (std::getline(page, line)) {
        if (line.starts_with("## ")) is_here = line == "## board";
        if (!is_here || !line.starts_with("| ")) continue;
        const std::size_t first = line.find("| ", 1), second = line.find(" | ", first + 1);
        if (line.starts_with("| `")) now = line.substr(3, line.find('`', 3) - 3);
        if (now != action) continue;
        const std::string keys = line.substr(first, second - first);
        const std::regex key("`([^`]*)`"), name("[a-z_]+");
        for (std::sregex_iterator k(keys.begin(), keys.end(), key), end; k != end; ++k) {
            const std::string path = (*k)[1];
            for (std::sregex_iterator n(path.begin(), path.end(), name); n != end; ++n)
                if (n->position() == 0 || path[std::size_t(n->position()) - 1] != '<') names.insert(n->str());
        }
    }
    return names;
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

TEST_CASE("a sample reports the reads of the board's screen, and no underruns", "[long]") {
    const TestFolder folder;
    const std::string out = folder.name("out.json");
    CHECK(run_program({"simulate", "gears:1", "--config", "ulx3s-board", "--clock", "75", "--size", "320x240",
                       "--sample", "10%", "--json", out})
              .code == 0);
    const auto report = nlohmann::json::parse(content_of(out));
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
    const TestFolder folder;
    const std::string file = folder.write("file", "text");
    check_refused(run_program(tiny("board", {"--sdram", "is42s"})),
                  {"no SDRAM is called 'is42s'; there are ", "is42s16160g"});
    check_refused(run_program(tiny("board", {"--port", folder.name("none")})), {"there is no such port"});
    check_refused(run_program(tiny("board", {"--port", file})), {"this is not a serial port"});
    check_refused(run_program(tiny("board", {"-o", file + "/out"})), {file});
    check_refused(run_program({"board", "gears:1", "--config", "ulx3s", "--size", "16x12"}),
                  {"dram=board", "ulx3s-board"});
}

TEST_CASE("actions of the board refuse what has no meaning for them") {
    const TestFolder folder;
    const std::string there = folder.write("there", "text"), none = folder.name("none");
    check_refused(run_program({"board"}), {"SCENE is missing"});
    check_refused(run_program({"board", "load"}), {"load: SCENE is missing"});
    check_refused(run_program({"board", "lod", "gears:1"}), {"'lod'", "did you mean 'load'"});
    for (const char* action : {"load", "run", "read", "counters"}) {
        std::vector<std::string> words{"board", action};
        if (std::string(action) == "load") words.push_back("gears:1");
        if (std::string(action) == "read") words.insert(words.end(), {"-o", none + ".png"});
        check_refused(run_program(words), {std::string(action) + " needs --port", "rayclock board serve"});
        words.insert(words.end(), {"--port", none});
        check_refused(run_program(words), {none + ": there is no such port"});
    }
    check_refused(run_program({"board", "run", "gears:1"}), {"run takes no scene"});
    check_refused(run_program(at_port("run", none, {"--depth", "1"})), {"--depth", "no meaning for run"});
    check_refused(run_program(at_port("run", none, {"--eye", "0,0,1"})), {"--eye", "no meaning for run"});
    check_refused(run_program(at_port("run", none, {"--frames", "0"})), {"--frames", "0"});
    check_refused(run_program(at_port("run", none, {"-o", "x"})), {"-o has no meaning for run"});
    check_refused(run_program(at_port("counters", none, {"--size", "8x8"})), {"--size has no meaning"});
    check_refused(run_program(at_port("counters", none, {"--dark"})), {"--dark has no meaning"});
    check_refused(run_program(at_port("counters", none, {"--patience", "0"})), {"--patience", "0"});
    check_refused(run_program(at_port("read", none)), {"-o names the file"});
    check_refused(run_program(at_port("read", none, {"-o", none})), {"not the name of a PNG file"});
    for (const char* lines : {"", "1", "1:", ":1", "1:0", "-1:4", "1:2:3", "1:99999999999999999999"})
        check_refused(run_program(at_port("read", none, {"-o", none, "--lines", lines})), {"--lines"});
    check_refused(run_program({"board", "gears:1", "--cycles", "5"}), {"--cycles has no meaning for check"});
    check_refused(run_program({"board", "serve", "--dark", "-o", none + ".png"}), {"--dark", "no screen"});
    check_refused(run_program({"board", "serve", "--config", "ulx3s"}), {"dram=board"});
    CHECK(folder.contents() == std::map<std::string, std::string>{{"there", "text"}});
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
        const ProgramRun outcome = run_and_stop(tiny("board", more), {}, 2, [&] {
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

TEST_CASE("a board that serve simulates is loaded, drawn, read and checked through its port", "[slow]") {
    const TestFolder folder;
    const std::string port = folder.name("board.tty"), screen = folder.name("screen.png"),
                      served = folder.name("served.json"), picture = folder.name("picture.png"),
                      lines = folder.name("lines"), out = folder.name("out");
    using Clock = std::chrono::steady_clock;
    Clock::time_point stopped;
    const auto report = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--json", "-"});
        const ProgramRun outcome = run_program(all);
        INFO(words[1] << ": " << outcome.err);
        CHECK(outcome.code == 0);
        return nlohmann::json::parse(outcome.out, nullptr, false);
    };
    const auto compare_keys = [](const std::string& action, std::initializer_list<nlohmann::json> reports) {
        std::set<std::string> written;
        for (const nlohmann::json& one : reports) add_keys(one, written);
        INFO(action);
        CHECK(written == documented_keys(action));
    };
    const auto balls = [&](const std::string& action) {
        std::vector<std::string> words{"board", "balls:1", "--depth", "1", "--size", "16x12", "--port", port};
        if (action == "load")
            words.insert(words.begin() + 1, action);
        else
            words.insert(words.end(), {"-o", out});   // check, which is left out
        return words;
    };
    const ProgramRun outcome =
        run_and_stop({"board", "serve", "--port", port, "-o", screen, "--json", served}, {}, 2, [&] {
            if (!std::filesystem::exists(std::filesystem::symlink_status(port))) return false;
            check_refused(run_program({"board", "serve", "--port", port}), {port, "this exists already"});
            check_refused(run_program(at_port("run", port)), {"no scene was loaded"});
            check_refused(run_program(at_port("counters", port)), {"has not drawn a frame"});
            check_refused(run_program(at_port("run", port, {"--set", "node_sets=4"})),
                          {"another configuration than 'ulx3s-board'"});
            check_refused(run_program(at_port("run", port, {"--sdram", "is42s16160g"})), {"64 MB"});
            check_refused(run_program(at_port("read", port, {"-o", lines, "--lines", "1048576:1"})),
                          {"the board has lines 0 to 1048575"});
            const auto check = report(balls("check"));
            compare_keys("check", {check});
            const auto load = report(balls("load"));
            compare_keys("load", {load});
            check_refused(run_program(at_port("read", port, {"-o", picture})), {"has not drawn a frame"});
            const auto run = report(at_port("run", port, {"--frames", "2"}));
            compare_keys("run", {run});
            CHECK(run["frames"].size() == 2);
            // The caches are empty before the first frame, and only then.
            CHECK(run["frames"][0]["cycles"]["board"] == check["frames"][0]["cycles"]["model"]);
            CHECK(run["frames"][1]["cycles"]["board"] < run["frames"][0]["cycles"]["board"]);
            CHECK(report(at_port("run", port))["frames"][0] == run["frames"][0]);
            const auto counters = report(at_port("counters", port));
            compare_keys("counters", {counters});
            CHECK(counters["cycles"] == run["frames"][0]["cycles"]);
            for (const auto& [unit, kinds] : counters["units"].items()) {
                INFO(unit);
                std::uint64_t sum = 0;
                for (const auto& causes : kinds)
                    for (const auto& cycles : causes) sum += cycles.get<std::uint64_t>();
                CHECK(sum == counters["cycles"]["board"]);
            }
            compare_keys("read", {report(at_port("read", port, {"-o", picture})),
                                  report(at_port("read", port, {"-o", lines, "--lines", "0:3"}))});
            stopped = Clock::now();
            return true;
        });
    INFO(outcome.out << outcome.err);
    CHECK(outcome.code == 0);
    CHECK(std::chrono::duration<double>(Clock::now() - stopped).count() < 1.5);
    CHECK(outcome.out.find("--port " + port + " drives it") != std::string::npos);
    compare_keys("serve", {nlohmann::json::parse(content_of(served), nullptr, false)});
    CHECK(content_of(picture) == content_of(out + "/model.png"));
    CHECK(content_of(lines).size() == 3 * 64);
    CHECK_FALSE(std::filesystem::exists(std::filesystem::symlink_status(port)));
    CHECK(std::filesystem::exists(screen));
}

TEST_CASE("a screen whose requests are never granted is reported, and the board is not equal", "[slow]") {
    const TestFolder folder;
    const std::string rtl = folder.name("rtl"), file = rtl + "/board/rc_board.sv";
    std::filesystem::copy(source_folder() + "/rtl", rtl, std::filesystem::copy_options::recursive);
    std::string text = content_of(file);
    for (const char* signal : {".scan_req_valid_i(scan_req_valid", ".req_ready_i(scan_req_ready"}) {
        const std::size_t at = text.find(std::string(signal) + ")");
        REQUIRE(at != std::string::npos);
        text.insert(at + std::string(signal).size(), " && 1'b0");
    }
    folder.write("rtl/board/rc_board.sv", text);
    const std::string json = folder.name("report.json");
    const ProgramRun outcome =
        run_program({"board", "tetra:1", "--config", "ulx3s", "--set", "dram=board", "--set", "scan_out=1",
                     "--set", "pixel_writes=1", "--size", "16x12", "--json", json},
                    {"RAYCLOCK_RTL=" + rtl});
    INFO(outcome.out << outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.out.ends_with("DIFFERENT\n"));
    CHECK(outcome.out.find("EQUAL") == std::string::npos);
    const auto report = nlohmann::json::parse(content_of(json), nullptr, false);
    CHECK(report["good"] == false);
    // The picture in memory is right, and none of its pixels reaches the screen.
    CHECK(report["frames"][0]["wrong_pixels"] == 0);
    CHECK(report["underruns"] > 0);
    CHECK(report["wrong_screen_pixels"] > 0);
    CHECK(report["faults"].empty());
}
