// Streams of rays: model and RTL in lockstep.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "model/compile/surfaces.hpp"
#include "model/base/error.hpp"
#include "model/engine/check.hpp"
#include "sim/load/load.hpp"
#include "sim/run/elastic/elastic.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/stream/make_rays.hpp"
#include "sim/run/stream/stream.hpp"
#include "tests/support/check/streams.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// The parameters of a chip for streams.
Config streaming_config(const Config& config, Values more = {}) {
    more.insert(more.begin(), {{"shading", 1}, {"source", 1}});
    return with(config, more);
}

/// Two pipelines that share a cache, rays one at a time, and lines of one word.
Config narrow_stream() {
    return streaming_config(named_config("small"), {{"structure", int(Structure::kd)},
                                                    {"pipelines", 2},
                                                    {"tile_bits", 0},
                                                    {"stream_line", 64},
                                                    {"stream_sets", 1},
                                                    {"stream_ways", 1},
                                                    {"stream_mshrs", 1},
                                                    {"l2_sets", 8},
                                                    {"raygen_interval", 4},
                                                    {"stack_depth", 64},
                                                    {"pixel_bits", 7},
                                                    {"timing", int(Timing::fast)}});
}

/// A stream of random rays that owns its scene.
struct RandomStream {
    RandomStream(const std::string& name, std::size_t count, const Config& config, std::uint64_t seed = 1)
        : scene(load_scene(name)),
          rays("random rays", random_rays(scene, count, seed)),
          stream(make_stream_job(scene, rays, config, Outside::clip)) {}
    Scene scene;
    ListedRays rays;
    StreamJob stream;
};

}   // namespace

TEST_CASE("model and RTL trace a stream alike, in every cycle", "[stream]") {
    const Config config = GENERATE(0, 1) == 0 ? streaming_config(quick_config("default")) : narrow_stream();
    for (const std::size_t count : {1, 2, 255, 256, 257, 1001}) {
        INFO(count);
        const LockstepResult result = check_lockstep(RandomStream("gears:2", count, config).stream.job);
        CHECK(result.model.answers.size() == count);
        CHECK(result.model.rays.all() == count);
        CHECK(result.rtl.rays.all() == count);
    }
}

TEST_CASE("model and RTL trace a stream alike under back-pressure", "[stream][long]") {
    const Config config = GENERATE(0, 1) == 0 ? streaming_config(quick_config("default")) : narrow_stream();
    const Disturbance disturbance =
        GENERATE(Disturbance{30, 0, 3}, Disturbance{0, 50, 4}, Disturbance{100, 90, 6});
    check_lockstep(RandomStream("teapot:6", 500, config, disturbance.seed).stream.job, disturbance,
                   int(disturbance.seed));
}

namespace {

/// A picture whose camera rays are exported and read back as a stream, with the hits of both.
struct ExportedPicture {
    ExportedPicture(const std::string& name, const Config& wanted)
        : scene(with_camera(load_scene(name))),
          config(fitted_config(scene, {}, wanted)),
          rays("camera rays", make_rays(scene, camera_rays(), config)),
          stream(make_stream_job(scene, rays, streaming(config, scene), Outside::refuse)) {
        const Job picture = make_job(scene, *scene.camera, size, config);
        drawn = record_frame(picture, picture.frame).trace.hits;
        traced = record_frame(stream.job, stream.job.frame).trace.hits;
    }
    static constexpr FrameSize size{48, 36};
    Scene scene;
    Config config;
    ListedRays rays;
    StreamJob stream;
    std::vector<Closest> drawn, traced;

private:
    static Scene with_camera(Scene scene) {
        scene.camera = fit_camera(scene, 4.0 / 3);
        return scene;
    }
    static RayStreamPlan camera_rays() {
        RayStreamPlan plan;
        plan.size = size;
        return plan;
    }
};

/// Requires that a stream on a chip of two levels has the same cycles in model and RTL, and right answers.
void check_two_levels(const Values& more) {
    Values values{{"levels", 2}, {"stack_depth", 64}};
    values.insert(values.end(), more.begin(), more.end());
    const Config config = streaming_config(quick_config("default"), values);
    RandomStream random("gearbox:2", 1500, config, 11);
    random.scene.camera = fit_camera(random.scene, 1);
    const LockstepResult result = check_lockstep(random.stream.job);
    for (const std::vector<Closest>* answers : {&result.model.answers, &result.rtl.answers}) {
        const StreamJudgement judged = judge_stream(random.stream, *answers);
        INFO(judged.first);
        CHECK(judged.wrong == 0);
    }
    std::set<std::uint32_t> places;
    for (const Closest& answer : result.rtl.answers) places.insert(answer.instance_line);
    CHECK(places.size() > 2);
}

}   // namespace

