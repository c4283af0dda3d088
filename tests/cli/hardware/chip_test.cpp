// rayclock chip with a fake nextpnr that copies the files of a real run: kept results, continued runs, and
// refusals. Yosys is real, on a unit that takes two seconds.
#include <csignal>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/hardware/fake_nextpnr.hpp"

using namespace rayclock::test;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("chip routes each seed once, reports the fastest, and answers from what is kept", "[long]") {
    const FakeNextpnr fake;
    const std::string out = fake.folder().name("out"), report = fake.folder().name("a.json");
    const ProgramRun first = fake.run({"--seeds", "1,2", "-o", out, "--json", report});
    INFO(first.err);
    REQUIRE(first.code == 0);
    CHECK(first.err.empty());
    CHECK(fake.routed() == 2);
    const std::string calls = content_of(fake.calls());
    for (const char* words :
         {"--85k --package CABGA381 --speed 6", "--json netlist.json", "--seed 1", "--seed 2"})
        CHECK_THAT(calls, Catch::Contains(words));
    CHECK_THAT(first.out, Catch::Contains("routed: 154.7 MHz with seed 1 (by seed 1: 154.7, 2: 154.7)") &&
                              Catch::Contains("harness.in_q -> dispatch.s0_q"));
    const json figures = json::parse(content_of(report));
    CHECK(figures["device"] == "lfe5u-85");
    CHECK(figures["fits"] == true);
    CHECK(figures["routed"] == true);
    CHECK(figures["fmax_mhz"].get<double>() == Approx(154.727).margin(0.001));
    CHECK(figures["seeds"].size() == 2);
    CHECK(figures["totals"] == json{{"lut", 10}, {"ff", 13}, {"dsp", 0}, {"bram", 0}});
    CHECK(figures["units"]["dispatch"] == figures["totals"]);
    for (const char* key : {"mhz", "from_unit", "to_unit", "stage", "source"})
        CHECK(figures["paths"][0].contains(key));
    CHECK(content_of(out + "/report.txt") == first.out);
    CHECK(json::parse(content_of(out + "/report.json")) == figures);
    CHECK_THAT(content_of(out + "/dispatch-placement.svg"),
               Catch::StartsWith("<svg") && Catch::EndsWith("</svg>\n"));

    const ProgramRun second = fake.run({"--seeds", "1,2"});
    CHECK(second.out == first.out);
    CHECK(fake.routed() == 2);
    CHECK(fake.run({"--seeds", "1:3"}).code == 0);
    CHECK(fake.routed() == 3);
    CHECK(fake.run({"--device", "lfe5u-45"}).code == 0);   // another device is another chip
    CHECK(fake.routed() == 4);
    CHECK(fake.run({"--fresh"}).code == 0);
    CHECK(fake.routed() == 5);
    // Other methods are also another chip.
    const ProgramRun other = fake.run({"--placer", "static", "--router", "router2"});
    CHECK(fake.routed() == 7);   // placed first, then routed with router2's own settings
    CHECK_THAT(other.out, Catch::Contains("with seed 1, placer static, router2\n"));
    CHECK_THAT(
        content_of(fake.calls()),
        Catch::Contains(
            "--timing-allow-fail --placer static --router router2 --json netlist.json --no-route") &&
            Catch::Contains("--router router2 --json roomy.json --no-pack --no-place --report report.json"));
    CHECK(fake.run({"--placer", "heap", "--router", "router1"}).code == 0);
    CHECK(fake.routed() == 7);
    CHECK_THAT(fake.run({"--placements", "3"}).out, Catch::Contains("with seed 1, placed 3 times\n"));
    CHECK(fake.routed() == 10);   // the first two only place
    const std::string all = content_of(fake.calls());
    CHECK_THAT(all, Catch::Contains("--json netlist.json --no-route --write placed.json") &&
                        Catch::Contains("--json anchored.json --no-route --write placed.json") &&
                        Catch::Contains("--json anchored.json --report report.json"));
    fake.replace("true", "nextpnr-0.12");   // another router gives another clock
    CHECK(fake.run().code == 0);
    CHECK(fake.routed() == 11);
}

