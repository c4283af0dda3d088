// Checks configurations, and limits parameters to what the others allow.
#include "model/core/parameters.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "model/base/error.hpp"
#include "model/core/settled.hpp"

namespace rayclock {

// A counter's address has four bits for the pipeline. The last value means the shared units.
constexpr int max_rtl_pipelines = 8;

void check_rtl(const Config& c) {
    if (c.test() != PrimitiveTest::exact && c.test() != PrimitiveTest::sheared)
        throw UserError("primitive_test=" + name_of(c.primitive_test) +
                        " exists in software only; the RTL has exact and sheared");
    if (c.pipelines > max_rtl_pipelines)
        throw UserError("pipelines=" + std::to_string(c.pipelines) +
                        " exists in the model only; the RTL has up to " + std::to_string(max_rtl_pipelines) +
                        ", since registers number no more counters");
}

void check_range(const Parameter& p, int value, const std::string& where) {
    if (std::string_view(p.key).ends_with("_line") && value < line_bytes)
        throw UserError(where + ": " + p.key + " must be at least 64 bytes, a line of memory, not " +
                        std::to_string(value));
    if (value < p.lo || value > p.hi)
        throw UserError(where + ": " + p.key + " must lie in " + std::to_string(p.lo) + ".." +
                        std::to_string(p.hi) + ", not " + std::to_string(value));
    if (p.power_of_two() && (value & (value - 1)) != 0)
        throw UserError(where + ": " + p.key + " must be a power of two, not " + std::to_string(value));
}

namespace {

/// Throws UserError with a sentence about a rule that the configuration breaks.
using Refuse = std::function<void(const std::string& rule)>;

void check_widths(const Config& c, const Refuse& refuse) {
    if (2 * c.coord_bits + c.dir_bits > 62)
        refuse(
            "2 * coord_bits + dir_bits must not exceed 62 (an edge function is one 64-bit integer), and is " +
            std::to_string(2 * c.coord_bits + c.dir_bits));
    // The widest shift of rc_box moves N + R + 3 bits left by at most F + M - 1 - R + (N - box_bits + 1).
    const int widest = c.coord_bits + c.recip_bits + 3 + c.t_frac_bits + c.dir_bits - 1 - c.recip_bits +
                       c.coord_bits - c.box_bits + 1;
    if (widest > 63)
        refuse("coord_bits, dir_bits and t_frac_bits together need " + std::to_string(widest) +
               " bits in box, more than 63");
    if (c.addr_bits < c.least_addr_bits())
        refuse("addr_bits must be at least " + std::to_string(c.least_addr_bits()) +
               " for the sets and lines of the caches, not " + std::to_string(c.addr_bits));
    if (c.is_sheared() && c.dir_bits < c.coord_bits + 2)
        refuse("primitive_test=sheared needs dir_bits of at least coord_bits + 2, " +
               std::to_string(c.coord_bits + 2) +
               " (then no sheared corner is off by more than a lattice step), and dir_bits is " +
               std::to_string(c.dir_bits));
}

void check_structures(const Config& c, const Refuse& refuse) {
    const bool boxes_only = (c.is_list() || c.engine() == Structure::bvh) && c.lower_engine() == c.engine();
    if (!boxes_only && c.test() != PrimitiveTest::exact && !c.is_sheared())
        refuse("structure=" + name_of(c.structure) +
               " needs primitive_test=exact or sheared: only these bound the distance between a hit and its "
               "primitive");
    if (c.has_octree() && c.straddlers == Straddlers::stop)
        refuse(
            "structure=octree has straddlers=leaves or inner: its planes are fixed, and only bsp has stop");
    if (c.is_walked(Structure::bsp) && c.straddlers == Straddlers::inner)
        refuse(
            "structure=bsp has straddlers=leaves or stop: only an octree's nodes keep primitives that a "
            "plane cuts (inner)");
    if (c.has_splits() && (c.has_instances() || (c.test() != PrimitiveTest::exact && !c.is_sheared())))
        refuse(
            "splits=on needs levels=1 and primitive_test=exact or sheared: meshes of instances are not cut, "
            "and other tests do not bound the distance between a hit and its primitive");
    if (c.has_instances() && (c.is_list() || c.test() != PrimitiveTest::exact))
        refuse(
            "levels=2 needs a structure (not none) and primitive_test=exact: how a ray walks instances is "
            "known of these alone");
}

void check_optional_units(const Config& c, const Refuse& refuse) {
    const std::pair<const char*, bool> units[] = {{"spheres", c.spheres},
                                                  {"planes", c.planes},
                                                  {"smooth", c.smooth},
                                                  {"refraction", c.refraction},
                                                  {"supersampling", c.supersampling},
                                                  {"textures", c.textures}};
    for (const auto& [key, is_there] : units)
        if (is_there && !c.shading) refuse(std::string(key) + "=1 needs shading=1");
    if (c.source == RaySource::stream && !c.shading)
        refuse("source=stream needs shading=1: rays that begin anywhere have the format of secondary rays");
    for (const auto& [key, is_there] : {std::pair{"smooth", c.smooth},
                                        {"refraction", c.refraction},
                                        {"supersampling", c.supersampling},
                                        {"textures", c.textures},
                                        {"horizon", c.horizon}})
        if (is_there && c.is_stream())
            refuse(std::string(key) + "=1 needs source=camera: a chip for ray streams has no unit shade");
    if (c.is_stream() && c.scan_out)
        refuse("scan_out=1 needs source=camera: a stream of rays draws no picture");
}

void check_board(const Config& c, const Refuse& refuse) {
    if (c.is_board() && (c.pipelines > 1 || c.dram_channels > 1))
        refuse("dram=board needs pipelines=1 and dram_channels=1");
    if (c.is_board() && (c.is_stream() || !c.scan_out || !c.pixel_writes))
        refuse("dram=board needs source=camera, scan_out=1 and pixel_writes=1: the board has a screen");
}

void check_shading(const Config& c, const Refuse& refuse) {
    if (c.panes > 0 && !(c.planes && c.refraction))
        refuse("panes=" + std::to_string(c.panes) + " needs planes=1 and refraction=1");
    if (c.horizon && (!c.planes || c.origin_bits < far_drop))
        refuse("horizon=1 needs planes=1 and origin_bits of at least " + std::to_string(far_drop));
    if (c.shading && c.test() != PrimitiveTest::exact)
        refuse("shading=1 needs primitive_test=exact: secondary rays are decided exactly");
    if (c.shading && (c.ray_dir_bits() > 31 || c.ray_dir_bits() < c.dir_bits))
        refuse(
            "shadow rays need coord_bits + origin_bits + 1 bits of direction, at least dir_bits and at most "
            "31, and that is " +
            std::to_string(c.ray_dir_bits()) +
            ": --set origin_bits=" + std::to_string(std::clamp(30 - c.coord_bits, 2, 12)));
    if (c.shading && c.origin_bits > c.bary_bits)
        refuse("a secondary ray's origin is made from u and v: origin_bits must not exceed bary_bits, " +
               std::to_string(c.bary_bits) + ", and is " + std::to_string(c.origin_bits));
    if (c.uv_bits() > 32)
        refuse("planes=1 needs bary_bits + " + std::to_string(plane_bits + 1) +
               " bits for u and v, at most 32, and bary_bits is " + std::to_string(c.bary_bits));
    if (c.shading && c.dir_bits + c.t_frac_bits <= c.origin_bits + 1)
        refuse("shading=1 needs dir_bits + t_frac_bits above origin_bits + 1");
    if (c.planes && c.dir_bits > c.origin_width())
        refuse("planes=1 needs dir_bits of at most coord_bits + origin_bits, " +
               std::to_string(c.origin_width()) + ", and dir_bits is " + std::to_string(c.dir_bits));
}

}   // namespace

void check_parameters(const Config& c, const std::string& where) {
    for (const Parameter& p : parameters()) check_range(p, p.get(c), where);
    const Refuse refuse = [&](const std::string& rule) { throw UserError(where + ": " + rule); };
    check_widths(c, refuse);
    check_structures(c, refuse);
    check_optional_units(c, refuse);
    check_board(c, refuse);
    check_shading(c, refuse);
    if (c.t_bits() > 31) refuse("coord_bits + 2 + t_frac_bits must not exceed 31");
}

Config settled(Config config) {
    config.origin_bits = std::max(2, std::min({config.origin_bits, 30 - config.coord_bits, config.bary_bits,
                                               config.dir_bits + config.t_frac_bits - 2}));
    if (!config.planes || !config.refraction) config.panes = 0;
    if (!config.planes || config.origin_bits < far_drop) config.horizon = false;
    return config;
}

}   // namespace rayclock
