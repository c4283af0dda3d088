// Faults before and during RTL builds: one sentence, and no process or file remains.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "tests/cli/hardware/fake_tools.hpp"
#include "tests/cli/under_test.hpp"

using namespace rayclock::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

bool comes_true(const std::function<bool()>& claim) {
    for (int i = 0; i < 500; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(10)))
        if (claim()) return true;
    return false;
}

/// Counts processes whose ids are in a file and that still run.
int living(const std::string& file) {
    std::istringstream numbers(content_of(file));
    int count = 0;
    for (long pid = 0; numbers >> pid;) {
        const std::string stat = content_of("/proc/" + std::to_string(pid) + "/stat");
        const std::size_t end = stat.rfind(')');
        count += end != std::string::npos && stat[end + 2] != 'Z';
    }
    return count;
}

/// A compiler that takes ten minutes and has a child that does too, like the real one.
const std::string endless = FakeTools::compiler("/bin/sleep 600 & echo $$ $! >> \"$FAKE/pids\"; wait");
/// Quick only for Verilator's own sources.
const std::string endless_on_modules = FakeTools::compiler(
    "case $out in support.o) echo built > $out; exit;; esac; /bin/sleep 600 & echo $$ $! >> \"$FAKE/pids\"; "
    "wait");

}   // namespace

TEST_CASE("a build that is stopped takes its compilers with it, and leaves no folder") {
    const int signal = GENERATE(SIGINT, SIGTERM, SIGKILL, SIGHUP);
    const std::string command = GENERATE("rtl", "verify");
    const bool own = command == "rtl";   // stopped at Verilator's own sources, or at a module
    const FakeTools tools;
    tools.replace("verilator", FakeTools::verilator("5.006", FakeTools::many));
    tools.replace("c++", own ? endless : endless_on_modules);
    std::vector<std::string> arguments{command};
    if (command == "verify") arguments.insert(arguments.end(), {"tetra:1", "--size", "8x8"});
    const std::string pids = tools.path("pids");
    const ProgramRun outcome =
        run_and_stop(arguments, tools.environment(), signal, [&] { return living(pids) == (own ? 2 : 4); });
    INFO(command << " stopped by signal " << signal << ": " << outcome.err);
    CHECK(comes_true([&] { return living(pids) == 0; }));
    CHECK(comes_true([&] { return tools.names().empty(); }));
    if (signal == SIGINT || signal == SIGTERM) {   // both are caught
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.err, Contains("rayclock: interrupted while RTL was built"));
    } else {
        CHECK(outcome.code == -1);
    }
    tools.replace("c++", FakeTools::compiler());
    CHECK_THAT(tools.rtl().out, Contains("built in "));
}

TEST_CASE("of two compilers the first that fails ends the other") {
    const FakeTools tools;
    tools.replace("verilator", FakeTools::verilator("5.006", FakeTools::many));
    tools.replace("c++", FakeTools::compiler("case $out in support.o) echo built > $out; exit;; esac; "
                                             "echo $$ >> \"$FAKE/pids\"; case $out in part0*) exec "
                                             "/bin/sleep 600;; esac; echo start.cpp: no; exit 1"));
    const ProgramRun outcome = tools.rtl();
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err,
               Contains("rayclock: the C++ compiler on the verilated rc_chip failed: start.cpp: no\n"));
    CHECK(living(tools.path("pids")) == 0);
    CHECK(tools.names().empty());
}

