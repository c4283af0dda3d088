#pragma once
// Checks the end of a ray at the inner ports of the RTL, so that a wrong hit is attributed to the right unit.
#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

#include "sim/run/lockstep/driver.hpp"
#include "sim/run/rtl/rtl_machine.hpp"

namespace rayclock {

/// True if the port carries this payload.
template <class P> bool carries(const RcPort& port, const P& payload, const Config& config) {
    const Words words = pack(payload, config);
    return std::memcmp(words.data(), port.data, std::min<std::size_t>(words.size() * 4, port.bytes)) == 0;
}

/// True if the engine's port `done` names this ray.
inline bool names_done(const RtlMachine& rtl, int pipeline, std::uint32_t ray) {
    const RcPort& port = rtl.done_port(pipeline);
    std::uint32_t got = 0;
    std::memcpy(&got, port.data, std::min<std::size_t>(port.bytes, sizeof got));
    return got == ray;
}

/// Checks whether the RTL has the end of a ray at its inner ports. The link carries only the payload.
template <class P>
RayEnd ray_end(const RtlMachine& rtl, int pipeline, const P& payload, const Config& config) {
    if constexpr (std::is_same_v<P, HitOut>) {
        return {names_done(rtl, pipeline, payload.closest.ray),
                carries(rtl.pixel_port(pipeline), Pixel{payload.closest, payload.colour}, config)};
    } else if constexpr (std::is_same_v<P, Closest>) {
        return {names_done(rtl, pipeline, payload.ray), true};
    } else {
        return {};
    }
}

/// Returns the unit's name, with the number of its pipeline if there are several: "tri[1]".
inline std::string located(const char* unit, int pipeline, Link c, const Config& config) {
    if (config.pipelines == 1 || index(c) >= pipeline_links) return unit;
    return std::string(unit) + "[" + std::to_string(pipeline) + "]";
}

}   // namespace rayclock