TEST_CASE("a stream walks two levels, alike in model and RTL", "[stream]") { check_two_levels({}); }

TEST_CASE("hits in memory name their instances", "[stream]") { check_two_levels({{"pixel_writes", 1}}); }

TEST_CASE("a stream walks two structures, alike in model and RTL", "[stream][slow]") {
    check_two_levels(
        {{"structure", int(Structure::kd)}, {"mesh_structure", int(MeshStructure::bvh)}, {"pipelines", 2}});
    check_two_levels({{"raygen_interval", 4}, {"timing", int(Timing::fast)}});
}

TEST_CASE("with two levels, the stream of a picture's camera rays has the picture's hits and instances",
          "[stream]") {
    const ExportedPicture picture("gearbox:2",
                                  with(quick_config("default"), {{"levels", 2}, {"stack_depth", 64}}));
    REQUIRE(picture.scene.placed);
    const PlacedScene& placed = *picture.scene.placed;
    const std::vector<Closest>& answers = picture.traced;
    REQUIRE(answers.size() == picture.drawn.size());
    std::size_t found = 0;
    std::set<std::uint32_t> met;
    const std::string bytes = hits_npy(hits_of(picture.stream, answers), {});
    for (std::size_t i = 0; i < answers.size(); ++i) {
        Closest drawn_hit = picture.drawn[i], traced = answers[i];
        // Without shading a picture's hits have no instance.
        drawn_hit.instance_line = traced.instance_line = 0;
        REQUIRE(same_answer(drawn_hit, traced));
        std::uint32_t instance;
        std::memcpy(&instance, &bytes[bytes.size() - (answers.size() - i) * 42 + 6], sizeof instance);
        if (!traced.found) {
            CHECK(instance == InstanceNumbers::none);
            continue;
        }
        ++found;
        met.insert(instance);
        if (instance == InstanceNumbers::none) {
            CHECK(traced.prim < placed.own.triangles.size());
            continue;
        }
        std::uint64_t first = placed.own.triangles.size();   // counted anew
        for (std::uint32_t k = 0; k < instance; ++k)
            first += placed.meshes[placed.instances.at(k).mesh].triangles.size();
        CHECK(traced.prim >= first);
        CHECK(traced.prim < first + placed.meshes[placed.instances.at(instance).mesh].triangles.size());
    }
    CHECK(found > 300);
    CHECK(met.size() > 1);
}

TEST_CASE("hits that are written to the memory take their share of it, alike in model and RTL", "[stream]") {
    const auto run = [](int writes) {
        const Config config = streaming_config(quick_config("default"), {{"pixel_writes", writes}});
        return check_lockstep(RandomStream("gears:2", 1001, config).stream.job).model;
    };
    const FrameResult with = run(1), without = run(0);
    CHECK(without.memory.writes == 0);
    CHECK(with.memory.pixel_writes == 251);   // the last line has one hit
    CHECK(with.memory.writes <= 251);
    CHECK(with.memory.writes + 4 >= 251);   // the last ones wait in the memory
    CHECK(with.cycles > without.cycles);
}