TEST_CASE("an interrupted chip keeps its netlist and its seeds, and goes on after them", "[long]") {
    const FakeNextpnr fake;
    fake.replace("case \"$*\" in *'--seed 2') sleep 100;; esac");
    const ProgramRun stopped =
        run_and_stop(FakeNextpnr::words({"--seeds", "1,2", "-o", fake.folder().name("out")}),
                     fake.environment(), SIGINT, [&] { return fake.routed() == 2; });
    CHECK(stopped.code == 1);
    CHECK_THAT(stopped.err, Catch::Contains("interrupted") && Catch::Contains("continues after"));
    CHECK(fake.kept("chip-route-") == 1);
    CHECK(fake.kept("yosys-") == 0);   // working folders
    CHECK_FALSE(fs::exists(fake.folder().name("out/report.txt")));
    fake.replace("true");
    CHECK(fake.run({"--seeds", "1,2"}).code == 0);
    CHECK(fake.routed() == 3);

    // A removed netlist is made again when a seed needs it, and not before.
    for (const auto& entry : fs::directory_iterator(fake.folder().name("cache/chip")))
        if (entry.path().extension() == ".netlist") fs::remove(entry.path());
    CHECK(fake.run({"--seeds", "1,2"}).code == 0);
    CHECK(fake.kept("chip-netlist-") == 1);
    CHECK(fake.run({"--seeds", "3"}).code == 0);
    CHECK(fake.kept("chip-netlist-") == 2);
    CHECK(fake.routed() == 4);
}

TEST_CASE("a router that fails is one sentence, and nothing of it is kept") {
    const FakeNextpnr fake;
    fake.replace("echo 'ERROR: Module is broken.'; false");
    check_refused(fake.run(), {"nextpnr-ecp5 failed: Module is broken."});
    fake.replace("cp() { echo '{\"fmax\":' > report.json; }");
    check_refused(fake.run(), {"report.json", "unexpected end of input"});
    fake.replace(
        "echo \"ERROR: Unable to place cell 'x', no BELs remaining to implement cell type 'MULT18X18D'\"; "
        "false");
    const ProgramRun large = fake.run();
    CHECK(large.code == 1);
    CHECK_THAT(large.out, Catch::Contains("'small' does not fit lfe5u-85"));
    CHECK(fake.kept("chip-route-") == 0);
    CHECK(fake.kept("yosys-") == 0);
}

TEST_CASE("a router without progress is stopped, and another seed may be routed", "[long]") {
    const FakeNextpnr fake;
    const std::string stuck =
        "echo 'Info: Running router2...'; i=0; while [ $i -lt 110 ]; do i=$((i+1)); "
        "echo 'Info:     iter=1 wires=900 overused=43 overuse=44 archfail=NA'; done; sleep 100";
    fake.replace(stuck);
    const ProgramRun none = fake.run();
    CHECK(none.code == 1);
    CHECK_THAT(
        none.out,
        Catch::Contains("'small' cannot be routed on lfe5u-85: after 100 more rounds of router2 at least "
                        "43 wires are still used twice; another seed"));
    CHECK(fake.kept("chip-route-") == 0);
    CHECK(fake.kept("yosys-") == 0);
    const std::string rows =
        "echo 'Info: Routing..'; echo 'Info: Routing 900 arcs.'; echo 'Info: | arcs | by | left | time |'; "
        "i=0; while [ $i -le 300 ]; do i=$((i+1)); "
        "echo 'Info:  1000 |  0  1000 |  0  1000 |  43|  0.1  0.1|'; done; sleep 100";
    fake.replace(rows);
    const ProgramRun no_step = fake.run();
    CHECK(no_step.code == 1);
    CHECK_THAT(no_step.out,
               Catch::Contains(
                   "after 300,000 more steps of router1 at least 43 wires are still not routed; another"));
    fake.replace("case \"$*\" in *'--seed 1') " + stuck + ";; esac");
    const ProgramRun second = fake.run({"--seeds", "1,2"});
    CHECK(second.code == 0);
    CHECK_THAT(second.out, Catch::Contains("with seed 2"));
}