TEST_CASE("a missing tool is one sentence, and the doctor knows it") {
    const FakeTools tools;
    const auto doctor = [&] { return run_program({"doctor"}, tools.environment()).out; };
    tools.remove("c++");
    check_refused(tools.rtl(), {"c++ is not installed"});
    check_refused(run_program({"verify", "tetra:1", "--size", "8x8"}, tools.environment()),
                  {"c++ is not installed"});
    CHECK_THAT(doctor(), Contains("c++: apt-get install g++") && Contains("no new RTL"));
    tools.replace("c++", "exit 1");
    check_refused(tools.rtl(), {"c++ does not run"});
    tools.replace("c++", FakeTools::compiler());
    tools.remove("verilator");
    check_refused(tools.rtl(), {"verilator is not installed"});
    CHECK_THAT(doctor(), Contains("verilator: apt-get install verilator") && !Contains("./bootstrap build"));
    tools.replace("verilator", FakeTools::verilator());
    fs::remove(tools.path("root/include/verilated.h"));
    check_refused(tools.rtl(), {"verilated.h is missing", "VERILATOR_ROOT"});
    CHECK_THAT(doctor(), Contains("verilated.h is missing"));
}

TEST_CASE("the doctor misses Vega, and neither Yosys nor other tools that one command needs") {
    const FakeTools tools;
    std::vector<std::string> environment = tools.environment();
    const ProgramRun good = run_program({"doctor"}, environment);
    CHECK(good.code == 0);
    CHECK_THAT(good.out,
               Contains("Everything is there.") && Contains("yosys") && Contains("none: no multipliers"));
    environment.push_back("RAYCLOCK_VEGA=" + tools.path("none"));
    const ProgramRun bad = run_program({"doctor"}, environment);
    CHECK(bad.code == 1);
    CHECK_THAT(bad.out,
               Contains("MISSING") && Contains("libjs-vega") && Contains("set RAYCLOCK_VEGA to a folder"));
}

TEST_CASE("RAYCLOCK_RTL that names no RTL is one sentence, and the doctor knows it") {
    const FakeTools tools;
    std::vector<std::string> environment = tools.environment();
    fs::create_directories(tools.path("empty"));
    tools.folder().write("file", "");
    fs::create_directories(tools.path("half"));
    tools.folder().write("half/rc_top.sv", "module rc_top; endmodule\n");
    fs::create_symlink(tools.path("loop"), tools.path("loop"));
    const std::vector<std::pair<std::string, std::string>> cases{
        {"missing", " does not exist"},    {"file", " is not a folder"}, {"empty", " has no file rc_top.sv"},
        {"half", " has no file lint.vlt"}, {"loop", " cannot be read"},  {"file/deeper", " does not exist"}};
    for (const auto& [name, words] : cases) {
        environment[2] = "RAYCLOCK_RTL=" + tools.path(name);
        check_refused(run_program({"rtl"}, environment), {environment[2] + words});
        const ProgramRun doctor = run_program({"doctor"}, environment);
        CHECK(doctor.code == 1);
        CHECK_THAT(doctor.out, Contains("MISSING: " + environment[2] + words) && Contains("no RTL: verify"));
    }
    environment[2] = "RAYCLOCK_RTL=" + tools.path("rtl");
    REQUIRE(mkfifo(tools.path("rtl/rc_pipe.sv").c_str(), 0600) == 0);
    check_refused(run_program({"rtl"}, environment), {"rc_pipe.sv: no ordinary file"});
}

TEST_CASE("a netlist needs Yosys, and models of its cells") {
    const FakeTools tools;
    const std::vector<std::string> words{"verify", "tetra:1", "--size", "8x8", "--netlist"};
    check_refused(run_program(words, tools.environment()), {"yosys is not installed, and netlists"});
    tools.replace("yosys", "echo 'Yosys 0.23 (git sha1 fake)'");
    check_refused(run_program(words, tools.environment()), {"ecp5/cells.v cannot be read, and netlists"});
    fs::create_directory(tools.path("rtl/ecp5"));
    tools.folder().write("rtl/ecp5/cells.v", "// no cell\n");
    const ProgramRun outcome = run_program(words, tools.environment());
    CHECK(outcome.code != 0);
    CHECK_THAT(outcome.err, Contains("yosys has no model of the cell LUT2"));
}

