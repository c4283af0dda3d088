// Formats a sweep as table, CSV and JSON.
#include "sim/explore/sweep/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::sweep {

using nlohmann::ordered_json;

namespace {

/// A column: its name and its cell for a complete point.
struct Column {
    const char* name;
    std::string (*cell)(const Result& r);
    bool has_words = false;
    bool of_picture = false;   ///< empty for a stream of rays and for a sample
};

std::string count_text(const std::optional<std::uint64_t>& n) { return n ? std::to_string(*n) : ""; }
template <int digits> std::string fixed(const ordered_json& figure) {
    return fmt::format("{:.{}f}", figure.get<double>(), digits);
}
std::string percent_other(const FrameError& e) {
    return fmt::format("{:.4f}", 100 * double(e.pixels_other_primitive) / double(e.pixels));
}
std::string decibel_text(double psnr) { return std::isfinite(psnr) ? fmt::format("{:.2f}", psnr) : ""; }
const ordered_json& frame_of(const Result& r) { return r.clock.at("frames").back(); }   // the last frame

const Column columns[] = {
    {"cycles", [](const Result& r) { return fmt::format("{:.0f}", r.cycles()); }},
    {"fps", [](const Result& r) { return fmt::format("{:.3f}", r.fps()); }},
    {"cycles_per_ray", [](const Result& r) { return fmt::format("{:.3f}", r.cycles_per_ray()); }},
    {"node_hit_rate", [](const Result& r) { return fixed<4>(frame_of(r).at("node_hit_rate")); }},
    {"prim_hit_rate", [](const Result& r) { return fixed<4>(frame_of(r).at("prim_hit_rate")); }},
    {"bytes_per_ray", [](const Result& r) { return fixed<2>(r.clock.at("bytes_per_ray")); }},
    {"bound", [](const Result& r) { return r.clock.at("bound").get<std::string>(); }, true},
    {"bound_reached", [](const Result& r) { return fixed<3>(r.clock.at("bound_reached")); }},
    {"pixels_other_primitive",
     [](const Result& r) { return count_text(r.picture->error.pixels_other_primitive); }, false, true},
    {"percent_other_primitive", [](const Result& r) { return percent_other(r.picture->error); }, false, true},
    {"psnr_db", [](const Result& r) { return decibel_text(r.picture->error.psnr_db); }, false, true},
    {"max_abs_depth", [](const Result& r) { return fmt::format("{:.4g}", r.picture->error.max_abs_depth); },
     false, true},
    {"cracks", [](const Result& r) { return count_text(r.picture->cracks); }, false, true},
    {"memory_bytes", [](const Result& r) { return count_text(r.picture->memory_bytes); }},
    {"multipliers", [](const Result& r) { return count_text(r.multipliers); }},
    {"flip_flops", [](const Result& r) { return count_text(r.flip_flops); }},
};

std::string area_text(const Result& r, std::uint64_t (*figure)(const synth::Count&)) {
    return r.area ? std::to_string(figure(*r.area)) : "";
}

/// Columns added later. They follow pareto and knee, so that older columns keep their positions. Their names
/// say which part of the machine a figure describes.
const Column more_columns[] = {
    {"clock_is", [](const Result& r) { return r.clock.value("clock_is", std::string()); }, true},
    {"pipeline_cache_bytes",
     [](const Result& r) { return std::to_string(pipeline_cache_bytes(r.point.config)); }},
    {"chip_cache_bytes", [](const Result& r) { return std::to_string(chip_cache_bytes(r.point.config)); }},
    {"chip_memory_bits", [](const Result& r) { return std::to_string(chip_memory_bits(r.point.config)); }},
    {"chip_luts", [](const Result& r) { return area_text(r, [](const auto& c) { return c.luts(); }); }},
    {"chip_flip_flops", [](const Result& r) { return area_text(r, [](const auto& c) { return c.ff; }); }},
    {"chip_multipliers", [](const Result& r) { return area_text(r, [](const auto& c) { return c.dsp; }); }},
    {"chip_block_rams", [](const Result& r) { return area_text(r, [](const auto& c) { return c.bram; }); }},
    {"rays", [](const Result& r) { return std::to_string(r.picture->rays.all()); }},
    {"frames", [](const Result& r) { return std::to_string(r.frames()); }},
    {"film_cycles", [](const Result& r) { return std::to_string(r.film_cycles()); }},
    {"film_fps", [](const Result& r) { return fmt::format("{:.3f}", r.film_fps()); }},
    {"mrays_per_s", [](const Result& r) { return fmt::format("{:.3f}", r.mrays_per_s()); }},
    {"cycles_half_width",
     [](const Result& r) {
         return r.sampled() ? fixed<0>(r.clock.at("sample").at("cycles_half_width")) : std::string();
     }},
};

std::string cell_text(const Column& column, const Result& r) {
    return r.complete() && (!column.of_picture || r.picture->has_error()) ? column.cell(r) : "";
}

}   // namespace

