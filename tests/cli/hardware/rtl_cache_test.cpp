// The cache of built RTL: after any damage the next run works again.
#include <filesystem>
#include <functional>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/cli/hardware/fake_tools.hpp"

using namespace rayclock::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

void check_built(const FakeTools& tools, bool now) {
    const ProgramRun outcome = tools.rtl();
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.out, Contains(now ? "built in " : "built before, "));
    CHECK_THAT(outcome.err, now ? Contains("rayclock: building the RTL of 'default'") : Contains(""));
    CHECK(content_of(tools.entry() + "/module.so") == "built\n");
}

struct Damage {
    const char* name;
    std::function<void(const std::string& entry)> work;
};

void write(const std::string& file, const std::string& bytes) {
    fs::remove_all(file);
    std::FILE* stream = std::fopen(file.c_str(), "w");
    std::fputs(bytes.c_str(), stream);
    std::fclose(stream);
}
void fifo(const std::string& file) {
    fs::remove_all(file);
    REQUIRE(mkfifo(file.c_str(), 0600) == 0);
}
void link(const std::string& file, const std::string& target) {
    fs::remove_all(file);
    fs::create_symlink(target, file);
}

const std::vector<Damage> damages{
    {"library cut", [](const std::string& e) { fs::resize_file(e + "/module.so", 3); }},
    {"library empty", [](const std::string& e) { fs::resize_file(e + "/module.so", 0); }},
    {"library gone", [](const std::string& e) { fs::remove(e + "/module.so"); }},
    {"one byte changed", [](const std::string& e) { write(e + "/module.so", "buiLt\n"); }},
    {"library a folder",
     [](const std::string& e) {
         fs::remove(e + "/module.so"), fs::create_directories(e + "/module.so/deep");
     }},
    {"library a pipe", [](const std::string& e) { fifo(e + "/module.so"); }},
    {"library a device", [](const std::string& e) { link(e + "/module.so", "/dev/zero"); }},
    {"library a link to itself", [](const std::string& e) { link(e + "/module.so", "module.so"); }},
    {"seal gone", [](const std::string& e) { fs::remove(e + "/seal"); }},
    {"seal empty", [](const std::string& e) { write(e + "/seal", ""); }},
    {"seal a pipe", [](const std::string& e) { fifo(e + "/seal"); }},
    {"seal a folder",
     [](const std::string& e) { fs::remove(e + "/seal"), fs::create_directory(e + "/seal"); }},
    {"entry empty", [](const std::string& e) { fs::remove_all(e), fs::create_directory(e); }},
    {"entry a file", [](const std::string& e) { write(e, "no folder"); }},
    {"entry a pipe", [](const std::string& e) { fifo(e); }},
    {"entry a device", [](const std::string& e) { link(e, "/dev/null"); }},
    {"entry a link to itself", [](const std::string& e) { link(e, e); }},
};

}   // namespace

TEST_CASE("a damaged entry of the RTL cache is built again, once") {
    const FakeTools tools;
    check_built(tools, true);
    check_built(tools, false);
    const std::string entry = tools.entry();
    for (const Damage& damage : damages) {
        INFO(damage.name);
        damage.work(entry);
        check_built(tools, true);
        check_built(tools, false);
    }
    CHECK(tools.compilations() == 2 * int(1 + damages.size()));
}

TEST_CASE("Verilator's own sources are compiled once for all RTL, and again if they are damaged") {
    const FakeTools tools;
    const auto compiled = [&] {
        const std::string calls = content_of(tools.path("calls"));
        int count = 0;
        for (std::size_t at = 0; (at = calls.find("-o support.o", at)) != std::string::npos; ++at) ++count;
        return count;
    };
    const auto own = [&] {
        for (const auto& entry : fs::directory_iterator(tools.cache()))
            if (entry.path().filename().string().starts_with("rc_verilated-"))
                return entry.path().string() + "/support.o";
        return std::string();
    };
    check_built(tools, true);
    CHECK(compiled() == 1);
    fs::remove_all(tools.entry());
    check_built(tools, true);
    CHECK(compiled() == 1);
    REQUIRE(content_of(own()) == "built\n");
    write(own(), "buiLt\n");
    check_built(tools, false);   // an existing library no longer needs them
    CHECK(compiled() == 1);
    fs::remove_all(tools.entry());
    check_built(tools, true);
    CHECK(compiled() == 2);
    CHECK(content_of(own()) == "built\n");
}

