// A machine that hangs: the watchdog detects it and reports where every ray is.
#include <map>

#include "model/machine/machine.hpp"
#include "model/machine/stuck_rays.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "tests/support/machine/machines.hpp"
#include "tests/support/world/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

constexpr rayclock::Disturbance shut{0, 100, 1};   // memory accepts no request and the sink no hit

/// One pipeline whose memory is the test. A requested word comes in the next cycle, or never.
struct Alone {
    Job job;
    RecordedFrame frame;
    Pipeline pipeline;
    Dispatch dispatch;
    std::uint64_t now = 0;

    explicit Alone(const Values& values)
        : job(small_job("tetra:3", {16, 12}, shaped(format("small"), values))),
          frame(record_frame(job, job.frame)),
          pipeline(job.config, shut, 0),
          dispatch(job.config) {
        pipeline.start(frame.frame, frame.trace);
        dispatch.start(frame.frame);
    }
    void run(int cycles, bool nodes, bool prims) {
        std::optional<std::uint32_t> node, prim;   // requested
        for (int i = 0; i < cycles; ++i) {
            SharedMoves shared;
            const int granted = dispatch.grant(pipeline.tile_ready());
            const Tile tile = dispatch.tile();
            if (granted == 0) shared.tile = &tile;
            const std::optional<std::uint32_t> node_fill = node, prim_fill = prim;
            if (node_fill) shared.node_fill = &*node_fill;
            if (prim_fill) shared.prim_fill = &*prim_fill;
            node.reset();
            prim.reset();
            const std::uint32_t misses = pipeline.misses(now);
            if ((shared.node_miss = nodes && (misses & 1) != 0)) node = pipeline.node_miss().id;
            if ((shared.prim_miss = prims && (misses & 2) != 0)) prim = pipeline.prim_miss().id;
            pipeline.step(now, shared);
            if (shared.node_miss) pipeline.take_miss(0);
            if (shared.prim_miss) pipeline.take_miss(1);
            dispatch.clock(granted);
            ++now;
        }
    }
    /// Returns the number of rays at each place.
    std::map<std::string, int> places() const {
        std::map<std::string, int> counts;
        for (std::uint32_t ray = 0; ray < std::uint32_t(job.config.contexts); ++ray)
            ++counts[pipeline.where(ray, now)];
        return counts;
    }
};

int lines_with(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}   // namespace

TEST_CASE("rays whose hit is not accepted wait for its acceptance", "[machine][stuck]") {
    Alone alone({{"contexts", 16}});
    REQUIRE(alone.places() == std::map<std::string, int>{{"", 16}});   // no ray is in flight
    alone.run(5000, true, true);
    INFO(alone.places().begin()->first);
    REQUIRE(alone.places() == std::map<std::string, int>{{"trav: done, waits for its hit to be taken", 16}});
}

TEST_CASE("rays whose node never arrives are in the node cache, and those behind them in their own units",
          "[machine][stuck]") {
    Alone alone({{"contexts", 64}, {"raygen_queue", 4}});
    alone.run(5000, false, true);
    int known = 0, cached = 0;
    for (const auto& [place, count] : alone.places()) {
        INFO(count << " rays: " << place);
        CHECK_FALSE((place.empty() || place == "nowhere"));
        cached += place.starts_with("node_cache: ") ? count : 0;
        known += count;
    }
    REQUIRE(known == 64);
    REQUIRE(cached == 64);   // any number of requests may wait for one line
}

TEST_CASE("rays whose triangle never arrives are in the primitive cache or done", "[machine][stuck]") {
    Alone alone({{"contexts", 32}});
    alone.run(5000, true, false);
    int cached = 0;
    for (const auto& [place, count] : alone.places()) {
        INFO(count << " rays: " << place);
        CHECK((place.starts_with("prim_cache: ") || place == "trav: done, waits for its hit to be taken" ||
               place.starts_with("list: waits for the link to prim_cache")));
        cached += place.starts_with("prim_cache: ") ? count : 0;
    }
    REQUIRE(cached > 0);
}

