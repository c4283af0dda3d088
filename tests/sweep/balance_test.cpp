// The search for the fastest machine that fits, on machines with formulas for speed and size.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <catch2/catch.hpp>

#include "sim/explore/balance/balance_report.hpp"

using namespace rayclock;
using namespace rayclock::balance;
using chip::Use;

namespace {

/// Rays per cycle, limited by caches, contexts and tri. An interval of 1 pays only with contexts.
double speed(const Config& c) {
    const double hits = 1 - 8.0 / (c.node_sets + 16) - 4.0 / (c.prim_sets + 16);
    const double flight = c.contexts * c.pipelines / 40.0;
    const double tests = 1.2 * c.pipelines / c.tri_interval, visits = 0.4 * c.node_width * c.pipelines;
    return 100 * hits * std::min({flight, tests, visits, 4.0});
}
Use size(const Config& c) {
    const auto n = [](double x) { return std::uint64_t(x); };
    return {n(c.pipelines * (2000 + 900 * c.node_width + 60 * c.contexts + 3000.0 / c.tri_interval)), 1000,
            n(c.pipelines * (6 * c.node_width + 60.0 / c.tri_interval)),
            n(c.pipelines * (c.node_sets + c.prim_sets) / 16.0)};
}

struct Formulas {
    std::size_t sizes = 0;   ///< number of machines whose size was requested
    int answers = 1000000;   ///< answers before the interrupt
    Evaluator evaluator() {
        return {[this](std::vector<Machine>& machines) {
                    for (Machine& m : machines) m.fps = speed(m.config);
                    return --answers >= 0;
                },
                [this](std::vector<Machine>& machines) {
                    for (Machine& m : machines) m.use = size(m.config), ++sizes;
                    return --answers >= 0;
                }};
    }
};

/// Returns all machines one step away, up (1) or down (-1) in one parameter.
std::vector<Config> steps(const Config& config, int by) {
    std::vector<Config> all;
    for (const ParameterValues& p : parameter_values()) {
        const auto at = std::find(p.values.begin(), p.values.end(), config.*p.member);
        REQUIRE(at != p.values.end());
        const std::ptrdiff_t to = at - p.values.begin() + by;
        if (to < 0 || to >= std::ptrdiff_t(p.values.size())) continue;
        all.push_back(config);
        all.back().*p.member = p.values[std::size_t(to)];
    }
    return all;
}

/// Repeats fits() independently.
bool inside(const Use& use, const Use& room) {
    return use.lut <= room.lut && use.ff <= room.ff && use.dsp <= room.dsp && use.bram <= room.bram;
}

/// Machines that differ in only three steps: node_sets (1), prim_sets (2) and node_mshrs (4). `speeds` are
/// the frames per second for each set of steps. Each step costs five block RAMs.
Evaluator three_steps(const std::array<double, 8>& speeds) {
    const auto taken = [](const Config& c) {
        return std::size_t(c.node_sets > 32) + 2 * std::size_t(c.prim_sets > 32) +
               4 * std::size_t(c.node_mshrs > 4);
    };
    return {[=](std::vector<Machine>& machines) {
                for (Machine& m : machines) m.fps = speeds[taken(m.config)];
                return true;
            },
            [=](std::vector<Machine>& machines) {
                for (Machine& m : machines)
                    m.use = Use{0, 0, 0, 5 * std::uint64_t(std::popcount(taken(m.config)))};
                return true;
            }};
}

constexpr Use rooms[] = {{12000, 90000, 60, 20},   {20000, 90000, 100, 40}, {40000, 90000, 100, 60},
                         {75000, 90000, 140, 180}, {75000, 90000, 50, 180}, {400000, 90000, 900, 900}};

}   // namespace

TEST_CASE("what the search finds fits, and no step, pair or exchange that fits is faster") {
    for (const Use& room : rooms) {
        Formulas formulas;
        const std::optional<SearchResult> found = search(named_config("default"), room, formulas.evaluator());
        REQUIRE(found);
        const Config& best = found->best().config;
        INFO(room.lut << " LUTs, " << room.dsp << " multipliers:\n" << text(*found, room));
        REQUIRE(inside(size(best), room));
        CHECK(*found->best().fps == speed(best));
        const auto better = [&](const Config& c) {
            return inside(size(c), room) && speed(c) >= (1 + least_gain) * speed(best);
        };
        for (const Config& up : steps(best, 1)) {
            CHECK_FALSE(better(up));
            for (const Config& pair : steps(up, 1)) CHECK_FALSE(better(pair));
        }
        for (const Config& down : steps(best, -1)) {
            CHECK(speed(down) < speed(best));   // every step has a gain
            for (const Config& exchange : steps(down, 1)) CHECK_FALSE(better(exchange));
        }
        for (const Machine& next : found->next) {
            CHECK(*next.fps > speed(best));
            CHECK_FALSE(excess(*next.use, room).empty());
        }
    }
}

