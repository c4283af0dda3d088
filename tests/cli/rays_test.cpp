// Streams of rays on the command line.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace rayclock::test::rays_test {

using namespace rayclock::test;
using nlohmann::json;

namespace {

json report(std::vector<std::string> command) {
    command.insert(command.end(), {"--json", "-"});
    const Outcome outcome = run_program(command);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

}   // namespace

TEST_CASE("rays are made, traced in lockstep and judged", "[rays]") {
    const Folder folder;
    const std::string rays = folder.name("rays.npy"), hits = folder.name("hits.npy");
    for (const std::string kind : {"camera", "shadow", "mirror", "ao", "diffuse"}) {
        INFO(kind);
        const json made = report({"rays", "gears:1", "--kind", kind, "--size", "24x18", "-o", rays});
        const json traced = report({"verify", "gears:1", "--rays", rays, "--hits", hits});
        CHECK(traced["stream"]["rays"] == made["rays"]);
        CHECK(traced["rays"]["primary"].get<int>() + traced["rays"]["shadow"].get<int>() == made["rays"]);
        CHECK((traced["rays"]["shadow"] == 0) == (kind != "shadow" && kind != "ao"));
        CHECK(traced["cycle_gap"] == 0);
        CHECK(traced["value_mismatches"] == 0);
        CHECK(traced["judge"]["wrong"] == 0);
        CHECK(traced["judge"]["rays"] == made["rays"]);
        const std::string bytes = bytes_of(hits);
        CHECK(bytes.find("('primitive', '<u4')") != std::string::npos);
        CHECK(bytes.size() == 192 + 38 * made["rays"].get<std::size_t>());
        CHECK(report({"simulate", "gears:1", "--rays", rays, "--clock", "66"})["clocks"][0]["cycles"] ==
              traced["clocks"][0]["cycles"]);
    }
    const json elastic = report({"verify", "gears:1", "--rays", rays, "--elastic", "tri"});
    CHECK(elastic["value_mismatches"] == 0);
    CHECK(elastic["events_compared"] > 1000);
    CHECK(elastic["cycle_gap"] == 0);
    CHECK(elastic["elastic"]["rtl_cycles"] == elastic["clocks"][0]["cycles"]);
    CHECK(elastic["judge"]["wrong"] == 0);
}

TEST_CASE("options that a stream cannot use are refused", "[rays]") {
    const Folder folder;
    const std::string rays = folder.name("rays.npy");
    REQUIRE(run_program({"rays", "gears:1", "--size", "4x3", "-o", rays}).code == 0);
    const auto refused = [&](std::vector<std::string> more) {
        const Outcome outcome = run_program(more);
        CHECK(outcome.code == 2);
        return outcome.err;
    };
    for (const std::vector<std::string>& odd :
         std::vector<std::vector<std::string>>{{"--size", "8x8"},
                                               {"--depth", "2"},
                                               {"--ground"},
                                               {"--material", "gold"},
                                               {"--time", "1"},
                                               {"--min-psnr", "60"},
                                               {"--frames", "2"},
                                               {"--no-reference"},
                                               {"-o", folder.name("out")}}) {
        std::vector<std::string> command{"simulate", "gears:1", "--rays", rays};
        command.insert(command.end(), odd.begin(), odd.end());
        CHECK(refused(command).find("takes the place of a camera") != std::string::npos);
    }
    CHECK(refused({"simulate", "gears:1", "--any-hit"}).find("--any-hit needs --rays") != std::string::npos);
    CHECK(refused({"simulate", "balls:1", "--rays", folder.name("none.npy")}).find("no such file") !=
          std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", rays, "--outside", "keep"}).find("not clip or refuse") !=
          std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", rays, "--set", "smooth=1"})
              .find("smooth=1 needs source=camera") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", rays, "--set", "source=camera"})
              .find("needs source=stream") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--set", "shading=1", "--set", "source=stream"})
              .find("has no camera") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--rays", ""}).find("--rays names no file") != std::string::npos);
    CHECK(refused({"simulate", "gears:1", "--outside", "refuse"}).find("--outside needs --rays") !=
          std::string::npos);
    CHECK(refused(
              {"simulate", "gears:1", "--rays", rays, "--hits", folder.name("a"), "--json", folder.name("a")})
              .find("the same file") != std::string::npos);
    CHECK(refused({"sweep", "gears:1", "--axis", "source=camera,stream"}).find("has no camera") !=
          std::string::npos);
    const Outcome idle = run_program({"simulate", "gears:1", "--rays", rays, "--set", "surf_sets=8"});
    CHECK(idle.code == 0);
    CHECK(idle.err.find("surf_sets has no effect with source=stream") != std::string::npos);
    CHECK(run_program({"simulate", "gears:1", "--rays", rays, "--set", "coord_bits=20"}).code == 0);
    CHECK(refused({"simulate", "spheres", "--rays", rays}).find("meets triangles only") != std::string::npos);
    CHECK(refused({"rays", "gears:1", "--kind", "light", "-o", rays}).find("is not one of camera") !=
          std::string::npos);
}

}   // namespace rayclock::test::rays_test
