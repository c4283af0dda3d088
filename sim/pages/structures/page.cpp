// docs/structures.md from measured figures; the words about each scene are in reasons.cpp.
#include "sim/pages/structures/page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/report/text.hpp"
#include "sim/sweep/front.hpp"
#include "sim/synth/yosys.hpp"

namespace rayclock::structures {

namespace {

std::string per_ray(std::uint64_t n, const Frame& frame) {
    return fmt::format("{:.2f}", double(n) / frame.rays());
}
std::string hits(const FrameRun& run, Unit cache) {
    const CacheAccount account = cache_account(run, cache);
    return account.accesses == 0 ? "-" : fmt::format("{:.1f} %", 100 * account.hit_rate());
}

/// Rays after which building the tree has taken less time than the chip needs for testing all primitives with
/// the rays: one test a cycle and primitive.
double paid_after(const SceneCells& scene, const Cell& cell) {
    const double saved = double(scene.primitives) - cell.camera.cycles_per_ray();
    return saved > 0 ? cell.build * default_khz * 1e3 / saved : HUGE_VAL;
}
std::string whole(double x) { return std::isfinite(x) ? grouped(std::uint64_t(std::ceil(x))) : "never"; }

Table tree_table(const SceneCells& scene) {
    Table table({"structure", "nodes", "depth", "bytes", "references a primitive", "build, s",
                 "pays after rays", "frames of the chip"});
    for (const Cell& c : scene.cells) {
        if (!c.refused.empty()) continue;
        const double build_frames = c.build * c.camera.fps();
        table.add({c.structure, grouped(c.report.nodes), std::to_string(c.report.depth),
                   grouped(c.report.bytes),
                   fmt::format("{:.2f}", double(c.report.references) / double(scene.primitives)),
                   fmt::format("{:.2f}", c.build), whole(paid_after(scene, c)),
                   fmt::format("{:.0f}", build_frames)});
    }
    return table;
}

void add_frame(Table& table, const std::string& what, const Frame& f) {
    table.add({what, per_ray(f.run.visits, f), per_ray(f.run.triangle_tests, f),
               fmt::format("{:.2f}", f.cycles_per_ray()), fmt::format("{:.1f}", f.fps()),
               hits(f.run, Unit::node_cache), hits(f.run, Unit::prim_cache),
               fmt::format("{:.0f}", double(bytes_read(f.run)) / f.rays()),
               fmt::format("{}, {:.0f} %", f.bound.unit, 100 * f.bound.reached),
               fmt::format("{:.0f} %", 100 * f.tri_busy)});
}
Table frame_table(const SceneCells& scene) {
    Table table({"structure", "visits a ray", "tests a ray", "cycles a ray", "fps", "node hits",
                 "primitive hits", "bytes a ray", "bound, reached", "tri busy"});
    for (const Cell& c : scene.cells)
        if (c.refused.empty()) add_frame(table, c.structure, c.camera);
    for (const Cell& c : scene.cells)
        if (c.refused.empty() && c.finished) add_frame(table, c.structure + ", finished", *c.finished);
    return table;
}

Table cache_table(const std::vector<SceneCells>& scenes, const Config& base) {
    std::vector<std::string> head{"scene"};
    for (const int sets : cache_sets())
        head.push_back(fmt::format("{} KB", sets * base.node_ways * base.node_line / 1024));
    Table table(head);
    for (const SceneCells& scene : scenes) {
        std::vector<std::string> row{scene.name};
        for (std::size_t i = 0; i < cache_sets().size(); ++i) {
            std::vector<std::string> all;
            for (const Cell& c : scene.cells)
                if (c.refused.empty()) all.push_back(fmt::format("{:.2f}", c.cached[i]));
            row.push_back(fmt::format("{}", fmt::join(all, " / ")));
        }
        table.add(row);
    }
    return table;
}

/// Geometric mean over the scenes in which all structures were built.
double mean_of(const std::vector<SceneCells>& scenes, std::size_t structure, double (*value)(const Cell&)) {
    double sum = 0;
    int n = 0;
    for (const SceneCells& scene : scenes) {
        if (std::any_of(scene.cells.begin(), scene.cells.end(),
                        [](const Cell& c) { return !c.refused.empty(); }))
            continue;
        sum += std::log(value(scene.cells[structure]));
        ++n;
    }
    return n > 0 ? std::exp(sum / n) : 0;
}
double fps_of(const Cell& c) { return c.camera.fps(); }
double cycles_of(const Cell& c) { return c.camera.cycles_per_ray(); }
double visits_of(const Cell& c) { return double(c.camera.run.visits) / c.camera.rays(); }
double bytes_of(const Cell& c) { return double(c.report.bytes); }

Table area_table(const Figures& figures) {
    Table table({"structure", "LUTs", "FF", "multipliers", "block memories", "fps", "fps per 1,000 LUTs",
                 "fps per multiplier", "visits a ray"});
    for (std::size_t i = 0; i < figures.large[0].cells.size(); ++i) {
        const double fps = mean_of(figures.large, i, fps_of), visits = mean_of(figures.large, i, visits_of);
        std::vector<std::string> row{figures.large[0].cells[i].structure};
        if (figures.counts) {
            const area::Count& c = (*figures.counts)[i];
            for (const std::uint64_t n : {c.luts(), c.ff, c.dsp, c.bram}) row.push_back(grouped(n));
            row.push_back(fmt::format("{:.1f}", fps));
            row.push_back(fmt::format("{:.2f}", 1000 * fps / double(c.luts())));
            row.push_back(fmt::format("{:.2f}", fps / double(c.dsp)));
        } else {
            row.insert(row.end(), {"-", "-", "-", "-", fmt::format("{:.1f}", fps), "-", "-"});
        }
        row.push_back(fmt::format("{:.2f}", visits));
        table.add(row);
    }
    return table;
}

Table list_table(const std::vector<SceneCells>& scenes) {
    Table table({"scene", "primitives", "structure", "tests a ray", "cycles a ray", "tri busy"}, 3);
    for (const SceneCells& scene : scenes)
        for (const Cell& c : scene.cells) {
            if (!c.refused.empty()) continue;
            table.add({scene.name, grouped(scene.primitives), c.structure,
                       per_ray(c.camera.run.triangle_tests, c.camera),
                       fmt::format("{:.2f}", c.camera.cycles_per_ray()),
                       fmt::format("{:.0f} %", 100 * c.camera.tri_busy)});
        }
    return table;
}

constexpr const char* intro = R"(# Structures on one machine

Made by `{}`. Configuration `{}`, {:g} MHz, one frame with cold caches:
{}x{} pixels of camera rays, scenes in triangles; finished pictures (`--depth 4`) have half as many columns
and rows, and true spheres where the scene has them. fps are of these pictures. All structures give the same
picture, bit for bit ([planes.md](planes.md), [boxes.md](boxes.md)).
An octree uses the engine of kd, to the gate ([configurations.md](configurations.md#structures)).

- **build**: processor time of scene compilation, all threads together. It is the only figure that depends on
  the host.
- **pays after rays**: camera rays that a chip with a list of all primitives, one test a cycle, would trace in
  the time that building takes, longer than with the tree. **Frames of the chip**: frames that the chip with
  the tree draws in that time.
- **bound, reached**: the largest of visits, tests (one a cycle each) and what memory can carry, and its share
  of the frame's cycles. **tri busy**: the share of cycles in which an intersection test begins.

)";

constexpr const char* area_words = R"(
Area: one pipeline without shading, unit by unit, as Yosys maps it to an ECP5 ([area.md](area.md) says what is
counted). fps and visits: geometric means of camera rays over the scenes below.
)";

constexpr const char* cache_words = R"(
Cycles a camera ray with node and primitive caches of {} sets, structures in the order {}:

)";

constexpr const char* list_words = R"(
## Against a list

Scenes small enough for a list of all primitives, Whitted's baseline: with it `tri` is busy all the time, and
trees take that away. The octree by the textbook's rule (`straddlers=inner`) stands between them: what lies
across the root's planes is tested by every ray.

)";

}   // namespace

