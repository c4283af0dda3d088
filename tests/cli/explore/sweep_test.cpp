// rayclock sweep and tradeoff as a user runs them: the cache, plots, and killed runs.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "tests/cli/view/browser.hpp"
#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Returns a small sweep with its own cache and without Yosys.
std::vector<std::string> sweep(std::vector<std::string> more) {
    std::vector<std::string> arguments{"sweep",  "tetra:4",      "--size",
                                       "64x48",  "--axis",       "coord_bits=12:20:4",
                                       "--axis", "clock=33,200", "--no-netlist"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::size_t files_in(const std::string& folder) {
    std::error_code error;
    return std::size_t(std::distance(fs::directory_iterator(folder, error), fs::directory_iterator()));
}

}   // namespace

TEST_CASE("a sweep gives all figures as table, CSV and JSON, and the same again from the cache") {
    const TestFolder folder;
    const std::vector<std::string> cache{"RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::string csv = folder.name("a.csv"), report = folder.name("a.json");
    const ProgramRun first = run_program(sweep({"-o", csv, "--json", report}), cache);
    INFO(first.err);
    REQUIRE(first.code == 0);
    CHECK(first.out.find("6 points from 3 traces, 0 of them known before") != std::string::npos);
    CHECK(first.out.find("Pareto front of pixels_other_primitive, chip_memory_bits and fps") !=
          std::string::npos);
    CHECK(first.out.find("cost: chip_memory_bits, because multipliers were not counted") !=
          std::string::npos);
    const std::string table = content_of(csv), whole = content_of(report);
    CHECK(
        table.starts_with("coord_bits,clock,cycles,fps,cycles_per_ray,node_hit_rate,prim_hit_rate,bytes_per_"
                          "ray,bound,bound_reached,pixels_other_primitive,"
                          "percent_other_primitive,psnr_db,max_abs_depth,cracks,memory_bytes,multipliers,"
                          "flip_flops,pareto,knee,clock_is,"));
    const json parsed = json::parse(whole);
    for (const json& point : parsed["points"]) {
        CHECK(point["cracks"] == 0);
        CHECK(point["error"]["pixels"] == 64 * 48);
        CHECK((point["error"]["psnr_db"].is_number() || point["error"]["pixels_other_primitive"] == 0));
        CHECK(point["memory_bytes"] > 1000);
        CHECK(point["multipliers"].is_null());
        CHECK(point["cycles_per_ray"].get<double>() ==
              Approx(point["clock"]["cycles"].get<double>() / (64 * 48)));
        CHECK(point["pareto"].is_boolean());
    }
    CHECK(parsed["points"][0]["error"] == parsed["points"][1]["error"]);
    CHECK(parsed["points"][0]["error"]["pixels_other_primitive"] >
          parsed["points"][4]["error"]["pixels_other_primitive"]);
    CHECK(parsed["front"]["cost"] == "chip_memory_bits");
    // The output of simulate for the same frame.
    const json single = json::parse(run_program({"simulate", "tetra:4", "--size", "64x48", "--set",
                                                 "coord_bits=12", "--clock", "33", "--json", "-"})
                                        .out);
    CHECK(parsed["points"][0]["error"]["pixels_other_primitive"] ==
          single["error"]["pixels_other_primitive"]);
    CHECK(parsed["points"][0]["error"]["psnr_db"] == single["error"]["psnr_db"]);
    CHECK(parsed["points"][0]["memory_bytes"] == single["compile"]["bytes"]);

    const ProgramRun second = run_program(sweep({"-o", csv, "--json", report}), cache);
    CHECK(second.out.find("6 of them known before") != std::string::npos);
    CHECK(content_of(csv) == table);
    CHECK(content_of(report) == whole);
    const ProgramRun fresh = run_program(sweep({"-o", csv, "--json", report, "--fresh"}), cache);
    CHECK(fresh.out.find("0 of them known before") != std::string::npos);
    CHECK(content_of(csv) == table);
    CHECK(content_of(report) == whole);
}

namespace {

/// The common options of `sweep` and `simulate`, and an axis.
struct Swept {
    std::vector<std::string> words;
    std::string key;
    std::vector<std::string> values;
};

/// Compares every figure of a sweep's row that simulate also has.
void check_row(const json& point, const json& single) {
    const json &swept = point["clock"], &alone = single["clocks"][0];
    for (const auto& [key, value] : alone.items()) {
        INFO(key);
        CHECK(swept[key] == value);
    }
    CHECK(point["error"] == single["error"]);
    CHECK(point["memory_bytes"] == single["compile"]["bytes"]);
    CHECK(point["rays"] == single["rays"]);
}

}   // namespace

TEST_CASE("a sweep's row is the frame that simulate draws with the same machine") {
    const std::vector<Swept> sweeps{
        {{"balls:1", "--depth", "2", "--threshold", "0.1"}, "coord_bits", {"16", "20"}},
        {{"spheres", "--depth", "3", "--aa", "2", "--jittered", "--fresnel"}, "surf_sets", {"1", "64"}},
        // Horizon needs 9 bits of an origin.
        {{"scenes/pond.json", "--depth", "2"}, "bary_bits", {"8", "12"}},
        // Fewer lights than the scene has are refused.
        {{"spheres", "--depth", "1"}, "lights", {"1", "4"}},
        {{"crowd", "--frames", "3", "--fps", "5"}, "levels", {"1", "2"}},
        {{"crowd", "--set", "levels=2", "--depth", "1", "--frames", "2"}, "pipelines", {"1", "2"}},
        {{"crowd", "--set", "levels=2", "--frames", "2", "--uploads", "double"}, "node_sets", {"8", "64"}},
        {{"gears:1", "--frames", "2", "--pan", "9", "--orbit", "30"}, "dram", {"sdr", "ddr3"}}};
    for (const Swept& s : sweeps) {
        const TestFolder folder;
        const auto run = [&](const char* command, std::vector<std::string> more) {
            std::vector<std::string> words{command};
            words.insert(words.end(), s.words.begin(), s.words.end());
            words.insert(words.end(), {"--size", "24x18", "--clock", "66"});
            words.insert(words.end(), more.begin(), more.end());
            return run_program(words, {"RAYCLOCK_CACHE=" + folder.name("cache")});
        };
        std::string values;
        for (const std::string& value : s.values) values += (values.empty() ? "" : ",") + value;
        const ProgramRun swept =
            run("sweep", {"--axis", s.key + "=" + values, "--no-netlist", "--json", folder.name("a.json")});
        INFO(s.words[0] << ", " << s.key << ": " << swept.err);
        REQUIRE(swept.code == 0);
        const json report = json::parse(content_of(folder.name("a.json")));
        for (std::size_t i = 0; i < s.values.size(); ++i) {
            CAPTURE(s.values[i]);
            const json& point = report["points"][i];
            const ProgramRun single =
                run("simulate", {"--set", s.key + "=" + s.values[i], "--no-judge", "--json", "-"});
            if (single.code == 2) {
                CHECK(single.err.find(point["refused"].get<std::string>()) != std::string::npos);
                continue;
            }
            INFO(single.err);
            REQUIRE(single.code == 0);
            check_row(point, json::parse(single.out));
        }
        // From the cache and after merging it is equal, byte for byte.
        CHECK(run("sweep", {"--axis", s.key + "=" + values, "--no-netlist"}).out.find("2 of them known") !=
              std::string::npos);
        REQUIRE(run_program({"merge", folder.name("a.json"), "--json", folder.name("b.json")}).code == 0);
        CHECK(json::parse(content_of(folder.name("b.json")))["points"] == report["points"]);
    }
}

TEST_CASE("what is drawn decides what a sweep takes from its cache") {
    const TestFolder folder;
    const auto known = [&](std::vector<std::string> more) {
        more.insert(more.begin(),
                    {"sweep", "crowd", "--size", "8x6", "--axis", "contexts=16", "--no-netlist"});
        const ProgramRun o = run_program(more, {"RAYCLOCK_CACHE=" + folder.name("cache")});
        INFO(o.err);
        REQUIRE(o.code == 0);
        return o.out.find(", 1 of them known") != std::string::npos;
    };
    const std::vector<std::vector<std::string>> all{
        {},
        {"--depth", "1"},
        {"--depth", "2"},
        {"--depth", "1", "--threshold", "0.5"},
        {"--depth", "1", "--aa", "2"},
        {"--depth", "1", "--aa", "2", "--jittered"},
        {"--depth", "1", "--aa", "2", "--jittered", "--seed", "2"},
        {"--frames", "2"},
        {"--frames", "2", "--fps", "5"},
        {"--frames", "2", "--time", "1"},
        {"--frames", "2", "--pan", "3"}};
    for (const auto& words : all) CHECK(!known(words));
    for (const auto& words : all) CHECK(known(words));
}

TEST_CASE("a sweep that was interrupted or killed goes on where it was") {
    const TestFolder folder;
    const std::vector<std::string> cache{"RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::vector<std::string> arguments{
        "sweep",        "rings:1",          "--size", "256x192",
        "--axis",       "coord_bits=12:20", "--axis", "clock=33,66,90,200",
        "--no-netlist", "--threads",        "1"};
    for (const int signal : {2, 9}) {
        const std::size_t before = files_in(folder.name("cache/sweep"));
        const ProgramRun stopped = run_and_stop(
            arguments, cache, signal, [&] { return files_in(folder.name("cache/sweep")) >= before + 4; });
        INFO("signal " << signal << ": " << stopped.out << stopped.err);
        if (signal == 2) {
            CHECK(stopped.code == 1);
            CHECK(stopped.out.find("PARTIAL") != std::string::npos);
        } else {
            CHECK(stopped.code == -1);
        }
        CHECK(files_in(folder.name("cache/sweep")) >= before + 4);
    }
    std::vector<std::string> with_json = arguments;
    const std::string report = folder.name("report.json"), other = folder.name("other.json");
    with_json.insert(with_json.end(), {"--json", report});
    const ProgramRun done = run_program(with_json, cache);
    REQUIRE(done.code == 0);
    CHECK(done.out.find(" 0 of them known before") == std::string::npos);
    with_json.back() = other;
    // Starts from nothing.
    CHECK(run_program(with_json, {"RAYCLOCK_CACHE=" + folder.name("other")}).code == 0);
    CHECK(content_of(report) == content_of(other));
}

TEST_CASE("values that do not go together are refused in their rows only") {
    const TestFolder folder;
    const ProgramRun outcome = run_program({"sweep", "tetra:2", "--size", "8x8", "--axis", "coord_bits=18,20",
                                            "--axis", "dir_bits=20,24", "--no-netlist", "--json", "-"},
                                           {"RAYCLOCK_CACHE=" + folder.name("cache")});
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["points"][3]["refused"].get<std::string>().find("must not exceed 62") != std::string::npos);
    CHECK(report["points"][2].contains("clock"));
}

TEST_CASE("a sweep uses the requested cost, over caches of one size") {
    const TestFolder folder;
    const std::string csv = folder.name("a.csv");
    const std::vector<std::string> caches{"sweep", "tetra:2", "--size",
                                          "8x8",   "--axis",  "node_sets/prim_sets=16/64,32/32,32/64,64/16"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), caches.begin(), caches.end());
        return run_program(more, {"RAYCLOCK_CACHE=" + folder.name("cache")});
    };
    const ProgramRun outcome =
        with({"--cost", "bits", "--cache-bytes", "20480", "--json", folder.name("a.json"), "-o", csv});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.find("front of pixels_other_primitive, chip_memory_bits and fps") != std::string::npos);
    CHECK(content_of(csv).find(
              ",pareto,knee,clock_is,pipeline_cache_bytes,chip_cache_bytes,chip_memory_bits,"
              "chip_luts,chip_flip_flops,chip_multipliers,chip_block_rams,rays,frames,film_cycles,"
              "film_fps,mrays_per_s,cycles_half_width\n") != std::string::npos);
    const json report = json::parse(content_of(folder.name("a.json")));
    CHECK(report["front"]["cost"] == "chip_memory_bits");
    REQUIRE(report["points"].size() == 2);   // 16/64 and 64/16, with four ways and 64 bytes
    CHECK(report["points"][1]["node_sets/prim_sets"] == "64/16");
    for (const json& point : report["points"]) {
        CHECK(point["pipeline_cache_bytes"] == 20480);
        CHECK(point["chip_cache_bytes"] == 20480);
        CHECK(point["chip_memory_bits"] > 8 * 20480);
        CHECK(point["chip"].is_null());
    }
    check_refused(with({"--cache-bytes", "20481"}), {"--cache-bytes", "20481", "16384 to 24576"});
    check_refused(with({"--cache-bytes", "0"}), {"--cache-bytes", "0"});
    check_refused(with({"--cost", "luts"}), {"--cost", "'luts'", "did you mean 'lut'"});
}

