// slant: compares the exits that a ray meets with exact planes.
#include "tests/support/cases/node_unit.hpp"
#include "tests/support/cases/slant_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns a configuration whose queue holds as many answers as slant has cycles.
Config bsp_format(const std::string& name) {
    Config config = format(name);
    config.structure = Structure::bsp;
    config.box_queue = 64;
    return config;
}

/// Returns a case with one plane and a ray that nothing else limits.
SlantCase one_plane(const Vec3i& normal, int at, const Vec3i& o, const Vec3i& d, const Config& config) {
    SlantCase c;
    for (std::size_t k = 0; k < 3; ++k) c.req.node.normal[k] = normal[k];
    c.req.node.at[0] = at;
    c.req.node.kind = {2, 1};
    c.req.node.open = 1;
    c.req.o = o;
    set_direction(c, d, config);
    return c;
}

}   // namespace

TEMPLATE_TEST_CASE("slant loses no exit that the ray meets and keeps few others", "[slant][long]",
                   Model<SlantUnit>, Rtl<SlantUnit>) {
    check_judged<TestType>(bsp_format(GENERATE("default", "shading:narrow")), random_slant_case);
}

TEST_CASE("slant is right for every small plane, origin and direction", "[slant]") {
    Config config = bsp_format("default");
    config.coord_bits = config.dir_bits = 12;
    config.node_width = 2;
    config.shading = GENERATE(0, 1);
    config.origin_bits = 2;
    const int frac = config.origin_frac();
    std::vector<Vec3i> small;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) small.push_back({x, y, z});
    for (const Vec3i& normal :
         {Vec3i{1, 0, 0}, Vec3i{1, 1, 0}, Vec3i{0, 2, -1}, Vec3i{-1, 2, 3}, Vec3i{63, -64, 1}})
        for (const Vec3i& d : small)
            for (const Vec3i& between : small)
                for (int at = -2; at <= 2; ++at) {
                    Vec3i o = between;   // quarters of a step, if the chip shades
                    for (auto& x : o) x += frac > 0 ? 4 : 0;
                    CAPTURE(at, normal[0], normal[1], normal[2], d[0], d[1], d[2], o[0], o[1], o[2]);
                    const SlantCase c = one_plane(normal, at, o, d, config);
                    judge(c, slant(c.req, config), config);
                }
}

TEST_CASE("a ray in a plane is on both of its sides, one from a plane only on the side that it goes to",
          "[slant]") {
    Config config = bsp_format("default");
    config.node_width = 2;
    const auto exits = [&](const Vec3i& o, const Vec3i& d) {
        const NodeAnswer rsp = slant(one_plane({3, -5, 7}, 5, o, d, config).req, config);
        return rsp.inner + 2 * rsp.leaves;   // the upper exit is an inner one
    };
    CHECK(exits({0, -1, 0}, {5, 3, 0}) == 3);
    CHECK(exits({0, -1, 0}, {5, 3, 1}) == 1);
    CHECK(exits({0, -1, 0}, {5, 3, -1}) == 2);
    CHECK(exits({0, 0, 0}, {5, 3, 0}) == 2);   // next to the plane
    CHECK(exits({0, -2, 0}, {5, 3, 0}) == 1);
}

TEST_CASE("model and RTL of slant make the same moves in every cycle", "[slant][lockstep]") {
    check_moves<SlantUnit>(bsp_format(GENERATE("default", "shading:narrow")), {11, 12}, random_slant_case);
}

TEST_CASE("model and RTL of a fast slant make the same moves in every cycle",
          "[slant][lockstep][fast][long]") {
    check_moves<SlantUnit>(bsp_format("fast:default"), {11}, random_slant_case);
}

TEST_CASE("slant is right at both ends of every width", "[slant]") {
    check_answers<SlantUnit>(bsp_format(GENERATE("default", "shading:narrow", "wide")), slant_case_at_ends);
}

TEST_CASE("model and RTL of slant make the same moves at both ends of every width",
          "[slant][lockstep][long]") {
    check_moves_at_ends<SlantUnit>(bsp_format(GENERATE("default", "shading:narrow", "fast:default")),
                                   slant_case_at_ends);
}

TEMPLATE_TEST_CASE("slant answers after exactly its latency, and accepts a request in every cycle", "[slant]",
                   Model<SlantUnit>, Rtl<SlantUnit>) {
    check_pace<TestType>(bsp_format(GENERATE("default", "fast:default")), random_slant_case);
}
