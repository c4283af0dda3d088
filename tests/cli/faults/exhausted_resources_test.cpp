// What the machine does not give: memory, threads, room on a disk, and time after Ctrl-C. One sentence each,
// and what was there before stays.
#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// One sentence and exit code 2, or the whole work: a limit need not be met.
void check_limited(const ProgramRun& outcome, const char* word) {
    INFO("code " << outcome.code << ", standard error: " << outcome.err);
    if (outcome.code == 0) return;
    check_refused(outcome, {word});
}

/// From the signal to the end.
struct Ended {
    ProgramRun outcome;
    double seconds = 0;
};
Ended signalled(const std::vector<std::string>& words, int signal, int after_ms,
                const std::vector<std::string>& environment = {}) {
    using Clock = std::chrono::steady_clock;
    Clock::time_point at;
    Ended e;
    e.outcome = run_and_stop(words, environment, signal, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
        at = Clock::now();
        return true;
    });
    e.seconds = std::chrono::duration<double>(Clock::now() - at).count();
    return e;
}

std::string program(const TestFolder& folder, const char* name, const std::string& script) {
    const std::string file = folder.write(name, "#!/bin/sh\n" + script);
    fs::permissions(file, fs::perms::owner_all);
    return file;
}

}   // namespace

TEST_CASE("without memory or threads there is a sentence, not a core file") {
    const TestFolder folder;
    const std::vector<std::string> render{"render", "gears:4", "--size", "64x48", "-o", folder.name("x.png")};
    int sentences = 0;
    for (const char* kilobytes : {"150000", "300000", "614400"}) {
        INFO(kilobytes);
        const ProgramRun outcome =
            run_in_shell(std::string("ulimit -v ") + kilobytes + "; exec \"$@\"", render);
        check_limited(outcome, "not enough");
        sentences += outcome.code == 2;
        CHECK((outcome.code == 0) == fs::exists(folder.name("x.png")));
        fs::remove(folder.name("x.png"));
    }
    CHECK(sentences > 0);
    sentences = 0;
    // The limit of processes binds no superuser: another user has none.
    for (const char* threads : {"1", "2", "3"})
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{"simulate", "tetra:1", "--size", "8x8", "--clock", "66"},
              {"simulate", "spheres:1", "--depth", "2", "--size", "16x12", "--clock", "66"}}) {
            INFO(threads << " " << words[0]);
            const ProgramRun outcome = run_in_shell(std::string("set -- prlimit --nproc=") + threads +
                                                        " \"$@\"; test $(id -u) = 0 && set -- setpriv "
                                                        "--reuid=54321 --clear-groups \"$@\"; exec \"$@\"",
                                                    words);
            check_limited(outcome, "not enough");
            sentences += outcome.code == 2;
        }
    CHECK(sentences > 0);
}

TEST_CASE("a waveform that the disk for temporary files does not hold leaves the old one") {
    const TestFolder folder;
    const std::vector<std::string> trace{"trace",    "cornell", "--size", "32x24",
                                         "--cycles", "0:20000", "-o",     folder.name("x.fst")};
    REQUIRE(run_program(trace).code == 0);
    const std::string good = content_of(folder.name("x.fst"));
    REQUIRE(good.size() > 20'000);
    for (const char* blocks : {"1", "8", "16"}) {   // of 512 bytes
        INFO(blocks);
        const ProgramRun outcome = run_in_shell(std::string("ulimit -f ") + blocks + "; exec \"$@\"", trace);
        check_refused(outcome, {"the waveform cannot be written", "File too large"});
        CHECK(content_of(folder.name("x.fst")) == good);
    }
    CHECK(folder.contents().size() == 2);   // and its view
}

TEST_CASE("what does not listen to Ctrl-C or SIGTERM is ended within a second, and nothing stays") {
    const TestFolder folder;
    const std::string out = folder.name("out");
    for (const int signal : {SIGINT, SIGTERM})
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{"simulate", "gears:20", "--size", "64x48", "-o", out},
              {"export", "gears:14", "-o", out},
              {"study", "tradeoff", "-o", out}}) {
            Ended ended;
            for (int attempt = 0; attempt < 3; ++attempt)
                if ((ended = signalled(words, signal, 700)).seconds < 1) break;
            INFO(words[0] << " " << signal << ": " << ended.outcome.err);
            CHECK(ended.seconds < 1);
            CHECK(ended.outcome.code == 1);
            CHECK_THAT(ended.outcome.err, Contains("rayclock: interrupted"));
            CHECK(folder.contents().empty());
        }
}

