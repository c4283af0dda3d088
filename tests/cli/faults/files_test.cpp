// Bad input files and outputs that cannot be written: exit code 2, one sentence, and no file is created or
// changed.
#include <catch2/catch.hpp>

#include <filesystem>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "model/core/parameters.hpp"
#include "tests/cli/program.hpp"

using namespace rayclock::test;
namespace fs = std::filesystem;

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct BadFile {
    std::string name, bytes;
    std::vector<std::string> words;
};

/// Requires that every command that reads the file refuses it and leaves the folder unchanged.
void check_input(const std::vector<BadFile>& cases, const std::vector<std::vector<std::string>>& commands) {
    for (const BadFile& bad : cases) {
        const TestFolder folder;
        const std::string file = folder.write(bad.name, bad.bytes);
        folder.write("picture.png", "here before");
        folder.write("report.json", "here before");
        const auto before = folder.contents();
        for (std::vector<std::string> arguments : commands) {
            for (std::string& argument : arguments)
                if (argument == "FILE")
                    argument = file;
                else if (argument.ends_with(".json") || argument.ends_with(".png") || argument == "pictures")
                    argument = folder.name(argument);
            INFO(bad.name << " with rayclock " << arguments[0]);
            std::vector<std::string> words = bad.words;
            words.push_back(bad.name);
            check_refused(run_program(arguments), words);
            CHECK(folder.contents() == before);
        }
    }
}

const std::vector<std::vector<std::string>> scene_commands{
    {"simulate", "FILE", "--size", "8x8", "--json", "report.json"},
    {"render", "FILE", "--size", "8x8", "-o", "picture.png", "--json", "new.json"},
    {"render", "FILE", "--size", "8x8", "-o", "new.png", "--engine", "reference"},
    {"verify", "FILE", "--size", "8x8", "-o", "pictures", "--json", "report.json"}};

/// Returns every parameter of `default` as a file states it, except the last.
std::string all_but_one() {
    const rayclock::Config config = rayclock::named_config("default");
    std::string text;
    for (const rayclock::Parameter& p : rayclock::parameters()) {
        const std::string value = value_text(config, p), quote = p.names ? "\"" : "";
        text += (text.empty() ? "" : ", ") + std::string("\"") + p.key + "\": " + quote + value + quote;
    }
    return text.substr(0, text.rfind(", "));
}
const std::string every_key = all_but_one();

}   // namespace

TEST_CASE("malformed scene files are refused") {
    check_input({{"empty.obj", "", {"empty"}},
                 {"nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", {"2"}},
                 {"infinite.obj", "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", {"3"}},
                 {"beyond.obj", corners + "f 1 2 9\n", {"9"}},
                 {"noface.obj", corners, {}},
                 {"text.obj", "Dear Sir or Madam,\nthis is not a mesh.\n", {}},
                 {"truncated.ply",
                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                  "float z\nelement face 1\n"
                  "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n",
                  {}},
                 {"truncated.glb", std::string("glTF\2\0\0\0\xff\0\0\0", 12), {}},
                 {"noise.stl", std::string(200, '\xa5'), {}},
                 {"broken.json", "{ \"meshes\": [", {}},
                 {"flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", {"every surface is invisible"}},
                 {"picture.gif", "GIF89a", {}}},
                {scene_commands[0], scene_commands[1], scene_commands[3]});
    // The reference needs no lattice, so it accepts a triangle without area.
    check_input({{"empty.obj", "", {"empty"}}, {"beyond.obj", corners + "f 1 2 9\n", {"9"}}},
                {scene_commands[2]});
}

TEST_CASE("a directory, a device or a missing file in place of a scene is refused") {
    const TestFolder folder;
    fs::create_directory(folder.name("folder.obj"));
    check_refused(run_program({"simulate", folder.name("folder.obj")}), {"folder.obj", "directory"});
    check_refused(run_program({"simulate", folder.name("")}), {"directory"});
    check_refused(run_program({"simulate", "/dev/null"}), {"/dev/null"});
    check_refused(run_program({"verify", folder.name("none.glb")}), {"none.glb", "no such file"});
}

