// xform: transforms a ray into the space of an instance. Compares model and RTL in every cycle, and judges
// both by exact fractions.
#include <catch2/catch.hpp>

#include "tests/support/oracle/fractions.hpp"
#include "model/engine/check.hpp"
#include "model/unit/xform/xform.hpp"
#include "tests/support/cases/placement_cases.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test::xform_test {

using namespace rayclock;
using namespace rayclock::test;
using oracle::Int;
using oracle::Rational;

namespace {

/// The model behind the interface that it shares with the RTL.
class ModelXform {
public:
    Wire<XformReq> in;
    std::optional<Change> change;

    explicit ModelXform(const Config& config, int = 1)
        : config_(config), pipe_(config.xform_latency() - 1, 2 * config.xform_latency()) {}
    void eval() {
        in.ready = now_ >= opens_;
        change.reset();
        if (pipe_.valid(now_)) change = pipe_.front();
    }
    void commit() {
        if (in.fires()) opens_ = now_ + std::uint64_t(config_.xform_interval);
        pipe_.clock(now_++, change.has_value(), in.fires(),
                    in.fires() ? xform(*in.offer, config_) : Change{});
    }

private:
    Config config_;
    Pipe<Change> pipe_;
    std::uint64_t now_ = 0, opens_ = 0;
};

class RtlXform {
public:
    Wire<XformReq> in;
    std::optional<Change> change;

    explicit RtlXform(const Config& config, int seed = 1) : links_(config, "rc_xform", seed) {
        links_.drive_in("req", in);
        links_.reset();
    }
    void eval() {
        links_.drive_in("req", in);
        links_.settle();
        links_.read_in("req", in);
        links_.read_told("change", change);
    }
    void commit() { links_.clock(); }

private:
    RtlLinks links_;
};

/// Draws a ray and a map that moves it within the mesh's lattice, often to its border. No component of a
/// scene's ray is a least number, which has no opposite.
XformReq request(Draw& draw, const Config& c) {
    XformReq req;
    req.ray = std::uint32_t(draw.natural(c.ray_bits()));
    const auto within = [&](std::int32_t x, int bits) { return std::max(x, 1 - (1 << (bits - 1))); };
    const Vec3i o = draw.vector(c.coord_bits), d = draw.vector(c.dir_bits);
    const std::int64_t one = std::int64_t(1) << c.map_frac(), most = (1 << (c.coord_bits - 1)) - 1;
    req.placement.first = std::uint32_t(draw.natural(c.prim_bits));
    req.placement.root = std::uint32_t(draw.natural(c.addr_bits));
    for (std::size_t k = 0; k < 3; ++k) {
        req.o[k] = within(o[k], c.coord_bits);
        req.d[k] = draw.below(6) == 0 ? 0 : within(d[k], c.dir_bits);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = row_of(draw, c.map_frac());
        std::int64_t sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            req.placement.a[3 * i + k] = row[k], sum += std::int64_t(row[k]) * req.o[k];
        // b is such that the result lies anywhere, on the border, or halfway between two steps.
        const std::int64_t half = draw.below(3) == 0   ? one / 2
                                  : draw.below(3) == 0 ? one / 2 - 1
                                                       : draw.number(c.map_frac());
        std::int64_t target =
            std::int64_t(within(std::int32_t(draw.number(c.coord_bits)), c.coord_bits)) * one + half;
        target = std::clamp(target, -most * one, most * one);
        req.placement.b[i] = std::clamp(target - sum, -most * one, most * one);
        if (draw.below(4) == 0) req.placement.b[i] = 0;
    }
    return req;
}

void judge(const XformReq& req, const Change& got, const Config& c) {
    const Rational unit = oracle::power_of_two(-c.map_frac());
    for (std::size_t i = 0; i < 3; ++i) {
        Int o = req.placement.b[i], d = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            o += Int(req.placement.a[3 * i + k]) * req.o[k];
            d += Int(req.placement.a[3 * i + k]) * req.d[k];
        }
        REQUIRE(Int(got.o[i]) == oracle::nearest(o * unit));
        REQUIRE(Int(got.d[i]) == oracle::nearest(d * unit));
        REQUIRE(int(got.len[i]) == oracle::digits(Int(got.d[i])));
        REQUIRE(
            Int(got.recip[i]) ==
            (got.d[i] == 0 ? Int(1) : oracle::floor(oracle::scaled_reciprocal(Int(got.d[i]), c.recip_bits))));
    }
    REQUIRE(got.ray == req.ray);
    REQUIRE(got.first == req.placement.first);
    REQUIRE(got.root == req.placement.root);
}