namespace {

/// Returns a Yosys script that has a chip with this number of multipliers, in tri.
std::string fake_yosys(const FakeNextpnr& fake, int multipliers) {
    std::string cells;
    for (int i = 0; i < multipliers; ++i)
        cells += (i ? ", " : "") + ("\"u_chip.u_top.u_pipeline.u_tri.m" + std::to_string(i)) +
                 "\": {\"type\": \"MULT18X18D\"}";
    fake.folder().write("netlist", R"({"modules": {"rc_harness": {"cells": {)" + cells + "}}}}");
    fake.folder().write(
        "face", R"({"modules": {"rc_chip": {"ports": {"wb_i": {"direction": "input", "bits": [2, 3]}}}}})");
    fs::create_directories(fake.folder().name("bin"));
    fake.folder().write("bin/yosys", "#!/bin/sh\n[ \"$1\" = -V ] && echo 'Yosys 0.23 fake" +
                                         std::to_string(multipliers) +
                                         "' && exit\nif grep -q interface.json run.ys; then cp '" +
                                         fake.folder().name("face") + "' interface.json; else cp '" +
                                         fake.folder().name("netlist") + "' netlist.json; fi\n");
    fs::permissions(fake.folder().name("bin/yosys"), fs::perms::owner_all);
    return "PATH=" + fake.folder().name("bin") + ":/usr/bin:/bin";
}

}   // namespace

TEST_CASE("the report of a chip that does not fit says by how much, and the chip is not routed") {
    const FakeNextpnr fake;
    std::vector<std::string> environment = fake.environment();
    environment.push_back(fake_yosys(fake, 30));
    const std::string report = fake.folder().name("a.json");
    const auto chip = [&](const char* device) {
        return run_program({"chip", "--config", "small", "--device", device, "--json", report}, environment);
    };
    const ProgramRun large = chip("lfe5u-25");
    CHECK(large.code == 1);
    CHECK_THAT(large.out,
               Catch::Contains("'small' does not fit lfe5u-25: it needs 30 multipliers of 28 (2 too many; "
                               "narrow tri, which takes 30)"));
    const json figures = json::parse(content_of(report));
    CHECK(figures["fits"] == false);
    CHECK(figures["routed"] == false);
    CHECK(figures["fmax_mhz"].is_null());
    CHECK(figures["totals"]["dsp"] == 30);
    CHECK(fake.routed() == 0);
    const ProgramRun fits = chip("lfe5u-45");
    CHECK(fits.code == 0);
    // A whole chip is placed twice and routed with its own default methods; a unit alone with nextpnr's
    // defaults.
    CHECK_THAT(fits.out, Catch::Contains("with seed 1, placer mixed, router1, placed 2 times\n"));
    CHECK_THAT(content_of(fake.calls()),
               Catch::Contains("--placer static --json netlist.json --no-route") &&
                   Catch::Contains(
                       "--timing-allow-fail --placer-heap-timingweight 120 --json anchored.json --report"));
    CHECK(fake.routed() == 2);
    const std::string static_again = "--placer static --json anchored.json --no-route";
    CHECK_THAT(content_of(fake.calls()), !Catch::Contains(static_again));
    const auto thrice =
        run_program({"chip", "--config", "small", "--device", "lfe5u-45", "--placements", "3"}, environment);
    CHECK_THAT(thrice.out, Catch::Contains("with seed 1, placer mixed, router1, placed 3 times\n"));
    CHECK_THAT(content_of(fake.calls()), Catch::Contains(static_again));   // heap is the last of them
    // The sites of multipliers and block memories from the first placement were kept.
    CHECK(fake.routed() == 4);
    // The first placement of mixed equals static's. The last of one is not that of the other.
    const auto by_static =
        run_program({"chip", "--config", "small", "--device", "lfe5u-45", "--placer", "static"}, environment);
    CHECK_THAT(by_static.out, Catch::Contains("with seed 1, placer static, router1, placed 2 times\n"));
    CHECK(fake.routed() == 5);
    CHECK(chip("lfe5u-45").out == fits.out);
    CHECK(fake.routed() == 5);
}

namespace {

/// A board on fake tools: nextpnr reports three clocks, the chip's at `mhz`, and ecppack copies the text.
class FakeBoard {
public:
    FakeBoard() : yosys_(fake_yosys(fake_, 1)) {
        pack("cat \"$2\" > \"$3\"");
        route("81.5");
    }

