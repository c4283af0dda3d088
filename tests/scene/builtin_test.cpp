// `name:size`, and the messages for invalid specifications.
#include <set>

#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"
#include "tests/scene/mesh_measures.hpp"

using namespace rayclock;

namespace {

std::string sentence(std::string_view spec) {
    return refusal([&] { make_builtin(spec); });
}

}   // namespace

TEST_CASE("names are listed once, with purposes", "[scene][builtin]") {
    std::set<std::string_view> names;
    for (const Builtin& b : builtins()) {
        CHECK(names.insert(b.name).second);
        CHECK(b.purpose.size() > 10);
        CHECK(is_builtin(b.name));
    }
    CHECK(names == std::set<std::string_view>{
                       "balls",   "boughs", "clockwork", "cornell", "crowd", "cube",  "flake", "flight",
                       "gearbox", "gears",  "icosphere", "mirrors", "mount", "plane", "rings", "room",
                       "spheres", "square", "teapot",    "tetra",   "tree",  "wknd"});
}

TEST_CASE("a name alone has its default size", "[scene][builtin]") {
    CHECK(make_builtin("gears").triangles.size() == 36610);
    CHECK(make_builtin("gears").name == "gears:4");
    CHECK(make_builtin("gears:1").triangles.size() == 574);
    CHECK(make_builtin("gears:1").name == "gears:1");
    CHECK(make_builtin("balls").triangles.size() == 88562);
    CHECK(make_builtin("mount").triangles.size() == 8624);
    CHECK(make_builtin("rings").triangles.size() == 217802);
    CHECK(make_builtin("teapot").triangles.size() == 9408);
    CHECK(make_builtin("tetra").triangles.size() == 4096);
    CHECK(make_builtin("tree").triangles.size() == 67454);
    CHECK(make_builtin("icosphere").triangles.size() == 5120);
    CHECK(make_builtin("cornell").name == "cornell");
    CHECK(make_builtin("cornell:1").name == "cornell");
}

TEST_CASE("is_builtin looks at the name only", "[scene][builtin]") {
    for (const auto* yes : {"gears", "gears:8", "gears:", "gears:x", "gears:1:2"}) CHECK(is_builtin(yes));
    for (const auto* no : {"", ":", "gear", "gears2", "Gears", " gears", "gears.obj", "gears/4", "./gears"})
        CHECK_FALSE(is_builtin(no));
}

TEST_CASE("an unknown name gets the nearest known one", "[scene][builtin]") {
    CHECK(sentence("gaers") ==
          "no built-in scene is called 'gaers'; did you mean 'gears'? (`rayclock scenes` lists them)");
    CHECK(sentence("teapots:4") ==
          "no built-in scene is called 'teapots'; did you mean 'teapot'? (`rayclock scenes` lists them)");
    CHECK(sentence("sphere") ==
          "no built-in scene is called 'sphere'; did you mean 'spheres'? (`rayclock scenes` lists them)");
    CHECK(sentence("bunny/meadow.obj") ==
          "no built-in scene is called 'bunny/meadow.obj' (`rayclock scenes` lists them)");
    CHECK(sentence("xyzxyz") == "no built-in scene is called 'xyzxyz' (`rayclock scenes` lists them)");
    CHECK_FALSE(sentence("").empty());
    CHECK_FALSE(sentence(":4").empty());
}

TEST_CASE("a bad size gets the allowed range", "[scene][builtin]") {
    for (const std::string size :
         {"", "0", "-1", "x", "999", "26", "3.5", "+4", " 4", "4 ", "4x", "0x4", "1e1", "4:4", "2147483648",
          "99999999999999999999999", "-99999999999999999999999"})
        CHECK(sentence("gears:" + size) ==
              "the size of the built-in scene 'gears' must be a whole number in 1..25, not '" + size + "'");
    CHECK(sentence("cornell:2") ==
          "the size of the built-in scene 'cornell' must be a whole number in 1..1, not '2'");
    CHECK(sentence("mount:12") ==
          "the size of the built-in scene 'mount' must be a whole number in 1..11, not '12'");
}
