// rayclock sweep: one scene on many configurations and clocks. Those that differ in timing only share one trace.
#include <algorithm>
#include <atomic>
#include <future>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "sim/app/commands.hpp"
#include "sim/image/image.hpp"
#include "sim/report/accounts.hpp"
#include "sim/report/json.hpp"
#include "sim/report/text.hpp"

namespace rayclock {

namespace {

constexpr std::size_t most_points = 10000;

struct Axis {
    std::string key;                    // a parameter of the configuration, or clock
    std::vector<std::string> values;
};

/// One point of the sweep, and what came of it.
struct Point {
    std::vector<std::string> values;    // [axis]
    Config config;
    int khz = default_khz;
    std::optional<FrameRun> run;
    std::string refused;                // the sentence, if the scene does not fit the configuration
};

int whole(const std::string& text, const std::string& axis) {
    try {
        std::size_t used = 0;
        const int value = std::stoi(text, &used);
        if (used == text.size()) return value;
    } catch (const std::exception&) {
    }
    throw UserError("--axis: '" + text + "' in '" + axis + "' is not a whole number");
}

/// key=1,2,4 or key=12:20:2 (from, to, step).
Axis parse_axis(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) throw UserError("--axis: '" + text + "' is not key=values, for example contexts=16,32,64");
    Axis axis{text.substr(0, equals), {}};
    const std::string list = text.substr(equals + 1);
    if (list.find(':') != std::string::npos) {
        const std::size_t a = list.find(':'), b = list.find(':', a + 1);
        const int from = whole(list.substr(0, a), text), to = whole(list.substr(a + 1, b == std::string::npos ? b : b - a - 1), text);
        const int step = b == std::string::npos ? 1 : whole(list.substr(b + 1), text);
        if (step < 1 || to < from) throw UserError("--axis: '" + list + "' in '" + text + "' is not from:to:step with a step above 0");
        for (long long value = from; value <= to && axis.values.size() <= most_points; value += step) axis.values.push_back(std::to_string(value));
    } else {
        for (std::size_t from = 0; from <= list.size();) {
            const std::size_t comma = std::min(list.find(',', from), list.size());
            axis.values.push_back(list.substr(from, comma - from));
            from = comma + 1;
        }
    }
    return axis;
}

std::vector<Point> make_points(const Options& o, const std::vector<Axis>& axes) {
    std::size_t count = 1;
    for (const Axis& axis : axes) {
        count *= axis.values.size();
        if (count > most_points) throw UserError(fmt::format("--axis: more than {} points", most_points));
    }
    const Config base = load_config(o.config, o.set);
    const int khz = parse_clocks(o.clock)[0];
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        Point point{{}, base, khz, {}, {}};
        std::size_t rest = i;
        for (std::size_t a = axes.size(); a-- > 0; rest /= axes[a].values.size()) {
            const std::string& value = axes[a].values[rest % axes[a].values.size()];
            point.values.insert(point.values.begin(), value);
            if (axes[a].key == "clock") point.khz = parse_clocks(value).at(0);
            else set_parameter(point.config, axes[a].key, value, "--axis");
        }
        check_config(point.config, "--axis");
        points.push_back(std::move(point));
    }
    return points;
}

/// What a trace depends on; configurations that agree here share one.
std::vector<int> trace_key(const Config& c) {
    return {c.coord_bits, c.dir_bits, c.t_frac_bits, c.recip_bits, c.box_bits, c.bary_bits, c.primitive_test, c.node_width, c.leaf_size, c.stack_depth};
}