    /// Routes a seed, 1 to 9, to these clocks.
    void route(const std::string& mhz, const std::string& shift_mhz = "310.25", char seed = '1') const {
        const auto clock = [](const std::string& net, const std::string& achieved, const char* asked) {
            return "\"$glbnet$" + net + "\": {\"achieved\": " + achieved + ", \"constraint\": " + asked + "}";
        };
        fake_.folder().write(std::string("report-") + seed,
                             "{\"fmax\": {" + clock("shift_clk", shift_mhz, "125") + ", " +
                                 clock("clk", mhz, "75") + ", " + clock("pixel_clk", "99", "25") + "}}");
        fake_.replace(
            "for seed; do :; done; cp() { /bin/cp \"$@\"; /bin/cp '" + fake_.folder().name("report-") +
            "'$seed report.json; case \"$*\" in *delays.sdf*) echo routed $seed > board.config;; esac; }");
    }
    void pack(const std::string& script) const {
        fake_.folder().write("bin/ecppack",
                             "#!/bin/sh\n[ \"$1\" = --version ] && echo 'fake' && exit\n" + script);
        fs::permissions(fake_.folder().name("bin/ecppack"), fs::perms::owner_all);
    }
    ProgramRun run(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"chip", "--config", "ulx3s-board", "--board"});
        std::vector<std::string> environment = fake_.environment();
        environment.push_back(yosys_);
        return run_program(more, environment);
    }
    const FakeNextpnr& fake() const { return fake_; }

private:
    FakeNextpnr fake_;
    std::string yosys_;
};

}   // namespace

TEST_CASE("chip --board routes the board with its pins, and packs a bitstream if all clocks are met") {
    const FakeBoard board;
    const std::string out = board.fake().folder().name("out"), report = board.fake().folder().name("a.json");
    const ProgramRun first = board.run({"-o", out, "--json", report});
    INFO(first.err);
    REQUIRE(first.code == 0);
    CHECK_THAT(first.out, Catch::Contains("ULX3S with 'ulx3s-board' at 75 MHz on lfe5u-85") &&
                              Catch::Contains("routed: 81.5 MHz with seed 1") &&
                              Catch::Contains("openFPGALoader --board ulx3s " + out + "/board.bit"));
    CHECK(content_of(out + "/board.bit") == "routed 1\n");
    CHECK_THAT(content_of(board.fake().calls()),
               Catch::Contains("--lpf board.lpf --seed 1") && Catch::Contains("--textcfg board.config"));
    const json figures = json::parse(content_of(report));
    CHECK(figures["fmax_mhz"] == 81.5);
    CHECK(figures["bitstream_bytes"] == 9);
    CHECK(figures["clocks"] == json{{{"name", "clk"}, {"target_mhz", 75}, {"fmax_mhz", 81.5}},
                                    {{"name", "pixel_clk"}, {"target_mhz", 25}, {"fmax_mhz", 99}},
                                    {{"name", "shift_clk"}, {"target_mhz", 125}, {"fmax_mhz", 310.25}}});

    const int routed = board.fake().routed();
    CHECK(board.run({"-o", out}).out == first.out);
    CHECK(board.fake().routed() == routed);
    CHECK(board.run({"--clock", "62.5"}).code == 0);   // another PLL is another design
    CHECK(board.fake().routed() == 2 * routed);
    CHECK(board.run({"--sdram", "is42s16160g"}).code == 0);   // the same holds for another memory
    CHECK(board.fake().routed() == 3 * routed);
}

TEST_CASE("chip --board makes no bitstream of a board that misses a clock") {
    const FakeBoard board;
    board.route("74.99");
    const std::string out = board.fake().folder().name("out");
    const ProgramRun missed = board.run({"-o", out});
    CHECK(missed.code == 1);
    CHECK_THAT(missed.out, Catch::Contains("MISSED") && Catch::Contains("there is no bitstream"));
    CHECK(fs::exists(out + "/report.txt"));
    CHECK_FALSE(fs::exists(out + "/board.bit"));
    board.route("90", "124.9", '2');   // faster, but it misses the screen's clock
    CHECK(board.run({"--seeds", "2"}).code == 1);
    board.route("75", "125", '3');
    const ProgramRun kept = board.run({"--seeds", "1:3", "-o", out});
    CHECK(kept.code == 0);
    CHECK_THAT(kept.out, Catch::Contains("routed: 75.0 MHz with seed 3") && !Catch::Contains("MISSED"));
    CHECK(content_of(out + "/board.bit") == "routed 3\n");
}