TEST_CASE("a sweep weighs the chip's cells", "[slow]") {
    if (run_program({"doctor", "--json", "-"}).out.find("\"yosys\": null") != std::string::npos) return;
    const ProgramRun outcome = run_program({"sweep", "tetra:1", "--size", "8x8", "--config", "small",
                                            "--axis", "node_sets=16,64", "--cost", "bram", "--json", "-"});
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["front"]["cost"] == "chip_block_rams");
    for (const json& point : report["points"]) {
        CHECK(point["chip"]["luts"] > 10000);
        CHECK(point["chip"]["mult18x18d"] > 50);
    }
    CHECK(report["points"][0]["chip"]["dp16kd"] <= report["points"][1]["chip"]["dp16kd"]);
    CHECK(report["points"][0]["chip"]["luts"] != report["points"][1]["chip"]["luts"]);
}

TEST_CASE("a sweep writes the plot of its front completely or not at all") {
    const TestFolder folder;
    const std::vector<std::string> cache{"RAYCLOCK_CACHE=" + folder.name("cache")};
    REQUIRE(run_program(sweep({"--plot", folder.name("plot")}), cache).code == 0);
    const std::string svg = content_of(folder.name("plot.svg"));
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(svg.find("coord_bits / clock") != std::string::npos);
    REQUIRE(run_program(sweep({"--plot", "coord_bits,bytes_per_ray=" + folder.name("two.svg"), "--plot",
                               folder.name("three")}),
                        cache)
                .code == 0);
    CHECK(content_of(folder.name("two.svg")).find("bytes_per_ray against coord_bits") != std::string::npos);
    CHECK(content_of(folder.name("three.svg")) == svg);
    const auto before = folder.contents();
    check_refused(run_program(sweep({"--plot", folder.name("no/such/plot")}), cache), {"no/such/plot.svg"});
    check_refused(run_program(sweep({"--plot", "cycls,fps"}), cache), {"--plot", "'cycls'", "'cycles'"});
    check_refused(run_program(sweep({"--plot", "cycles,fps="}), cache), {"--plot", "'cycles,fps='"});
    check_refused(run_program(sweep({"--plot", "cycles,bound=" + folder.name("x")}), cache),
                  {"--plot", "bound", "words"});
    CHECK(folder.contents() == before);
}

