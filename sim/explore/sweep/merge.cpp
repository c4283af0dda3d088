// Reads the reports of a sweep's parts, checks that they belong together, and joins them.
#include "sim/explore/sweep/merge.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/scene/camera.hpp"
#include "sim/explore/sweep/table.hpp"
#include "sim/files/input.hpp"
#include "sim/files/json_value.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/stream/make_rays.hpp"

namespace rayclock::sweep {

using nlohmann::ordered_json;

namespace {

struct Part {
    std::string file;
    ordered_json report;
    Shard shard;
};

[[noreturn]] void refuse(const std::string& file, const std::string& sentence) {
    throw UserError(printable(file) + " " + sentence);
}

/// Returns the part of a sweep that a report holds.
Shard shard_of(const JsonValue& in) {
    if (in.raw().is_null()) return {};
    constexpr std::uint64_t most = std::uint64_t(1) << 31;
    const Shard shard{int(in.at("part").whole(most)), int(in.at("of").whole(most))};
    if (shard.of < 1 || shard.part < 1 || shard.part > shard.of)
        in.refuse(fmt::format("is not a part of a sweep: there is no part {}", name_of(shard)));
    for (const char* key : {"scene_digest", "program"})
        if (const auto text = in.find(key)) text->string();
    return shard;
}

/// Checks the form of a file's values by name. Values below a point are checked when it is read.
void check_form(const JsonValue& in) {
    in.at("config").object();
    in.at("scene").at("name").string();
    const JsonValue sweep = in.at("sweep"), axes = sweep.at("axes").array();
    const auto stream = sweep.find("stream");
    if (stream && !stream->raw().is_null()) {
        for (const char* key : {"file", "digest"}) stream->at(key).string();
        if (stream->at("rays").whole(max_rays + 1) == 0) stream->at("rays").expected("above 0");
    } else {
        for (const char* key : {"width", "height"})
            if (in.at("frame").at(key).whole(max_frame_side + 1) == 0)
                in.at("frame").at(key).expected("above 0");
    }
    const auto sample = sweep.find("sample");
    if (sample && !sample->raw().is_null()) sample->at("share").number();
    for (std::size_t a = 0; a < axes.size(); ++a) {
        axes[a].at("key").string();
        for (std::size_t v = 0; v < axes[a].at("values").array().size(); ++v)
            axes[a].at("values")[v].string();
    }
    for (const char* key : {"clock", "cost"}) sweep.at(key).string();
    if (const JsonValue bytes = sweep.at("cache_bytes"); !bytes.raw().is_null())
        bytes.whole(std::uint64_t(1) << 31);
    if (!sweep.at("netlists").raw().is_boolean()) sweep.at("netlists").expected("true or false");
    in.at("points").array();
    if (const JsonValue shard = in.at("shard"); !shard.raw().is_null()) shard.at("points").array();
}

Part read_part(const std::string& file) {
    const std::string text = read_file(file);
    const Json checked = parse_json(file, text);
    for (const char* key : {"scene", "config", "frame", "sweep", "shard", "partial", "points"})
        if (!checked.is_object() || !checked.contains(key))
            refuse(file, fmt::format("is not a report of sweep: it has no key '{}'", key));
    if (checked["partial"] != false)
        refuse(file, "was interrupted before its end; the command that wrote it continues where it stopped");
    const Shard shard = shard_of(JsonValue(checked, file).at("shard"));
    return {file, ordered_json::parse(text), shard};   // parsed again to keep the order of keys
}

/// Throws UserError unless both files agree in everything that determines their figures.
void check_same(const Part& first, const Part& other) {
    const auto differ = [&](const char* what) {
        throw UserError(fmt::format("{} and {} do not belong to one sweep: they differ in {}",
                                    printable(first.file), printable(other.file), what));
    };
    if (first.shard.of != other.shard.of) differ("how many parts there are");
    for (const char* key : {"scene", "config", "frame"})
        if (first.report[key] != other.report[key]) differ(key);
    for (const auto& [key, value] : first.report["sweep"].items())
        if (!other.report["sweep"].is_object() || !other.report["sweep"].contains(key) ||
            other.report["sweep"][key] != value)
            differ(("the request (" + printable(key, 40) + ")").c_str());
    const ordered_json &a = first.report["shard"], &b = other.report["shard"];
    if (a.is_null() || b.is_null()) return;
    if (a.value("scene_digest", "") != b.value("scene_digest", "")) differ("the scene's content");
    if (a.value("program", "") != b.value("program", "")) differ("the program that made them");
}

void check_complete(const std::vector<Part>& parts) {
    std::map<int, std::string> seen;
    for (const Part& part : parts) {
        const auto [at, is_new] = seen.emplace(part.shard.part, part.file);
        if (!is_new)
            throw UserError(fmt::format("{} and {} are both part {}", printable(at->second),
                                        printable(part.file), name_of(part.shard)));
    }
    const int of = parts[0].shard.of, missing = of - int(seen.size());
    if (missing == 0) return;
    constexpr std::size_t most = 20;
    std::vector<std::string> named;
    for (int part = 1; part <= of && named.size() < most; ++part)
        if (!seen.contains(part)) named.push_back(name_of(Shard{part, of}));
    throw UserError(fmt::format("{} of {} parts are missing: {}{}", missing, of, fmt::join(named, ", "),
                                std::size_t(missing) > most ? " and more" : ""));
}

std::optional<std::uint64_t> count_or_none(const ordered_json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<std::uint64_t>());
}

/// Reads a point's figures as written by points_json().
void fill(Result& r, const ordered_json& json, const std::vector<Axis>& axes) {
    for (std::size_t a = 0; a < axes.size(); ++a)
        if (json.at("values").at(axes[a].key) != value_json(r.point.values[a]))
            throw std::runtime_error("another grid");
    if (json.contains("refused")) {
        r.point.refused = json.at("refused").get<std::string>();
        return;
    }
    r.clock = json.at("clock");
    ordered_json picture = json.at("error").is_null() ? ordered_json::object() : json.at("error");
    picture["cracks"] = json.at("cracks");
    picture["memory_bytes"] = json.at("memory_bytes");
    picture["rays"] = json.at("rays");
    r.picture = picture_figures_from_json(picture);
    r.multipliers = count_or_none(json.at("multipliers"));
    r.flip_flops = count_or_none(json.at("flip_flops"));
    if (!json.at("chip").is_null()) r.area = synth::count_of(json.at("chip"));
    table_cells(r, false, false);   // check that a table can read every value
}

void fill(Evaluation& outcome, const Part& part, const std::vector<Axis>& axes) {
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < outcome.results.size(); ++i) mine.push_back(i);
    if (!part.shard.is_whole()) {
        std::vector<Point> points;
        for (const Result& r : outcome.results) points.push_back(r.point);
        mine = points_of(part.shard, points);
        if (part.report["shard"].at("points") != mine) throw std::runtime_error("other points");
    }
    const ordered_json& rows = part.report["points"];
    if (rows.size() != mine.size()) throw std::runtime_error("another number of points");
    for (std::size_t k = 0; k < mine.size(); ++k) fill(outcome.results[mine[k]], rows.at(k), axes);
}

}   // namespace