TEST_CASE("a file without a visible surface has a background, and no machine holds it") {
    const TestFolder folder;
    // One triangle whose opacity is below the cutoff.
    const std::string file = folder.write("mask.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
"materials": [{"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.2]}}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    for (const char* levels : {"levels=1", "levels=2"}) {
        const ProgramRun refused = run_program({"simulate", file, "--size", "8x6", "--set", levels});
        INFO(refused.err);
        CHECK(refused.code == 2);
        CHECK(refused.err.find("opacity below the cutoff of the material (alphaMode MASK)") !=
              std::string::npos);
        CHECK(refused.err.find("mask.gltf: every surface is invisible") != std::string::npos);
    }
    const ProgramRun drawn = run_program(
        {"render", file, "--engine", "reference", "--size", "8x6", "-o", folder.name("background.png")});
    INFO(drawn.err);
    CHECK(drawn.code == 0);
}

TEST_CASE("malformed configuration files are refused") {
    const std::vector<std::vector<std::string>> commands{
        {"simulate", "tetra:1", "--config", "FILE", "--json", "report.json"},
        {"config", "FILE"},
        {"rtl", "--config", "FILE"}};
    check_input(
        {{"empty.json", "", {}},
         {"text.json", "coord_bits = 18", {}},
         {"list.json", "[1, 2]", {"object"}},
         {"unknown.json", R"({"like": "default", "contxts": 4})", {"'contxts'", "did you mean 'contexts'"}},
         {"missing.json", "{" + every_key + "}", {rayclock::parameters().back().key, "missing"}},
         {"type.json", R"({"like": "default", "contexts": "4"})", {"contexts"}},
         {"fraction.json", R"({"like": "default", "contexts": 4.5})", {"contexts", "4.5"}},
         {"bool.json", R"({"like": "default", "contexts": true})", {"contexts", "true"}},
         {"power.json", R"({"like": "default", "contexts": 5})", {"power of two", "5"}},
         {"range.json", R"({"like": "default", "coord_bits": 21})", {"coord_bits", "21"}},
         {"sum.json", R"({"like": "default", "coord_bits": 20, "dir_bits": 23})", {"62", "63"}},
         {"like.json", R"({"like": "defualt"})", {"'defualt'", "did you mean 'default'"}},
         {"liketype.json", R"({"like": 4})", {"like"}},
         {"name.json", R"({"like": "small", "name": 7})", {"name", "7"}},
         {"null.json", R"({"like": "small", "contexts": null})", {"contexts"}}},
        commands);
    const TestFolder folder;
    check_refused(run_program({"simulate", "tetra:1", "--config", folder.name("none.json")}), {"none.json"});
    check_refused(run_program({"simulate", "tetra:1", "--config", folder.name("")}), {"folder"});
    check_refused(run_program({"simulate", "tetra:1", "--config", "nosuch"}), {"'nosuch'"});
    check_refused(run_program({"simulate", "tetra:1", "--config", "smal"}), {"did you mean 'small'"});
    check_refused(run_program({"simulate", "tetra:1", "--config", ""}), {});
}

TEST_CASE("an output that cannot be written is refused, and no file changes") {
    const TestFolder folder;
    fs::create_directory(folder.name("taken"));
    fs::create_directory(folder.name("taken.png"));
    folder.write("file", "not a folder");
    const auto before = folder.contents();
    const std::string missing = folder.name("none/report.json");
    const auto refused = [&](std::vector<std::string> arguments, const std::string& word) {
        INFO("rayclock " << arguments[0] << " " << arguments.back());
        check_refused(run_program(arguments), {word});
        CHECK(folder.contents() == before);
    };
    refused({"simulate", "tetra:1", "--size", "8x8", "--json", missing}, missing);
    refused({"verify", "tetra:1", "--size", "8x8", "--json", missing}, missing);
    refused({"bench", "tetra:1", "--size", "8x8", "--json", missing}, missing);
    refused({"scenes", "--json", missing}, missing);
    refused({"doctor", "--json", missing}, missing);
    refused({"render", "tetra:1", "--size", "8x8", "-o", folder.name("none/x.png")}, "none");
    refused({"render", "tetra:1", "--size", "8x8", "-o", folder.name("x.png"), "--json", missing}, missing);
    refused({"simulate", "tetra:1", "--size", "8x8", "--json", folder.name("taken")}, "directory");
    refused({"render", "tetra:1", "--size", "8x8", "-o", folder.name("taken.png")}, "directory");
    refused({"render", "tetra:1", "--size", "8x8", "-o", folder.name("file/x.png")}, "file");
    refused({"render", "tetra:1", "--size", "8x8", "-o", folder.name("x.jpg")}, ".jpg");
    refused({"render", "tetra:1", "--size", "8x8", "-o", folder.name("x")}, "ending");
    refused({"render", "tetra:1", "--size", "8x8", "-o", ""}, "--output is required");
    refused({"verify", "tetra:1", "--size", "8x8", "-o", folder.name("file")}, "file");
    refused({"verify", "tetra:1", "--size", "8x8", "-o", folder.name("file/deeper")}, "file");
    if (::geteuid() != 0) {   // permission bits do not restrict root
        fs::create_directory(folder.name("locked"));
        fs::permissions(folder.name("locked"), fs::perms::owner_read | fs::perms::owner_exec);
        check_refused(
            run_program({"simulate", "tetra:1", "--size", "8x8", "--json", folder.name("locked/x.json")}),
            {"locked"});
        check_refused(run_program({"render", "tetra:1", "--size", "8x8", "-o", folder.name("locked/x.png")}),
                      {"locked"});
    }
    check_refused(run_program({"simulate", "tetra:1", "--json", "/proc/rayclock.json"}),
                  {"/proc/rayclock.json"});
}

TEST_CASE("a report that cannot be written at the end gives an error") {
    const ProgramRun full = run_program({"simulate", "tetra:1", "--size", "8x8", "--json", "/dev/full"});
    CHECK(full.code == 2);
    CHECK(full.err == "rayclock: /dev/full: cannot be written: No space left on device\n");
}

TEST_CASE("a cache of RTL that cannot be written is refused") {
    check_refused(run_program({"rtl"}, {"RAYCLOCK_CACHE=/proc/none"}), {"/proc/none", "RAYCLOCK_CACHE"});
}

TEST_CASE("simulate writes the pictures that render draws, without drawing them again") {
    const TestFolder folder;
    const std::vector<std::string> scene{"gears:1", "--size", "24x18"};
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin() + 1, scene.begin(), scene.end());
        return run_program(arguments);
    };
    const std::string out = folder.name("out");
    const ProgramRun outcome = run({"simulate", "-o", out});
    CHECK(outcome.code == 0);
    CHECK(outcome.out.find("pictures: " + out + "/picture.png " + out + "/reference.png " + out +
                           "/difference.png\n") != std::string::npos);
    for (const auto& [engine, name] :
         {std::pair("model", "picture.png"), std::pair("reference", "reference.png")}) {
        CHECK(run({"render", "--engine", engine, "-o", folder.name(name)}).code == 0);
        CHECK(content_of(out + "/" + name) == content_of(folder.name(name)));
    }
    CHECK(fs::exists(out + "/difference.png"));
    CHECK(run({"simulate", "--no-reference", "-o", folder.name("alone")}).code == 0);
    CHECK(content_of(folder.name("alone/picture.png")) == content_of(out + "/picture.png"));
    CHECK_FALSE(fs::exists(folder.name("alone/reference.png")));
    check_refused(run({"simulate", "-o", folder.name("picture.png")}),
                  {"picture.png", "is a file, not a folder"});
}

