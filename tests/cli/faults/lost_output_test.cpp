// If output is lost, the exit code is 2 and a sentence says so. A full disk destroys no old file.
#include <catch2/catch.hpp>

#include <filesystem>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
namespace fs = std::filesystem;

namespace {

const std::vector<std::vector<std::string>> printing{
    {"config"},
    {"config", "small"},
    {"scenes"},
    {"scenes", "--json", "-"},
    {"doctor"},
    {"doctor", "--json", "-"},
    {"--help"},
    {"--version"},
    {"render", "--help"},
    {"simulate", "tetra:1", "--size", "8x8"},
    {"simulate", "tetra:1", "--size", "8x8", "--json", "-"},
    {"stress", "--bits", "16", "--family", "edges", "--rays", "100"},
    {"study", "counts", "balls:1", "--size", "8x8", "--json", "-"}};

void check_lost(const ProgramRun& outcome, const std::string& reason) {
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "rayclock: standard output: cannot be written: " + reason + "\n");
}

}   // namespace

TEST_CASE("standard output that is full or closed is an error of every command that prints") {
    for (const auto& arguments : printing) {
        INFO("rayclock " << arguments[0] << " " << arguments.back());
        check_lost(run_in_shell("exec \"$@\" >/dev/full", arguments), "No space left on device");
        check_lost(run_in_shell("exec \"$@\" >&-", arguments), "Bad file descriptor");
        // The pipe's reader ends before the program begins.
        const TestFolder folder;
        const ProgramRun pipe =
            run_in_shell("{ sleep 0.3; \"$@\"; echo $? >" + folder.name("code") + "; } | true", arguments);
        CHECK(content_of(folder.name("code")) == "2\n");
        CHECK(pipe.err == "rayclock: standard output: cannot be written: Broken pipe\n");
    }
}

TEST_CASE("a closed standard stream is not mistaken for a file") {
    const TestFolder folder;
    const std::string picture = folder.name("a.png");
    const ProgramRun outcome =
        run_in_shell("exec \"$@\" <&- >&- 2>&-",
                     {"render", "tetra:1", "--size", "8x8", "--engine", "reference", "-o", picture});
    CHECK(outcome.code == 2);
    CHECK(content_of(picture).starts_with("\x89PNG"));
    CHECK(content_of(picture).find("tetra") == std::string::npos);
    CHECK(folder.contents().size() == 1);
}

TEST_CASE("a disk that fills up while a file is written costs no old file") {
    // No file may grow beyond 1 KB (2 blocks).
    const auto full = [](const std::vector<std::string>& arguments) {
        return run_in_shell("ulimit -f 2; \"$@\" 2>&1 >/dev/null | cat >&2", arguments);
    };
    const auto code = [](const std::vector<std::string>& arguments, const std::string& file) {
        return run_in_shell("(ulimit -f 2; \"$@\" >/dev/null 2>/dev/null; echo $?) > " + file, arguments);
    };
    const std::vector<std::pair<std::string, std::vector<std::string>>> writers{
        {"a.png", {"render", "tetra:3", "--size", "64x48", "--engine", "reference", "-o"}},
        {"a.exr", {"render", "tetra:3", "--size", "64x48", "--engine", "reference", "-o"}},
        {"b.json", {"simulate", "tetra:1", "--size", "8x8", "--no-reference", "--json"}},
        {"scenes.json", {"scenes", "--json"}},
        {"page.md", {"stress", "--bits", "16", "--family", "edges", "--rays", "100", "-o"}},
        {"state.json", {"stress", "--bits", "12:20:1", "--rays", "100", "--state"}}};
    for (auto [name, arguments] : writers) {
        const TestFolder folder, elsewhere;
        arguments.push_back(folder.write(name, name == "state.json" ? "" : "precious"));
        if (name == "state.json") fs::remove(arguments.back());
        const auto before = folder.contents();
        INFO(name);
        code(arguments, elsewhere.name("code"));
        CHECK(content_of(elsewhere.name("code")) == "2\n");
        const ProgramRun outcome = full(arguments);
        INFO(outcome.err);
        CHECK(outcome.err.find("cannot be written: File too large") != std::string::npos);
        CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
        auto after = folder.contents();
        if (name == "page.md") after.erase("page");   // the folder of its drawings
        CHECK(after == before);
    }
}

TEST_CASE("an output may be a pipe or a device, but not a symbolic link") {
    const TestFolder folder;
    folder.write("real.json", "precious");
    fs::create_symlink("real.json", folder.name("link.json"));
    fs::create_symlink("real.json", folder.name("link.png"));
    const auto before = folder.contents();
    check_refused(run_program({"scenes", "--json", folder.name("link.json")}),
                  {"link.json", "symbolic link"});
    check_refused(run_program({"render", "tetra:1", "--size", "8x8", "-o", folder.name("link.png")}),
                  {"link.png", "symbolic link"});
    check_refused(run_program({"stress", "--rays", "10", "--state", folder.name("link.json")}),
                  {"link.json", "symbolic link"});
    CHECK(folder.contents() == before);
    const ProgramRun nobody = run_in_shell("mkfifo " + folder.name("pipe") + "; timeout 20 \"$@\"",
                                           {"scenes", "--json", folder.name("pipe")});
    CHECK(nobody.code == 2);
    CHECK(nobody.err.find("is a pipe that nobody reads") != std::string::npos);
    // The shell holds the other end, so the pipe has a reader from the start.
    const ProgramRun read =
        run_in_shell("exec 3<>" + folder.name("pipe") + "; \"$@\" >/dev/null && head -n 5 <&3",
                     {"scenes", "--json", folder.name("pipe")});
    CHECK(read.code == 0);
    CHECK(read.out.find("\"balls\"") != std::string::npos);
    CHECK(run_program({"scenes", "--json", "/dev/null"}).code == 0);
}