TEST_CASE("chip --board refuses wrong options and failing tools") {
    const FakeBoard board;
    check_refused(board.run({"--clock", "70"}), {"--clock 70", "75 or 62.5 MHz"});
    check_refused(run_program({"chip", "--config", "small", "--board"}), {"dram=board"});
    check_refused(run_program({"chip", "--clock", "75"}), {"--clock and --sdram need --board"});
    check_refused(run_program({"chip", "--sdram", "is42s16160g"}), {"--clock and --sdram need --board"});
    check_refused(board.run({"--sdram", "is42"}), {"is42"});
    check_refused(board.run({"--unit", "box"}), {"leave out --unit"});
    check_refused(board.run({"--fast"}), {"leave out --unit, --fast"});
    board.pack("echo 'ERROR: no such tile'; exit 1");
    check_refused(board.run(), {"ecppack failed: no such tile"});
    CHECK(board.fake().kept("chip-route-") == 0);
    board.pack(":");
    check_refused(board.run(), {"no bitstream"});
    board.route("75");
    fs::remove(board.fake().folder().name("bin/ecppack"));
    check_refused(board.run(), {"ecppack is not installed"});
}

TEST_CASE("a chip that is interrupted during a second placement continues after the first", "[long]") {
    const FakeNextpnr fake;
    fake.replace("case \"$*\" in *anchored*--seed*) sleep 100;; esac");
    const std::vector<std::string> placed{"--placements", "3", "--router", "router1"};
    const ProgramRun stopped = run_and_stop(FakeNextpnr::words(placed), fake.environment(), SIGINT,
                                            [&] { return fake.routed() == 2; });
    CHECK(stopped.code == 1);
    CHECK_THAT(stopped.err, Catch::Contains("interrupted") && Catch::Contains("continues after"));
    CHECK(fake.kept("chip-sites-") == 1);
    fake.replace("true");
    REQUIRE(fake.run(placed).code == 0);
    CHECK(fake.routed() == 4);   // placed a second and a third time, and routed
    CHECK(fake.kept("chip-sites-") == 2);
    // Another router needs no other placements; another seed, placer or device does.
    CHECK(fake.run({"--placements", "3", "--router", "router2"}).code == 0);
    CHECK(fake.routed() == 6);
    CHECK(fake.kept("chip-sites-") == 2);
    for (const std::vector<std::string>& other : std::vector<std::vector<std::string>>{
             {"--seeds", "2"}, {"--placer", "static"}, {"--device", "lfe5u-45"}}) {
        const int before = fake.kept("chip-sites-");
        std::vector<std::string> words = placed;
        words.insert(words.end(), other.begin(), other.end());
        CHECK(fake.run(words).code == 0);
        CHECK(fake.kept("chip-sites-") == before + 2);
    }
}

TEST_CASE("an estimate has the sum of all units and the slowest clock, next to the routed chip") {
    const FakeNextpnr fake;
    std::vector<std::string> environment = fake.environment();
    environment.push_back(fake_yosys(fake, 1));
    const std::string report = fake.folder().name("a.json");
    const auto chip = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"chip", "--config", "small", "--json", report});
        return run_program(more, environment);
    };
    check_refused(chip({"--fast"}), {"sched, raygen, trav", "--unit sched,raygen,trav"});
    const ProgramRun units = chip({"--unit", "all"});
    REQUIRE(units.code == 0);
    const json alone = json::parse(content_of(report))["alone"];
    CHECK(alone.size() == 10);
    const int routed = fake.routed();
    CHECK(routed == 10);
    const ProgramRun fast = chip({"--fast"});
    REQUIRE(fast.code == 0);
    CHECK_THAT(fast.out,
               Catch::Contains("estimated: 154.7 MHz") && Catch::Contains("the chip itself was not routed"));
    const json estimate = json::parse(content_of(report));
    CHECK(estimate["estimated"] == true);
    CHECK(estimate["routed"] == false);
    CHECK(estimate["fmax_mhz_routed"].is_null());
    int luts = 0;
    for (const json& unit : alone) luts += unit["totals"]["lut"].get<int>();
    CHECK(estimate["totals"]["lut"] == luts);
    CHECK(fake.routed() == routed);
    REQUIRE(chip({}).code == 0);
    CHECK_THAT(chip({"--fast"}).out,
               Catch::Contains("the chip itself, routed: 154.7 MHz") && Catch::Contains("+0.0 %"));
}