TEST_CASE("a chip writes the hits of a stream into memory, alike in model and RTL", "[stream][long]") {
    const Config config = GENERATE(0, 1) == 0
                              ? streaming_config(quick_config("default"), {{"pixel_writes", 1}})
                              : with(narrow_stream(), {{"pixel_writes", 1}, {"dram", int(DramName::sdr)}});
    REQUIRE(hits_of_line(config) == 4);
    for (const std::size_t count : {1, 3, 4, 5, 257}) {
        INFO(count);
        // Lockstep takes the RTL's answers from its memory.
        const LockstepResult result = check_lockstep(RandomStream("gears:2", count, config).stream.job);
        CHECK(result.rtl.answers.size() == count);
        CHECK(result.rtl.memory.pixel_writes == (count + 3) / 4);
    }
    const Disturbance disturbance =
        GENERATE(Disturbance{30, 0, 3}, Disturbance{0, 50, 4}, Disturbance{100, 90, 6});
    const RandomStream random("teapot:6", 500, config, disturbance.seed);
    check_lockstep(random.stream.job, disturbance, int(disturbance.seed));
    CHECK(run_elastic(random.stream.job, disturbance).agrees());
}

TEST_CASE("records of hits that are wider take half a line", "[stream][long]") {
    const Config config =
        streaming_config(quick_config("default"), {{"planes", 1}, {"pixel_writes", 1}, {"pipelines", 4}});
    REQUIRE(hits_of_line(config) == 2);
    const FrameResult run = check_lockstep(RandomStream("gears:2", 301, config).stream.job).rtl;
    CHECK(run.memory.pixel_writes == 151);
}

TEST_CASE("two frames of a stream write their hits to the same lines", "[stream]") {
    const Config config = streaming_config(quick_config("default"), {{"pixel_writes", 1}});
    const RandomStream random("gears:2", 101, config);
    std::vector<RecordedFrame> frames;
    for (int f = 0; f < 2; ++f) frames.push_back(record_frame(random.stream.job, random.stream.job.frame));
    CHECK(run_lockstep(random.stream.job, frames).agrees());
}

TEST_CASE("a record of a hit has the bits that the chip's page gives", "[stream]") {
    const Config config = streaming_config(named_config("default"), {{"pixel_writes", 1}});
    const Closest answer{9, 1, 0x89abcdef, 0x654321, 0x12345, 0x1ffff, 1, 77, 0};
    const Words words = pack(HitRecord{1, {0x1003, 0x2001, answer, {}}}, config);
    REQUIRE(words.size() == 4);
    const auto bits = [&](int top, int bottom) {
        std::uint64_t value = 0;
        for (int i = top; i >= bottom; --i) value = value << 1 | (words[std::size_t(i) / 32] >> i % 32 & 1);
        return value;
    };
    CHECK(bits(126, 126) == 1);          // valid
    CHECK(bits(125, 112) == 0x1003);     // x
    CHECK(bits(111, 98) == 0x2001);      // y
    CHECK(bits(97, 92) == 9);            // ray
    CHECK(bits(91, 91) == 1);            // found
    CHECK(bits(90, 90) == 1);            // back
    CHECK(bits(89, 58) == 0x89abcdef);   // prim
    CHECK(bits(57, 34) == 0x654321);     // t
    CHECK(bits(33, 17) == 0x12345);      // u
    CHECK(bits(16, 0) == 0x1ffff);       // v
    CHECK(words[3] >> 31 == 0);
}

TEST_CASE("an answer leaves the chip when memory accepts its line", "[stream]") {
    const Config config = streaming_config(quick_config("default"), {{"pixel_writes", 1}});
    const RandomStream random("gears:2", 42, config);
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(random.stream.job, random.stream.job.frame));
    const std::uint64_t cycles = replay(config, default_khz, frames)[0].cycles;
    const std::vector<std::uint64_t> retired = retirements(config, default_khz, frames[0], {}, cycles);
    CHECK(std::set(retired.begin(), retired.end()).size() == 11);   // four answers in each line
    CHECK(*std::max_element(retired.begin(), retired.end()) == cycles - 1);
}

