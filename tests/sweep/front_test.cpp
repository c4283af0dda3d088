// Fronts and knees of hand-made points.
#include "model/base/error.hpp"
#include "tests/sweep/small_sweeps.hpp"

namespace rayclock::test::front_test {

using namespace rayclock;
using namespace rayclock::test;
using sweep::Figures;

namespace {

std::vector<Figures> points(std::initializer_list<std::vector<double>> list) {
    std::vector<Figures> all;
    for (const std::vector<double>& p : list) all.push_back(p.empty() ? Figures() : Figures(p));
    return all;
}

/// Returns a result with these figures; 0 multipliers means that none were counted.
sweep::Result result(std::uint64_t wrong, double fps, std::uint64_t multipliers, std::uint64_t bytes = 1000) {
    sweep::Result r;
    r.clock = {{"cycles", 100.0}, {"fps", fps}, {"frames", {nullptr}}};
    r.picture = sweep::PictureFigures{{1000, wrong, 40, 1000, 0.1}, 0, bytes, {}};
    if (multipliers) r.multipliers = multipliers;
    return r;
}

}   // namespace

TEST_CASE("the front is what no other point beats") {
    CHECK(sweep::front(points({{1, 5}, {2, 2}, {5, 1}, {3, 3}, {2, 4}, {5, 5}})) ==
          std::vector<bool>{true, true, true, false, false, false});
    CHECK(sweep::front(points({{1, 1, 3}, {1, 1, 2}, {2, 2, 1}})) == std::vector<bool>{false, true, true});
    CHECK(sweep::front({}).empty());
    CHECK(sweep::front(points({{4, 4}})) == std::vector<bool>{true});
    CHECK(sweep::front(points({{4, 4}, {4, 4}, {4, 5}})) ==
          // Equal points: both are on the front.
          std::vector<bool>{true, true, false});
    // Missing figures.
    CHECK(sweep::front(points({{}, {4, 4}, {}})) == std::vector<bool>{false, true, false});
    CHECK(sweep::front(points({{}, {}})) == std::vector<bool>{false, false});
}

TEST_CASE("the knee lies farthest below the chord") {
    const auto knee = sweep::knee_of(points({{0, 100}, {10, 20}, {30, 10}, {100, 0}, {50, 50}}));
    REQUIRE(knee);
    CHECK(knee->point == 1);   // 1 - 0.1 - 0.2 against 1 - 0.3 - 0.1
    CHECK(knee->distance == Approx(0.7 / std::sqrt(2.0)));
    // Scaling and shifting a figure changes nothing.
    const auto scaled = sweep::knee_of(points({{7, 1e6}, {7.1, 2e5}, {7.3, 1e5}, {8, 0}, {7.5, 5e5}}));
    REQUIRE(scaled);
    CHECK(scaled->point == 1);
    CHECK(scaled->distance == Approx(knee->distance));
}

TEST_CASE("the automatic cost is the first that differs between points, and says so") {
    const auto chosen = [](const std::vector<sweep::Result>& results) {
        const sweep::Front front = sweep::front_of(results, sweep::Cost::automatic);
        CHECK(front.why.starts_with(front.measures[1].key + ", "));
        return front.measures[1].key;
    };
    std::vector<sweep::Result> results{result(5, 50, 90), result(4, 49, 100)};
    CHECK(chosen(results) == "multipliers");
    results[1].multipliers = 90;
    results[1].picture->memory_bytes = 2000;
    CHECK(chosen(results) == "memory_bytes");
    results[1].point.config.node_sets *= 2;   // a cache costs on-chip memory
    CHECK(chosen(results) == "chip_memory_bits");
    CHECK(chosen({result(5, 50, 0), result(4, 49, 0, 2000)}) == "memory_bytes");
    CHECK(chosen({result(5, 50, 90), result(4, 49, 90)}) == "multipliers");
    CHECK(chosen({result(5, 50, 0), result(4, 49, 0)}) == "memory_bytes");
    CHECK(sweep::front_of(results).why.empty());
}

TEST_CASE("the speed of a film is that of all its frames") {
    std::vector<sweep::Result> results{result(5, 50, 90), result(4, 49, 100)};
    for (sweep::Result& r : results) {
        const nlohmann::ordered_json first{{"cycles", 100}, {"upload_cycles", 0}, {"reset_cycles", 0}},
            second{{"cycles", 200}, {"upload_cycles", 60}, {"reset_cycles", 40}};
        r.clock["frames"] = {first, second};
        r.clock["mhz"] = 66.0;
        CHECK(r.film_cycles() == 400);
        CHECK(r.film_fps() == Approx(2 * 66e6 / 400));
    }
    CHECK(sweep::front_of(results).measures[2].key == "film_fps");
}

TEST_CASE("a front without a bend has no knee") {
    CHECK(!sweep::knee_of({}));
    CHECK(!sweep::knee_of(points({{1, 1}})));
    CHECK(!sweep::knee_of(points({{1, 1}, {1, 1}, {1, 1}})));
    CHECK(!sweep::knee_of(points({{0, 1}, {1, 0}})));             // only the ends
    CHECK(!sweep::knee_of(points({{0, 2}, {1, 1}, {2, 0}})));     // straight
    CHECK(!sweep::knee_of(points({{0, 10}, {9, 9}, {10, 0}})));   // bulges to the other side
    CHECK(!sweep::knee_of(points({{}, {}, {1, 2}})));
}

TEST_CASE("cost is multipliers, or bytes where nothing has any") {
    const std::vector<sweep::Result> with{result(100, 50, 90), result(20, 49, 100), result(5, 48, 160),
                                          result(300, 60, 0)};
    const sweep::Front hardware = sweep::front_of(with);
    CHECK(hardware.measures[1].key == "multipliers");
    CHECK(hardware.pareto == std::vector<bool>{true, true, true, false});   // the last has no hardware
    REQUIRE(hardware.knee);
    CHECK(hardware.knee->point == 1);
    const std::vector<sweep::Result> without{result(100, 50, 0, 3000), result(100, 50, 0, 2000),
                                             result(100, 50, 0, 2000)};
    const sweep::Front bytes = sweep::front_of(without);
    CHECK(bytes.measures[1].key == "memory_bytes");
    CHECK(bytes.pareto == std::vector<bool>{false, true, true});
    CHECK(!bytes.knee);
}

TEST_CASE("the cost of a front is the chosen one") {
    std::vector<sweep::Result> results{result(10, 50, 90), result(10, 60, 80), result(10, 70, 70),
                                       result(10, 80, 60)};
    // In cells of the chip: LUTs fall, multipliers and block RAMs rise with speed. The last was not counted.
    results[0].area = synth::Count{900, 0, 0, 5, 1, 1};
    results[1].area = synth::Count{800, 0, 0, 5, 2, 2};
    results[2].area = synth::Count{100, 50, 100, 5, 3, 2};   // also 800 LUTs
    const auto on_front = [&](sweep::Cost cost, const char* key) {
        const sweep::Front front = sweep::front_of(results, cost);
        CHECK(front.measures[1].key == key);
        return front.pareto;
    };
    using Flags = std::vector<bool>;
    CHECK(on_front(sweep::Cost::lut, "chip_luts") == Flags{false, false, true, false});
    CHECK(on_front(sweep::Cost::dsp, "chip_multipliers") == Flags{true, true, true, false});
    CHECK(on_front(sweep::Cost::bram, "chip_block_rams") == Flags{true, false, true, false});
    CHECK(on_front(sweep::Cost::multipliers, "multipliers") == Flags{false, false, false, true});
    // In memory, which follows from the configuration; software has none.
    results[0].point.config.node_sets = 16;
    results[1].point.config.contexts = 128;
    results[2].point.config.pipelines = 2;
    results[3].point.config.primitive_test = PrimitiveTest::woop;
    CHECK(on_front(sweep::Cost::bits, "chip_memory_bits") == Flags{true, true, true, false});
    CHECK_THROWS_AS(sweep::parse_cost("lutt"), UserError);
    CHECK(sweep::parse_cost("bram") == sweep::Cost::bram);
}

TEST_CASE("memory on the chip is that of every pipeline, and what they share") {
    Config one = named_config("small");
    CHECK(sweep::pipeline_cache_bytes(one) == 2u * 32 * 2 * 64);
    CHECK(sweep::chip_cache_bytes(one) == sweep::pipeline_cache_bytes(one));
    const std::uint64_t bits = sweep::chip_memory_bits(one);
    CHECK(bits > 8 * sweep::chip_cache_bytes(one));
    Config four = one;
    four.pipelines = 4;
    CHECK(sweep::chip_memory_bits(four) == 4 * bits);
    four.l2_sets = 64;
    CHECK(sweep::chip_cache_bytes(four) == 4 * sweep::pipeline_cache_bytes(one) + 64u * 4 * 64);
    CHECK(sweep::chip_memory_bits(four) == 4 * bits + 8u * 64 * 4 * 64);
    one.shading = 1;
    CHECK(sweep::pipeline_cache_bytes(one) == 2u * 32 * 2 * 64 + 64u * 4 * 64);
    one.structure = Structure::none;
    CHECK(sweep::pipeline_cache_bytes(one) == 32u * 2 * 64 + 64u * 4 * 64);
}

TEST_CASE("without errors that differ the knee is that of speed against cost") {
    const sweep::Front front =
        sweep::front_of({result(10, 10, 100), result(10, 19, 200), result(10, 21, 400), result(10, 22, 800)});
    REQUIRE(front.knee);
    CHECK(front.knee->point == 1);
    CHECK(front.measures[front.plane[0]].key == "multipliers");
    CHECK(front.measures[front.plane[1]].key == "fps");
}

TEST_CASE("points that are refused or not done are not on the front") {
    std::vector<sweep::Result> results(2);
    results[0].point.refused = "does not fit";
    const sweep::Front front = sweep::front_of(results);
    CHECK(front.pareto == std::vector<bool>{false, false});
    CHECK(!front.knee);
}

}   // namespace rayclock::test::front_test
