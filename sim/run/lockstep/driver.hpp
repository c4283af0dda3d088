#pragma once
// Which unit drives a value on a link. Mostly it is the unit at the link's beginning. Some units pass on what
// comes to them in the same cycle; a value that came to them wrong is of the unit before.
#include <algorithm>
#include <string>
#include <string_view>

#include "model/core/links.hpp"

namespace rayclock {

/// Of a ray's end, which goes from the engine (rc_pipeline's `done`) through list to sched (`pixel`) in one
/// cycle, whether the RTL has it there as it should be.
struct RayEnd {
    bool done_is_right = true, pixel_is_right = true;
};

/// Fields of tri_req that list sends, and of node requests and xform_req that trav sends. A cache adds the
/// others.
inline constexpr std::string_view sent_by_list[] = {
    "o",    "d",         "axis",       "neg",   "size",     "slope",    "kind",
    "self", "is_inside", "is_partial", "found", "best_num", "best_det", "best_prim"};
inline constexpr std::string_view sent_by_trav[] = {"o",      "d",    "neg",  "recip",  "len",   "along",
                                                    "toward", "kind", "home", "home_o", "home_d"};

/// `field` is a field of the payload ("t", "o[1]"); empty for the offer.
inline const char* driver_of(Link link, std::string_view field, const Config& config, RayEnd end = {}) {
    field = field.substr(0, field.find('['));
    const auto is_one_of = [&](const auto& names) {
        return std::ranges::find(names, field) != std::end(names);
    };
    // The engine says that a ray is done, list adds its hit, and sched its place in the picture.
    const char* const last = end.done_is_right ? "list" : "trav";
    if (link == Link::closest) return last;
    if (link == Link::hit && !end.pixel_is_right) return config.shading ? "shade" : last;
    // What a cache has read goes on with the ray for which it was.
    if (link == Link::tri_req && is_one_of(sent_by_list)) return "list";
    if ((asks_of_node(link) || link == Link::xform_req) && is_one_of(sent_by_trav)) return "trav";
    return link_infos[index(link)].from;
}

/// What the link is called at the unit's ports, without direction: "closest".
inline std::string port_of(Link link, std::string_view unit, const Config& config) {
    if (link == Link::hit && unit == "shade") return "pixel";
    if (link == Link::hit && unit == "list") return "closest";
    if ((link == Link::hit || link == Link::closest) && unit == "trav") return "done";
    if (asks_of_node(link) && unit == "trav")
        return link == node_unit(config.engine()).req ? "decide_req" : "mesh_req";
    return link_infos[index(link)].name;
}

}   // namespace rayclock
