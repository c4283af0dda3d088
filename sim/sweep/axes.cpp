#include "sim/sweep/axes.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"

namespace rayclock::sweep {

namespace {

int whole(const std::string& text, const std::string& axis) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) return value;
    throw UserError("--axis: " + shown(text) + " in " + shown(axis) + " is not a whole number");
}

std::vector<std::string> range(const std::string& list, const std::string& text) {
    const std::vector<std::string> ends = split(list, ':');
    if (ends.size() > 3)
        throw UserError("--axis: " + shown(list) + " in " + shown(text) + " is not from:to:step");
    const int from = whole(ends[0], text), to = whole(ends[1], text),
              step = ends.size() == 3 ? whole(ends[2], text) : 1;
    if (step < 1 || to < from)
        throw UserError("--axis: " + shown(list) + " in " + shown(text) +
                        " is not from:to:step with a step above 0");
    std::vector<std::string> values;
    for (long long value = from; value <= to && values.size() <= most_points; value += step)
        values.push_back(std::to_string(value));
    return values;
}

/// Parameters that change when things happen, and never what a ray does. Any other one belongs to the format.
constexpr std::array timing_only{"contexts",    "raygen_queue", "box_queue", "tri_queue", "cache_queue",
                                 "pipelines",   "tile_bits",    "node_sets", "node_ways", "node_line",
                                 "node_mshrs",  "prim_sets",    "prim_ways", "prim_line", "prim_mshrs",
                                 "l2_sets",     "l2_ways",      "l2_line",   "l2_mshrs",  "dram",
                                 "mem_latency", "mem_interval", "timing",    "lights",    "bounces",
                                 "shade_queue", "surf_sets",    "surf_ways", "surf_line", "surf_mshrs"};

}   // namespace

Axis parse_axis(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw UserError("--axis: " + shown(text) + " is not key=values, for example contexts=16,32,64");
    const std::string list = text.substr(equals + 1);
    return {text.substr(0, equals),
            list.find(':') != std::string::npos ? range(list, text) : split(list, ',')};
}

std::vector<Point> make_points(const std::vector<Axis>& axes, const Config& base, int khz,
                               int (*clock)(const std::string&)) {
    std::size_t count = 1;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b)
            if (axes[a].key == axes[b].key)
                throw UserError("--axis: " + shown(axes[a].key) + " is given twice");
        count *= axes[a].values.size();
        if (count > most_points) throw UserError(fmt::format("--axis: more than {} points", most_points));
    }
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> legal;   // [axis][value]: points
    for (const Axis& axis : axes) legal.emplace_back(axis.values.size());
    for (std::size_t i = 0; i < count; ++i) {
        Point point{std::vector<std::string>(axes.size()), base, khz, {}};
        std::vector<std::size_t> index(axes.size());
        std::size_t rest = i;
        for (std::size_t a = axes.size(); a-- > 0; rest /= axes[a].values.size()) {
            index[a] = rest % axes[a].values.size();
            const std::string& value = point.values[a] = axes[a].values[index[a]];
            if (axes[a].key == "clock")
                point.khz = clock(value);
            else
                set_parameter(point.config, axes[a].key, value, "--axis");
        }
        try {
            check_config(point.config, "--axis");
            for (std::size_t a = 0; a < axes.size(); ++a) ++legal[a][index[a]];
        } catch (const UserError& e) {
            point.refused = e.what();
        }
        points.push_back(std::move(point));
    }
    for (std::size_t a = 0; a < axes.size(); ++a)
        for (std::size_t v = 0; v < axes[a].values.size(); ++v)
            if (legal[a][v] == 0)
                throw UserError(std::find_if(points.begin(), points.end(), [&](const Point& p) {
                                    return p.values[a] == axes[a].values[v];
                                })->refused);
    return points;
}

std::string trace_format(const Config& config) {
    std::string text;
    for (const Parameter& p : parameters())
        if (std::find(timing_only.begin(), timing_only.end(), std::string_view(p.key)) == timing_only.end())
            text += fmt::format("{}={} ", p.key, value_text(config, p));
    return text;
}

}   // namespace rayclock::sweep
