#pragma once
// The fields of payloads, for messages about a divergence.
#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// Lists a payload's fields as (name, value).
class ListVisitor {
public:
    std::vector<std::pair<std::string, std::string>> fields;
    template <class T> void operator()(const char* name, const T& value, int) {
        if constexpr (std::is_enum_v<T>)
            fields.emplace_back(name, fmt::format("{}", std::uint32_t(value)));
        else
            fields.emplace_back(name, fmt::format("{}", value));
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>& value, int, int count) {
        for (int i = 0; i < count; ++i)
            fields.emplace_back(fmt::format("{}[{}]", name, i), fmt::format("{}", value[std::size_t(i)]));
    }
};

/// Describes the fields in which two payloads differ, as "name=value" for each side. `d.field`, which
/// identifies the unit, becomes the ray number if it differs, because all other fields depend on it.
/// Otherwise it becomes the first one.
template <class P> void describe(P model, P rtl, const Config& config, Divergence& d) {
    ListVisitor a, b;
    model.fields(a, config);
    rtl.fields(b, config);
    for (std::size_t i = 0; i < a.fields.size(); ++i) {
        if (a.fields[i].second == b.fields[i].second) continue;
        if (d.field.empty() || a.fields[i].first == "ray") d.field = a.fields[i].first;
        d.expected += (d.expected.empty() ? "" : " ") + a.fields[i].first + "=" + a.fields[i].second;
        d.got += (d.got.empty() ? "" : " ") + b.fields[i].first + "=" + b.fields[i].second;
    }
}

/// Returns the ray or request number in a payload, or 0 if it has none.
template <class P> std::uint32_t id_of(const P& p) {
    if constexpr (requires { p.closest; })
        return p.closest.ray;
    else if constexpr (requires { p.ray; })
        return p.ray;
    else if constexpr (requires { p.id; })
        return p.id;
    else
        return 0;
}

}   // namespace rayclock
