#pragma once
// The chips that tests of units select by name.
#include "tests/support/cases/chip_name.hpp"

namespace rayclock::test {

/// `every2:` sets the interval of tri, `lanes2:` the children that box tests at once, and `rays2:` the
/// interval of raygen. `sheared:` selects that primitive test. `shading:` has all primitives, `samples:`
/// several samples per pixel and triangles only.
inline constexpr FormatPrefix format_prefixes[] = {
    {"every", "24", [](Config& c, int cycles) { c.tri_interval = cycles; }},
    {"lanes", "124", [](Config& c, int lanes) { c.box_lanes = lanes; }},
    {"rays", "248", [](Config& c, int cycles) { c.raygen_interval = cycles; }},
    {"fast", "", [](Config& c, int) { make_fast(c); }},
    {"sheared", "", [](Config& c, int) { c.primitive_test = PrimitiveTest::sheared; }},
    {"shading", "", [](Config& c, int) { make_shading(c), c.spheres = c.planes = 1; }},
    {"samples", "", [](Config& c, int) { make_shading(c), c.supersampling = 1; }},
};

/// `default` and `small` are shipped. `narrow` has a narrow lattice and long directions, `wide` the widest
/// lattice. `precise` has reciprocals longer than its slopes. `coarse` has few bits of reciprocal and many of
/// t, which give the longest shifts.
inline Config base_format(const std::string& name) {
    check_base(name, {"default", "small", "narrow", "wide", "precise", "coarse"});
    if (name == "default" || name == "small") return named_config(name);
    Config config;
    config.name = name;
    if (name == "narrow") config.coord_bits = 12, config.dir_bits = 24, config.recip_bits = 15;
    if (name == "wide") config.coord_bits = 20, config.dir_bits = 22, config.recip_bits = 18;
    if (name == "precise") config.coord_bits = 12, config.dir_bits = 15, config.recip_bits = 24;
    if (name == "coarse") config.recip_bits = config.t_frac_bits = 8;
    return config;
}

/// Returns a format for tests of the arithmetic units, with prefixes of `format_prefixes`. Throws
/// std::invalid_argument for a name that is unknown.
inline Config format(const std::string& name) {
    Config config = read_format(name, format_prefixes, base_format);
    check_config(config, name);
    return config;
}

}   // namespace rayclock::test