TEST_CASE("at any time every ray under way is somewhere", "[machine][stuck]") {
    const Job job = small_job("gears:1", {16, 12}, shaped(format("small"), {{"pipelines", 2}, {"dram", 2}}));
    const RecordedFrame frame = record_frame(job, job.frame);
    Machine machine{job.config, job.khz, {20, 50, 4}};
    machine.start(frame.frame, frame.trace);
    REQUIRE_THAT(describe_stuck_rays(machine), Contains("no ray is under way"));
    std::array<int, 2> under_way{};
    while (!machine.done()) {
        REQUIRE(machine.cycle() < 100000);
        machine.step([&](const Move& move) {
            if (move.link == Link::slot) ++under_way[std::size_t(move.pipeline)];
            if (move.link == Link::hit) --under_way[std::size_t(move.pipeline)];
        });
        const std::string text = describe_stuck_rays(machine);
        INFO("cycle " << machine.cycle() << "\n" << text);
        if (lines_with(text, "nowhere") > 0) FAIL("a ray is nowhere");
        for (int p = 0; p < 2; ++p)
            if (lines_with(text, "pipeline " + std::to_string(p) + " ray") != under_way[std::size_t(p)])
                FAIL(under_way[std::size_t(p)] << " rays in " << p);
    }
    REQUIRE_THAT(describe_stuck_rays(machine), Contains("no ray is under way"));
}

TEST_CASE("a hung run ends with a list of the places of all rays", "[machine][stuck]") {
    const Job job = small_job("tetra:3", {16, 12}, shaped(format("small"), {{"contexts", 4}}));
    const auto said = [](auto run) -> std::string {
        try {
            run();
        } catch (const std::runtime_error& e) {
            return e.what();
        }
        return "nothing";
    };
    const std::string model = said([&] { run_model(job, shut); });
    INFO(model);
    REQUIRE(model.starts_with("model: nothing has moved for "));
    REQUIRE(model.find("with 0 of 192 pixels done\n") != std::string::npos);
    REQUIRE(lines_with(model, "  pipeline 0 ray ") == 4);   // all of them
    REQUIRE(lines_with(model, "): node_cache: ") == 4);
    REQUIRE(model.find("  pipeline 0 ray 3 pixel (1, 1): ") != std::string::npos);
    const Job built = small_job("tetra:3", {16, 12}, format("small"));
    const std::string both = said([&] { run_lockstep(built, shut); });
    INFO(both);
    REQUIRE(both.starts_with("nothing has moved for "));
    REQUIRE(lines_with(both, "): node_cache: ") == built.config.contexts);
    const std::string rtl = said([&] { run_rtl(built, shut); });
    INFO(rtl);
    REQUIRE(rtl.starts_with("rtl: nothing has moved for "));
    REQUIRE(rtl.find("with 0 of 192 pixels done") != std::string::npos);
}

TEST_CASE("a memory latency of tens of thousands of cycles is not reported as a hang", "[machine][stuck]") {
    const std::string memory = GENERATE("sdr", "ddr3", "rpu", "ddr4", "lpddr4", "hbm2");
    Job job = small_job("tetra:1", {4, 3}, shaped(format("small"), {}));
    set_parameter(job.config, "dram", memory, "test");
    job.khz = 100'000'000;   // 100 GHz, the fastest legal clock
    const DramPart& part = dram_part(memory);
    const std::uint64_t pause = std::uint64_t(longest_pause_ps(part)) / 10;   // a cycle is 10 ps
    REQUIRE(patience(job.config, job.khz, {}) >= 10 * pause);
    // Colder than any frame: each answer alone, with the refreshes between them.
    Dram dram(part, job.khz, 1);
    std::uint64_t longest = 0;
    for (std::uint32_t i = 0; i < 400; ++i) {
        const std::uint64_t sent_at = dram.now();
        const Dram::Answer request{0, i * 4099};
        dram.clock(&request);
        while (!dram.valid())
            dram.quiet_until() > dram.now() + 1 ? dram.skip(dram.quiet_until() - dram.now() - 1)
                                                : dram.clock(nullptr);
        longest = std::max(longest, dram.now() - sent_at);
    }
    CHECK(longest <= pause);
    CHECK(longest > pause / 3);   // the bound is realistic
    const FrameResult model = run_model(job);
    CHECK(model.cycles > 15000);
    if (memory != "sdr") return;   // 30,000 cycles for each answer
    const LockstepResult both = run_lockstep(job);
    CHECK(both.agrees());
    CHECK(both.model.cycles == model.cycles);
    CHECK(run_rtl(job).cycles == model.cycles);
}
