// Ctrl-C: long commands end soon, leave no incomplete files, and leave no process running.
#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
namespace fs = std::filesystem;

namespace {

/// Counts processes whose command line or working directory contains this folder.
std::size_t processes_of(const std::string& folder) {
    std::size_t found = 0;
    for (const auto& process : fs::directory_iterator("/proc")) {
        std::error_code error;
        const std::string cwd = fs::read_symlink(process.path() / "cwd", error).string();
        found += cwd.starts_with(folder) ||
                 content_of((process.path() / "cmdline").string()).find(folder) != std::string::npos;
    }
    return found;
}

struct Stopped {
    ProgramRun outcome;
    double seconds = 0;   ///< from Ctrl-C to the end
};
Stopped stop(const std::vector<std::string>& arguments, const std::string& cache) {
    using Clock = std::chrono::steady_clock;
    Clock::time_point at;
    Stopped s;
    s.outcome = run_and_stop(arguments, {"RAYCLOCK_CACHE=" + cache}, 2, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
        at = Clock::now();
        return true;
    });
    s.seconds = std::chrono::duration<double>(Clock::now() - at).count();
    return s;
}

}   // namespace

TEST_CASE("Ctrl-C ends every long command within a second, and nothing half-written stays", "[slow]") {
    const std::vector<std::vector<std::string>> commands{
        {"render", "tree:8", "--engine", "reference", "--size", "4096x3072", "-o", "out.png"},
        {"render", "gears:4", "--engine", "rtl", "-o", "out.png"},
        {"simulate", "spheres", "--depth", "8", "--aa", "4", "--size", "2048x1536", "--clock", "66", "--json",
         "out.json"},
        {"simulate", "gears:4", "--engine", "rtl", "--json", "out.json"},
        {"verify", "gears:4", "--size", "512x384", "-o", "out"},
        {"verify", "--torture", "--json", "out.json"},
        {"stress", "--test", "all", "--rays", "1e10", "--json", "out.json"},
        {"explain", "spheres", "500,300", "--depth", "8", "--aa", "4", "--size", "2048x1536", "--json",
         "out.json"},
        {"trace", "spheres", "--depth", "8", "--aa", "4", "--size", "2048x1536", "--cycles", "2000:3000",
         "-o", "out.pftrace"},
        {"simulate", "spheres", "--depth", "8", "--aa", "4", "--size", "2048x1536", "--clock", "33,66",
         "--json", "out.json"},
        {"sweep", "tree:8", "--axis", "coord_bits=12:20", "--axis", "clock=33,66", "--json", "out.json"},
        {"fit", "tree:8", "-o", "out.json"},
        {"study", "tradeoff", "-o", "out.md"},
        {"study", "counts", "-o", "out.md"},
        {"study", "area", "-o", "out.md"},
        {"study", "yardstick", "-o", "out.md"},
        {"study", "figures", "-o", "out"},
        {"study", "structures", "--no-netlist", "-o", "out"},
        {"study", "gigahertz", "-o", "out"},
        {"bench", "balls:4", "--size", "1024x768", "--json", "out.json"},
        {"export", "spheres", "--depth", "8", "--aa", "4", "--size", "2048x1536", "--config", "wide", "-o",
         "out"},
    };
    for (const std::vector<std::string>& command : commands) {
        Stopped stopped;
        for (int attempt = 0; attempt < 3; ++attempt) {   // retries, because other jobs may delay it
            const TestFolder folder;
            std::vector<std::string> words = command;
            if (words.back().starts_with("out")) words.back() = folder.name(words.back());
            const bool is_page = words[1] == "structures" || words[1] == "gigahertz" || words[1] == "figures";
            if (is_page) fs::create_directory(words.back());
            stopped = stop(words, folder.name("cache"));
            INFO(command[0] << " " << command[1] << ": " << stopped.outcome.out << stopped.outcome.err);
            const int code = stopped.outcome.code;   // -1: there was nothing to clean up
            CHECK((code == 1 || code == 2 || code == -1));
            CHECK(processes_of(folder.name("")) == 0);
            for (const auto& [name, bytes] : folder.contents()) {
                if (name == "cache" || name.starts_with("cache/") || (is_page && bytes == "folder")) continue;
                INFO(name);
                CHECK(name == "out.json");
                CHECK(nlohmann::json::parse(bytes)["partial"] == true);
            }
            if (stopped.seconds < 1) break;
        }
        INFO(command[0] << " " << command[1]);
        CHECK(stopped.seconds < 1);
    }
}
