// Causes of different pixels: each cause is provoked alone, the oracle accepts correct answers, and every
// fault is reported as a bug.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/cause.hpp"
#include "sim/judge/cause/exact_answers.hpp"
#include "sim/files/image/srgb.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::cause_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr FrameSize size{64, 48};

/// A frame of the model and of the reference, for modification.
struct Case {
    Scene scene;
    Job job;
    HitFrame reference;
    std::vector<Closest> answers;
    Picture picture;

    Case(Scene of, Job made) : scene(std::move(of)), job(std::move(made)) {
        reference = Reference(scene).frame(*scene.camera, job.size);
        answers = record_frame(job, job.frame).trace.hits;
        shade_again();
    }
    void shade_again() { picture = shade(scene, scaled(job, job.frame, answers)); }
    Judgement judged() const {
        return judge({scene, *scene.camera, job.frame, job.image.lattice, job.config}, job.image,
                     {reference, answers, picture});
    }
};
Case make_case(const Scene& scene, const Config& config) {
    return {scene, make_job(scene, *scene.camera, size, config)};
}
Case make_case(const std::string& name, const Config& config) {
    Shot shot = make_deep_shot(name, size, config);
    return {std::move(shot.scene), std::move(shot.job)};
}

std::uint64_t count(const Judgement& j, PixelCause cause) { return j.causes[std::size_t(cause)]; }

/// Waves with smooth normals, seen from above. Corners and eye have integer coordinates over the full range
/// of `bits` bits on every axis. So they are lattice points: the pitch is 1.
Scene waves(int bits) {
    constexpr int side = 20;
    const double most = double((1 << (bits - 1)) - 1);
    Scene scene;
    scene.name = "waves";
    scene.materials = {Material{}};
    scene.lights = {Light{{most, most, 3 * most}, glm::dvec3{1}}};
    const auto whole = [](double v) { return std::round(v); };
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x) {
            const double u = 2.0 * x / side - 1, v = 2.0 * y / side - 1,
                         height = x + y == 0 ? 0 : 0.06 * (1 + std::sin(9 * u + 2 * v));
            scene.vertices.push_back({whole(u * most), whole(v * most), whole((height - 1) * most)});
            scene.normals.push_back(glm::normalize(glm::dvec3(std::cos(9 * u + 2 * v), std::sin(3 * v), 1)));
        }
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
            scene.triangles.push_back({{a, b, d}, 0});
            scene.triangles.push_back({{a, d, c}, 0});
        }
    scene.camera = Camera{{whole(most / 7), whole(-most / 3), most}, {0, 0, -most}, {0, 1, 0}, 40};
    return scene;
}
Config formats(int coord_bits, int dir_bits, int bary_bits) {
    return with(
        named_config("default"),
        {{"coord_bits", coord_bits}, {"dir_bits", dir_bits}, {"bary_bits", bary_bits}, {"stack_depth", 32}});
}

}   // namespace

TEST_CASE("no pixel is a bug because corner normals lie in the triangle's plane", "[cause]") {
    Scene scene = make_builtin("teapot:1", Primitives::triangles);
    if (!scene.camera) scene.camera = fit_camera(scene, 4.0 / 3);
    const Judgement j = make_case(scene, named_config("default")).judged();
    CHECK(count(j, PixelCause::bug) == 0);
    CHECK(j.wrong == 0);
}

TEST_CASE("vertices on lattice points are not snapped: what differs is the ray", "[cause]") {
    const Case made = make_case(waves(16), formats(16, 12, 24));
    REQUIRE(made.job.image.lattice.pitch == glm::dvec3{1});
    const Judgement j = made.judged();
    CHECK(count(j, PixelCause::snapping) == 0);
    CHECK(count(j, PixelCause::ray_quantisation) > 100);
    CHECK(count(j, PixelCause::t_rounding) == 0);
    CHECK(count(j, PixelCause::shading) == 0);
    CHECK(j.wrong == 0);
    CHECK(j.causes_other[std::size_t(PixelCause::ray_quantisation)] > 10);
}

TEST_CASE("fine rays on a coarse lattice: what differs is snapped", "[cause]") {
    const Judgement j = make_case(waves(16), formats(12, 24, 24)).judged();
    CHECK(count(j, PixelCause::snapping) > 30);
    CHECK(count(j, PixelCause::ray_quantisation) == 0);
    CHECK(count(j, PixelCause::t_rounding) == 0);
    CHECK(count(j, PixelCause::shading) == 0);
    CHECK(j.wrong == 0);
    CHECK(j.causes_other[std::size_t(PixelCause::snapping)] > 5);
}