TEST_CASE("a tool that hangs, floods, says nonsense or fails is a sentence") {
    const TestFolder folder;
    const std::string version = "[ \"$1\" = --version ] && echo '(Version 0.11.1)' && exit\n";
    const std::string hangs = program(folder, "hangs", "exec sleep 1000\n"),
                      floods = program(folder, "floods", version + "exec yes 'Info: overlap: COMB=1.0%'\n"),
                      talks = program(folder, "talks", "exec yes talks\n"),
                      odd = program(
                          folder, "odd",
                          version + "echo '{\"fmax\":{\"clk\":{\"achieved\":\"x\"}}}' > report.json\n");
    const std::vector<std::string> chip{"chip", "--config", "small", "--unit", "dispatch"};
    const std::string cache = "RAYCLOCK_CACHE=" + folder.name("cache");
    check_refused(run_program(chip, {"RAYCLOCK_NEXTPNR=" + odd, cache}),
                  {"report.json of nextpnr-ecp5: fmax.clk.achieved must be a number, not \"x\""});
    check_refused(run_program(chip, {"RAYCLOCK_NEXTPNR=" + floods, cache}), {"has printed more than 16 MB"});
    check_refused(run_program(chip, {"RAYCLOCK_NEXTPNR=" + talks, cache}), {"does not run"});
    Ended ended;
    for (int attempt = 0; attempt < 3; ++attempt)
        if ((ended = signalled(chip, SIGINT, 1000, {"RAYCLOCK_NEXTPNR=" + hangs, cache})).seconds < 1) break;
    CHECK(ended.seconds < 1);
    CHECK(ended.outcome.code == 1);

    fs::create_directory(folder.name("bin"));
    const std::string path = "PATH=" + folder.name("bin") + ":" + std::getenv("PATH");
    const std::string says = "[ \"$1\" = -V ] && echo 'Yosys 0.23 (git sha1 7ce5011c24b)' && exit\n";
    program(folder, "bin/yosys", says + "printf 'a\\nERROR: \\033[2J bad\\nb\\n'; exit 1\n");
    check_refused(run_program({"study", "area", "--config", "small", "--unit", "dispatch"}, {path, cache}),
                  {"yosys failed: \\x1b[2J bad"});
    program(folder, "bin/yosys", says + "exit 0\n");
    check_refused(run_program({"study", "area", "--config", "small", "--unit", "dispatch"}, {path, cache}),
                  {"yosys has not written", "is the disk full?"});
    program(folder, "bin/yosys",
            says + "echo '{\"design\":{\"num_cells_by_type\":{\"$dff_x\":1}}}' > stat.json\n");
    const ProgramRun sweep =
        run_program({"sweep", "tetra:1", "--size", "8x8", "--axis", "contexts=8"}, {path, cache});
    CHECK(sweep.code == 0);
    CHECK_THAT(sweep.out + sweep.err,
               Contains("stat.json of yosys: 'x' is not a whole number") && !Contains("exception"));
}

TEST_CASE("a cache that others can write to is refused, since what is in it is run") {
    const TestFolder folder;
    fs::create_directory(folder.name("cache"));
    REQUIRE(::chmod(folder.name("cache").c_str(), 0777) == 0);
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"verify", "tetra:1", "--size", "8x8", "--config", "small"},
          {"sweep", "tetra:1", "--size", "8x8", "--axis", "contexts=8", "--no-netlist"}})
        check_refused(run_program(words, {"RAYCLOCK_CACHE=" + folder.name("cache")}),
                      {"others can write to this folder (mode 777)", "chmod go-w"});
    REQUIRE(::chmod(folder.name("cache").c_str(), 0755) == 0);
    CHECK(run_program({"sweep", "tetra:1", "--size", "8x8", "--axis", "contexts=8", "--no-netlist"},
                      {"RAYCLOCK_CACHE=" + folder.name("cache")})
              .code == 0);
}

TEST_CASE("temporary files of other users do not disturb a run") {
    // Only their number is known before: none of these may be needed.
    const TestFolder folder;
    const ProgramRun outcome = run_in_shell(
        "export TMPDIR='" + folder.name("") +
            "'; for n in wave divergence lint; do mkdir -m 0 \"$TMPDIR\"/rayclock-$n.$$-0; done; "
            "exec \"$@\"",
        {"trace", "tetra:1", "--size", "8x8", "--cycles", "0:100", "-o", folder.name("x.fst")});
    CHECK(outcome.code == 0);
}