TEST_CASE(
    "options for the compiler of RTL are handed on, make RTL of its own, and are named if they are wrong") {
    const FakeTools tools;
    const auto with = [&](const std::string& flags) {
        std::vector<std::string> environment = tools.environment();
        environment.push_back("RAYCLOCK_CXXFLAGS=" + flags);
        return run_program({"rtl"}, environment);
    };
    CHECK(with("").code == 0);
    CHECK(tools.compilations() == 2);
    CHECK(with(" -O1  -g ").code == 0);
    CHECK(tools.compilations() == 4);
    CHECK(with("").code == 0);
    CHECK(with(" -O1  -g ").code == 0);
    CHECK(tools.compilations() == 4);   // both are kept
    CHECK_THAT(content_of(tools.path("calls")), Contains(" -O2 -fPIC -fvisibility=default -w -O1 -g -I. "));

    tools.replace(
        "c++", FakeTools::compiler("echo 'c++: error: unrecognized option -Q' >&2; echo more >&2; exit 1"));
    const ProgramRun refused = with("-Q");
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err,
               Contains("RAYCLOCK_CXXFLAGS=-Q: the C++ compiler says: error: unrecognized option -Q\n"));
    CHECK(refused.err.find("more") == std::string::npos);
}

TEST_CASE("any file in place of the lock is tolerated") {
    const FakeTools tools;
    check_built(tools, true);
    const std::string entry = tools.entry(), lock = entry + ".lock";
    const std::function<void()> obstacles[] = {[&] { fs::create_directories(lock + "/deep"); },
                                               [&] { fifo(lock); }, [&] { link(lock, "/dev/null"); },
                                               [&] { link(lock, lock); }, [&] { write(lock, "1"); }};
    for (const auto& obstacle : obstacles) {
        fs::remove_all(entry);
        obstacle();
        check_built(tools, true);
    }
    CHECK_FALSE(fs::exists(fs::symlink_status(lock)));
}

TEST_CASE("a cache that cannot be a folder is refused, and doctor reports it") {
    const FakeTools tools;
    tools.folder().write("file", "taken");
    fifo(tools.path("pipe"));
    link(tools.path("loop"), tools.path("loop"));
    for (const std::string& place : {tools.path("file"), tools.path("file/deeper"), tools.path("pipe"),
                                     tools.path("loop"), std::string("/dev/null")}) {
        std::vector<std::string> environment = tools.environment();
        environment[3] = "RAYCLOCK_CACHE=" + place;
        check_refused(run_program({"rtl"}, environment), {place, "RAYCLOCK_CACHE"});
        const ProgramRun doctor = run_program({"doctor"}, environment);
        CHECK(doctor.code == 1);
        CHECK_THAT(doctor.out, Contains("MISSING: " + place) && Contains("set RAYCLOCK_CACHE to a folder"));
    }
}

