// The page of figures and the ray counts, with small pictures.
#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

TEST_CASE("the page of figures shows every picture and every number", "[long]") {
    const TestFolder folder;
    const ProgramRun outcome =
        run_program({"study", "figures", "-o", folder.name("page"), "--size", "32x24", "--engine",
                     "reference,model", "--json", folder.name("numbers.json")});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.err.empty());
    const std::string page = content_of(folder.name("page/figures.md"));
    std::size_t pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.name("page/figures"))) {
        INFO(entry.path());
        CHECK(page.find("(figures/" + entry.path().filename().string() + ")") != std::string::npos);
        CHECK(entry.file_size() > 0);
        ++pictures;
    }
    CHECK(pictures == 2 * 11 + 2 * 6 + 2 * 6 + 4 + 2);
    CHECK(page.find("The RTL was not requested.") != std::string::npos);
    for (const char* bad : {"nan", "inf ", "{}", "/tmp"}) CHECK(page.find(bad) == std::string::npos);

    const json numbers = json::parse(content_of(folder.name("numbers.json")));
    for (const char* engine : {"reference", "model"}) {
        const json& bounces = numbers["bounces"][engine];
        REQUIRE(bounces.size() == 6);
        for (std::size_t k = 1; k < 6; ++k) CHECK(bounces[k]["rays"] >= bounces[k - 1]["rays"]);
        CHECK(bounces[5]["added"].get<double>() < 0.1 * bounces[1]["added"].get<double>());
    }
    for (const char* scene : {"spheres", "balls:3", "mount:5", "gears:2"})
        for (const char* engine : {"reference", "model"}) {
            const json &depths = numbers["cutoffs"][scene][engine]["depths"],
                       &thresholds = numbers["cutoffs"][scene][engine]["thresholds"];
            INFO(scene << ", " << engine);
            CHECK(depths.back()["depth"] == 15);
            CHECK(depths.back()["rmse"] == 0);
            CHECK(depths.back() == thresholds.front());
            CHECK(depths.front()["rmse"].get<double>() > 0);
            CHECK(thresholds.back()["rays"] < thresholds.front()["rays"]);
            for (std::size_t k = 1; k < depths.size(); ++k) CHECK(depths[k]["rays"] >= depths[k - 1]["rays"]);
        }
    // With 8x8 samples the plane has less noise than with one. An adaptive picture has at most as many
    // samples as 4x4 everywhere.
    for (const json& p : numbers["adaptive"]["plane"]["model"])
        CHECK(p["samples"].get<int>() <= 16 * 32 * 24);
    CHECK(numbers["plane"].size() == 12);
    CHECK(numbers["square"].size() == 12);
    for (const char* scene : {"balls:2", "mount:4", "gears:1"}) {
        const json& share = numbers["test_share"][scene];
        CHECK(share["reference"]["with"]["tests"].get<double>() <
              0.5 * share["reference"]["without"]["tests"].get<double>());
        CHECK(share["reference"]["without"]["search_share"].get<double>() < 1);
        CHECK(share["model"]["tri_busy"].get<double>() <= 1);
        CHECK(share["model"]["tests"].get<double>() < share["model"]["tests_without"].get<double>());
    }
}

TEST_CASE("figures refuses what it cannot do") {
    const TestFolder folder;
    check_refused(run_program({"study", "figures", "-o", folder.name("page"), "--engine", "model,chip"}),
                  {"--engine", "'chip'", "reference, model or rtl"});
    check_refused(run_program({"study", "figures", "-o", folder.name("page"), "--size", "0x5"}), {"picture"});
    const std::string file = folder.write("file", "no folder");
    check_refused(run_program({"study", "figures", "-o", file, "--size", "16x12"}), {file, "folder"});
    CHECK(content_of(file) == "no folder");
}