TEST_CASE("the stream of a picture's camera rays has the picture's hits", "[stream]") {
    const ExportedPicture picture("gears:2", quick_config("default"));
    REQUIRE(picture.traced.size() == picture.drawn.size());
    std::size_t found = 0, differ = 0;
    for (std::size_t i = 0; i < picture.traced.size(); ++i) {
        found += picture.drawn[i].found;
        differ += !same_answer(picture.drawn[i], picture.traced[i]);
    }
    CHECK(differ == 0);
    CHECK(found > 500);
}

TEST_CASE("the judge of streams passes right answers and names a wrong one", "[stream]") {
    const Config config = streaming_config(quick_config("default"));
    Scene scene = load_scene("gears:1");
    scene.camera = fit_camera(scene, 1);
    const ListedRays rays("random rays", random_rays(scene, 3000, 5));
    const StreamJob stream = make_stream_job(scene, rays, config, Outside::clip);
    std::vector<Closest> answers = record_frame(stream.job, stream.job.frame).trace.hits;
    CHECK(judge_stream(stream, answers).wrong == 0);
    const auto first_found = [&](bool any_hit) {
        std::size_t i = 0;
        while (i < answers.size() && !(answers[i].found && rays[i].any_hit == any_hit)) ++i;
        REQUIRE(i < answers.size());
        return i;
    };
    const std::size_t hit = first_found(false), blocked = first_found(true);
    const Closest right = answers[hit];
    answers[hit].t += 1;
    StreamJudgement judged = judge_stream(stream, answers);
    CHECK(judged.wrong == 1);
    CHECK(judged.first.starts_with("ray " + std::to_string(hit) + ": "));
    answers[hit] = right;
    answers[blocked].found = 0;
    judged = judge_stream(stream, answers);
    CHECK(judged.wrong == 1);
    CHECK(judged.first.starts_with("ray " + std::to_string(blocked) + ": "));
}

TEST_CASE("every structure gives a stream the same right answers", "[stream][structures]") {
    Scene scene = load_scene("teapot:6");
    scene.camera = fit_camera(scene, 1);
    const ListedRays rays("random rays", random_rays(scene, 2000, 7));
    std::vector<Closest> first;
    for (int s = 0; s < int(names_of<Structure>().size()); ++s) {
        INFO(name_of(Structure(s)));
        const Config config =
            streaming_config(quick_config("default"), {{"structure", s}, {"stack_depth", 64}});
        const StreamJob stream = make_stream_job(scene, rays, config, Outside::clip);
        const std::vector<Closest> answers = record_frame(stream.job, stream.job.frame).trace.hits;
        CHECK(judge_stream(stream, answers).wrong == 0);
        if (first.empty()) first = answers;
        std::size_t differ = 0;
        for (std::size_t i = 0; i < answers.size(); ++i) differ += !same_answer(first[i], answers[i]);
        CHECK(differ == 0);
    }
}

