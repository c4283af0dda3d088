#pragma once
// Finding the unit that drives a value on a link. Usually this is the unit at the link's beginning. Some
// units forward their input in the same cycle. If the input was wrong, the previous unit caused the
// difference.
#include <algorithm>
#include <string>
#include <string_view>

#include "model/machine/links.hpp"

namespace rayclock {

/// A ray's end goes from the engine (rc_pipeline's `done`) through list to sched (`pixel`) in one cycle.
/// These flags are true if the RTL has the right value at the port.
struct RayEnd {
    bool done_is_right = true, pixel_is_right = true;
};

/// The fields of tri_req that list sends, and those of node requests and xform_req that trav sends. A cache
/// adds the others.
inline constexpr std::string_view sent_by_list[] = {
    "o",    "d",         "axis",       "neg",   "size",     "slope",    "kind",
    "self", "is_inside", "is_partial", "found", "best_num", "best_det", "best_prim"};
inline constexpr std::string_view sent_by_trav[] = {"o",      "d",    "neg",  "recip",  "len",   "along",
                                                    "toward", "kind", "home", "home_o", "home_d"};

/// Returns the name of the unit. `field` is a field of the payload ("t", "o[1]"); empty means the valid
/// signal.
inline const char* driver_of(Link link, std::string_view field, const Config& config, RayEnd end = {}) {
    field = field.substr(0, field.find('['));
    const auto is_one_of = [&](const auto& names) {
        return std::ranges::find(names, field) != std::end(names);
    };
    // The engine reports that a ray is done, list adds its hit, and sched adds its pixel.
    const char* const last = end.done_is_right ? "list" : "trav";
    if (link == Link::closest) return last;
    if (link == Link::hit && !end.pixel_is_right) return config.has_shade() ? "shade" : last;
    // A cache adds the line that it read to the ray that requested it.
    if (link == Link::tri_req && is_one_of(sent_by_list)) return "list";
    if ((is_node_request(link) || link == Link::xform_req) && is_one_of(sent_by_trav)) return "trav";
    return link_infos[index(link)].from;
}

/// Returns the link's name at the unit's ports, without direction: "closest".
inline std::string port_of(Link link, std::string_view unit, const Config& config) {
    if (link == Link::hit && unit == "shade") return "pixel";
    if (link == Link::hit && unit == "list") return "closest";
    if ((link == Link::hit || link == Link::closest) && unit == "trav") return "done";
    if (is_node_request(link) && unit == "trav")
        return link == node_unit(config.engine()).req ? "node_unit_req" : "mesh_req";
    return link_infos[index(link)].name;
}

}   // namespace rayclock
