#pragma once
// The fields of payloads, for the words in which a divergence is told.
#include <array>
#include <string>
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
        fields.emplace_back(name, fmt::format("{}", value));
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>& value, int, int count) {
        for (int i = 0; i < count; ++i)
            fields.emplace_back(fmt::format("{}[{}]", name, i), fmt::format("{}", value[std::size_t(i)]));
    }
};

/// The fields in which two payloads differ, as "name=value" of each side. The one that names the unit is that
/// of the ray, on which all others hang, or the first.
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