TEST_CASE("only the remains of dead builds are removed") {
    const FakeTools tools;
    fs::create_directory(tools.cache());
    const std::string dead = tools.cache() + "/rc_top-0123456789abcdef-0123456789abcdef",
                      living = tools.cache() + "/rc_box-0123456789abcdef-0123456789abcdef";
    for (const std::string& entry : {dead, living}) {
        fs::create_directories(entry + ".4711-0/obj");
        write(entry + ".4711-0/obj/Vrc.cpp", "// half");
        write(entry + ".lock", "");
    }
    const std::vector<std::string> others{"sweep", "mine.4711-0", "rc_top-notes.4711",
                                          "rc_top-0123456789abcdef.txt"};
    for (const std::string& other : others) fs::create_directory(tools.cache() + "/" + other);
    const int lock = open((living + ".lock").c_str(), O_RDWR);
    REQUIRE(flock(lock, LOCK_EX) == 0);
    REQUIRE(tools.rtl().code == 0);
    CHECK_FALSE(fs::exists(dead + ".4711-0"));
    CHECK_FALSE(fs::exists(dead + ".lock"));
    CHECK(fs::exists(living + ".4711-0/obj/Vrc.cpp"));
    CHECK(fs::exists(living + ".lock"));
    close(lock);
    REQUIRE_THAT(tools.rtl().out, Contains("built before"));   // a run that builds nothing also sweeps
    CHECK_FALSE(fs::exists(living + ".4711-0"));
    CHECK_FALSE(fs::exists(living + ".lock"));
    for (const std::string& other : others) CHECK(fs::exists(tools.cache() + "/" + other));
}

TEST_CASE("programs that need the same RTL at the same time build it once") {
    const FakeTools tools;
    tools.replace("c++", FakeTools::compiler("/bin/sleep 0.3; echo built > \"$out\""));
    std::vector<ProgramRun> outcomes(4);
    std::vector<std::thread> programs;
    for (ProgramRun& outcome : outcomes) programs.emplace_back([&] { outcome = tools.rtl(); });
    for (std::thread& program : programs) program.join();
    int built = 0;
    for (const ProgramRun& outcome : outcomes) {
        INFO(outcome.err);
        CHECK(outcome.code == 0);
        built += outcome.out.find("built in") != std::string::npos;
    }
    CHECK(built == 1);
    CHECK(tools.compilations() == 2);
    CHECK(content_of(tools.entry() + "/module.so") == "built\n");
}

TEST_CASE("RTL built by another Verilator or compiler is not used, and the first build remains") {
    const FakeTools tools;
    check_built(tools, true);
    tools.replace("c++", FakeTools::compiler("echo built > \"$out\"", "14.2.0"));
    CHECK_THAT(tools.rtl().out, Contains("built in "));
    tools.replace("verilator", FakeTools::verilator("5.032"));
    CHECK_THAT(tools.rtl().out, Contains("built in "));
    CHECK(tools.names().size() == 3);
    tools.replace("c++", FakeTools::compiler());
    tools.replace("verilator", FakeTools::verilator());
    CHECK_THAT(tools.rtl().out, Contains("built before"));
    CHECK(tools.compilations() == 6);
}

TEST_CASE("RTL that is built needs no tools any more") {
    const FakeTools tools;
    check_built(tools, true);
    tools.remove("c++");
    CHECK_THAT(tools.rtl().out, Contains("built before"));
    tools.remove("verilator");
    CHECK_THAT(tools.rtl().out, Contains("built before"));
    fs::resize_file(tools.entry() + "/module.so", 3);
    check_refused(tools.rtl(), {"verilator is not installed"});
}

TEST_CASE("without HOME the RTL cache is a private temporary folder, with a warning") {
    const FakeTools tools;
    const std::string place = tools.path("rayclock-" + std::to_string(geteuid()));
    std::vector<std::string> environment = tools.environment();
    environment[3] = "RAYCLOCK_CACHE=";
    environment.insert(environment.end(), {"HOME=", "XDG_CACHE_HOME=relative", "TMPDIR=" + tools.path("")});
    const ProgramRun outcome = run_program({"rtl"}, environment);
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.err, Contains("rayclock: HOME is not set") && Contains("RAYCLOCK_CACHE"));
    CHECK_THAT(outcome.out, Contains(place));
    CHECK(fs::status(place).permissions() == fs::perms::owner_all);
    CHECK_THAT(run_program({"doctor"}, environment).out, Contains("HOME is not set"));
    fs::permissions(place, fs::perms::all);   // anybody could plant a library there
    check_refused(run_program({"rtl"}, environment), {place, "others can write to this folder"});
    fs::remove_all(place);
    link(place, tools.path("rtl"));
    check_refused(run_program({"rtl"}, environment), {place, "this is a link"});
}
