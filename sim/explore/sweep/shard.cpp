// Divides a sweep's points into parts, and writes what the parts must agree in.
#include "sim/explore/sweep/shard.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/explore/sweep/cost.hpp"
#include "sim/explore/sweep/key.hpp"

namespace rayclock::sweep {

using nlohmann::ordered_json;

std::vector<std::size_t> points_of(const Shard& shard, const std::vector<Point>& points) {
    const std::size_t parts = std::size_t(shard.of);
    if (parts > points.size())
        throw UserError(fmt::format("--shard: {} points cannot be {} parts", points.size(), parts));
    std::map<std::string, std::size_t> groups;   // by trace, in the order of their first points
    std::vector<std::size_t> group, order;
    for (const Point& point : points)
        group.push_back(groups.try_emplace(trace_format(point.config), groups.size()).first->second);
    for (std::size_t i = 0; i < points.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return group[a] < group[b]; });
    const auto cut = [&](std::size_t part) {
        return order.begin() + std::ptrdiff_t(part * points.size() / parts);
    };
    std::vector<std::size_t> mine(cut(std::size_t(shard.part) - 1), cut(std::size_t(shard.part)));
    std::sort(mine.begin(), mine.end());
    return mine;
}

ordered_json settings_json(const SweepSettings& settings) {
    ordered_json axes = ordered_json::array();
    for (const Axis& axis : settings.axes) axes.push_back({{"key", axis.key}, {"values", axis.values}});
    return {
        {"axes", axes},
        {"clock", settings.clock},
        {"cost", settings.cost},
        {"cache_bytes", settings.cache_bytes ? ordered_json(*settings.cache_bytes) : ordered_json(nullptr)},
        {"netlists", settings.netlists},
        {"picture", settings.picture},
        {"stream", settings.stream},
        {"sample", settings.sample}};
}

ordered_json picture_json(const PictureChoice& choice) {
    const Whitted& w = choice.settings;
    const FramesOptions& frames = choice.frames;
    ordered_json json{
        {"finished", nullptr},      {"frames", frames.frames},
        {"pan", frames.pan},        {"fps", frames.fps ? ordered_json(*frames.fps) : ordered_json(nullptr)},
        {"time", frames.time},      {"uploads", frames.uploads},
        {"rebuild", frames.rebuild}};
    if (choice.finished)
        json["finished"] = {{"depth", w.depth},     {"threshold", w.threshold}, {"aa", w.aa},
                            {"jittered", w.jitter}, {"contrast", w.contrast},   {"seed", w.seed}};
    return json;
}

ordered_json stream_json(const StreamInput& stream) {
    return {{"file", stream.rays().name()}, {"rays", stream.rays().size()}, {"digest", stream.digest()}};
}

ordered_json sample_json(const sample::Ask& ask) { return {{"share", ask.share}, {"seed", ask.seed}}; }

SweepSettings settings_of(const ordered_json& json) {
    SweepSettings settings;
    for (const ordered_json& axis : json.at("axes"))
        settings.axes.push_back(
            {axis.at("key").get<std::string>(), axis.at("values").get<std::vector<std::string>>()});
    settings.clock = json.at("clock").get<std::string>();
    settings.cost = json.at("cost").get<std::string>();
    if (!json.at("cache_bytes").is_null()) settings.cache_bytes = json.at("cache_bytes").get<int>();
    settings.netlists = json.at("netlists").get<bool>();
    settings.picture = json.at("picture");
    settings.stream = json.value("stream", ordered_json());
    settings.sample = json.value("sample", ordered_json());
    return settings;
}

void keep_size(std::vector<Point>& points, const std::optional<int>& bytes) {
    if (!bytes) return;
    std::uint64_t least = ~std::uint64_t(0), most = 0;
    for (const Point& point : points) {
        least = std::min(least, pipeline_cache_bytes(point.config));
        most = std::max(most, pipeline_cache_bytes(point.config));
    }
    std::erase_if(points, [&](const Point& point) {
        return pipeline_cache_bytes(point.config) != std::uint64_t(*bytes);
    });
    if (points.empty())
        throw UserError(
            fmt::format("--cache-bytes: no point's caches hold {} bytes in a pipeline; they hold {} to {}",
                        *bytes, least, most));
}

ordered_json shard_json(const Shard& shard, const std::vector<std::size_t>& points, const Scene& scene) {
    if (shard.is_whole()) return nullptr;
    return {{"part", shard.part},
            {"of", shard.of},
            {"points", points},
            {"scene_digest", scene_digest(scene)},
            {"program", program_stamp()}};
}

}   // namespace rayclock::sweep
