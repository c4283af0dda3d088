// Ctrl-C while Assimp reads a file: neither its process nor its folder remains.
#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "tests/cli/program.hpp"

using namespace rayclock::test;

TEST_CASE("Ctrl-C ends a converter that hangs, and removes what it left") {
    namespace fs = std::filesystem;
    using Clock = std::chrono::steady_clock;
    const TestFolder folder;
    fs::create_directories(folder.name("bin"));
    fs::create_directories(folder.name("tmp"));
    const std::string file = folder.write("a.fbx", "Kaydara FBX Binary"), started = folder.name("started");
    folder.write("bin/assimp", "#!/bin/sh\necho $$ > '" + started + ".part'\nmv '" + started + ".part' '" +
                                   started + "'\nexec sleep 100\n");
    fs::permissions(folder.name("bin/assimp"), fs::perms::owner_all);
    Clock::time_point stopped;
    const ProgramRun outcome = run_and_stop(
        {"simulate", file, "--size", "8x8"},
        {"PATH=" + folder.name("bin") + ":" + std::getenv("PATH"), "TMPDIR=" + folder.name("tmp")}, SIGINT,
        [&] {
            stopped = Clock::now();
            return fs::exists(started);
        });
    // A second on an idle machine.
    CHECK(Clock::now() - stopped < std::chrono::seconds(5));
    CHECK(outcome.code != 0);
    const pid_t converter = static_cast<pid_t>(std::stol(content_of(started)));
    for (int i = 0; i < 500 && (kill(converter, 0) == 0 || !fs::is_empty(folder.name("tmp"))); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(kill(converter, 0) != 0);
    CHECK(fs::is_empty(folder.name("tmp")));
}
