// Streams of rays of many kinds, on every acceleration structure and in three orders.
#include "sim/study/streams.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/compile/compile.hpp"
#include "model/core/settled.hpp"
#include "model/engine/check.hpp"
#include "sim/files/table.hpp"
#include "sim/run/request/request.hpp"
#include "sim/run/stream/make_rays.hpp"
#include "sim/run/stream/stream.hpp"
#include "sim/study/structures/measure_structures.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock::streams {

namespace {

struct StreamKind {
    const char* name;
    RayStreamKind kind;
    int bounce;
};
constexpr StreamKind kinds[]{
    {"camera", RayStreamKind::camera, 1},        {"shadow", RayStreamKind::shadow, 1},
    {"mirror", RayStreamKind::mirror, 1},        {"ambient occlusion", RayStreamKind::ao, 1},
    {"diffuse, 1st", RayStreamKind::diffuse, 1}, {"diffuse, 2nd", RayStreamKind::diffuse, 2},
    {"diffuse, 3rd", RayStreamKind::diffuse, 3}};
constexpr std::pair<const char*, RayOrder> orders[]{
    {"recorded", RayOrder::recorded}, {"Morton", RayOrder::morton}, {"random", RayOrder::random}};

/// A structure's machine, with the scene in its memory.
struct Machinery {
    std::string name;
    Config config;
    MemoryImage image;
};

Row trace(const Scene& scene, const Rays& rays, const Machinery& machine, const Study& study) {
    const Config& config = machine.config;
    const StreamJob stream = make_stream_job(scene, rays, config, machine.image, Outside::clip);
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(stream.job, stream.job.frame, study.threads));
    const FrameResult run = frame_result(frames[0], replay(config, study.khz, frames)[0]);
    const Bound bound = bound_of(config, study.khz, run);
    const auto per_ray = [&](std::uint64_t n) { return double(n) / double(rays.size()); };
    Row row;
    row.rays = rays.size();
    row.cycles = run.cycles;
    row.visits = per_ray(run.visits);
    row.tests = per_ray(run.triangle_tests);
    row.bytes = per_ray(bytes_read(run));
    row.node_hits = cache_account(run, Unit::node_cache).hit_rate();
    row.primitive_hits = cache_account(run, Unit::prim_cache).hit_rate();
    row.bound = bound.unit;
    row.reached = bound.reached;
    row.mrays_per_s = double(rays.size()) * study.khz / 1e3 / double(run.cycles);
    row.wrong = judge_stream(stream, frames[0].trace.hits, study.threads).wrong;
    return row;
}

}   // namespace

std::vector<Row> measure(const Study& study, const Progress& progress) {
    const auto structures = structures::trees(study.base);
    std::vector<Row> rows;
    const std::size_t all = study.scenes.size() * std::size(kinds);
    std::size_t done = 0;
    for (const std::string& name : study.scenes) {
        const Scene scene = ready_scene(name, study.size, progress);
        std::vector<Machinery> machines;
        for (const structures::NamedStructure& structure : structures) {
            const Config config = settled(streaming(structure.config, scene));
            check_config(config, structure.name);
            machines.push_back(
                {structure.name, config, compile_scene(scene, scene.camera->eye, config, progress)});
        }
        for (const StreamKind& kind : kinds) {
            if (progress) progress("streams", done++, all);
            RayStreamPlan plan;
            plan.kind = kind.kind, plan.bounce = kind.bounce, plan.size = study.size;
            const std::vector<StreamRay> made = make_rays(scene, plan, study.base, study.threads);
            if (made.empty()) continue;
            for (const auto& [order_name, order] : orders) {
                std::vector<StreamRay> ordered = made;
                order_rays(ordered, order);
                const ListedRays rays(kind.name, std::move(ordered));
                for (const Machinery& machine : machines) {
                    if (order != RayOrder::recorded && &machine != &machines[0]) continue;
                    Row row = trace(scene, rays, machine, study);
                    row.scene = name, row.kind = kind.name, row.structure = machine.name,
                    row.order = order_name;
                    rows.push_back(std::move(row));
                }
            }
        }
    }
    if (progress) progress("streams", all, all);
    return rows;
}