void run_group(const Options& o, const Scene& scene, FrameSize size, std::vector<Point*>& group, std::atomic<std::size_t>& done, std::size_t all,
               const Progress& progress) {
    std::vector<FrameTrace> frames;
    try {
        const Job job = make_job(scene, *scene.camera, size, group[0]->config);
        frames.push_back(record_frame(job, job.frame, o.threads));
    } catch (const UserError& e) {
        for (Point* point : group) point->refused = e.what();
        done += group.size();
        return;
    }
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    const auto work = [&] {
        for (std::size_t i = next++; i < group.size() && !interrupted(); i = next++) {
            group[i]->run = frame_run(frames[0], replay(group[i]->config, group[i]->khz, frames)[0]);
            const std::lock_guard lock(mutex);
            if (progress) progress("points", ++done, all);
        }
    };
    const std::size_t cores = o.threads > 0 ? std::size_t(o.threads) : std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::future<void>> helpers;
    for (std::size_t i = 1; i < std::min(cores, group.size()); ++i) helpers.push_back(std::async(std::launch::async, work));
    work();
    for (auto& helper : helpers) helper.get();
}

const std::vector<std::string> figures{"cycles", "fps", "cycles_per_ray", "node_hit_rate", "prim_hit_rate", "bytes_per_ray", "bound", "bound_reached"};

std::vector<std::string> figures_of(const Point& p) {
    if (!p.run || p.run->partial) return std::vector<std::string>(figures.size());
    const FrameRun& run = *p.run;
    const Bound bound = bound_of(p.config, p.khz, run);
    const double rays = double(run.pixels);
    return {std::to_string(run.cycles), fmt::format("{:.3f}", per_second(run, p.khz)), fmt::format("{:.3f}", double(run.cycles) / rays),
            fmt::format("{:.4f}", cache_account(run, Unit::node_cache).hit_rate()), fmt::format("{:.4f}", cache_account(run, Unit::prim_cache).hit_rate()),
            fmt::format("{:.2f}", double(bytes_read(run)) / rays), bound.unit, fmt::format("{:.3f}", bound.reached)};
}

} // namespace

int sweep_command(const Options& o) {
    catch_interrupts();
    const FrameSize size = parse_size(o.size);
    std::vector<Axis> axes;
    for (const std::string& text : o.axes) axes.push_back(parse_axis(text));
    std::vector<Point> points = make_points(o, axes);
    check_outputs(o);
    if (!o.output.empty()) check_writable(o.output);
    const Progress progress = terminal_progress();
    const Scene scene = ready_scene(o, size, progress);
    std::map<std::vector<int>, std::vector<Point*>> groups;
    for (Point& point : points) groups[trace_key(point.config)].push_back(&point);
    std::atomic<std::size_t> done = 0;
    for (auto& [key, group] : groups) run_group(o, scene, size, group, done, points.size(), progress);

    std::vector<std::string> head;
    for (const Axis& axis : axes) head.push_back(axis.key);
    head.insert(head.end(), figures.begin(), figures.end());
    Table table(head, 0);
    std::string csv = fmt::format("{}\n", fmt::join(head, ","));
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    bool partial = false;
    for (const Point& point : points) {
        std::vector<std::string> row = point.values;
        const std::vector<std::string> values = figures_of(point);
        row.insert(row.end(), values.begin(), values.end());
        csv += fmt::format("{}\n", fmt::join(row, ","));
        if (!point.refused.empty()) row.push_back(point.refused);
        table.add(row);
        partial = partial || (point.refused.empty() && (!point.run || point.run->partial));
        nlohmann::ordered_json json;
        for (std::size_t a = 0; a < axes.size(); ++a) json[axes[a].key] = point.values[a];
        if (point.run && !point.run->partial) json["clock"] = clock_json(point.config, {point.khz, {*point.run}});
        if (!point.refused.empty()) json["refused"] = point.refused;
        rows.push_back(std::move(json));
    }
    if (o.json != "-") fmt::print("{}, {}x{}: {} points from {} traces\n{}{}", scene.name, size.width, size.height, points.size(), groups.size(), table.text(), partial ? "  PARTIAL: interrupted\n" : "");
    if (!o.output.empty()) write_file(o.output, csv);
    if (!o.json.empty())
        write_file(o.json, nlohmann::ordered_json{{"scene", scene_json(scene)}, {"config", config_json_object(load_config(o.config, o.set))},
                                                  {"frame", {{"width", size.width}, {"height", size.height}}}, {"partial", partial}, {"points", rows}}.dump(2) + "\n");
    return partial ? 1 : 0;
}

} // namespace rayclock
