// The variants of a configuration, and the table of units.
#include "sim/silicon/area/variants.hpp"

#include <algorithm>

#include "model/core/parameters.hpp"
#include "model/core/settled.hpp"
#include "model/engine/check.hpp"
#include "model/machine/links.hpp"
#include "sim/run/gen/rc_pkg.hpp"

namespace rayclock::area {

namespace {

/// Units of a chip that shades, which only some scenes need.
constexpr const char* further[] = {"spheres", "planes", "smooth", "refraction", "supersampling", "textures"};

bool always(const Config&) { return true; }
bool shades(const Config& c) { return c.has_shade(); }
bool has_textures(const Config& c) { return c.has_textures(); }
bool draws(const Config& c) { return !c.is_stream(); }
bool streams(const Config& c) { return c.is_stream(); }
bool writes_hits(const Config& c) { return c.writes_hits(); }
bool has_l2(const Config& c) { return c.l2_sets > 0; }
bool has_nodes(const Config& c) { return !c.is_list(); }
bool lists(const Config& c) { return c.is_list(); }
bool has_instances(const Config& c) { return c.has_instances(); }

}   // namespace

Config shading_alone(Config c) {
    c.shading = true;
    c.levels = 1;
    for (const char* unit : further) parameter(unit).set(c, 0);
    return settled(c);
}

Config all_units(Config c) {
    c = shading_alone(c);
    for (const char* unit : further) parameter(unit).set(c, 1);
    return c;
}

Config streaming_alone(Config c) {
    c = shading_alone(c);
    c.source = RaySource::stream;
    c.scan_out = c.pixel_writes = false;
    if (c.is_board()) c.dram = Config{}.dram;   // the board has a screen
    return c;
}

std::vector<Variant> variants_of(const Config& base) {
    std::vector<Variant> all{{"hits", base},
                             {"stream", streaming_alone(base)},
                             {"stream, hits in memory", streaming_alone(base), stream_alone},
                             {"shading", shading_alone(base)}};
    Config& hits = all[hits_alone].config;
    hits.shading = hits.horizon = false, hits.panes = 0;
    all[stream_writes].config.pixel_writes = true;
    for (const char* unit : further) {
        parameter(unit).set(all[hits_alone].config, 0);
        all.push_back({std::string("shading, ") + unit, shading_alone(base), shading_only});
        parameter(unit).set(all.back().config, 1);
    }
    all.push_back({"all units", all_units(base), shading_only});
    for (const Variant& variant : all) {
        check_config(variant.config, base.name + " (" + variant.name + ")");
        check_rtl(variant.config);
    }
    return all;
}

const std::vector<UnitRow>& unit_rows() {
    static const std::vector<UnitRow> rows = [] {
        std::vector<UnitRow> all{{"sched", true, always},   {"raygen", true, draws},
                                 {"stream", true, streams}, {"raygen_stream", true, streams},
                                 {"trav", true, has_nodes}, {"node_cache", true, has_nodes}};
        for_each_engine([&]<class E>(E) {
            all.push_back(
                {unit_name(E::structure), true, [](const Config& c) { return c.is_walked(E::structure); }});
        });
        const UnitRow rest[] = {{"none", true, lists},       {"xform", true, has_instances},
                                {"list", true, always},      {"prim_cache", true, always},
                                {"tri", true, always},       {"surf_cache", true, shades},
                                {"tex", true, has_textures}, {"tex_cache", true, has_textures},
                                {"shade", true, shades},     {"dispatch", false, always},
                                {"arbiter", false, always},  {"l2", false, has_l2},
                                {"hits", false, writes_hits}};
        all.insert(all.end(), std::begin(rest), std::end(rest));
        return all;
    }();
    return rows;
}

}   // namespace rayclock::area