TEST_CASE("few bits for u and v: what differs was rounded", "[cause]") {
    const Judgement j = make_case(waves(16), formats(16, 24, 4)).judged();
    CHECK(count(j, PixelCause::snapping) == 0);
    CHECK(count(j, PixelCause::ray_quantisation) == 0);
    CHECK(count(j, PixelCause::t_rounding) > 100);
    CHECK(count(j, PixelCause::shading) == 0);
    CHECK(j.wrong == 0);
    CHECK(j.causes_other == PixelCauses{});
}

TEST_CASE("a wrong local light with right hits has the cause shading", "[cause]") {
    Case made = make_case(waves(16), formats(16, 24, 24));
    const Judgement before = made.judged();
    const auto same =
        std::size_t(std::find(before.pixels.begin() + 1000, before.pixels.end(), PixelCause::none) -
                    before.pixels.begin());
    REQUIRE(same < before.pixels.size());
    made.picture.pixels[same].g += 0.1f;
    const Judgement j = made.judged();
    CHECK(count(j, PixelCause::shading) == 0);
    CHECK(j.pixels[same] == PixelCause::bug);
    CHECK(j.wrong == 1);
    CHECK(j.faults.at(0).what == "the colour is not the local light of the hit by the reference's rules");
}

TEST_CASE("registers that host, model and judge share are held against the camera", "[cause]") {
    struct Fault {
        const char* what;
        void (*change)(Frame&);
    };
    const auto fault = GENERATE(
        Fault{"the camera ray does not go through its pixel",
              [](Frame& f) { f.corner[0] += f.right[0] / 64; }},
        Fault{"the camera ray does not go through its pixel",
              [](Frame& f) { f.right[0] += f.right[0] / 512; }},
        Fault{"the eye lies further from the camera's than it may", [](Frame& f) { f.eye[1] += 1; }});
    Job job = make_case("teapot:6", quick_config("default")).job;
    const Scene scene = make_deep_shot("teapot:6", size, quick_config("default")).scene;
    fault.change(job.frame);
    const Judgement j = Case(scene, job).judged();
    INFO(fault.what);
    REQUIRE(j.wrong > 0);
    CHECK(j.faults.at(0).what == fault.what);
}

TEST_CASE("the oracle finds every answer right, and every pixel that differs has a cause", "[cause]") {
    const std::string name =
        GENERATE("gears:1", "rings:1", "tree:6", "cornell", "tetra:4", "balls:1", "mount:4", "teapot:6");
    const std::string config = GENERATE("default", "small", "narrow", "broad");
    const Case made = make_case(name, quick_config(config));
    const Judgement j = made.judged();
    INFO(name << " on " << config);
    CHECK(j.wrong == 0);
    CHECK(j.bugs() == 0);
    const Picture expected = shade(made.scene, made.reference);
    PixelCauses tally{}, tally_other{};
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < j.pixels.size(); ++i) {
        const bool other =
            made.reference.hits[i].primitive != (made.answers[i].found ? made.answers[i].prim : no_primitive);
        const bool differs = other || srgb_bytes(expected.pixels[i]) != srgb_bytes(made.picture.pixels[i]);
        unlike += differs != (j.pixels[i] != PixelCause::none) || other != j.other[i];
        if (!differs) continue;
        ++tally[std::size_t(j.pixels[i])];
        if (other) ++tally_other[std::size_t(j.pixels[i])];
    }
    CHECK(unlike == 0);
    CHECK(tally == j.causes);
    CHECK(tally_other == j.causes_other);
}

TEST_CASE("the oracle requires the lowest number of coplanar triangles that are hit at the same t",
          "[cause]") {
    Scene scene = waves(16);
    for (glm::dvec3& v : scene.vertices) v.z = scene.vertices[0].z;
    const auto last = std::uint32_t(scene.vertices.size() - 1);
    const std::uint32_t side = 20;
    scene.triangles.push_back({{0, side, last}, 0});   // covers all of it
    scene.triangles.push_back({{0, last, last - side}, 0});
    const Case made = make_case(scene, formats(16, 20, 16));
    const Judgement j = made.judged();
    CHECK(j.wrong == 0);
    std::size_t hits = 0, large = 0;
    for (const Closest& answer : made.answers) {
        hits += answer.found;
        large += answer.found && answer.prim >= scene.triangles.size() - 2;
    }
    CHECK(hits > 1000);
    CHECK(large == 0);
}

