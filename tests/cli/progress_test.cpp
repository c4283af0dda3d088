// Progress on a terminal: it shows the current work and the remaining time.
#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/cli/program.hpp"
#include "tests/cli/under_test.hpp"

using namespace rayclock::test;

namespace {

struct Watched {
    int code = -1;
    double seconds = 0, silence = 0;   ///< total time, and the longest time without output
    std::string before;                ///< the text shown when that silence began
};

/// Runs the program on a terminal.
Watched watch(const std::vector<std::string>& arguments, const std::string& folder) {
    using Clock = std::chrono::steady_clock;
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), program_under_test());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    REQUIRE(child >= 0);
    if (child == 0) {
        setenv("RAYCLOCK_CACHE", (folder + "cache").c_str(), 1);
        if (chdir(folder.c_str()) == 0) execv(argv[0], argv.data());
        _exit(127);
    }
    Watched w;
    std::string shown;
    const Clock::time_point start = Clock::now();
    Clock::time_point last = start;
    const auto heard = [&](Clock::time_point now) {
        if (const double silence = std::chrono::duration<double>(now - last).count(); silence > w.silence)
            w.silence = silence, w.before = shown;
        last = now;
    };
    for (char bytes[4096];;) {
        pollfd wanted{terminal, POLLIN, 0};
        if (poll(&wanted, 1, 1000) <= 0) continue;
        // An error means that the terminal is closed.
        const ssize_t got = read(terminal, bytes, sizeof bytes);
        heard(Clock::now());
        if (got <= 0) break;
        shown.assign(bytes, std::size_t(got));
    }
    int status = 0;
    waitpid(child, &status, 0);
    close(terminal);
    w.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    w.seconds = std::chrono::duration<double>(last - start).count();
    return w;
}

}   // namespace

TEST_CASE("a terminal shows progress within two seconds", "[slow]") {
    const std::vector<std::vector<std::string>> commands{
        {"explain", "tree:8", "255,190", "--report", "out.html"},
        {"trace", "gears:8", "--cycles", "100000:101000", "-o", "out.kanata"},
        {"export", "gears:8", "-o", "out"},
        {"simulate", "gears:8", "--clock", "66", "--report", "out.html"},
        {"simulate", "spheres", "--depth", "4", "--aa", "2", "--size", "512x384"},
        {"render", "balls:4", "--engine", "reference", "--size", "1024x768", "-o", "out.png"},
        {"stress", "--test", "all", "--rays", "1e5"},
        {"fit", "gears:2", "--size", "128x96", "-o", "out.json"},
        {"bench", "gears:4", "--size", "128x96"},
        {"verify", "gears:4", "--size", "128x96", "--config", "small", "-o", "out"},
        {"sweep", "gears:4", "--size", "128x96", "--axis", "pipelines=1,2", "--axis", "clock=33,66", "-o",
         "out.csv"},
    };
    for (const std::vector<std::string>& command : commands) {
        Watched watched;
        for (int attempt = 0; attempt < 2; ++attempt) {   // retries, because other jobs may delay it
            const TestFolder folder;
            watched = watch(command, folder.name(""));
            if (watched.silence < 2) break;
        }
        INFO(command[0] << " " << command[1] << ": " << watched.seconds << " s, silent for "
                        << watched.silence << " s after '" << watched.before << "'");
        CHECK(watched.code == 0);
        CHECK(watched.silence < 2);
    }
}
