// The machine as a whole: the order in which units see the clock does not matter, and every link's cycles add up.
#include <algorithm>
#include <numeric>

#include "model/machine.hpp"
#include "model/scene/builtin.hpp"
#include "sim/engine/engine.hpp"
#include "sim/rtl/rtl_machine.hpp"
#include "tests/support/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Job small_job(const char* scene, FrameSize size, const Config& config) {
    const Scene made = make_builtin(scene);
    return make_job(made, made.camera ? *made.camera : fit_camera(made, double(size.width) / size.height), size, config);
}

rayclock::Traffic disturbed(std::uint64_t seed) { return {5, 30, seed}; }

} // namespace

TEST_CASE("the order in which units see the clock edge does not matter", "[machine]") {
    const Job job = small_job("tetra:3", {16, 12}, format("small"));
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const rayclock::Traffic traffic = seed % 2 ? rayclock::Traffic{} : disturbed(seed);
        Machine plain{job.image, job.frame, job.config, traffic}, shuffled{job.image, job.frame, job.config, traffic};
        Draw draw{seed};
        std::array<int, 7> order{};
        std::iota(order.begin(), order.end(), 0);
        while (!plain.done()) {
            for (int i = 6; i > 0; --i) std::swap(order[std::size_t(i)], order[std::size_t(draw.below(i + 1))]);
            INFO("seed " << seed << ", cycle " << plain.cycle());
            REQUIRE(plain.cycle() < 100000);
            plain.step();
            shuffled.step_in_order(order);
            REQUIRE(plain.valid_mask() == shuffled.valid_mask());
            REQUIRE(plain.fire_mask() == shuffled.fire_mask());
            if (plain.fire_mask() & bit(Channel::hit)) REQUIRE(same(plain.last_hit(), shuffled.last_hit(), job.config));
        }
        REQUIRE(shuffled.done());
        REQUIRE(plain.counts() == shuffled.counts());
        REQUIRE(plain.box_tests() == shuffled.box_tests());
        REQUIRE(plain.recirculations() == shuffled.recirculations());
    }
}

TEST_CASE("a machine makes every pixel once and its accounts add up", "[machine]") {
    const Job job = small_job("tetra:3", {16, 12}, format("small"));
    const rayclock::Traffic traffic = GENERATE(rayclock::Traffic{}, disturbed(1), disturbed(2));
    Machine machine{job.image, job.frame, job.config, traffic};
    std::vector<int> seen(16 * 12, 0);
    std::array<std::uint64_t, channel_count> moved{};
    while (!machine.done()) {
        REQUIRE(machine.cycle() < 100000);
        machine.step([&](Channel c, const auto&) { ++moved[index(c)]; });
        REQUIRE((machine.fire_mask() & ~machine.valid_mask()) == 0);
        if (machine.fire_mask() & bit(Channel::hit)) ++seen[machine.last_hit().y * 16 + machine.last_hit().x];
    }
    REQUIRE(std::count(seen.begin(), seen.end(), 1) == 16 * 12);
    const ChannelCounts counts = machine.counts();
    for (std::size_t c = 0; c < channel_count; ++c) {
        CAPTURE(channels[c].name);
        REQUIRE(counts[c].moved == moved[c]);
        REQUIRE(counts[c].moved + counts[c].refused <= machine.cycle());
    }
    // What goes into a loop comes out of it.
    const auto count = [&](Channel c) { return counts[index(c)].moved; };
    for (const Channel c : {Channel::slot, Channel::ray, Channel::hit}) REQUIRE(count(c) == 16 * 12);
    for (const Channel c : {Channel::box_req, Channel::box_rsp, Channel::step}) REQUIRE(count(c) == count(Channel::node_req));
    for (const Channel c : {Channel::tri_req, Channel::tri_rsp}) REQUIRE(count(c) == count(Channel::prim_req));
}

TEST_CASE("model and rtl of the machine count the same", "[machine][lockstep]") {
    const Job job = small_job("tetra:3", {16, 12}, format("small"));
    for (const rayclock::Traffic& traffic : {rayclock::Traffic{}, disturbed(3)}) {
        Machine model{job.image, job.frame, job.config, traffic};
        RtlMachine rtl{job.image, job.frame, job.config, traffic};
        while (!model.done()) {
            INFO("cycle " << model.cycle());
            REQUIRE(model.cycle() < 100000);
            model.step();
            rtl.step();
            REQUIRE(model.valid_mask() == rtl.valid_mask());
            REQUIRE(model.fire_mask() == rtl.fire_mask());
        }
        REQUIRE(rtl.done());
        REQUIRE(rtl.cycle() == model.cycle());
        REQUIRE(rtl.counts() == model.counts());
        REQUIRE(rtl.box_tests() == model.box_tests());
    }
}