TEST_CASE("hits of a stream belong to the rays as given", "[stream]") {
    // A square of 2 x 2 in the plane z = 1, seen from below, and a triangle that makes the scene larger.
    Scene scene;
    scene.name = "square";
    scene.vertices = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {5, 5, 3}, {6, 5, 3}, {6, 6, 3}};
    scene.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}, {{4, 5, 6}, 0}};
    scene.materials.emplace_back();
    scene.camera = Camera{{0, 0, -1}, {0, 0, 1}, {0, 1, 0}, 60};
    const auto ray = [](double t_min, double t_max, bool any) {
        return StreamRay{{0.5, 0.25, 0}, {0, 0, 0.125}, t_min, t_max, any};   // meets the square at t = 8
    };
    const double inf = std::numeric_limits<double>::infinity();
    std::vector<StreamRay> given{ray(0, inf, false),
                                 ray(0, 7.9, false),
                                 ray(0, 8.1, false),
                                 ray(8.1, inf, false),
                                 ray(0, inf, true),
                                 ray(0, 7.9, true),
                                 ray(0, 8.1, true),
                                 ray(8.1, inf, true),
                                 ray(7.9, 8.1, true),
                                 {{0.5, 0.25, -900}, {0, 0, 1}, 0, inf, false},
                                 {{5000, 0, 0}, {0, 0, 1}, 0, inf, false}};
    const std::vector<bool> expected{true, false, true, false, true, false, true, false, true, true, false};
    const ListedRays rays("rays by hand", given);
    const StreamJob stream =
        make_stream_job(scene, rays, streaming_config(quick_config("default")), Outside::clip);
    CHECK(stream.clipped == 1);
    CHECK(stream.missing == 1);
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(stream.job, stream.job.frame));
    const std::vector<Closest>& answers = frames[0].trace.hits;
    CHECK(judge_stream(stream, answers).wrong == 0);

    const Config& config = stream.job.config;
    const std::uint64_t cycles = replay(config, default_khz, frames)[0].cycles;
    const std::vector<std::uint64_t> retired = retirements(config, default_khz, frames[0], {}, cycles);
    CHECK(std::set(retired.begin(), retired.end()).size() == given.size());   // one answer in a cycle
    CHECK(*std::min_element(retired.begin(), retired.end()) > 0);
    CHECK(*std::max_element(retired.begin(), retired.end()) == cycles - 1);
    const std::string bytes = hits_npy(hits_of(stream, answers), retired);
    constexpr std::size_t head = 256, bytes_of_hit = 42;
    REQUIRE(bytes.size() == head + bytes_of_hit * given.size());
    const auto field = [&]<class T>(std::size_t i, std::size_t at, T) {
        T value;
        std::memcpy(&value, &bytes[head + i * bytes_of_hit + at], sizeof value);
        return value;
    };
    const auto is_same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };

    for (std::size_t i = 0; i < given.size(); ++i) {
        INFO(i);
        const StreamHit hit = hit_of(stream, i, answers[i]);
        CHECK(field(i, 0, std::uint8_t()) == hit.hit);
        CHECK(field(i, 1, std::uint8_t()) == hit.back);
        CHECK(field(i, 2, std::uint32_t()) == hit.primitive);
        CHECK(field(i, 6, std::uint32_t()) == InstanceNumbers::none);
        CHECK(is_same(field(i, 10, double()), hit.t));
        CHECK(is_same(field(i, 18, double()), hit.u));
        CHECK(is_same(field(i, 26, double()), hit.v));
        CHECK(field(i, 34, std::uint64_t()) == retired[i]);
        CHECK(hit.hit == expected[i]);
        if (!hit.hit || given[i].any_hit) {
            CHECK(hit.primitive == no_primitive);
            CHECK(std::isnan(hit.t + hit.u + hit.v));
            continue;
        }
        CHECK(hit.t == Approx(i == 9 ? 901 : 8).epsilon(1e-4));
        CHECK(hit.primitive == 0);
        CHECK(hit.u == Approx(0.125).epsilon(1e-3));   // weights of the second and third corner
        CHECK(hit.v == Approx(0.625).epsilon(1e-3));
    }
    CHECK_THROWS_WITH(make_stream_job(scene, rays, config, Outside::refuse),
                      "rays by hand: ray 9 begins outside the lattice that holds the scene; --outside clip "
                      "leaves out the part before it");
}