TEST_CASE(
    "the clock that a chip was routed for is one of simulate and sweep, and reports say which were shown") {
    const FakeNextpnr fake;
    std::vector<std::string> environment = fake.environment();
    environment.push_back(fake_yosys(fake, 1));
    const std::string report = fake.folder().name("a.json");
    const auto run = [&](const char* command, std::vector<std::string> more) {
        more.insert(more.begin(),
                    {command, "tetra:1", "--size", "16x12", "--config", "small", "--json", report});
        return run_program(more, environment);
    };
    check_refused(run("simulate", {"--clock", "fmax"}),
                  {"--clock fmax", "'small' was not routed", "rayclock chip --config small"});
    check_refused(run("sweep", {"--clock", "fmax", "--axis", "pipelines=1"}),
                  {"--clock fmax", "was not routed"});
    const ProgramRun before = run("simulate", {"--clock", "66"});
    REQUIRE(before.code == 0);
    CHECK_THAT(before.out, Catch::Contains("'small' was not routed, so these clocks are assumed"));
    const json assumed = json::parse(content_of(report))["clocks"][0];
    CHECK(assumed["clock_is"] == "assumed");
    CHECK(assumed["clock_mhz_routed"].is_null());

    const ProgramRun chip =
        run_program({"chip", "--config", "small", "--scene", "tetra:1", "--size", "16x12"}, environment);
    REQUIRE(chip.code == 0);
    CHECK_THAT(chip.out,
               Catch::Contains("tetra:1, 16x12: ") && Catch::Contains("per second at the routed 154.7 MHz"));

    const ProgramRun after = run("simulate", {"--clock", "fmax,66,200"});
    REQUIRE(after.code == 0);
    CHECK_THAT(after.out, Catch::Contains("routed on lfe5u-85: 154.7 MHz; 200 MHz assumed"));
    const json clocks = json::parse(content_of(report))["clocks"];
    REQUIRE(clocks.size() == 3);
    CHECK(clocks[0]["mhz"] == 154.726);   // rounds down to a clock that routing has shown
    CHECK(clocks[0]["clock_is"] == "routed");
    CHECK(clocks[0]["clock_mhz_routed"].get<double>() == Approx(154.727).margin(0.001));
    CHECK(clocks[1]["clock_is"] == "routed");
    CHECK(clocks[2]["clock_is"] == "assumed");
    REQUIRE(run("sweep", {"--clock", "fmax", "--axis", "node_sets=32", "--no-netlist"}).code == 0);
    CHECK(json::parse(content_of(report))["points"][0]["clock"]["mhz"] == 154.726);
    check_refused(run("sweep", {"--clock", "fmax", "--axis", "node_sets=16", "--no-netlist"}),
                  {"was not routed"});
}

TEST_CASE("a full disk gives one sentence in every step, and nothing of that step is kept") {
    const FakeNextpnr fake;
    const std::string variables = "RAYCLOCK_NEXTPNR='" + fake.folder().name("nextpnr") +
                                  "' RAYCLOCK_CACHE='" + fake.folder().name("cache") + "' ";
    // In blocks of 512 bytes. rayclock writes the package, Yosys the netlist, and Yosys does not report why
    // it fails.
    for (const auto& [blocks, why] :
         {std::pair{"4", "File too large"}, {"150", "is the disk full?"}, {"400", "is the disk full?"}}) {
        INFO("blocks: " << blocks);
        check_refused(run_in_shell(std::string("ulimit -f ") + blocks + "; " + variables + "exec \"$@\"",
                                   FakeNextpnr::words({})),
                      {why});
        CHECK(fake.kept("chip-netlist-") == 0);
        CHECK(fake.kept("yosys-") == 0);
    }
    CHECK(fake.run().code == 0);
}

