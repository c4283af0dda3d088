// Starts the program in a process of its own and collects its outcome.
#include "tests/cli/program.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/cli/under_test.hpp"

namespace rayclock::test {

namespace fs = std::filesystem;

namespace {

ProgramRun run(std::string program, const std::vector<std::string>& arguments,
               const std::vector<std::string>& environment, const std::function<void(pid_t)>& meanwhile) {
    const TestFolder folder;
    const std::string out = folder.name("out"), err = folder.name("err");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_CREAT | O_WRONLY, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_CREAT | O_WRONLY, 0600);
    std::vector<std::string> texts = arguments, variables = environment;
    for (char** v = environ; *v; ++v) {
        const std::string text = *v, name = text.substr(0, text.find('=') + 1);
        const auto is_it = [&](const std::string& e) { return e.starts_with(name); };
        if (std::none_of(environment.begin(), environment.end(), is_it)) variables.push_back(text);
    }
    std::vector<char*> argv{program.data()}, envp;
    for (std::string& text : texts) argv.push_back(text.data());
    for (std::string& text : variables) envp.push_back(text.data());
    argv.push_back(nullptr);
    envp.push_back(nullptr);
    pid_t child = 0;
    REQUIRE(posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), envp.data()) == 0);
    posix_spawn_file_actions_destroy(&actions);
    if (meanwhile) meanwhile(child);
    int status = 0;
    rusage used{};
    REQUIRE(wait4(child, &status, 0, &used) == child);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err),
            seconds(used.ru_utime) + seconds(used.ru_stime), double(used.ru_maxrss) / 1024};
}

}   // namespace

std::string program_under_test() {
    const char* const other = std::getenv("RAYCLOCK_PROGRAM");
    return other ? other : RAYCLOCK_PROGRAM;
}

std::string source_folder() { return RAYCLOCK_SOURCE_DIR; }

ProgramRun run_program(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& environment) {
    return run(program_under_test(), arguments, environment, {});
}
ProgramRun run_in_shell(const std::string& script, const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"-c", script, "sh", program_under_test()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run("/bin/sh", all, {}, {});
}
ProgramRun run_and_interrupt(const std::vector<std::string>& arguments, int milliseconds) {
    return run(program_under_test(), arguments, {}, [milliseconds](pid_t child) {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        ::kill(child, SIGINT);
    });
}
ProgramRun run_and_stop(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& environment, int signal,
                        const std::function<bool()>& ready) {
    return run(program_under_test(), arguments, environment, [&](pid_t child) {
        for (int i = 0; i < 6000 && !ready(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ::kill(child, signal);
    });
}

void check_refused(const ProgramRun& outcome, const std::vector<std::string>& words) {
    INFO("standard output: " << outcome.out);
    INFO("standard error: " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("rayclock: "));
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);   // one line
    CHECK(outcome.err.size() > 20);
    for (const char* never : {"terminate", "std::", "exception", "what()", "basic_"})
        CHECK(outcome.err.find(never) == std::string::npos);
    for (const std::string& word : words) {
        INFO("wanted: " << word);
        CHECK(outcome.err.find(word) != std::string::npos);
    }
}

}   // namespace rayclock::test