TEST_CASE("a ray from outside meets a surface on the border of the scene", "[stream]") {
    Scene scene;
    scene.name = "panel";
    scene.vertices = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, -1}};
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.materials.emplace_back();
    scene.camera = Camera{{0.5, -0.5, -1}, {0, 0, 1}, {0, 1, 0}, 60};
    const double inf = std::numeric_limits<double>::infinity();
    const ListedRays rays("rays by hand", {{{0.5, -0.5, 9}, {0, 0, -1}, 0, inf, false},
                                           {{0.5, -0.5, 9}, {0, 0, -1}, 0, inf, true},
                                           {{0.5, -0.5, 9}, {0, 0, -1}, 0, 8.5, true},
                                           {{0.5, -0.5, -9}, {0, 0, 1}, 0, inf, false},
                                           {{0.5, -0.5, -9}, {0, 0, 1}, 0, 10.5, true}});
    const StreamJob stream =
        make_stream_job(scene, rays, streaming_config(quick_config("default")), Outside::clip);
    CHECK(stream.clipped == 5);
    for (const Closest& answer : record_frame(stream.job, stream.job.frame).trace.hits)
        CHECK(answer.found == 1);
}

TEST_CASE("a common origin far away does not coarsen the lattice", "[stream]") {
    Scene scene = load_scene("tetra:2");
    scene.camera = fit_camera(scene, 1);
    const double inf = std::numeric_limits<double>::infinity();
    const Config config = streaming_config(quick_config("default"));
    double pitch = 0;
    for (const double far : {1e3, 1e6, 1e12, 1e15}) {
        INFO(far);
        const ListedRays rays("one ray", {{{0.01, 0.02, far}, {0, 0, -1}, 0, inf, false}});
        const StreamJob stream = make_stream_job(scene, rays, config, Outside::clip);
        CHECK((pitch == 0 || stream.job.image.lattice.coarsest() == pitch));
        pitch = stream.job.image.lattice.coarsest();
        const auto record = unpack<RayRecord>(stream.job.image.record(0), config);
        CHECK(record.o[2] == (1 << (config.origin_width() - 1)) - 1);   // exactly on the border
    }
}

TEST_CASE("a segment that rounds to a point meets nothing", "[stream]") {
    const Config config = streaming_config(quick_config("default"));
    Lattice lattice;
    lattice.coord_bits = config.coord_bits;
    for (const double t_max : {0.0, 1e-5}) {
        const auto made = on_lattice({{1, 2, 3}, {0, 1, 0}, 0, t_max, true}, lattice, config);
        REQUIRE(made);
        CHECK(made->record == ray_to_nowhere(config));
    }
}

TEST_CASE("a request for any hit without an end has no end, however short its direction is", "[stream]") {
    const Config config = streaming_config(quick_config("default"));
    Lattice lattice;
    lattice.coord_bits = config.coord_bits;
    const double inf = std::numeric_limits<double>::infinity();
    for (const double size : {StreamRay::least_size, 0x1p-400, 1.0, 0x1p400, StreamRay::max_size}) {
        INFO(size);
        for (const double other : {0.0, 0x1p-1074, size * 0x1p-60, -size}) {
            const glm::dvec3 direction{other, size, 0};
            const auto endless = on_lattice({{1, 2, 3}, direction, 0, inf, true}, lattice, config);
            REQUIRE(endless);
            CHECK(endless->record.kind == RayKind::away);
            const double ten = 10 / size;
            const auto ended = on_lattice({{1, 2, 3}, direction, 0, ten, true}, lattice, config);
            REQUIRE(ended);
            CHECK(ended->record.kind == RayKind::shadow);
            CHECK(ended->record.o[1] == 12 << config.origin_frac());
        }
    }
    lattice.pitch = glm::dvec3(0x1p600);   // the ray leaves this lattice beyond the largest double
    const auto endless =
        on_lattice({{1, 2, 3}, {0, StreamRay::least_size, 0}, 0, inf, true}, lattice, config);
    REQUIRE(endless);
    CHECK(endless->record.kind == RayKind::away);
    lattice.pitch = glm::dvec3(1);
    for (const double far : {StreamRay::max_size, -StreamRay::max_size}) {
        const auto made = on_lattice({{0, far, 0}, {0, -far, 0}, 0, inf, false}, lattice, config);
        REQUIRE(made);
        CHECK(made->is_clipped);
    }
}

