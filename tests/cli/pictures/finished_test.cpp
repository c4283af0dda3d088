// Finished pictures on the command line: invalid options are refused, unusual but valid scenes are rendered.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace rayclock::test::finished_test {

using namespace rayclock::test;
using nlohmann::json;

namespace {

json simulate(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "simulate");
    for (const char* more : {"--size", "48x36", "--clock", "66", "--json", "-"}) arguments.emplace_back(more);
    const ProgramRun outcome = run_program(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

/// Returns a scene of one sphere on a plane, with parts replaced.
std::string sphere_scene(const std::string& sphere, const std::string& material, const std::string& eye,
                         const std::string& lights) {
    return R"({"camera":{"eye":)" + eye + R"(,"at":[0,0,-9],"up":[0,1,0],"fov_degrees":50},"lights":)" +
           lights + R"(,"materials":{"m":{)" + material + R"(},"floor":{"colour":[1,1,1]}},"spheres":[)" +
           sphere + R"(],"planes":[{"point":[0,-1,0],"u":[1,0,0],"v":[0,0,-1],"material":"floor"}]})";
}
constexpr const char* ball = R"({"centre":[0,0,-4],"radius":1,"material":"m"})";
constexpr const char* lamp = R"([{"position":[3,4,0]}])";

}   // namespace

TEST_CASE("illegal options of finished pictures are refused") {
    const auto refused = [](std::vector<std::string> arguments, const std::vector<std::string>& words) {
        arguments.insert(arguments.begin(), {"simulate", "tetra:1"});
        check_refused(run_program(arguments), words);
    };
    refused({"--depth", "99"}, {"--depth", "0..15", "99"});
    refused({"--depth=-1"}, {"--depth", "-1"});
    refused({"--depth", "two"}, {"--depth", "two"});
    refused({"--aa", "0"}, {"--aa", "1..8", "0"});
    refused({"--aa", "9"}, {"--aa", "9"});
    refused({"--threshold", "1.5"}, {"--threshold", "0..1", "1.5"});
    refused({"--threshold", "nan"}, {"--threshold", "nan"});
    refused({"--contrast=-0.1"}, {"--contrast", "-0.1"});
    refused({"--set", "spheres=1"}, {"spheres=1", "shading=1"});
    refused({"--set", "shading=1", "--set", "primitive_test=sheared"}, {"shading=1", "primitive_test=exact"});
    refused({"--set", "shading=1", "--set", "coord_bits=20", "--set", "dir_bits=22"}, {"origin_bits", "31"});
    refused({"--depth", "2", "--set", "lights=0"}, {"lights", "1..64"});
}

TEST_CASE("a machine without the units that a scene needs refuses it by name") {
    const TestFolder folder;
    const std::string glass = folder.write(
        "glass.json", sphere_scene(ball, R"("colour":[1,1,1],"transmit":0.9,"index":1.5)", "[0,0,3]", lamp));
    check_refused(run_program({"simulate", glass, "--set", "shading=1"}), {"spheres"});
    check_refused(run_program({"simulate", glass, "--set", "shading=1", "--set", "spheres=1"}), {"planes"});
    check_refused(
        run_program({"simulate", glass, "--set", "shading=1", "--set", "spheres=1", "--set", "planes=1"}),
        {"transmits", "refraction"});
    check_refused(run_program({"simulate", glass, "--depth", "9", "--set", "bounces=3"}),
                  {"depth 9", "bounces"});
    check_refused(run_program({"simulate", glass, "--aa", "2", "--set", "supersampling=0"}),
                  {"4 samples", "supersampling"});
    check_refused(run_program({"simulate", "balls:1", "--depth", "1", "--set", "lights=2"}),
                  {"3 lights", "lights"});
}

TEST_CASE("odd but sound scenes are drawn, and the reference agrees") {
    struct Odd {
        const char* what;
        std::string scene;
        double least;   ///< least PSNR
    };
    const std::string mirror = R"("colour":[1,0.9,0.8],"mirror":0.5)",
                      glass = R"("colour":[1,1,1],"diffuse":0.1,"transmit":0.8,"index":)";
    const Odd odd = GENERATE_COPY(
        Odd{"no light", sphere_scene(ball, mirror, "[0,0,3]", "[]"), 40},
        Odd{"light inside the sphere", sphere_scene(ball, mirror, "[0,0,3]", R"([{"position":[0,0,-4]}])"),
            40},
        Odd{"camera inside the sphere", sphere_scene(ball, glass + "1.3", "[0,0,-4]", lamp), 30},
        Odd{"index 1", sphere_scene(ball, glass + "1", "[0,0,3]", lamp), 35},
        Odd{"index 15", sphere_scene(ball, glass + "15", "[0,0,3]", lamp), 35},
        Odd{"a huge sphere",
            sphere_scene(R"({"centre":[0,0,-1000],"radius":900,"material":"m"})", mirror, "[0,0,3]", lamp),
            30},
        Odd{"a light very far away", sphere_scene(ball, mirror, "[0,0,3]", R"([{"position":[3e6,4e6,0]}])"),
            35},
        Odd{"a black mirror",
            sphere_scene(ball, R"("colour":[0,0,0],"ambient":0,"diffuse":0,"mirror":1)", "[0,0,3]", lamp),
            35});
    INFO(odd.what);
    const TestFolder folder;
    const json report = simulate({folder.write("odd.json", odd.scene), "--depth", "4"});
    CHECK(report["rays"]["primary"] == 48 * 36);
    const json& psnr = report["error"]["psnr_db"];
    UNSCOPED_INFO(psnr.dump());
    CHECK((psnr.is_null() || psnr.get<double>() >= odd.least));
    CHECK(report["error"]["causes"]["bug"] == 0);
}

TEST_CASE("depth, threshold and samples limit the rays of a picture") {
    const auto rays = [](const json& report) {
        return report["rays"]["reflection"].get<std::uint64_t>() +
               report["rays"]["refraction"].get<std::uint64_t>();
    };
    const json none = simulate({"spheres", "--depth", "0"}), some = simulate({"spheres", "--depth", "5"});
    CHECK(rays(none) == 0);
    CHECK(none["rays"]["shadow"] > 0);
    CHECK(rays(some) > 48 * 36 / 4);
    const json cut = simulate({"spheres", "--depth", "5", "--threshold", "0.2"});
    CHECK(rays(cut) < rays(some));
    CHECK(cut["clocks"][0]["cycles"] < some["clocks"][0]["cycles"]);
    CHECK(simulate({"spheres", "--depth", "1", "--aa", "3"})["rays"]["primary"] == 9 * 48 * 36);
    const json adaptive = simulate({"plane", "--depth", "0", "--aa", "3", "--contrast", "0.1"});
    CHECK(adaptive["rays"]["primary"] > 4 * 48 * 36);
    CHECK(adaptive["rays"]["primary"] < 9 * 48 * 36);
    CHECK(simulate({"plane", "--aa", "2", "--jittered", "--seed", "2"})["digest"] !=
          simulate({"plane", "--aa", "2", "--jittered", "--seed", "3"})["digest"]);
}

TEST_CASE("units that a scene does not need are absent") {
    const json triangles = simulate({"gears:1", "--depth", "2"})["config"],
               spheres = simulate({"spheres", "--depth", "2"})["config"];
    CHECK(triangles["shading"] == 1);
    CHECK(triangles["spheres"] == 0);
    CHECK(triangles["refraction"] == 1);
    CHECK(spheres["spheres"] == 1);
    CHECK(spheres["planes"] == 1);
    CHECK(spheres["supersampling"] == 0);
    CHECK(simulate({"tetra:1"})["config"]["shading"] == 0);
    CHECK(!simulate({"tetra:1"})["units"].contains("shade"));
    CHECK(simulate({"tetra:1", "--depth", "1"})["units"].contains("shade"));
}

}   // namespace rayclock::test::finished_test
