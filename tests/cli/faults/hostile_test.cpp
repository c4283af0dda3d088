// Hostile inputs, as a user would pass them: one sentence and exit code 2, soon, for any input.
#include <catch2/catch.hpp>

#include <filesystem>

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string nested(int depth) {
    return std::string(std::size_t(depth), '[') + std::string(std::size_t(depth), ']');
}

/// Requires output that is safe for a terminal.
void check_printable(const ProgramRun& outcome) {
    CHECK(outcome.err.size() < 1200);
    for (const char c : outcome.err + outcome.out)
        CHECK(((static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) || c == '\n'));
}

/// The options of a stress run that makes a state.
const std::vector<std::string> plan{"stress", "--bits", "16", "--family", "edges,quad", "--rays", "2000"};
std::vector<std::string> with_state(const std::string& file) {
    std::vector<std::string> all = plan;
    all.insert(all.end(), {"--state", file});
    return all;
}

}   // namespace

TEST_CASE("a configuration that is not a file, is nested too deeply, or has a key twice is refused") {
    const TestFolder folder;
    fs::create_directory(folder.name("folder.json"));
    REQUIRE(::mkfifo(folder.name("pipe.json").c_str(), 0600) == 0);
    const std::vector<std::pair<std::string, std::string>> cases{
        {folder.name("folder.json"), "folder"},
        {folder.name("pipe.json"), "not an ordinary file"},
        {"/dev/zero", "not an ordinary file"},
        {folder.write("deep.json", nested(60'000)), "nested deeper"},
        {folder.write("like.json", "{\"like\":" + nested(60'000) + "}"), "nested deeper"},
        {folder.write("big.json", R"({"like":"small","contexts":1e999})"), "'1e999'"},
        {folder.write("huge.json", R"({"like":"small","contexts":99999999999999999999})"), "contexts"},
        {folder.write("twice.json", R"({"like":"small","contexts":4,"contexts":8})"),
         "'contexts' appears twice"},
        {folder.write("list.json", R"({"like":"small","contexts":[[1]]})"), "whole number"},
        {folder.write("odd.json", "{\"like\":\"\\u001b[2J\\u0000\"}"), "\\x1b[2J\\x00"},
        {folder.write("name.json", "{\"like\":\"small\",\"" + std::string(500'000, 'x') + "\":1}"), "'xxx"},
        {folder.write("long.json", std::string(2'000'000, ' ')), "the most is 1048576"}};
    for (const auto& [file, word] : cases)
        for (const std::vector<std::string>& arguments :
             {std::vector<std::string>{"config", file}, {"simulate", "tetra:1", "--config", file}}) {
            INFO(file);
            const ProgramRun outcome = run_program(arguments);
            check_refused(outcome, {word});
            check_printable(outcome);
        }
    // Tables and terminals show the name.
    const ProgramRun named =
        run_program({"config", folder.write("good.json", "{\"like\":\"small\",\"name\":\"\\u001b[2J" +
                                                             std::string(1000, 'y') + "\"}")});
    CHECK(named.code == 0);
    check_printable(named);
    CHECK(json::parse(named.out)["name"].get<std::string>().size() < 100);
}

TEST_CASE("a state of a stress run with wrong numbers is refused") {
    const TestFolder folder;
    const std::string file = folder.name("state.json");
    REQUIRE(run_program(with_state(file)).code == 0);
    const json good = json::parse(content_of(file));
    REQUIRE(run_program(with_state(file)).code == 0);   // nothing is left to do
    int number = 0;
    const auto refused = [&](const json& changed, const std::string& word) {
        const std::string bad = folder.write("bad" + std::to_string(number++) + ".json", changed.dump());
        const std::string before = content_of(bad);
        INFO(before.substr(0, 300));
        check_refused(run_program(with_state(bad)), {bad, word});
        CHECK(content_of(bad) == before);
    };
    for (const json& wrong : {json(-1), json(1e8), json(100'000'000), json(1e300), json(0.5),
                              json(std::uint64_t(1) << 60), json("2"), json(nullptr), json(json::array())}) {
        json changed = good;
        changed["batches"] = wrong;
        refused(changed, "batches");
        changed = good;
        changed["counts"][0][0] = wrong;   // number of rays
        refused(changed, "counts[0]");
        changed = good;
        changed["counts"][1][1] = wrong;   // number of leaks
        refused(changed, "counts[1]");
    }
    for (const char* key : {"plan", "batches", "counts", "check"}) {
        json changed = good;
        changed.erase(key);
        refused(changed, key);
    }
    json changed = good;
    changed["counts"][0][1] = 1;   // a leak that did not happen
    refused(changed, "check");
    changed = good;
    changed["batches"] = 0;   // the counts belong to more batches
    refused(changed, "counts[0]");
    changed = good;
    changed["counts"].push_back(good["counts"][0]);
    refused(changed, "3 rows");
    changed = good;
    changed["counts"][0].push_back(1);
    refused(changed, "counts[0]");
    changed = good;
    changed["more"] = 1;
    refused(changed, "'more'");
    changed = good;
    changed["plan"]["seed"] = 2;
    refused(changed, "another stress run");
    refused(json::parse(nested(100)), "object");
    std::string twice = good.dump();
    twice.insert(1, "\"batches\":0,");
    for (const auto& [text, word] : {std::pair<std::string, std::string>{twice, "'batches' appears twice"},
                                     {nested(60'000), "nested deeper"},
                                     {"{\"plan\":1e999}", "'1e999'"},
                                     {"", "empty"}})
        check_refused(run_program(with_state(folder.write("text.json", text))), {word});
    REQUIRE(::mkfifo(folder.name("pipe.json").c_str(), 0600) == 0);
    fs::create_directory(folder.name("folder.json"));
    check_refused(run_program(with_state(folder.name("pipe.json"))), {"pipe"});
    check_refused(run_program(with_state(folder.name("folder.json"))), {"directory"});
    check_refused(run_program(with_state("/dev/null")), {"/dev/null"});
}

TEST_CASE("an entry of the sweep's cache that is not a file, or is nested, is computed again") {
    const TestFolder folder;
    const std::vector<std::string> cache{"RAYCLOCK_CACHE=" + folder.name("cache")};
    const std::vector<std::string> sweep{"sweep",        "tetra:2",      "--size", "16x12", "--axis",
                                         "contexts=2,4", "--no-netlist", "--json", "-"};
    const ProgramRun first = run_program(sweep, cache);
    REQUIRE(first.code == 0);
    std::vector<fs::path> entries;
    for (const auto& entry : fs::recursive_directory_iterator(folder.name("cache")))
        if (entry.path().extension() == ".json") entries.push_back(entry.path());
    REQUIRE(entries.size() >= 3);
    const auto points = [](const ProgramRun& outcome) { return json::parse(outcome.out)["points"].dump(); };
    for (int kind = 0; kind < 3; ++kind) {
        for (const fs::path& entry : entries) {
            fs::remove_all(entry);
            if (kind == 0) folder.write(fs::relative(entry, folder.name("")).string(), nested(60'000));
            if (kind == 1) REQUIRE(::mkfifo(entry.c_str(), 0600) == 0);
            if (kind == 2) fs::create_directory(entry);
        }
        const ProgramRun again = run_program(sweep, cache);
        INFO(kind << again.err);
        CHECK(again.code == 0);
        CHECK(points(again) == points(first));
    }
}

TEST_CASE("warnings go to standard error, and the frame is drawn") {
    const TestFolder folder;
    const std::string file = folder.write(
        "\x1b[2Jodd.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nf 1 1 2\n");
    const ProgramRun outcome = run_program({"simulate", file, "--size", "8x8", "--no-reference"});
    CHECK(outcome.code == 0);
    check_printable(outcome);
    CHECK(outcome.err.find("rayclock: warning: ") == 0);
    CHECK(outcome.err.find("none.mtl does not exist") != std::string::npos);
    CHECK(outcome.err.find("1 triangle with two corners in one place left out") != std::string::npos);
}

namespace {

json report_of_simulate() {
    return {{"scene", json::object()},
            {"config", json::object()},
            {"frame", json::object()},
            {"units", json::object()},
            {"memory", json::object()},
            {"digest", "x"},
            {"clocks", {{{"mhz", 1}, {"cycles", 1}}}}};
}
std::string page_of(const json& data) {
    return "<!DOCTYPE html><script type=\"application/json\" id=\"report\">" + report_of_simulate().dump() +
           "</script><script type=\"application/json\" id=\"data\">" + data.dump() + "</script>";
}
/// Four zero bytes, packed.
const json map{{"key", "cycles"}, {"name", "cycles"}, {"bytes", 1}, {"data", "eJxjYGBgAAAABAAB"}};

json changed(json value, const char* place, const json& to) {
    value[json::json_pointer(place)] = to;
    return value;
}

/// Requires a refusal with these words, soon, and without much memory.
void check_cheap(const std::vector<std::string>& words, const std::vector<std::string>& wanted) {
    const ProgramRun outcome = run_program(words);
    INFO(words[0] << " " << words[1] << ": " << outcome.seconds << " s, " << outcome.peak_mb << " MB");
    check_refused(outcome, wanted);
    check_printable(outcome);
    CHECK(outcome.seconds < 10);
    CHECK(outcome.peak_mb < 2048);
}

}   // namespace

TEST_CASE("compare refuses a damaged report and names the fault") {
    const TestFolder folder;
    const std::string good = folder.write("good.json", report_of_simulate().dump());
    json deep = report_of_simulate();
    deep[std::string(400'000, 'k')] = std::vector<int>(200'000);
    check_cheap({"compare", folder.write("path.json", deep.dump()), good},
                {"path.json", "'kkk", "400000 bytes"});
    const json page{{"width", 2}, {"height", 2}, {"maps", {map}}};
    json nameless = map;
    nameless.erase("name");
    struct Bad {
        json data;
        std::vector<std::string> words;
    };
    for (const Bad& bad :
         {Bad{changed(page, "/maps/0", nameless), {"data.maps[0]", "lacks the key 'name'"}},
          Bad{changed(page, "/maps/1", nullptr), {"data.maps[1]", "an object"}},
          Bad{changed(page, "/maps/1", map), {"data.maps[1].key", "stands in two maps"}},
          Bad{changed(page, "/maps/0/bytes", 5), {"data.maps[0].bytes"}},
          Bad{changed(page, "/width", 16'385), {"data.width"}},
          Bad{changed(page, "/width", "2"), {"data.width"}},
          Bad{changed(changed(page, "/width", 16'384), "/height", 16'384), {"are not packed"}}}) {
        const std::string file = folder.write("bad.html", page_of(bad.data));
        std::vector<std::string> words = bad.words;
        words.push_back("bad.html");
        check_cheap({"compare", file, file, "--report", folder.name("o.html")}, words);
        CHECK_FALSE(fs::exists(folder.name("o.html")));
    }
    const std::string sound = folder.write("sound.html", page_of(page));
    CHECK(run_program({"compare", sound, sound}).code == 0);
}

TEST_CASE("merge refuses a damaged report and names the fault") {
    const TestFolder folder;
    const json part = {{"scene", {{"name", "x"}}},
                       {"config", json::object()},
                       {"frame", {{"width", 8}, {"height", 8}}},
                       {"sweep",
                        {{"axes", json::array()},
                         {"clock", "66"},
                         {"cost", "multipliers"},
                         {"cache_bytes", nullptr},
                         {"netlists", false}}},
                       {"shard",
                        {{"part", 1},
                         {"of", 2'147'483'647},
                         {"scene_digest", "x"},
                         {"program", "x"},
                         {"points", json::array()}}},
                       {"partial", false},
                       {"points", json::array()}};
    check_cheap({"merge", folder.write("part.json", part.dump())},
                {"2147483646 of 2147483647 parts are missing: 2/2147483647, 3/2147483647", "and more"});
    const json whole = changed(part, "/shard/of", 1);
    struct Bad {
        const char* place;
        json value;
        std::vector<std::string> words;
    };
    for (const Bad& bad :
         {Bad{"/shard/scene_digest", 5, {"shard.scene_digest must be a string, not 5"}},
          Bad{"/shard/part", 1.5, {"shard.part"}}, Bad{"/shard/points", nullptr, {"shard.points"}},
          Bad{"/scene/name", json::array(), {"scene.name"}}, Bad{"/frame/width", 1e9, {"frame.width"}},
          Bad{"/sweep/axes", {{{"key", "contexts"}, {"values", {8}}}}, {"sweep.axes[0].values[0]"}},
          Bad{"/sweep/netlists", "no", {"sweep.netlists"}}, Bad{"/partial", 0, {"was interrupted"}},
          Bad{"/points", 0, {"points"}}}) {
        const std::string file = folder.write("bad.json", changed(whole, bad.place, bad.value).dump());
        std::vector<std::string> words = bad.words;
        words.push_back("bad.json");
        check_cheap({"merge", file}, words);
    }
}

TEST_CASE("small files that declare many keys or triangles are refused before these are made") {
    const TestFolder folder;
    json turns = json::array();
    for (int i = 0; i < 15'000; ++i)
        turns.push_back({{"time", i}, {"rotate", {{"axis", {0, 1, 0}}, {"degrees", i % 2 * 360'000}}}});
    const json leaf{{"vertices", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {"triangles", {{0, 1, 2}}}},
        scene{{"meshes", {{"leaf", leaf}}},
              {"objects", {{{"mesh", "leaf"}, {"instances", {{{"keyframes", turns}}}}}}}};
    check_cheap({"simulate", folder.write("turns.json", scene.dump())},
                {"objects[0].instances[0].keyframes makes more than 1024 MB"});
    const auto primitives = [](int in_mesh, int nodes) {
        json all{
            {"asset", {{"version", "2.0"}}},
            {"meshes", {{{"primitives", json::array()}}}},
            {"accessors", {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}}},
            {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
            {"buffers",
             {{{"byteLength", 36},
               {"uri", "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}}}};
        for (int i = 0; i < in_mesh; ++i)
            all["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
        for (int i = 0; i < nodes; ++i) {
            all["nodes"].push_back({{"mesh", 0}});
            all["scenes"][0]["nodes"].push_back(i);
        }
        return all.dump();
    };
    check_cheap({"simulate", folder.write("many.gltf", primitives(14'000, 20'000))},
                {"many.gltf", "placed triangles; the most is 100000000"});
    check_cheap({"simulate", folder.write("some.gltf", primitives(3'000, 3'000))},
                {"some.gltf", "makes more than 1024 MB"});
    CHECK(run_program({"simulate", folder.write("few.gltf", primitives(30, 30)), "--size", "8x8"}).code == 0);
}

TEST_CASE("any input under 1 MB ends with exit code 0, 1 or 2, within 2 GB and 10 s") {
    const TestFolder folder;
    const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    std::string runs = v3, face = v3 + "f", faces = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.1 0\n", dust;
    for (int i = 0; runs.size() < 1'000'000; ++i) (runs += "usemtl ") += std::to_string(i) + "\nf 1 2 3\n";
    for (int i = 0; i < 9'999; ++i) face += i % 3 == 0 ? " 1" : i % 3 == 1 ? " 2" : " 3";
    for (int k = 0; faces.size() < 970'000; ++k) {
        faces += "f";
        for (int i = 0; i < 9'999; ++i) faces += " " + std::to_string(1 + (i * (k + 1)) % 5);
        faces += "\n";
    }
    for (int i = 0; dust.size() < 970'000; ++i)
        dust += "v " + std::to_string(i % 97) + " " + std::to_string(i % 89) + " " + std::to_string(i % 83) +
                "\n";
    dust += "f 1 2 3\n";
    json nodes = {{"asset", {{"version", "2.0"}}}, {"nodes", json::array()}},
         materials = {{"meshes", {{"b", {{"builtin", "icosphere:1"}}}}}, {"objects", {{{"mesh", "b"}}}}};
    for (int i = 0; i < 300'000; ++i) nodes["nodes"].push_back(json::object());
    for (int i = 0; i < 40'000; ++i) materials["materials"]["m" + std::to_string(i)] = {{"shine", 1}};
    json copies = {{"meshes", {{"b", {{"builtin", "balls:5"}}}, {"t", {{"builtin", "mount:9"}}}}},
                   {"objects", json::array()}};
    for (int i = 0; i < 20'000; ++i)
        copies["objects"].push_back({{"mesh", i % 2 ? "b" : "t"}, {"translate", {i, 0, 0}}});
    const std::vector<std::pair<std::string, std::string>> files{
        {"runs.obj", runs},
        {"face.obj", face},
        {"faces.obj", faces},
        {"dust.obj", dust},
        {"nodes.gltf", nodes.dump()},
        {"materials.json", materials.dump()},
        {"copies.json", copies.dump()},
        {"deep.json", nested(400'000)},
        {"keys.json", "{\"" + std::string(900'000, 'k') + "\":1}"},
        {"zero.stl", std::string(900'000, '\0')},
        {"ones.ply", "ply\nformat ascii 1.0\nelement vertex " + std::string(900'000, '9')},
        {"list.ply",
         "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float "
         "y\nproperty float z\nelement face 9\n"
         "property list uint uchar vertex_indices\nend_header\n" +
             std::string(900'000, '\x7f')},
        {"open.json", std::string(900'000, '{')},
        {"text.glb", "glTF" + std::string(900'000, '\xff')}};
    for (const auto& [name, bytes] : files) {
        REQUIRE(bytes.size() <= 1'000'000 + 20);
        const ProgramRun outcome = run_program({"render", folder.write(name, bytes), "--engine", "reference",
                                                "--size", "8x8", "-o", folder.name("x.png")});
        INFO(name << ": " << outcome.seconds << " s, " << outcome.peak_mb
                  << " MB: " << outcome.err.substr(0, 300));
        CHECK((outcome.code == 0 || outcome.code == 2));
        CHECK(outcome.seconds < 10);
        CHECK(outcome.peak_mb < 2048);
        check_printable(outcome);
        if (outcome.code == 2) CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    }
}