Config machine(const std::string& name, int interval) {
    Config config = format(name);
    config.levels = 2;
    config.xform_interval = interval;
    check_config(config, name);
    return config;
}

const std::vector<std::pair<const char*, int>> shapes{
    {"default", 1},      {"small", 2},       {"narrow", 4},   {"wide", 4},
    {"fast:default", 1}, {"fast:narrow", 2}, {"fast:wide", 4}};

}   // namespace

TEMPLATE_TEST_CASE("a ray is moved into an instance's space and rounded once", "[xform][long]", ModelXform,
                   RtlXform) {
    const auto [name, interval] = GENERATE(from_range(shapes));
    const Config config = machine(name, interval);
    TestType dut{config};
    Draw draw{7};
    std::deque<XformReq> waiting;
    std::optional<XformReq> pending;
    int answered = 0;
    for (int cycle = 0; answered < 3000; ++cycle) {
        INFO(config.name << ", interval " << interval << ", cycle " << cycle << ", ray " << answered);
        REQUIRE(cycle < 30000);
        if (!pending && !draw.percent(30)) pending = request(draw, config);
        dut.in.offer = pending;
        dut.eval();
        if (dut.change) {
            REQUIRE_FALSE(waiting.empty());
            judge(waiting.front(), *dut.change, config);
            waiting.pop_front();
            ++answered;
        }
        if (dut.in.fires()) waiting.push_back(*pending), pending.reset();
        dut.commit();
    }
}

TEST_CASE("model and RTL of xform do the same in every cycle", "[xform][long]") {
    const auto [name, interval] = GENERATE(from_range(shapes));
    const Config config = machine(name, interval);
    const int idle = GENERATE(0, 60);
    ModelXform model{config};
    RtlXform rtl{config, 5};
    Draw draw{11};
    std::optional<XformReq> pending;
    int moved = 0;
    for (int cycle = 0; cycle < 2000; ++cycle) {
        INFO(config.name << ", interval " << interval << ", idle " << idle << ", cycle " << cycle);
        if (!pending && !draw.percent(idle)) pending = request(draw, config);
        model.in.offer = rtl.in.offer = pending;
        model.eval();
        rtl.eval();
        REQUIRE(same(model.in, rtl.in, config));
        REQUIRE(same(model.change, rtl.change, config));
        if (model.in.fires()) pending.reset();
        moved += model.change.has_value();
        model.commit();
        rtl.commit();
    }
    REQUIRE(moved > 2000 / (4 * interval));
}

TEMPLATE_TEST_CASE("xform answers after its latency, and accepts a ray at its interval", "[xform]",
                   ModelXform, RtlXform) {
    const auto [name, interval] = GENERATE(from_range(shapes));
    const Config config = machine(name, interval);
    TestType dut{config};
    Draw draw{3};
    const int first = 8;   // nothing arrives before
    for (int cycle = 0; cycle < 200; ++cycle) {
        INFO("interval " << interval << ", cycle " << cycle);
        dut.in.offer.reset();
        if (cycle >= first) dut.in.offer = request(draw, config);
        dut.eval();
        const int since = cycle - first, later = since - config.xform_latency();
        if (since >= 0) REQUIRE(dut.in.ready == (since % interval == 0));
        REQUIRE(dut.change.has_value() == (later >= 0 && later % interval == 0));
        dut.commit();
    }
}

}   // namespace rayclock::test::xform_test