MergedSweep merge(const std::vector<std::string>& files, int (*clock)(const std::string&)) {
    std::vector<Part> parts;
    for (const std::string& file : files) parts.push_back(read_part(file));
    for (const Part& part : parts) check_same(parts[0], part);
    check_complete(parts);
    for (const Part& part : parts) check_form(JsonValue(Json(part.report), part.file));

    const auto broken = [](const Part& part, const char* why) {
        refuse(part.file, fmt::format("is not a report of sweep: {}", why));
    };
    MergedSweep merged;
    const ordered_json& report = parts[0].report;
    try {
        merged.scene = report["scene"];
        merged.scene.at("name").get<std::string>();
        merged.settings = settings_of(report["sweep"]);
        const ordered_json& frame = report["frame"];
        merged.size = {0, 0};
        if (!merged.settings.is_stream())
            merged.size = {frame.at("width").get<int>(), frame.at("height").get<int>()};
        merged.config = parse_config(parts[0].file, report["config"].dump());
    } catch (const nlohmann::json::exception&) {
        broken(parts[0], "the request of the sweep cannot be read");
    }
    if (merged.settings.axes.empty()) broken(parts[0], "it has no axis");
    // If the clock is each point's routed clock, its figures contain it.
    std::vector<Point> points = make_points(merged.settings.axes, merged.config, 0, clock);
    keep_size(points, merged.settings.cache_bytes);
    for (Point& point : points) merged.outcome.results.push_back({std::move(point), nullptr, {}, {}, {}, {}});
    for (const Part& part : parts) {
        try {
            fill(merged.outcome, part, merged.settings.axes);
        } catch (const nlohmann::json::exception&) {
            broken(part, "a point has not all of its figures");
        } catch (const std::runtime_error& e) {
            broken(part, fmt::format("its points do not match its axes ({})", e.what()).c_str());
        }
    }
    return merged;
}

}   // namespace rayclock::sweep