const std::vector<std::string>& large_scenes() {
    static const std::vector<std::string> scenes{"gears:8", "balls:3",   "mount:8", "rings:3",
                                                 "tetra:8", "teapot:12", "tree:8"};
    return scenes;
}
const std::vector<std::string>& small_scenes() {
    static const std::vector<std::string> scenes{"gears:1", "tetra:4", "mount:3"};
    return scenes;
}

std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture) {
    std::vector<std::string> names;
    for (const Kind& kind : trees(study.base)) names.push_back(kind.name);
    std::string text = fmt::format(fmt::runtime(intro), command, study.base.name, default_khz / 1e3,
                                   study.size.width, study.size.height);
    text += "## In short\n\n" + area_table(figures).markdown() + area_words;
    if (figures.counts)
        text += fmt::format("A pipeline that walks a mere list takes {} LUTs and {} multipliers.\n",
                            grouped(figures.counts->back().luts()), grouped(figures.counts->back().dsp));
    if (figures.counts) text += fmt::format("\n![Speed against area and memory]({}.svg)\n", picture);
    text += fmt::format(fmt::runtime(cache_words), fmt::join(cache_sets(), ", "), fmt::join(names, " / "));
    text += cache_table(figures.large, study.base).markdown();
    const bool is_usual = study.base.name == "default" && study.scenes == large_scenes();
    if (is_usual) text += fmt::format("\n{}\n", reason(""));
    for (const SceneCells& scene : figures.large) {
        text += fmt::format("\n## {}\n\n{} primitives.\n\n", scene.name, grouped(scene.primitives));
        text += tree_table(scene).markdown() + "\n" + frame_table(scene).markdown();
        for (const Cell& c : scene.cells)
            if (!c.refused.empty()) text += fmt::format("\n{} is not there: {}.\n", c.structure, c.refused);
        if (const std::string why = reason(scene.name); is_usual && !why.empty()) text += "\n" + why + "\n";
    }
    return text + list_words + list_table(figures.small).markdown();
}