TEST_CASE("a plot is a PDF if it is called so, and says what it needs for that") {
    const TestFolder folder;
    const std::string cache = "RAYCLOCK_CACHE=" + folder.name("cache"), file = folder.name("plot.pdf");
    check_refused(run_program(sweep({"--plot", file}), {cache, "PATH=" + folder.name("nothing")}),
                  {"plot.pdf", "rsvg-convert", "librsvg2-bin"});
    if (!is_installed("rsvg-convert")) {
        WARN("rsvg-convert is not installed");
        return;
    }
    REQUIRE(run_program(sweep({"--plot", file}), {cache}).code == 0);
    const std::string first = content_of(file);
    CHECK(first.starts_with("%PDF-"));
    CHECK(first.find("%%EOF") != std::string::npos);
    REQUIRE(run_program(sweep({"--plot", file}), {cache}).code == 0);
    CHECK(content_of(file) == first);
}

TEST_CASE("tradeoff writes its page with a plot for each scene") {
    const TestFolder folder;
    const std::string page = folder.name("page.md");
    const ProgramRun outcome =
        run_program({"study", "tradeoff", "-o", page, "--scenes", "tetra:2,icosphere:2", "--size", "24x18",
                     "--no-netlist", "--min-psnr", "200"},
                    {"RAYCLOCK_CACHE=" + folder.name("cache")});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const std::string text = content_of(page);
    for (const char* word :
         {"# Speed against error", "### coord_bits", "### dir_bits", "### box_bits", "### recip_bits",
          "### node_width", "### primitive_test",
          "--scenes tetra:2,icosphere:2 --size 24x18 --no-netlist --min-psnr 200", "](page-tetra-2.svg)",
          "](page-icosphere-2.svg)", "| moller |", " % † |",
          "\n† FAR FROM THE REFERENCE: ", "(limit 200 dB, --min-psnr)", "pictures are far)"}) {
        INFO(word);
        CHECK(text.find(word) != std::string::npos);
    }
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(fs::path(page).parent_path()))
        files.push_back(entry.path().filename().string());
    std::sort(files.begin(), files.end());
    CHECK(files == std::vector<std::string>{"cache", "page-icosphere-2.svg", "page-tetra-2.svg", "page.md"});
    check_refused(run_program({"study", "tradeoff", "-o", folder.name("no/such/page.md")}),
                  {"no/such/page.md"});
}

