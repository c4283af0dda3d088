// tri: rays aimed exactly at corners and edges that triangles share. On a closed surface exactly one triangle
// around the corner or edge accepts the ray, for any winding.
#include "tests/support/cases/tri_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// A closed fan of triangles around `hub`. Seen along d, its rim goes around once. Rim points are an even
/// number of steps from the hub, so that the middle of every spoke is a lattice point.
struct Fan {
    Vec3i d{}, hub{};
    std::vector<Vec3i> rim;
};

Fan random_fan(Draw& draw, const Config& config) {
    const std::size_t axis = std::size_t(draw.below(3)), x = (axis + 1) % 3, y = (axis + 2) % 3;
    Fan fan;
    fan.hub = draw.near({}, 1 << (config.coord_bits - 3), config.coord_bits);
    fan.d[axis] = draw.coin() ? 1 : -1;
    if (draw.coin()) {
        fan.d[x] = draw.between(-2, 2);
        fan.d[y] = draw.between(-2, 2);
    }
    // Rim points in order of their angle: corners of a diamond, and on some sides points between them.
    const int size = 1 << draw.below(config.coord_bits - 6);
    const int way[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (std::size_t side = 0; side < 4; ++side) {
        for (int part = 0; part < 3; ++part) {
            if (part > 0 && draw.coin()) continue;
            Vec3i p = fan.hub;
            const auto& from = way[side];
            const auto& to = way[(side + 1) % 4];
            p[x] += 2 * size * ((3 - part) * from[0] + part * to[0]);
            p[y] += 2 * size * ((3 - part) * from[1] + part * to[1]);
            // A shift along the ray does not change what it sees.
            const int lift = 2 * draw.between(-size, size);
            for (std::size_t k = 0; k < 3; ++k) p[k] += lift * fan.d[k];
            fan.rim.push_back(p);
        }
    }
    return fan;
}

/// Returns a request for each triangle of the fan with shuffled corners and winding, for a ray along d that
/// ends at `target`.
std::vector<TriReq> requests_at(const Fan& fan, const Vec3i& target, Draw& draw, const Config& config) {
    std::vector<TriReq> all;
    const int back = 1 << (config.coord_bits - 4);
    for (std::size_t i = 0; i < fan.rim.size(); ++i) {
        std::array<Vec3i, 3> corner{fan.hub, fan.rim[i], fan.rim[(i + 1) % fan.rim.size()]};
        for (std::size_t k = 2; k > 0; --k) std::swap(corner[k], corner[std::size_t(draw.below(int(k) + 1))]);
        TriReq req;
        for (std::size_t k = 0; k < 3; ++k) req.o[k] = target[k] - back * fan.d[k];
        req.d = fan.d;
        req.triangle = {corner[0], corner[1], corner[2], std::uint32_t(i)};
        all.push_back(req);
    }
    return all;
}

int taken(const std::vector<TriRsp>& rsps) {
    int n = 0;
    for (const TriRsp& rsp : rsps) n += rsp.closer != 0;
    return n;
}

}   // namespace

TEMPLATE_TEST_CASE("a ray through a corner or edge hits exactly one triangle around it", "[tri]",
                   Model<TriUnit>, Rtl<TriUnit>) {
    const Config config = format(GENERATE("default", "small", "narrow", "wide"));
    TestType dut{config};
    for (unsigned seed = 1; seed <= 25; ++seed) {
        Draw draw{seed};
        const Fan fan = random_fan(draw, config);
        INFO(config.name << ", seed " << seed);
        const auto hub = requests_at(fan, fan.hub, draw, config);
        const auto at_hub = answers(dut, config, hub);
        REQUIRE(taken(at_hub) == 1);
        for (std::size_t i = 0; i < hub.size(); ++i) judge(hub[i], at_hub[i], config);
        for (const Vec3i& p : fan.rim) {
            Vec3i middle;
            for (std::size_t k = 0; k < 3; ++k) middle[k] = fan.hub[k] + (p[k] - fan.hub[k]) / 2;
            REQUIRE(taken(answers(dut, config, requests_at(fan, middle, draw, config))) == 1);
        }
    }
}

TEMPLATE_TEST_CASE("a corner's weight is exactly one where the ray goes through it", "[tri]", Model<TriUnit>,
                   Rtl<TriUnit>) {
    const Config config = format(GENERATE("default", "narrow"));
    TestType dut{config};
    int seen_u = 0, seen_v = 0;
    for (unsigned seed = 1; seed <= 25; ++seed) {
        Draw draw{seed};
        const Fan fan = random_fan(draw, config);
        const auto requests = requests_at(fan, fan.hub, draw, config);
        const auto rsps = answers(dut, config, requests);
        for (std::size_t i = 0; i < rsps.size(); ++i) {
            if (!rsps[i].closer) continue;
            const std::uint32_t one = 1u << config.bary_bits;
            CAPTURE(seed, i);
            REQUIRE(rsps[i].u == (requests[i].triangle.b == fan.hub ? one : 0));
            REQUIRE(rsps[i].v == (requests[i].triangle.c == fan.hub ? one : 0));
            seen_u += rsps[i].u == one;
            seen_v += rsps[i].v == one;
        }
    }
    REQUIRE((seen_u > 0 && seen_v > 0));
}