plot::Drawing picture(const Figures& figures, const Study& study) {
    plot::Panel area{"speed against area", "LUTs of a pipeline", "cycles a ray", false, {}},
        memory{"speed against memory", "image, MB", "cycles a ray", false, {}};
    std::vector<sweep::Figures> by_area, by_memory;
    for (std::size_t i = 0; i < figures.large[0].cells.size(); ++i) {
        const std::string& name = figures.large[0].cells[i].structure;
        const double cycles = mean_of(figures.large, i, cycles_of),
                     megabytes = mean_of(figures.large, i, bytes_of) / 1e6;
        const double luts = figures.counts ? double((*figures.counts)[i].luts()) : 0;
        area.marks.push_back({luts, cycles, name, false, false});
        memory.marks.push_back({megabytes, cycles, name, false, false});
        by_area.push_back(std::vector<double>{luts, cycles});
        by_memory.push_back(std::vector<double>{megabytes, cycles});
    }
    const std::vector<bool> front_area = sweep::front(by_area), front_memory = sweep::front(by_memory);
    for (std::size_t i = 0; i < area.marks.size(); ++i) {
        area.marks[i].on_front = front_area[i];
        memory.marks[i].on_front = front_memory[i];
    }
    return plot::chart(
        fmt::format("Structures, configuration {}", study.base.name),
        fmt::format("geometric means over {} scenes; line: the panel's own front", figures.large.size()),
        {area, memory});
}

}   // namespace rayclock::structures