TEST_CASE("Yosys counts multipliers and flip-flops once, where there is RTL", "[long]") {
    if (run_program({"doctor", "--json", "-"}).out.find("\"yosys\": null") != std::string::npos) return;
    const TestFolder folder;
    const auto counts = [&] {
        const ProgramRun outcome =
            run_program({"sweep", "tetra:1", "--size", "8x8", "--axis", "primitive_test=exact,moller",
                         "--config", "small", "--json", "-"});
        REQUIRE(outcome.code == 0);
        return json::parse(outcome.out);
    };
    const json report = counts(), again = counts();
    CHECK(report == again);
    CHECK(report["points"][0]["multipliers"] > 20);
    CHECK(report["points"][0]["flip_flops"] > 1000);
    CHECK(report["points"][1]["multipliers"].is_null());
    CHECK(report["points"][1]["pareto"] == false);
    CHECK(report["front"]["cost"] == "multipliers");
    // Without Yosys there are no counts, and a note.
    const ProgramRun without =
        run_program({"sweep", "tetra:1", "--size", "8x8", "--axis", "contexts=16"},
                    {"RAYCLOCK_CACHE=" + folder.name("cache"), "PATH=" + folder.name("nothing")});
    CHECK(without.code == 0);
    CHECK(without.out.find("Yosys is not installed") != std::string::npos);
}