TEST_CASE("an answer that is off in anything is a bug, whether or not it shows", "[cause]") {
    const Case sound = make_case("gears:1", named_config("default"));
    const Judgement before = sound.judged();
    REQUIRE(before.wrong == 0);
    std::size_t hit = 0, miss = 0;
    while (!sound.answers[hit].found || sound.answers[hit].t < 2 || sound.answers[hit].u < 2) ++hit;
    while (sound.answers[miss].found) ++miss;
    using Fault = void (*)(Closest&);
    const std::vector<std::pair<std::size_t, Fault>> faults{
        {hit, [](Closest& c) { --c.t; }},       {hit, [](Closest& c) { ++c.t; }},
        {hit, [](Closest& c) { --c.u; }},       {hit, [](Closest& c) { ++c.v; }},
        {hit, [](Closest& c) { c.prim += 1; }}, {hit, [](Closest& c) { c = Closest{}; }},
        {hit, [](Closest& c) { c.found = 0; }}, {miss, [](Closest& c) { c.found = 1; }},
        {miss, [](Closest& c) { c.u = 1; }}};
    for (std::size_t f = 0; f < faults.size(); ++f) {
        Case faulty = sound;
        const auto [at, fault] = faults[f];
        fault(faulty.answers[at]);
        faulty.shade_again();
        const Judgement j = faulty.judged();
        INFO("fault " << f);
        CHECK(j.wrong == 1);
        CHECK(j.bugs() == 1);
        CHECK(j.pixels[at] == PixelCause::bug);
        // No other pixel's cause changes.
        std::size_t changed = 0;
        for (std::size_t i = 0; i < j.pixels.size(); ++i)
            changed += i != at && j.pixels[i] != before.pixels[i];
        CHECK(changed == 0);
    }
    // The context that did the work is arbitrary.
    Case renamed = sound;
    renamed.answers[hit].ray ^= 1;
    CHECK(renamed.judged().wrong == 0);
}

TEST_CASE("errors of an inexact primitive test have the cause primitive_test, not bug", "[cause]") {
    const int test = GENERATE(1, 2, 3, 4, 5);   // all except exact
    const Case made =
        make_case("gears:1", with(named_config("default"), {{"primitive_test", test}, {"dir_bits", 22}}));
    const Judgement j = made.judged();
    INFO(name_of(PrimitiveTest(test)) << ": " << j.wrong << " answers are not the oracle's");
    CHECK(j.wrong > 0);
    CHECK(j.bugs() == 0);
    // Another primitive is never blamed on it where it holds the oracle's.
    const ExactAnswers truth(made.scene, made.job.image.lattice, made.job.config);
    for (std::size_t i = 0; i < j.pixels.size(); ++i) {
        if (j.pixels[i] != PixelCause::primitive_test || !j.other[i]) continue;
        const std::uint32_t right =
            truth.pixel(made.job.frame, int(i) % size.width, int(i) / size.width).primitive;
        CHECK(right != (made.answers[i].found ? made.answers[i].prim : no_primitive));
    }
    if (PrimitiveTest(test) == PrimitiveTest::truncated) CHECK(count(j, PixelCause::primitive_test) > 0);

    Case exact = make_case("gears:1", with(named_config("default"), {{"dir_bits", 22}}));
    CHECK(count(exact.judged(), PixelCause::primitive_test) == 0);
    // The same answers from a machine that guarantees exactness are bugs.
    exact.answers = made.answers;
    exact.shade_again();
    CHECK(exact.judged().bugs() == j.wrong);
}

TEST_CASE("a pixel on an edge of the reference's triangle is counted apart", "[cause]") {
    Case made = make_case(waves(16), formats(16, 24, 24));
    REQUIRE(made.judged().on_edge == 0);
    const auto reference_with = [&](float u, float v) {
        Case changed = made;
        Hit& hit = changed.reference.hits[1000];
        hit = {hit.primitive ^ 1, hit.depth, u, v};
        return changed.judged().on_edge;
    };
    CHECK(reference_with(0, 0.5f) == 1);
    CHECK(reference_with(0.25f, 0) == 1);
    CHECK(reference_with(0.25f, 0.75f) == 1);
    CHECK(reference_with(0.25f, 0.5f) == 0);
    CHECK(reference_with(1e-5f, 0.5f) == 0);
}

TEST_CASE("the picture of causes has a colour for each", "[cause]") {
    const Picture reference{{5, 2}, std::vector<glm::vec3>(pixel_causes + 2, glm::vec3{1, 1, 1})};
    Judgement j;
    for (std::size_t k = 0; k <= pixel_causes; ++k) j.pixels.push_back(PixelCause(k));
    j.pixels.push_back(PixelCause::snapping);
    j.other.assign(pixel_causes, true);
    j.other.resize(pixel_causes + 2);
    const Picture picture = cause_picture(reference, j);
    for (std::size_t k = 0; k < pixel_causes; ++k)
        CHECK(srgb_bytes(picture.pixels[k]) == cause_info(PixelCause(k)).colour);
    CHECK(picture.pixels[pixel_causes] == glm::vec3(0.25f));   // no cause: the reference, dimmed
    CHECK(picture.pixels[pixel_causes + 1].r == Approx(picture.pixels[0].r / 3));
    for (std::size_t a = 0; a < pixel_causes; ++a)
        for (std::size_t b = 0; b < a; ++b)
            CHECK(cause_info(PixelCause(a)).colour != cause_info(PixelCause(b)).colour);
}

}   // namespace rayclock::test::cause_test