TEST_CASE("a setting without effect is noted") {
    const ProgramRun outcome = run_program({"simulate", "gears:1", "--size", "8x8", "--no-reference", "--set",
                                            "mem_latency=5", "--set", "contexts=8"});
    CHECK(outcome.code == 0);
    CHECK(outcome.err == "rayclock: note: mem_latency has no effect with dram=ddr3\n");
}

TEST_CASE("a mesh without a mirror: --depth prints a note, and --material adds a mirror") {
    const TestFolder folder;
    folder.write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n");
    const auto reflections = [&](const std::vector<std::string>& more, const std::string& told) {
        std::vector<std::string> words{"simulate", folder.name("two.obj"), "--size", "24x18", "--depth", "1",
                                       "--json",   folder.name("out.json")};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun outcome = run_program(words);
        CHECK(outcome.code == 0);
        CHECK(outcome.err == told);
        return nlohmann::json::parse(content_of(folder.name("out.json")))["rays"]["reflection"].get<int>();
    };
    CHECK(reflections(
              {},
              "rayclock: note: --depth 1 draws no reflected or refracted ray, since no material reflects or "
              "transmits light; --material mirror=0.5 lets reflect what has no material of its own\n") == 0);
    CHECK(reflections({"--material", "mirror=0.5"}, "") > 0);
    check_refused(run_program({"simulate", "gears:1", "--size", "8x8", "--material", "glass"}),
                  {"--material", "every surface of gears:1 has one"});
}