TEST_CASE("reference and model count the same rays of Haines' scenes, within 1 %") {
    const TestFolder folder;
    const ProgramRun outcome =
        run_program({"study", "counts", "balls:2", "gears:1", "mount:4", "teapot:4", "tetra:4", "--size",
                     "96x96", "-o", folder.name("spd.md"), "--json", folder.name("spd.json")});
    INFO(outcome.err << outcome.out);
    REQUIRE(outcome.code == 0);
    const json report = json::parse(content_of(folder.name("spd.json")));
    CHECK(report["good"] == true);
    REQUIRE(report["scenes"].size() == 5);
    for (const json& scene : report["scenes"]) {
        CHECK(scene["published"].is_null());
        CHECK(scene["model_from_reference"].get<double>() <= 0.01);
        CHECK(scene["reference"]["shadow"].get<int>() > 0);
    }
    CHECK(content_of(folder.name("spd.md")).find("rayclock study counts balls:2") != std::string::npos);
    check_refused(run_program({"study", "counts", "nothing"}), {"nothing"});
}

// V. Havran, "Comparison of Octree Traversal Algorithms", 1999. Means change little with the picture's size.
TEST_CASE("visits and tests in octrees are the published ones, within 3 %") {
    const ProgramRun outcome = run_program(
        {"study", "counts", "balls:4", "mount:6", "teapot:12", "--size", "129x129", "--json", "-"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    for (const json& scene : report["scenes"]) {
        REQUIRE(scene["octrees"].size() == 4);
        for (const json& tree : scene["octrees"])
            for (const char* figure : {"tests_per_hit", "leaves_per_ray", "empty_leaves_per_ray"}) {
                INFO(scene["scene"] << ", depth " << tree["depth"] << ": " << figure);
                const double mine = tree[figure], his = tree["published"][figure];
                CHECK(std::abs(mine / his - 1) < 0.03);
            }
    }
}

TEST_CASE("rays of tetra are the published ones", "[slow]") {
    const ProgramRun outcome = run_program({"study", "counts", "tetra:6", "--json", "-"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const json scene = json::parse(outcome.out)["scenes"][0];
    CHECK(scene["published"]["shadow"] == 46112);
    CHECK(std::abs(scene["model"]["shadow"].get<double>() / 46112 - 1) < 0.01);
    CHECK(scene["good"] == true);
}

TEST_CASE("the page of structures has every structure on every scene, and the list on small ones", "[long]") {
    const TestFolder folder;
    const ProgramRun outcome =
        run_program({"study", "structures", "-o", folder.name("."), "--scenes", "tetra:2", "--size", "32x24",
                     "--no-netlist", "--min-psnr", "200", "--json", folder.name("rows.json")});
    INFO(outcome.err << outcome.out);
    REQUIRE(outcome.code == 0);
    const std::string page = content_of(folder.name("structures.md"));
    for (const char* part :
         {"\n| bvh |", "\n| spheres |", "\n| kd |", "\n| octree |", "| octree, finished † |",
          "| octree, inner |", "| none |", "--scenes tetra:2 --size 32x24 --no-netlist --min-psnr 200",
          "\n| kd, finished † |", "| octree, inner † |", "\n† FAR FROM THE REFERENCE: PSNR ",
          "(limit 200 dB, --min-psnr) (", " of 14 pictures are far)"}) {
        INFO(part);
        CHECK(page.find(part) != std::string::npos);
    }
    for (const json& row : json::parse(content_of(folder.name("rows.json")))["rows"])
        CHECK(row["far"] == true);
    CHECK(page.find(" is missing: ") == std::string::npos);
    CHECK(!content_of(folder.name("structures.svg")).empty());
    check_refused(run_program({"study", "structures"}), {"--output"});
    check_refused(
        run_program({"study", "structures", "-o", folder.name("."), "--set", "primitive_test=woop"}),
        {"splits=on", "primitive_test"});
}

TEST_CASE("the page of gigahertz has every memory at every clock, says where the wall is, and answers") {
    const TestFolder folder;
    const ProgramRun outcome = run_program({"study", "gigahertz", "-o", folder.name("."), "--scene",
                                            "tetra:2", "--finished", "tetra:1", "--size", "16x12"});
    INFO(outcome.err << outcome.out);
    REQUIRE(outcome.code == 0);
    const std::string page = content_of(folder.name("gigahertz.md"));
    for (const char* part : {"\n| rpu |", "\n| sdr |", "\n| ddr3 |", "\n| lpddr4 x 2 |", "\n| ddr4 |",
                             "\n| hbm2 x 4 |", "\n| ideal |", "| 66 MHz | 133 MHz |", "| 4000 MHz |",
                             "All clocks here are assumed", "18.4 to 32.3", "## Where the memory wall is",
                             "## Do frames follow the clock?\n\nIf frames followed the clock, 66 to 4000 MHz",
                             "--scene tetra:2 --finished tetra:1"})
        CHECK(page.find(part) != std::string::npos);
    const std::string drawing = content_of(folder.name("gigahertz.svg"));
    CHECK(drawing.find("hbm2 x 4") != std::string::npos);
    CHECK(drawing.find("nan") == std::string::npos);
    check_refused(run_program({"study", "gigahertz"}), {"--output"});
}

TEST_CASE("the page of scale has every frame with its cost, and its exponents are those of the times") {
    const TestFolder folder;
    const ProgramRun outcome =
        run_program({"study", "scale", "-o", folder.name("."), "--scenes", "teapot:1,teapot:4", "--placed",
                     "gearbox:1,gearbox:2", "--size", "32x24", "--sizes", "16x12,64x48", "--json",
                     folder.name("s.json")});
    INFO(outcome.err << outcome.out);
    REQUIRE(outcome.code == 0);
    const json figures = json::parse(content_of(folder.name("s.json")));
    for (const char* series : {"triangles", "placed", "pixels"}) {
        INFO(series);
        const json &rows = figures[series]["rows"], &first = rows[0], &last = rows[1];
        REQUIRE(rows.size() == 2);
        const auto size = [&](const json& row) {
            return std::string(series) == "pixels" ? row["width"].get<double>() * row["height"].get<double>()
                                                   : row["triangles"].get<double>();
        };
        CHECK(size(last) > 2 * size(first));
        for (const char* work : {"load", "compile", "record", "replay", "reference", "judge"}) {
            INFO(work);
            // Two points determine the power law.
            const double a = first["seconds"][work], b = last["seconds"][work];
            REQUIRE(a > 0);
            CHECK(figures[series]["exponents"][work].get<double>() * std::log(size(last) / size(first)) ==
                  Approx(std::log(b / a)));
        }
        for (const json& row : rows) {
            CHECK(row["rays_judged"] == row["width"].get<int>() * row["height"].get<int>());
            CHECK(row["rays_wrong"] == 0);
            CHECK(row["peak_bytes"].get<double>() > row["image_bytes"].get<double>());
        }
    }
    CHECK(figures["largest"]["scene"] == "teapot:4");
    CHECK(figures["largest"]["width"] == 64);
    const std::string page = content_of(folder.name("scale.md")),
                      drawing = content_of(folder.name("scale.svg"));
    for (const char* part : {"\n| `teapot:4` | ", "\n| `gearbox:2` | ", "\n| **exponent** | ",
                             "--scenes teapot:1,teapot:4 --placed gearbox:1,gearbox:2 --size 32x24 --sizes "
                             "16x12,64x48"}) {
        INFO(part);
        CHECK(page.find(part) != std::string::npos);
    }
    CHECK(drawing.find("reference") != std::string::npos);
    CHECK(drawing.find("nan") == std::string::npos);
    check_refused(run_program({"study", "scale"}), {"--output"});
    check_refused(run_program({"study", "scale", "-o", folder.name("."), "--set", "shading=1"}),
                  {"shading=1"});
    check_refused(run_program({"study", "scale", "-o", folder.name("."), "--sizes", "0x5"}), {"0 x 5"});
}

TEST_CASE("the page of textures has every filter and format, and the same cycles as simulate", "[long]") {
    const TestFolder folder;
    const ProgramRun outcome =
        run_program({"study", "textures", "-o", folder.name("page"), "--size", "48x36", "--scenes",
                     "room,scenes/street.json,scenes/globe.json", "--json", folder.name("t.json")});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const json scenes = json::parse(content_of(folder.name("t.json")))["scenes"];
    REQUIRE(scenes.size() == 3);
    for (const json& scene : scenes) {
        INFO(scene["scene"]);
        REQUIRE(scene["rows"].size() == 9);
        const auto row = [&](const std::string& texels, const std::string& filter) -> json {
            for (const json& each : scene["rows"])
                if (each["texels"] == texels && each["filter"] == filter) return each;
            return {};
        };
        const std::string levels = "bilinear, mip levels", level_0 = "bilinear, level 0";
        for (const char* filter : {"nearest texel, level 0", "bilinear, level 0", "bilinear, mip levels"}) {
            INFO(filter);
            const json wide = row("rgb888", filter), narrow = row("rgb565", filter),
                       blocks = row("BC1", filter);
            CHECK(wide["texel_bytes"].get<double>() / narrow["texel_bytes"].get<double>() ==
                  Approx(2).epsilon(0.01));
            CHECK(narrow["texel_bytes"].get<double>() / blocks["texel_bytes"].get<double>() ==
                  Approx(4).epsilon(0.15));
            CHECK(wide["image_bytes"].get<int>() - narrow["image_bytes"].get<int>() ==
                  wide["texel_bytes"].get<int>() - narrow["texel_bytes"].get<int>());
            // Only the lines of texels differ.
            CHECK(wide["costs"][0]["tex_cache_look_ups"].get<double>() ==
                  Approx(narrow["costs"][0]["tex_cache_look_ups"].get<double>()).epsilon(0.05));
            CHECK(narrow["costs"][0]["tex_cache_look_ups"] == blocks["costs"][0]["tex_cache_look_ups"]);
            CHECK(blocks["costs"][0]["bytes_read"] < narrow["costs"][0]["bytes_read"]);
            CHECK(narrow["costs"][0]["bytes_read"] < wide["costs"][0]["bytes_read"]);
            CHECK(wide["psnr_exact_8_bit_alpha_db"] == wide["psnr_exact_db"]);
            CHECK(wide["psnr_exact_db"] > blocks["psnr_exact_db"]);
        }
        CHECK(row("rgb888", levels)["psnr_64_samples_db"] > row("rgb888", level_0)["psnr_64_samples_db"]);
        CHECK(scene["one_line_of_texels"]["costs"][0]["bytes_read"] <
              row("BC1", levels)["costs"][0]["bytes_read"]);
        // The scenes have mip levels everywhere, so simulate draws the same frames.
        for (const std::string texels : {"rgb888", "rgb565"})
            for (const std::size_t machine : {0, 3}) {
                std::vector<std::string> arguments{
                    "simulate", scene["scene"],     "--size",     "48x36",  "--depth", "2",
                    "--set",    "texels=" + texels, "--no-judge", "--json", "-"};
                const json cost = row(texels, levels)["costs"][machine];
                if (machine == 3) {
                    CHECK(cost["machine"] == "default, dram=sdr, pipelines=8");
                    arguments.insert(arguments.end(), {"--set", "dram=sdr", "--set", "pipelines=8"});
                }
                const ProgramRun run = run_program(arguments);
                INFO(run.err);
                REQUIRE(run.code == 0);
                const json report = json::parse(run.out);
                CHECK(report["clocks"][0]["cycles"] == cost["cycles"]);
                CHECK(report["clocks"][0]["dram_bytes"] == cost["bytes_read"]);
            }
    }
    const std::string page = content_of(folder.name("page/textures.md"));
    for (const auto& entry : std::filesystem::directory_iterator(folder.name("page/figures"))) {
        INFO(entry.path());
        CHECK(page.find("(figures/" + entry.path().filename().string() + ")") != std::string::npos);
    }
    for (const char* bad : {"nan", "inf ", "{}", "/tmp"}) CHECK(page.find(bad) == std::string::npos);
    check_refused(run_program({"study", "textures"}), {"--output"});
    check_refused(run_program({"study", "textures", "-o", folder.name("page"), "--scenes", "gears:1"}),
                  {"gears:1", "no texture"});
    check_refused(run_program({"study", "textures", "-o", folder.name("page"), "--set", "texels=rgb565"}),
                  {"texels"});
    check_refused(run_program({"study", "textures", "-o", folder.name("page"), "--scenes", "room,room"}),
                  {"room", "same names"});
}
