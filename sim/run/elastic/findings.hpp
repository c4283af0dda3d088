#pragma once
// What elastic verification finds, and texts about payloads.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "model/machine/links.hpp"
#include "sim/run/lockstep/fields.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "sim/run/rtl/rtl_machine.hpp"

namespace rayclock {

/// Counts transfers and differences, and keeps the first difference.
struct Findings {
    std::uint64_t events_compared = 0, value_mismatches = 0;
    std::optional<Divergence> first{};
    /// `make` describes the difference. It is called for the first one only.
    void add(const std::function<Divergence()>& make) {
        ++value_mismatches;
        if (!first) first = make();
    }
};

/// Returns a difference at a unit. `on` is its link, if there is one.
inline Divergence difference(std::uint64_t cycle, std::string unit, std::string link, std::string expected,
                             std::string got) {
    Divergence d;
    d.cycle = cycle;
    d.unit = std::move(unit);
    d.link = std::move(link);
    d.expected = std::move(expected);
    d.got = std::move(got);
    return d;
}
/// Returns a difference on a link without texts.
inline Divergence difference(std::uint64_t cycle, std::string unit, int pipeline, Link c) {
    Divergence d = difference(cycle, std::move(unit), link_infos[index(c)].name, {}, {});
    d.pipeline = pipeline;
    d.on = c;
    return d;
}

/// Calls `see.operator()<Payload>()` for the payload of a link.
template <std::size_t i = 0, class See> decltype(auto) with_payload(Link c, See&& see) {
    if constexpr (i + 1 < link_count) {
        if (index(c) != i) return with_payload<i + 1>(c, std::forward<See>(see));
    }
    return see.template operator()<std::tuple_element_t<i, LinkPayloads>>();
}

/// Lists the fields of a payload except its ray. Lists at most 16 of them.
template <class P> std::string fields_text(P payload, const Config& config) {
    constexpr int most = 16;
    ListVisitor all;
    payload.fields(all, config);
    std::string text;
    int count = 0;
    for (const auto& [name, value] : all.fields) {
        if (name == "ray") continue;
        if (++count > most) return text + " ...";
        text += (text.empty() ? "" : " ") + name + "=" + value;
    }
    return text;
}

/// Returns the ray or the request in the RTL's payload on a link.
inline std::uint32_t rtl_id(const RtlMachine& rtl, int pipeline, Link c, const Config& config) {
    return with_payload(c, [&]<class P>() { return id_of(get_data<P>(rtl.link(pipeline, c), config)); });
}
/// Describes the RTL's payload on a link.
inline std::string rtl_text(const RtlMachine& rtl, int pipeline, Link c, const Config& config) {
    return with_payload(
        c, [&]<class P>() { return fields_text(get_data<P>(rtl.link(pipeline, c), config), config); });
}

/// Calls `see(link)` for each link of a mask.
template <class See> void each_link(LinkMask mask, See&& see) {
    for (; mask; mask &= mask - 1) see(Link(std::countr_zero(mask)));
}

}   // namespace rayclock