TEST_CASE("a segment that ends beyond all vertices needs no end, or meets nothing", "[stream]") {
    const Config config = streaming_config(quick_config("default"));
    Lattice lattice;
    lattice.coord_bits = config.coord_bits;
    const double reach = std::ldexp(1.0, config.coord_bits - 1);
    const auto kind_of = [&](double from, double to, int axis, double other) {
        StreamRay ray{{0, 0, 0}, {0, 0, 0}, 0, 1, true};
        ray.origin[axis] = from, ray.direction[axis] = to - from;
        ray.direction[(axis + 1) % 3] = other;
        const auto made = on_lattice(ray, lattice, config);
        REQUIRE(made);
        if (made->record == ray_to_nowhere(config)) return "nothing";
        return made->record.kind == RayKind::shadow ? "segment" : "endless";
    };
    for (const int axis : {0, 1, 2})
        for (const double side : {1.0, -1.0}) {
            INFO(axis << ", " << side);
            const auto kind = [&](double from, double to, double other = 0) {
                return kind_of(side * (reach - from), side * (reach - to), axis, other);
            };
            CHECK(std::string(kind(9, 0.25)) == "endless");         // outward, and rounded to the border
            CHECK(std::string(kind(9, 1.25)) == "segment");         // outward, to the outermost vertex
            CHECK(std::string(kind(0.25, 0.4)) == "nothing");       // inward, beyond all vertices
            CHECK(std::string(kind(0.4, 1.75)) == "segment");       // inward, past the outermost vertex
            CHECK(std::string(kind(0.25, 0.25, 5)) == "nothing");   // along the border
        }
}

TEST_CASE("a stream that the chip cannot number or hold is refused", "[stream]") {
    Config config = streaming_config(quick_config("default"), {{"pixel_bits", 7}});
    MemoryImage image;
    image.words.resize(16);
    const std::vector<RayRecord> rays(1 << 14, ray_to_nowhere(config));
    CHECK_THROWS_WITH(place_rays(image, rays, config),
                      "16384 rays are too many: with pixel_bits=7 the chip numbers at most 16383");
    CHECK(image.records.empty());
    place_rays(image, std::span(rays).first(16383), config);
    CHECK(image.end() == image.first_ray_line + 8192);

    config.addr_bits = 10;   // 1024 lines: the scene's first burst, and 1020 lines of rays
    CHECK_THROWS_WITH(place_rays(image, std::span(rays).first(2041), config),
                      "2041 rays and the scene need 1025 lines of memory, and addr_bits=10 allows 1024");
    place_rays(image, std::span(rays).first(2040), config);
    CHECK(image.end() == 1024);

    config.pixel_writes = true;   // the hits follow: four in a line
    place_rays(image, std::span(rays).first(1360), config);
    CHECK(image.first_hit_line == 684);
    CHECK_NOTHROW(check_capacity(image, config));
    place_rays(image, std::span(rays).first(1361), config);
    CHECK_THROWS_WITH(check_capacity(image, config),
                      "the scene, the rays and their hits need 1029 lines of memory, and addr_bits=10 allows "
                      "1024; without pixel_writes=1 the chip writes no hits");
    config.pixel_writes = false;
    CHECK_NOTHROW(check_capacity(image, config));
}

TEST_CASE("a chip for streams has no unit that only a picture needs", "[stream]") {
    const Config config = streaming_config(quick_config("default"));
    for (const std::string item :
         {"smooth=1", "refraction=1", "supersampling=1", "horizon=1", "scan_out=1"}) {
        INFO(item);
        CHECK_THROWS_WITH(with_settings(config, {item}, "here"),
                          Catch::Contains(item + " needs source=camera"));
    }
    CHECK_THROWS_WITH(with_settings(config, {"shading=0"}, "here"),
                      Catch::Contains("source=stream needs shading=1"));
    Config all = config;
    all.scan_out = all.smooth = all.spheres = true;
    CHECK_NOTHROW(check_config(streaming(all, load_scene("tetra:1")), "here"));
}