std::vector<std::string> table_cells(const Result& r, bool pareto, bool knee) {
    std::vector<std::string> all;
    for (const Column& column : columns) all.push_back(cell_text(column, r));
    for (const bool flag : {pareto, knee}) all.emplace_back(!r.complete() ? "" : flag ? "1" : "0");
    for (const Column& column : more_columns) all.push_back(cell_text(column, r));
    return all;
}

namespace {

bool is_knee(const Front& front, std::size_t i) { return front.knee && front.knee->point == i; }

std::vector<std::string> row(const Result& r, const Front& front, std::size_t i) {
    std::vector<std::string> all = r.point.values;
    const std::vector<std::string> figures = table_cells(r, front.pareto[i], is_knee(front, i));
    all.insert(all.end(), figures.begin(), figures.end());
    return all;
}

}   // namespace

std::vector<std::string> column_names(const std::vector<Axis>& axes) {
    std::vector<std::string> names;
    for (const Axis& axis : axes) names.push_back(axis.key);
    for (const Column& column : columns) names.emplace_back(column.name);
    names.insert(names.end(), {"pareto", "knee"});
    for (const Column& column : more_columns) names.emplace_back(column.name);
    return names;
}

bool has_words(const std::vector<Axis>& axes, const std::string& column) {
    for (const Axis& axis : axes)
        if (axis.key == column)
            return std::any_of(axis.values.begin(), axis.values.end(),
                               [](const std::string& value) { return !value_json(value).is_number(); });
    const auto is = [&](const Column& c) { return c.name == column && c.has_words; };
    return std::any_of(std::begin(columns), std::end(columns), is) ||
           std::any_of(std::begin(more_columns), std::end(more_columns), is);
}

bool is_of_picture(const std::string& column) {
    const auto is = [&](const Column& c) { return c.name == column && c.of_picture; };
    return std::any_of(std::begin(columns), std::end(columns), is);
}

std::vector<std::optional<double>> column_values(const std::vector<Axis>& axes,
                                                 const std::vector<Result>& results, const Front& front,
                                                 const std::string& column) {
    const std::vector<std::string> names = column_names(axes);
    const auto at = std::size_t(std::find(names.begin(), names.end(), column) - names.begin());
    std::vector<std::optional<double>> values;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::string cell = row(results[i], front, i).at(at);
        values.push_back(cell.empty() ? std::nullopt : std::optional(value_json(cell).get<double>()));
    }
    return values;
}

std::string name_of(const std::vector<Axis>& axes, const Result& r) {
    std::string name;
    for (std::size_t a = 0; a < axes.size(); ++a)
        name += fmt::format("{}{} {}", a ? ", " : "", axes[a].key, r.point.values[a]);
    return name;
}

std::string csv(const std::vector<Axis>& axes, const std::vector<Result>& results, const Front& front) {
    std::string text = fmt::format("{}\n", fmt::join(column_names(axes), ","));
    for (std::size_t i = 0; i < results.size(); ++i)
        text += fmt::format("{}\n", fmt::join(row(results[i], front, i), ","));
    return text;
}

std::string text(const std::vector<Axis>& axes, const Evaluation& outcome, const Front& front) {
    Table table(column_names(axes), 0);
    std::size_t on_front = 0;
    for (std::size_t i = 0; i < outcome.results.size(); ++i) {
        std::vector<std::string> cells = row(outcome.results[i], front, i);
        if (outcome.results[i].refused()) cells.push_back(outcome.results[i].point.refused);
        table.add(cells);
        on_front += front.pareto[i];
    }
    std::string text = table.text();
    text += fmt::format("  Pareto front of {}{} and {}: {} points",
                        front.has_error ? front.measures[0].key + ", " : "", front.measures[1].key,
                        front.measures[2].key, on_front);
    if (front.knee)
        text += fmt::format("; knee of {} against {}: {}", front.measures[front.plane[0]].key,
                            front.measures[front.plane[1]].key,
                            name_of(axes, outcome.results[front.knee->point]));
    text += "\n";
    if (!front.why.empty()) text += fmt::format("  cost: {}; --cost chooses another\n", front.why);
    if (!outcome.netlist_note.empty()) text += "  " + outcome.netlist_note + "\n";
    return text;
}