TEST_CASE("chip refuses what makes no sense") {
    const FakeNextpnr fake;
    const auto chip = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"chip", "--config", "small"});
        return run_program(words, fake.environment());
    };
    check_refused(chip({"--device", "lfe5u-84"}), {"'lfe5u-84'", "did you mean 'lfe5u-85'"});
    check_refused(chip({"--unit", "bx"}), {"'bx'", "did you mean 'box'", "raygen"});
    check_refused(chip({"--unit", "shade"}), {"'shade'", "small"});   // the configuration lacks it
    check_refused(chip({"--seeds", "0"}), {"--seeds", "above 0"});
    check_refused(chip({"--seeds", "1:200"}), {"--seeds", "more than 100"});
    check_refused(chip({"--seeds", "one"}), {"'one'"});
    check_refused(chip({"--placer", "statik"}), {"--placer", "'statik'", "did you mean 'static'"});
    check_refused(chip({"--router", "3"}), {"--router", "'3'"});
    check_refused(chip({"--placements", "0"}), {"--placements", "0", "1..9"});
    check_refused(chip({"--placements", "1"}), {"--placements", "mixed needs at least two"});
    check_refused(chip({"--fast", "--unit", "box"}), {"--fast", "--unit"});
    check_refused(chip({"--fast", "--placements", "2"}), {"--fast", "leave out --placements"});
    check_refused(chip({"--fast"}), {"sched, raygen", "--unit sched,raygen"});
    check_refused(chip({"--scene", "tetr:2"}), {"'tetr'"});
    check_refused(chip({"--set", "primitive_test=woop"}), {"primitive_test=woop", "software only"});
    check_refused(chip({"--json", fake.folder().name("none/a.json")}), {"none/a.json"});
    fake.folder().write("file", "x");
    check_refused(chip({"--unit", "dispatch", "-o", fake.folder().name("file")}), {"file"});
    CHECK(fake.routed() == 0);
}

TEST_CASE("a missing, old or wrong router gives one sentence, and doctor reports it") {
    const FakeNextpnr fake;
    const auto with = [&](const std::string& nextpnr, std::vector<std::string> words) {
        return run_program(words,
                           {"RAYCLOCK_NEXTPNR=" + nextpnr, "RAYCLOCK_CACHE=" + fake.folder().name("cache")});
    };
    const std::string own = fake.folder().name("nextpnr");
    check_refused(with("/nonexistent", {"chip"}), {"RAYCLOCK_NEXTPNR=/nonexistent", "no program"});
    check_refused(with("/bin/true", {"chip"}), {"/bin/true", "./bootstrap chip"});
    fake.replace("true", "0.4-1");
    check_refused(with(own, {"chip"}), {"nextpnr-ecp5 0.4 is too old", "./bootstrap chip"});
    CHECK_THAT(with(own, {"doctor"}).out,
               Catch::Contains("nextpnr-ecp5 0.4 is too old") && Catch::Contains("only chip"));
    fake.replace("true", "nextpnr-0.99");
    CHECK_THAT(with(own, {"doctor"}).out, Catch::Contains("nextpnr-ecp5 0.99 was not tried"));
    fake.replace("true");
    CHECK_THAT(with(own, {"doctor"}).out, Catch::Contains("0.11.1, " + own));
    check_refused(run_program({"chip"}, {"PATH=/nonexistent", "RAYCLOCK_NEXTPNR=" + own,
                                         "RAYCLOCK_CACHE=" + fake.folder().name("cache")}),
                  {"yosys is not installed", "apt-get install yosys"});
}

TEST_CASE("dispatch is really placed and routed, and has the registers that Yosys has counted", "[slow]") {
    const TestFolder folder;
    const std::vector<std::string> environment{"RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::string doctor = run_program({"doctor", "--json", "-"}, environment).out;
    if (json::parse(doctor)["nextpnr"].is_null()) {
        WARN("nextpnr-ecp5 is not installed, so nothing was routed; ./bootstrap chip installs it");
        return;
    }
    const auto chip = [&](const char* report, const std::string& seed) {
        const ProgramRun outcome = run_program({"chip", "--config", "small", "--unit", "dispatch", "--seeds",
                                                seed, "--json", folder.name(report)},
                                               environment);
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return json::parse(content_of(folder.name(report)));
    };
    const json routed = chip("a.json", "1"), area = [&] {
        run_program(
            {"study", "area", "--config", "small", "--unit", "dispatch", "--json", folder.name("area.json")},
            environment);
        return json::parse(content_of(folder.name("area.json")))["variants"][0]["units"][0]["count"];
    }();
    CHECK(routed["totals"]["ff"] == area["ff"]);
    CHECK(routed["fmax_mhz"].get<double>() > 60);
    const json slowest = routed["paths"][0];
    CHECK(slowest["mhz"].get<double>() == Approx(routed["fmax_mhz"].get<double>()).epsilon(0.001));
    CHECK_THAT(slowest["source"].get<std::string>(), Catch::StartsWith("rtl/"));
}