std::string page(const std::vector<Row>& rows, const Study& study, const std::string& command) {
    std::uint64_t judged = 0, wrong = 0;
    for (const Row& row : rows) judged += row.rays, wrong += row.wrong;
    std::string text = fmt::format(R"(# Streams of rays, measured

Made by `{}`. Do not edit.

A chip with `source=stream` traces rays from memory ([streams.md](../guide/streams.md)). `rayclock rays` made these
streams: it followed the camera rays of {}x{} pictures. The machine is `{}` at {:.0f} MHz, with the memory
{}. The chip `ulx3s` was routed at this clock; a chip for streams was not routed. The exact judge judged
{} rays and found {} wrong.

Every ray of a stream waits for its record of 32 bytes. The column "bytes" includes these bytes.
)",
                                   command, study.size.width, study.size.height, study.base.name,
                                   study.khz / 1e3, name_of(study.base.dram), grouped(judged), wrong);
    std::vector<std::string> structures;
    for (const Row& row : rows)
        if (std::find(structures.begin(), structures.end(), row.structure) == structures.end())
            structures.push_back(row.structure);
    const auto heading = [&](const std::string& scene) { text += fmt::format("\n### {}\n\n", scene); };
    text += fmt::format(
        "\n## The value of coherence\n\nThe structure is {}. Visits, tests, bytes and "
        "cycles are per ray of the stream.\n",
        structures[0]);
    for (const std::string& scene : study.scenes) {
        heading(scene);
        Table table({"rays", "order", "number", "visits", "tests", "node hits", "tri hits", "bytes", "cycles",
                     "Mrays/s", "bound", "reached"},
                    2);
        for (const Row& row : rows)
            if (row.scene == scene && row.structure == structures[0])
                table.add({row.kind, row.order, grouped(row.rays), fmt::format("{:.2f}", row.visits),
                           fmt::format("{:.2f}", row.tests), fmt::format("{:.1f} %", 100 * row.node_hits),
                           fmt::format("{:.1f} %", 100 * row.primitive_hits),
                           fmt::format("{:.1f}", row.bytes), fmt::format("{:.2f}", row.cycles_per_ray()),
                           fmt::format("{:.2f}", row.mrays_per_s), row.bound,
                           fmt::format("{:.0f} %", 100 * row.reached)});
        text += table.markdown();
    }
    text += "\n## Acceleration structures\n\nCycles per ray, in recorded order. The fewest are bold.\n";
    for (const std::string& scene : study.scenes) {
        heading(scene);
        std::vector<std::string> head{"rays"};
        head.insert(head.end(), structures.begin(), structures.end());
        Table table(head);
        for (const StreamKind& kind : kinds) {
            std::vector<double> cycles;
            for (const std::string& structure : structures)
                for (const Row& row : rows)
                    if (row.scene == scene && row.kind == kind.name && row.structure == structure &&
                        row.order == orders[0].first)
                        cycles.push_back(row.cycles_per_ray());
            if (cycles.empty()) continue;
            const double least = *std::min_element(cycles.begin(), cycles.end());
            std::vector<std::string> cells{kind.name};
            for (const double c : cycles)
                cells.push_back(c == least ? fmt::format("**{:.2f}**", c) : fmt::format("{:.2f}", c));
            table.add(std::move(cells));
        }
        text += table.markdown();
    }
    return text;
}

nlohmann::ordered_json rows_json(const std::vector<Row>& rows) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Row& r : rows)
        all.push_back({{"scene", r.scene},
                       {"kind", r.kind},
                       {"structure", r.structure},
                       {"order", r.order},
                       {"rays", r.rays},
                       {"cycles", r.cycles},
                       {"visits", r.visits},
                       {"tests", r.tests},
                       {"bytes", r.bytes},
                       {"node_hits", r.node_hits},
                       {"primitive_hits", r.primitive_hits},
                       {"bound", r.bound},
                       {"reached", r.reached},
                       {"mrays_per_s", r.mrays_per_s},
                       {"wrong", r.wrong}});
    return {{"rows", all}};
}

}   // namespace rayclock::streams
