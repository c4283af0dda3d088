// Parses axes and shards, and builds the grid of points.
#include "sim/explore/sweep/axes.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "model/core/parameters.hpp"
#include "model/core/settled.hpp"
#include "model/engine/check.hpp"
#include "sim/run/memory/memory_file.hpp"

namespace rayclock::sweep {

namespace {

std::optional<int> whole(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) return value;
    return std::nullopt;
}

int whole(const std::string& text, const std::string& axis) {
    if (const auto value = whole(text)) return *value;
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
    for (long long value = from; value <= to && values.size() <= max_points; value += step)
        values.push_back(std::to_string(value));
    return values;
}

/// One value for each of the linked parameters. A memory alone may be the path of its file.
std::vector<std::string> values_of(const std::string& value, const std::string& key) {
    return key == "dram" ? std::vector<std::string>{value} : split(value, '/');
}

}   // namespace

Axis parse_axis(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw UserError("--axis: " + shown(text) + " is not key=values, for example contexts=16,32,64");
    const std::string key = text.substr(0, equals), list = text.substr(equals + 1);
    const std::size_t linked = split(key, '/').size();
    if (linked > 1 && list.find(':') != std::string::npos)
        throw UserError("--axis: linked parameters have no range, as in " + shown(text) +
                        "; name the values, for example node_sets/prim_sets=32/64,64/32");
    const Axis axis{key, list.find(':') != std::string::npos ? range(list, text) : split(list, ',')};
    for (const std::string& value : axis.values)
        if (const std::size_t given = values_of(value, axis.key).size(); given != linked)
            throw UserError(fmt::format("--axis: {} in {} has {} values for {} parameters", shown(value),
                                        shown(text), given, linked));
    return axis;
}

namespace {

/// Sets one point's value of an axis, which may set several parameters.
void set(Point& point, const Axis& axis, const std::string& value, int (*clock)(const std::string&)) {
    const std::vector<std::string> keys = split(axis.key, '/'), values = values_of(value, axis.key);
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (keys[k] == "clock")
            point.khz = clock(values[k]);
        else
            set_value(point.config, keys[k], values[k], "--axis");
}

/// Returns every parameter that an axis changes. Throws UserError if two axes change the same one.
std::vector<std::string> keys_of(const std::vector<Axis>& axes) {
    std::vector<std::string> keys;
    for (const Axis& axis : axes)
        for (const std::string& key : split(axis.key, '/')) {
            if (std::find(keys.begin(), keys.end(), key) != keys.end())
                throw UserError("--axis: " + shown(key) + " is given twice");
            if (key == "shading")
                throw UserError(
                    "--axis: shading changes the picture, so it needs two sweeps: one without and one with "
                    "--depth");
            if (key == "source")
                throw UserError("--axis: source=stream has no camera, and a sweep draws what a camera sees");
            keys.push_back(key);
        }
    return keys;
}

}   // namespace

std::vector<Point> make_points(const std::vector<Axis>& axes, const Config& base, int khz,
                               int (*clock)(const std::string&)) {
    std::size_t count = 1;
    const std::vector<std::string> keys = keys_of(axes);
    const auto is_axis = [&](const char* key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    for (const Axis& axis : axes) {
        count *= axis.values.size();
        if (count > max_points) throw UserError(fmt::format("--axis: more than {} points", max_points));
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
            point.values[a] = axes[a].values[index[a]];
            set(point, axes[a], point.values[a], clock);
        }
        if (base.shading) {   // the same adjustment as fitted_config()
            const Config fitted = settled(point.config);
            if (!is_axis("origin_bits")) point.config.origin_bits = fitted.origin_bits;
            if (!is_axis("panes")) point.config.panes = fitted.panes;
            if (!is_axis("horizon")) point.config.horizon = fitted.horizon;
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
        if (!p.timing_only) text += fmt::format("{}={} ", p.key, value_text(config, p));
    return text;
}

Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto part = whole(text.substr(0, slash));
    const auto of = slash == text.npos ? std::nullopt : whole(text.substr(slash + 1));
    if (!part || !of) throw UserError("--shard: " + shown(text) + " is not PART/PARTS, for example 2/4");
    if (*of < 1 || *part < 1 || *part > *of)
        throw UserError(
            fmt::format("--shard: there is no part {} of {}; parts are counted from 1", *part, *of));
    return {*part, *of};
}

std::string name_of(const Shard& shard) { return fmt::format("{}/{}", shard.part, shard.of); }

}   // namespace rayclock::sweep