TEST_CASE("the doctor names versions that were not tried, where things are, and what is set") {
    const FakeTools tools;
    const ProgramRun good = run_program({"doctor"}, tools.environment());
    CHECK_THAT(good.out, Contains("RAYCLOCK_RTL       " + tools.path("rtl")) &&
                             Contains("RAYCLOCK_CACHE     " + tools.cache()) && !Contains("not tried"));
    tools.replace("verilator", FakeTools::verilator("5.020"));
    tools.replace("c++", FakeTools::compiler("echo built > \"$out\"", "13.1.0"));
    tools.replace("yosys", "echo 'Yosys 0.33 (git sha1 fake)'");
    const ProgramRun untried = run_program({"doctor"}, tools.environment());
    CHECK(untried.code == 0);
    CHECK_THAT(untried.out, Contains("verilator 5.020 was not tried") && Contains("c++ 13 was not tried") &&
                                Contains("yosys 0.33 was not tried"));
    CHECK_THAT(untried.out, Contains("Everything is there."));
    tools.replace("c++", "case $1 in --version) echo 'Debian clang version 14.0.6';; esac");
    CHECK_THAT(run_program({"doctor"}, tools.environment()).out,
               Contains("Debian clang version 14.0.6") && !Contains("c++ clang"));
}

TEST_CASE("tools see no path of the user's, and need nothing of the source tree") {
    const FakeTools tools("a cache's \"odd\" $HOME");
    std::vector<std::string> environment = tools.environment();
    fs::rename(tools.path("rtl"), tools.path("my 'odd' $x rtl"));
    fs::create_directory(tools.path("my 'odd' $x rtl/a part"));
    tools.folder().write("my 'odd' $x rtl/a part/rc_odd name.sv", "module rc_odd; endmodule\n");
    environment[2] = "RAYCLOCK_RTL=" + tools.path("my 'odd' $x rtl");
    environment.push_back("RAYCLOCK_CXXFLAGS=-Og");   // those of the tests name a precompiled header
    // The included files are next to the sources, and nothing names the tree from which the program was
    // built.
    tools.replace("c++", FakeTools::compiler("[ -f abi.hpp -o $out = support.o ] && ! /bin/grep -rq '" +
                                             source_folder() + "' . && echo built > \"$out\""));
    const ProgramRun outcome = run_program({"rtl"}, environment);
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    for (const char* file : {"calls", "verilated"}) {
        const std::string said = content_of(tools.path(file));
        INFO(said);
        CHECK(said.size() > 10);
        for (const std::string& never :
             {std::string("odd'"), std::string("$"), std::string("'"), std::string("\""), source_folder()})
            CHECK_THAT(said, !Contains(never));
    }
    CHECK_THAT(content_of(tools.path("verilated")), Contains("rtl/a_part/rc_odd_name.sv"));
}

TEST_CASE("a build says what it builds: one line when piped") {
    const FakeTools tools;
    const ProgramRun first = tools.rtl();
    CHECK(first.err == "rayclock: building the RTL of 'default', once for all runs\n");
    CHECK(tools.rtl().err.empty());
}

TEST_CASE("on a terminal a build shows its stage and its time, and wipes the line") {
    const FakeTools tools;
    tools.replace("c++", FakeTools::compiler("/bin/sleep 0.3; echo built > \"$out\""));
    std::string command = "env";
    for (const std::string& variable : tools.environment()) command += " '" + variable + "'";
    command += " " + program_under_test() + " rtl";
    tools.folder().write("run.sh", command);
    REQUIRE(
        std::system(("script -qec 'sh " + tools.path("run.sh") + "' " + tools.path("seen") + " > /dev/null")
                        .c_str()) == 0);
    const std::string seen = content_of(tools.path("seen"));
    CHECK_THAT(seen, Contains("building the RTL of 'default': Verilator, 0 s"));
    CHECK_THAT(seen, Contains("building the RTL of 'default': the C++ compiler, 0 s, about 0 s left"));
    CHECK_THAT(seen, Contains("\r\033[Kdefault: built in ") || Contains("\r\033[K\r\ndefault: built in "));
}
