// Tables and diagram from the descriptions of units and links.
#include "sim/run/gen/description.hpp"

#include <fmt/format.h>

#include "model/machine/links.hpp"
#include "sim/files/table.hpp"

namespace rayclock {

namespace {

/// Returns the structures that an engine walks: "`structure` is kd or octree".
std::string walked_text(Presence when) {
    std::string text;
    for (const Structure structure : tree_structures()) {
        Config config;
        config.structure = structure;
        if (is_there(when, config)) text += (text.empty() ? "`structure` is " : " or ") + name_of(structure);
    }
    return text;
}

std::string when_text(Presence when) {
    switch (when) {
        case Presence::shade: return "`shading`";
        case Presence::textures: return "`textures`";
        case Presence::stream: return "`source=stream`";
        case Presence::hits: return "`source=stream`, `pixel_writes`";
        case Presence::shared_cache: return "`l2_sets` above 0";
        case Presence::nodes: return "`structure` is not none";
        case Presence::instances: return "`levels` is 2";
        case Presence::always: return "always";
        default: return walked_text(when);
    }
}

const char* place_text(UnitPlace place) {
    return place == UnitPlace::pipeline ? "a pipeline"
           : place == UnitPlace::engine ? "a pipeline's engine"
           : place == UnitPlace::shared ? "the chip"
                                        : "(outside the chip)";
}

/// Returns the causes of one kind, in the order of their codes.
std::string causes_text(const UnitInfo& unit, CauseKind kind) {
    std::string text;
    for (const Cause& cause : unit.causes)
        if (cause.kind == kind) text += (text.empty() ? "" : ", ") + std::string(cause.name);
    return text;
}

template <std::size_t i = 0> void add_links(Table& table) {
    if constexpr (i < link_count) {
        const LinkInfo& link = link_infos[i];
        table.add({fmt::format("`{}`", link.name), link.from, link.to,
                   link.flow == Flow::fires ? "always taken" : "valid, ready", when_text(link.when),
                   std::to_string(bits_of<std::tuple_element_t<i, LinkPayloads>>(named_config("default")))});
        add_links<i + 1>(table);
    }
}

}   // namespace

std::string units_table() {
    Table table({"unit", "one in", "exists", "busy with", "starved by", "stalled by"}, Table::words_only);
    for (const UnitInfo& unit : unit_infos)
        table.add({unit.name, place_text(unit.place), when_text(unit.when),
                   causes_text(unit, CauseKind::busy), causes_text(unit, CauseKind::starved),
                   causes_text(unit, CauseKind::stalled)});
    return table.markdown();
}

std::string links_table() {
    Table table({"link", "from", "to", "flow", "exists", "bits in `default`"}, 5);
    add_links(table);
    return table.markdown();
}

std::string links_diagram() {
    std::string text = "```mermaid\nflowchart LR\n";
    for (const LinkInfo& link : link_infos)
        text += fmt::format("  {} {}|{}| {}\n", link.from, link.when == Presence::always ? "-->" : "-.->",
                            link.name, link.to);
    return text + "```\n";
}

}   // namespace rayclock