TEST_CASE("the path goes from the least machine to the best, and each machine on it fits") {
    Formulas formulas;
    const std::optional<SearchResult> found = search(named_config("default"), rooms[3], formulas.evaluator());
    REQUIRE(found);
    Config at = found->first.config;
    for (const ParameterValues& p : parameter_values()) CHECK(at.*p.member == p.values.front());
    REQUIRE(found->others.size() == 3);   // eight pipelines at their least do not fit
    CHECK_FALSE(fits(*found->others.back().use, rooms[3]));
    for (const Machine& other : found->others) {
        CHECK(other.config.pipelines != at.pipelines);
        CHECK((!fits(*other.use, rooms[3]) || *other.fps <= *found->best().fps));
    }
    double fps = *found->first.fps;
    for (const Machine& machine : found->path) {
        for (const Step& step : machine.steps) {
            CHECK(at.*step.parameter->member == step.from);
            at.*step.parameter->member = step.to;
        }
        for (const ParameterValues& p : parameter_values()) CHECK(at.*p.member == machine.config.*p.member);
        CHECK(*machine.fps >= fps);
        CHECK(inside(*machine.use, rooms[3]));
        fps = *machine.fps;
    }
    CHECK(found->path.size() >= 5);
    CHECK(formulas.sizes < found->machines / 2);   // Yosys is used only for machines that would be faster
    // Other parameters keep the base's values.
    CHECK(found->best().config.coord_bits == named_config("default").coord_bits);
}

TEST_CASE("the brute-force best of small devices is met") {
    // Over all values of the five parameters that matter in these formulas.
    for (const Use& room : {rooms[0], rooms[1], rooms[2]}) {
        double most = 0;
        Config c = named_config("default");
        for (c.node_width = 2; c.node_width <= 8; c.node_width *= 2)
            for (c.contexts = 16; c.contexts <= 128; c.contexts *= 2)
                for (c.tri_interval = 1; c.tri_interval <= 4; c.tri_interval *= 2)
                    for (c.node_sets = 32; c.node_sets <= 512; c.node_sets *= 2)
                        for (c.prim_sets = 32; c.prim_sets <= 512; c.prim_sets *= 2)
                            for (c.pipelines = 1; c.pipelines <= 8; c.pipelines *= 2)
                                if (inside(size(c), room)) most = std::max(most, speed(c));
        Formulas formulas;
        const std::optional<SearchResult> found = search(named_config("default"), room, formulas.evaluator());
        REQUIRE(found);
        INFO(text(*found, room));
        CHECK(*found->best().fps >= 0.98 * most);   // a local optimum may miss the global one slightly
        CHECK(*found->best().fps <= most);
    }
}

TEST_CASE("a step is given back for a better one, and when it has become useless") {
    // The first is best alone. With the second, the third is better, and only two fit.
    const Use two{0, 0, 0, 10};
    const std::optional<SearchResult> exchanged =
        search(named_config("default"), two, three_steps({100, 130, 125, 140, 110, 135, 150, 160}));
    REQUIRE(exchanged);
    CHECK(exchanged->best().config.node_sets == 32);
    CHECK(*exchanged->best().fps == 150);
    // All fit, and with the two others the first has no gain.
    const Use all{0, 0, 0, 15};
    const std::optional<SearchResult> given_back =
        search(named_config("default"), all, three_steps({100, 130, 125, 150, 100, 131, 170, 170}));
    REQUIRE(given_back);
    CHECK(given_back->best().config.node_sets == 32);
    CHECK(*given_back->best().fps == 170);
    CHECK(given_back->best().use->bram == 10);
}

TEST_CASE("a device too small for the least machine gets none, and an interrupted search has no result") {
    Formulas formulas;
    const Use room{100, 90000, 60, 20};
    const std::optional<SearchResult> none = search(named_config("default"), room, formulas.evaluator());
    REQUIRE(none);
    CHECK(none->path.empty());
    CHECK(excess(*none->best().use, room) == "5,510 of 100 LUTs");
    for (const int answers : {0, 1, 2, 3, 5, 8, 20}) {
        Formulas stopped;
        stopped.answers = answers;
        CHECK_FALSE(search(named_config("default"), rooms[2], stopped.evaluator()));
    }
}

TEST_CASE("a search is reported as text and as JSON") {
    Formulas formulas;
    const std::optional<SearchResult> found = search(named_config("default"), rooms[4], formulas.evaluator());
    REQUIRE(found);
    const nlohmann::ordered_json made = json(*found, rooms[4]);
    CHECK(made["path"].size() == found->path.size());
    CHECK(made["best"]["fits"] == true);
    CHECK(made["best"]["fps"] == *found->best().fps);
    CHECK(made["room"]["dsp"] == 50);
    REQUIRE(!made["next"].empty());
    for (const auto& next : made["next"]) CHECK(next["fits"] == false);
    const std::string told = text(*found, rooms[4]);
    CHECK_THAT(told, Catch::Contains("all other parameters at their smallest") &&
                         Catch::Contains(steps_text(found->path[0].steps)));
    CHECK_THAT(told, Catch::Contains(" of 50 multipliers"));
}
