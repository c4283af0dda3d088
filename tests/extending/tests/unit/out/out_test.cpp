// out: every result comes out once, unchanged and in order, one cycle after it came if nothing stalls it.
#include "model/unit/out/out.hpp"
#include "tests/support/world/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct OutLinks {
    Wire<Result> result;
    Wire<Pixel> pixel;
    std::uint32_t cause = 0;
};

/// Out decides when; the results are stored here.
class OutModel : public OutLinks {
public:
    explicit OutModel(const Config&, int = 1) {}
    void eval() {
        result.ready = out_.ready();
        pixel.offer.reset();
        if (out_.valid()) pixel.offer = Pixel{kept_.front().closest, kept_.front().colour};
        cause = !out_.valid() ? 1 : pixel.ready ? 0 : 2;
    }
    void commit() {
        out_.clock({result.fires(), result.offer ? result.offer->closest.ray : 0}, pixel.fires());
        if (pixel.fires()) kept_.pop_front();
        if (result.fires()) kept_.push_back(*result.offer);
    }

private:
    Out out_;
    std::deque<Result> kept_;
};

class OutRtl : public OutLinks {
public:
    explicit OutRtl(const Config& config, int seed = 1) : links_(config, "rc_out", seed) {
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_in("result", result);
        links_.read_out("pixel", pixel);
        cause = links_.plain("cause");
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_in("result", result);
        links_.drive_out("pixel", pixel);
    }
    RtlLinks links_;
};

/// The required outputs of every cycle follow from the results that came in earlier cycles and are still
/// inside.
template <class Dut> void pass_results(const Config& config, const Pace& pace, unsigned seed) {
    Dut dut{config, int(seed)};
    Draw draw{seed};
    std::deque<Result> inside;
    for (int cycle = 0; cycle < 500; ++cycle) {
        INFO(config.name << ", " << pace.name << ", seed " << seed << ", cycle " << cycle);
        if (!dut.result.offer && !draw.percent(pace.idle_percent))
            dut.result.offer = random_payload<Result>(draw, config);
        dut.pixel.ready = !draw.percent(pace.stall_percent);
        dut.eval();
        REQUIRE(dut.result.ready == (inside.size() < 2));
        REQUIRE(dut.pixel.offer.has_value() == !inside.empty());
        if (dut.pixel.offer) REQUIRE(pack(*dut.pixel.offer, config) == pack(inside.front(), config));
        REQUIRE(dut.cause == (inside.empty() ? 1u : dut.pixel.ready ? 0u : 2u));
        dut.commit();
        if (dut.pixel.fires()) inside.pop_front();
        if (!dut.result.fires()) continue;
        inside.push_back(*dut.result.offer);
        dut.result.offer.reset();
    }
}

}   // namespace

TEMPLATE_TEST_CASE("out keeps results for a cycle", "[out]", OutModel, OutRtl) {
    for (const char* name : {"default", "shading:default"})
        for (unsigned seed = 0; seed < paces.size(); ++seed)
            pass_results<TestType>(format(name), paces[seed], seed + 1);
}