TEST_CASE("a sweep of samples has the estimates of simulate, their half-widths, and no pictures") {
    const TestFolder folder;
    const std::vector<std::string> sweep{"sweep",          "gears:4",  "--size", "512x384", "--axis",
                                         "node_sets=4,64", "--sample", "10%",    "--seed",  "3",
                                         "--no-netlist",   "--clock",  "66"};
    const auto with = [](std::vector<std::string> arguments, const std::vector<std::string>& more) {
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    };
    const ProgramRun outcome =
        run_program(with(sweep, {"--json", folder.name("all.json"), "-o", folder.name("all.csv"), "--plot",
                                 "cycles,fps=" + folder.name("plot")}));
    INFO(outcome.err << outcome.out);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.find("512x384, samples of 10 %") != std::string::npos);
    const json report = json::parse(content_of(folder.name("all.json")));
    CHECK(report["sweep"]["sample"] == json({{"share", 0.1}, {"seed", 3}}));
    CHECK(report["front"]["speed"] == "fps");
    for (const json& point : report["points"]) {
        const std::string sets = "node_sets=" + std::to_string(point["node_sets"].get<int>());
        INFO(sets);
        const ProgramRun single =
            run_program({"simulate", "gears:4", "--size", "512x384", "--set", sets, "--sample", "10%",
                         "--seed", "3", "--clock", "66", "--json", "-"});
        const json one = json::parse(single.out);
        CHECK(point["clock"]["cycles"] == one["clocks"][0]["cycles"]);
        CHECK(point["rays"] == one["rays"]);
        CHECK(point["error"].is_null());
        const double half_width = point["clock"]["sample"]["cycles_half_width"];
        CHECK(half_width > 0);
        CHECK(half_width ==
              Approx(one["sampling"]["clocks"][0]["figures"]["cycles"]["half_width"].get<double>()));
    }
    CHECK(report["points"][0]["clock"]["cycles"] > report["points"][1]["clock"]["cycles"]);
    for (const char* part : {"1/2", "2/2"}) {
        const std::string file = folder.name(std::string("part") + part[0] + ".json");
        REQUIRE(run_program(with(sweep, {"--shard", part, "--json", file})).code == 0);
    }
    REQUIRE(run_program({"merge", folder.name("part1.json"), folder.name("part2.json"), "--json",
                         folder.name("merged.json")})
                .code == 0);
    CHECK(json::parse(content_of(folder.name("merged.json")))["points"] == report["points"]);

    const auto refused = [&](const std::vector<std::string>& more, const std::vector<std::string>& words) {
        check_refused(run_program(with(sweep, more)), words);
    };
    refused({"--frames", "2"}, {"--sample", "--frames"});
    refused({"--rays", "r.npy"}, {"--sample", "--rays"});
    refused({"--min-psnr", "30"}, {"--sample", "--min-psnr"});
    refused({"--report", folder.name("page.html")}, {"--report", "a sample has no picture"});
    refused({"--plot", "psnr_db,cycles"}, {"psnr_db", "a sample has no picture"});
    check_refused(run_program({"sweep", "gears:4", "--axis", "node_sets=4,64", "--sample", "50%"}),
                  {"--sample", "30 %"});
    check_refused(run_program({"sweep", "crowd:2", "--axis", "node_sets=4,64", "--sample", "10%"}),
                  {"--sample", "moves"});
}