std::string far_points(const std::vector<Axis>& axes, const std::vector<Result>& results,
                       const Limits& limits) {
    std::vector<NamedError> pictures;
    for (const Result& r : results)
        if (r.picture && r.picture->has_error()) pictures.push_back({name_of(axes, r), r.picture->error});
    return far_from_reference(limits, pictures, results.size(), "points");
}

ordered_json far_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                      const Limits& limits) {
    ordered_json points = ordered_json::array();
    for (const Result& r : results)
        points.push_back(r.picture && r.picture->has_error()
                             ? ordered_json(!far_from_reference(limits, r.picture->error).empty())
                             : ordered_json(nullptr));
    const std::string sentence = far_points(axes, results, limits);
    ordered_json json = limit_values_json(limits);
    json["far"] = !sentence.empty();
    json["sentence"] = sentence.empty() ? ordered_json(nullptr) : ordered_json(sentence);
    json["points"] = points;
    return json;
}

ordered_json value_json(const std::string& value) {
    const char* const end = value.data() + value.size();
    long long whole = 0;
    if (const auto r = std::from_chars(value.data(), end, whole); r.ec == std::errc{} && r.ptr == end)
        return whole;
    double number = 0;
    if (const auto r = std::from_chars(value.data(), end, number);
        r.ec == std::errc{} && r.ptr == end && std::isfinite(number))
        return number;
    return value;
}

namespace {

/// Returns the value of every axis. Linked parameters also have an entry each.
ordered_json values_json(const std::vector<Axis>& axes, const std::vector<std::string>& values) {
    ordered_json json = ordered_json::object();
    for (std::size_t a = 0; a < axes.size(); ++a) {
        json[axes[a].key] = value_json(values[a]);
        const std::vector<std::string> keys = split(axes[a].key, '/'), parts = split(values[a], '/');
        if (keys.size() < 2) continue;   // a single `dram` value may be a path
        for (std::size_t k = 0; k < keys.size(); ++k) json[keys[k]] = value_json(parts[k]);
    }
    return json;
}

}   // namespace

ordered_json points_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                         const Front& front) {
    const auto count = [](const std::optional<std::uint64_t>& n) {
        return n ? ordered_json(*n) : ordered_json(nullptr);
    };
    ordered_json rows = ordered_json::array();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Result& r = results[i];
        ordered_json json;
        for (std::size_t a = 0; a < axes.size(); ++a) json[axes[a].key] = value_json(r.point.values[a]);
        json["values"] = values_json(axes, r.point.values);   // the axis `clock` has its value only here
        if (r.complete()) {
            json["clock"] = r.clock;
            json["cycles_per_ray"] = r.cycles_per_ray();
            json["node_hit_rate"] = frame_of(r).at("node_hit_rate");
            json["prim_hit_rate"] = frame_of(r).at("prim_hit_rate");
            json["error"] =
                r.picture->has_error() ? error_json(r.picture->error, std::nullopt) : ordered_json(nullptr);
            json["cracks"] = count(r.picture->cracks);
            json["memory_bytes"] = r.picture->memory_bytes;
            json["multipliers"] = count(r.multipliers);
            json["flip_flops"] = count(r.flip_flops);
            json["pareto"] = bool(front.pareto[i]);
            json["knee"] = is_knee(front, i);
            json["pipeline_cache_bytes"] = pipeline_cache_bytes(r.point.config);
            json["chip_cache_bytes"] = chip_cache_bytes(r.point.config);
            json["chip_memory_bits"] = chip_memory_bits(r.point.config);
            json["chip"] = r.area ? synth::count_json(*r.area) : ordered_json(nullptr);
            json["rays"] = rays_json(r.picture->rays);
            json["film"] = {{"frames", r.frames()}, {"cycles", r.film_cycles()}, {"fps", r.film_fps()}};
        }
        if (r.refused()) json["refused"] = r.point.refused;
        rows.push_back(std::move(json));
    }
    return rows;
}

ordered_json knee_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                       const Front& front) {
    if (!front.knee) return nullptr;
    return {{"point", front.knee->point},
            {"values", values_json(axes, results[front.knee->point].point.values)},
            {"of", {front.measures[front.plane[0]].key, front.measures[front.plane[1]].key}},
            {"distance", front.knee->distance}};
}

}   // namespace rayclock::sweep
