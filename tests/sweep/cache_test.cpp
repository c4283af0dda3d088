// The cache finds earlier results, and nothing else.
#include <fstream>

#include "sim/explore/sweep/key.hpp"
#include "tests/sweep/small_sweeps.hpp"

using namespace rayclock;
using namespace rayclock::test;
using nlohmann::ordered_json;

namespace {

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

void check_same(const sweep::Evaluation& a, const sweep::Evaluation& b) {
    REQUIRE(a.results.size() == b.results.size());
    for (std::size_t i = 0; i < a.results.size(); ++i) {
        INFO("point " << i);
        const sweep::Result &x = a.results[i], &y = b.results[i];
        CHECK(x.point.refused == y.point.refused);
        CHECK(x.clock.dump() == y.clock.dump());
        REQUIRE(x.picture.has_value() == y.picture.has_value());
        if (!x.picture) continue;
        CHECK(x.picture->error.pixels_other_primitive == y.picture->error.pixels_other_primitive);
        CHECK(x.picture->error.psnr_db == y.picture->error.psnr_db);
        CHECK(x.picture->error.max_abs_depth == y.picture->error.max_abs_depth);
        CHECK(x.picture->cracks == y.picture->cracks);
        CHECK(x.picture->memory_bytes == y.picture->memory_bytes);
    }
}

}   // namespace

TEST_CASE("the cache gives back what it got, under its key only") {
    const TestFolder folder;
    results::Cache cache(folder.path(), false);
    const ordered_json value{{"a", 1.0 / 3}, {"b", nullptr}, {"c", {1, 2, 3}}};
    CHECK(!cache.find("frame", "key"));
    cache.keep("frame", "key", value);
    REQUIRE(cache.find("frame", "key"));
    CHECK(cache.find("frame", "key")->dump() == value.dump());
    CHECK(!cache.find("frame", "other key"));
    CHECK(!cache.find("picture", "key"));
    CHECK(!results::Cache(folder.path(), true).find("frame", "key"));   // --fresh
    CHECK(files_in(folder.path()).size() == 1);
    CHECK(cache.trouble().empty());
}

TEST_CASE("an entry whose value is of another kind counts as missing, although its checksum is right") {
    const TestFolder folder;
    const Scene scene = scene_with_camera("tetra:1");
    const sweep::Evaluation first = run_sweep(scene, {"coord_bits=16"}, folder.path());
    for (const auto& file : files_in(folder.path())) {
        std::ifstream stream(file);
        const ordered_json entry = ordered_json::parse(stream);
        const std::string kind = file.filename().string().substr(0, file.filename().string().find('-'));
        for (const ordered_json& wrong : {ordered_json("text"), ordered_json(7), ordered_json::array({1}),
                                          ordered_json{{"refused", 7}}, ordered_json{{"cycles", "many"}}}) {
            INFO(kind << ": " << wrong.dump());
            results::Cache(folder.path(), false).keep(kind, entry["key"], wrong);
            check_same(first, run_sweep(scene, {"coord_bits=16"}, folder.path()));
        }
    }
}

TEST_CASE("an entry that is not whole, or was changed, counts as missing") {
    const TestFolder folder;
    results::Cache cache(folder.path(), false);
    cache.keep("frame", "key", {{"cycles", 12345}});
    const std::filesystem::path file = files_in(folder.path()).at(0);
    std::ifstream stream(file);
    const std::string good{std::istreambuf_iterator<char>(stream), {}};
    std::string changed = good;
    changed.replace(changed.find("12345"), 5, "12346");
    for (const std::string& bad :
         {std::string(), good.substr(0, good.size() / 2), std::string("null"), std::string("[1]"),
          std::string("{}"), std::string(R"({"key": 7})"), changed, std::string("\0\xff\0", 3)}) {
        INFO(bad);
        std::ofstream(file, std::ios::binary) << bad;
        CHECK(!cache.find("frame", "key"));
    }
    std::ofstream(file, std::ios::binary) << good;
    CHECK(cache.find("frame", "key"));
}

TEST_CASE("a folder that cannot be made does not stop the sweep") {
    const TestFolder folder;
    std::ofstream(folder.path() / "file") << "not a folder";
    results::Cache cache(folder.path() / "file" / "sweep", false);
    CHECK(!cache.trouble().empty());
    cache.keep("frame", "key", 1);
    CHECK(!cache.find("frame", "key"));
}

TEST_CASE("every part of a scene that a picture shows changes its digest") {
    const Scene scene = scene_with_camera("teapot:3");
    const auto changed = [&](auto change) {
        Scene other = scene;
        change(other);
        return sweep::scene_digest(other) != sweep::scene_digest(scene);
    };
    CHECK(!changed([](Scene&) {}));
    CHECK(changed([](Scene& s) { s.vertices[7].y += 1e-9; }));
    CHECK(changed([](Scene& s) { std::swap(s.triangles[0].vertex[0], s.triangles[0].vertex[1]); }));
    CHECK(changed([](Scene& s) { std::swap(s.triangles[0], s.triangles[1]); }));
    CHECK(changed([](Scene& s) { s.materials[0].diffuse *= 0.5; }));
    CHECK(changed([](Scene& s) { s.lights.pop_back(); }));
    CHECK(changed([](Scene& s) { s.camera->fov_degrees += 1; }));
    CHECK(changed([](Scene& s) { s.background.x += 0.1; }));
}