TEST_CASE("a memory from a file equals the named memory, and its report can be run again") {
    const TestFolder folder;
    const auto simulate = [&](const std::vector<std::string>& more, const std::string& json) {
        std::vector<std::string> words{"simulate",       "gears:1",    "--size", "16x12",
                                       "--no-reference", "--no-judge", "--json", folder.name(json)};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun outcome = run_program(words);
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return nlohmann::json::parse(content_of(folder.name(json)));
    };
    folder.write("same.json", R"({"like": "sdr"})");
    folder.write("slow.json", R"({"like": "sdr", "name": "slow", "cl_clocks": 30})");
    const auto named = simulate({"--set", "dram=sdr"}, "named.json");
    const auto same = simulate({"--set", "dram=" + folder.name("same.json")}, "out.json");
    const auto slow = simulate({"--set", "dram=" + folder.name("slow.json")}, "slow_out.json");
    CHECK(same["digest"] == named["digest"]);
    CHECK(slow["clocks"][0]["cycles"] > named["clocks"][0]["cycles"]);
    CHECK(slow["config"]["dram"]["cl_clocks"] == 30);
    CHECK(slow["memory"]["dram"]["name"] == "slow");
    // The report's configuration unchanged, and a configuration next to the memory file that it names.
    folder.write("config.json", slow["config"].dump());
    CHECK(simulate({"--config", folder.name("config.json")}, "again.json")["digest"] == slow["digest"]);
    folder.write("beside.json", R"({"like": "default", "dram": "slow.json", "dram_channels": 2})");
    const auto beside = simulate({"--config", folder.name("beside.json")}, "beside_out.json");
    CHECK(beside["memory"]["dram"]["channels"] == 2);
    CHECK(beside["config"]["dram"]["cl_clocks"] == 30);
    folder.write("bad.json", "{\"like\": \"sdr\",\n \"cl_clocks\": 0}");
    check_refused(run_program({"simulate", "gears:1", "--set", "dram=" + folder.name("bad.json")}),
                  {"bad.json", "line 2", "cl_clocks", "from 1 to 200, not 0"});

    // The picture's load: its reads and writes are reported, and memories that are too slow are refused.
    const auto shown =
        simulate({"--set", "dram=sdr", "--set", "scan_out=1", "--set", "pixel_writes=1"}, "shown.json");
    CHECK(shown["clocks"][0]["cycles"] > named["clocks"][0]["cycles"]);
    const auto& load = shown["memory"]["dram"];
    CHECK(load["scan_out"]["reads"] > 0);
    CHECK(load["scan_out"]["backlog"] > 0);
    CHECK(load["reads"] > load["scan_out"]["reads"]);
    CHECK(load["pixel_writes"] == load["writes"]);
    CHECK(load["writes"] > 0);
    CHECK_FALSE(named["memory"]["dram"].contains("scan_out"));
    folder.write("tiny.json", R"({"like": "sdr", "rows": 256})");
    check_refused(run_program({"simulate", "gears:1", "--set", "scan_out=1", "--set",
                               "dram=" + folder.name("tiny.json")}),
                  {"two pictures", "scan_out", "2457600", "2097152"});
    folder.write("lazy.json", R"({"like": "sdr", "tck_ns": 50, "trc_ns": 500, "trefi_ns": 100000})");
    check_refused(run_program({"simulate", "gears:1", "--set", "scan_out=1", "--set",
                               "dram=" + folder.name("lazy.json")}),
                  {"scan_out=1", "73.7 MB/s", "40.0"});

    const ProgramRun sweep = run_program({"sweep", "gears:1", "--size", "16x12", "--no-netlist", "--axis",
                                          "dram=sdr," + folder.name("slow.json"), "--axis",
                                          "dram_channels=1,2", "-o", folder.name("sweep.csv")});
    INFO(sweep.err);
    REQUIRE(sweep.code == 0);
    const std::string csv = content_of(folder.name("sweep.csv"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 5);
    CHECK(csv.find("slow.json") != csv.npos);
}

TEST_CASE("no output replaces an input, whatever the command and the option") {
    const TestFolder folder;
    const std::string mesh = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    const std::string x = folder.write("x.obj", mesh), m = folder.write("m.mtl", "newmtl a\nKd 1 0 0\n"),
                      config = folder.write("c.json", R"({"like": "small"})"),
                      memory = folder.write("d.json", R"({"like": "sdr", "cl_clocks": 3})"),
                      report = folder.name("r.json"), part = folder.name("p.json"),
                      other = folder.name("link.obj");
    fs::create_hard_link(x, other);
    REQUIRE(run_program({"simulate", x, "--size", "8x8", "--clock", "66", "--json", report}).code == 0);
    REQUIRE(run_program({"sweep", x, "--size", "8x8", "--axis", "contexts=8", "--no-netlist", "--json", part})
                .code == 0);
    const auto before = folder.contents();
    const std::string size = "--size=8x8";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"simulate", x, size, "--json", x},
             {"simulate", x, size, "--report", x},
             {"simulate", x, size, "--json", m},
             {"simulate", x, size, "--json", other},
             {"simulate", x, size, "--config", config, "--json", config},
             {"simulate", x, size, "--set", "dram=" + memory, "--report", memory},
             {"verify", x, size, "--config", config, "--json", config},
             {"explain", x, "4,4", size, "--json", x},
             {"explain", x, "4,4", size, "--report", m},
             {"trace", x, size, "--cycles", "0:9", "-o", folder.name("x.fst"), "--json", x},
             {"sweep", x, size, "--axis", "contexts=8", "--no-netlist", "-o", x},
             {"sweep", x, size, "--axis", "contexts=8", "--no-netlist", "--json", x},
             {"sweep", x, size, "--axis", "dram=" + memory, "--no-netlist", "--report", memory},
             {"merge", part, "--json", part},
             {"merge", part, "-o", part},
             {"compare", report, report, "--json", report},
             {"compare", report, report, "--report", report},
             {"fit", x, size, "--config", config, "-o", config},
             {"export", x, size, "--json", x, "-o", folder.name("out")},
             {"study", "area", "--config", config, "-o", config}}) {
        INFO(words[0] << " " << words[words.size() - 1]);
        check_refused(run_program(words), {"the output would replace"});
        CHECK(folder.contents() == before);
    }
}

TEST_CASE("a sweep over memories from files is merged") {
    const TestFolder folder;
    const std::string slow = folder.write("slow.json", R"({"like": "sdr", "cl_clocks": 30})"),
                      swept = folder.name("s.json"), merged = folder.name("m.json");
    REQUIRE(run_program({"sweep", "tetra:1", "--size", "8x8", "--no-netlist", "--axis", "dram=sdr," + slow,
                         "--axis", "node_sets/prim_sets=16/32,32/16", "--json", swept})
                .code == 0);
    const auto report = nlohmann::json::parse(content_of(swept));
    CHECK(report["points"][2]["values"]["dram"] == slow);
    CHECK(report["points"][2]["values"]["prim_sets"] == 32);
    REQUIRE(run_program({"merge", swept, "--json", merged}).code == 0);
    CHECK(nlohmann::json::parse(content_of(merged))["points"] == report["points"]);
}