TEST_CASE("spheres, planes, checkers and instances change a scene's digest as well, and motion a film's") {
    const auto changes = [](const Scene& scene, auto change) {
        Scene other = scene;
        change(other);
        return sweep::scene_digest(other) != sweep::scene_digest(scene);
    };
    const Scene round = load_scene("spheres", {}, Primitives::native);
    CHECK(changes(round, [](Scene& s) { s.spheres[0].radius *= 1.001; }));
    CHECK(changes(round, [](Scene& s) { s.spheres[0].centre.x += 0.01; }));
    CHECK(changes(round, [](Scene& s) { s.planes[0].point.y += 0.01; }));
    CHECK(changes(round, [](Scene& s) { s.planes[0].u.x += 0.01; }));
    for (std::size_t m = 0; m < round.materials.size(); ++m) {
        CHECK(changes(round, [&](Scene& s) { s.materials[m].checkered = !s.materials[m].checkered; }));
        CHECK(changes(round, [&](Scene& s) { s.materials[m].other.x += 0.01; }));
        CHECK(changes(round, [&](Scene& s) { s.materials[m].schlick = !s.materials[m].schlick; }));
    }
    const Scene crowd = load_scene("crowd");
    REQUIRE(crowd.placed);
    const auto placed = [&](auto change) {
        return changes(crowd, [&](Scene& s) {
            PlacedScene other = *s.placed;
            change(other);
            s.placed = std::make_shared<const PlacedScene>(other);
        });
    };
    CHECK(placed([](PlacedScene& p) { p.instances[0].place[3].x += 0.01; }));
    CHECK(placed([](PlacedScene& p) { p.meshes[0].vertices[0].x += 0.01; }));
    CHECK(!placed([](PlacedScene&) {}));
    const std::string film = sweep::film_digest(*crowd.placed, {0, 0.1});
    CHECK(film == sweep::film_digest(*crowd.placed, {0, 0.1}));
    CHECK(film != sweep::film_digest(*crowd.placed, {0, 0.2}));
}

TEST_CASE("a sweep that is known is not worked out again, and says the same") {
    const TestFolder folder;
    const Scene scene = scene_with_camera("teapot:4");
    const std::vector<std::string> axes{"coord_bits=12,16", "clock=66,200"};
    const sweep::Evaluation first = run_sweep(scene, axes, folder.path()),
                            second = run_sweep(scene, axes, folder.path());
    CHECK(first.known == 0);
    CHECK(first.traces == 2);
    CHECK(second.known == 4);
    check_same(first, second);
    const sweep::Evaluation fresh = run_sweep(scene, axes, folder.path(), true);
    CHECK(fresh.known == 0);
    check_same(first, fresh);
    CHECK(first.results[0].picture->error.pixels_other_primitive >
          first.results[2].picture->error.pixels_other_primitive);
}

TEST_CASE("another parameter, clock, size or scene is another point") {
    const TestFolder folder;
    const Scene scene = scene_with_camera("tetra:3");
    const std::vector<std::string> axes{"coord_bits=14"};
    run_sweep(scene, axes, folder.path());
    CHECK(run_sweep(scene, axes, folder.path()).known == 1);
    CHECK(run_sweep(scene, {"coord_bits=15"}, folder.path()).known == 0);
    CHECK(run_sweep(scene, {"coord_bits=14", "node_sets=32"}, folder.path()).known == 0);
    CHECK(run_sweep(scene, {"coord_bits=14", "clock=67"}, folder.path()).known == 0);
    CHECK(run_sweep(scene, axes, folder.path(), false, {48, 37}).known == 0);
    Scene moved = scene;
    moved.vertices[0].x += 0.01;
    CHECK(run_sweep(moved, axes, folder.path()).known == 0);
    CHECK(run_sweep(scene, axes, folder.path()).known == 1);
}

TEST_CASE("an entry that is broken is worked out again") {
    const TestFolder folder;
    const Scene scene = scene_with_camera("tetra:3");
    const std::vector<std::string> axes{"coord_bits=14,16"};
    const sweep::Evaluation first = run_sweep(scene, axes, folder.path());
    const std::vector<std::filesystem::path> files = files_in(folder.path());
    CHECK(files.size() == 4);   // frame and picture of each
    for (const std::filesystem::path& file : files) {
        std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
        const sweep::Evaluation again = run_sweep(scene, axes, folder.path());
        CHECK(again.known == 1);
        check_same(first, again);
    }
}

TEST_CASE("a refusal is cached as well, separately for each memory") {
    const TestFolder folder;
    const Scene scene = scene_with_camera("icosphere:2");
    for (const std::size_t known : {0, 2}) {
        const sweep::Evaluation outcome = run_sweep(scene, {"stack_depth=1,16"}, folder.path());
        CHECK(outcome.known == known);
        CHECK(outcome.results[0].point.refused.find("stack_depth") != std::string::npos);
        CHECK(outcome.results[1].complete());
    }
}
