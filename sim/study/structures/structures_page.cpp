// Writes docs/measured/structures.md from measurements. The comparisons and the causes are in reasons.cpp.
#include "sim/study/structures/structures_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/explore/sweep/front.hpp"
#include "sim/silicon/synth/yosys.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::structures {

namespace {

std::string per_ray(std::uint64_t n, const Frame& frame) {
    return fmt::format("{:.2f}", double(n) / frame.rays());
}
std::string hits(const FrameResult& run, Unit cache) {
    const CacheAccount account = cache_account(run, cache);
    return account.accesses == 0 ? "-" : fmt::format("{:.1f} %", 100 * account.hit_rate());
}

/// Returns the number of rays at which building the tree pays off. Beyond it the build took less time than
/// testing all primitives with these rays on the chip, at one test per cycle and primitive.
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

/// Returns the pictures of a scene for the note below its table.
std::vector<NamedError> pictures_of(const SceneCells& scene) {
    std::vector<NamedError> pictures;
    for (const Cell& c : scene.cells) {
        if (!c.refused.empty()) continue;
        pictures.push_back({c.structure, c.camera.error});
        if (c.finished) pictures.push_back({c.structure + ", finished", c.finished->error});
    }
    return pictures;
}
std::string far_note(const Limits& limits, const std::vector<NamedError>& pictures) {
    const std::string far = far_from_reference(limits, pictures, pictures.size(), "pictures");
    return far.empty() ? "" : "\n† " + far + "\n";
}
const char* mark_of(const Limits& limits, const Frame& frame) {
    return far_from_reference(limits, frame.error).empty() ? "" : " †";
}

void add_frame(Table& table, const std::string& what, const Frame& f, const area::Count* area,
               const Limits& limits) {
    std::vector<std::string> row{what + mark_of(limits, f),
                                 per_ray(f.run.visits, f),
                                 per_ray(f.run.triangle_tests, f),
                                 fmt::format("{:.2f}", f.cycles_per_ray()),
                                 fmt::format("{:.1f}", f.fps()),
                                 hits(f.run, Unit::node_cache),
                                 hits(f.run, Unit::prim_cache),
                                 fmt::format("{:.0f}", double(bytes_read(f.run)) / f.rays()),
                                 fmt::format("{}, {:.0f} %", f.bound.unit, 100 * f.bound.reached),
                                 fmt::format("{:.0f} %", 100 * f.tri_busy)};
    if (area) {
        row.push_back(fmt::format("{:.2f}", 1000 * f.fps() / double(area->luts())));
        row.push_back(fmt::format("{:.2f}", f.fps() / double(area->dsp)));
    }
    table.add(row);
}
Table frame_table(const Figures& figures, const SceneCells& scene, const Limits& limits) {
    std::vector<std::string> head{"structure", "visits a ray",   "tests a ray", "cycles a ray",   "fps",
                                  "node hits", "primitive hits", "bytes a ray", "bound, reached", "tri busy"};
    if (figures.areas) head.insert(head.end(), {"fps per 1,000 LUTs", "fps per multiplier"});
    Table table(head);
    for (const bool finished : {false, true})
        for (std::size_t i = 0; i < scene.cells.size(); ++i) {
            const Cell& c = scene.cells[i];
            if (!c.refused.empty() || (finished && !c.finished)) continue;
            add_frame(table, finished ? c.structure + ", finished" : c.structure,
                      finished ? *c.finished : c.camera, area_of(figures, scene, i, finished), limits);
        }
    return table;
}

double finished_fps_of(const Cell& c) { return c.finished ? c.finished->fps() : 0; }

void add_area(std::vector<std::string>& row, const area::Count* c, double fps) {
    if (c) {
        for (const std::uint64_t n : {c->luts(), c->ff, c->dsp, c->bram}) row.push_back(grouped(n));
        row.push_back(fmt::format("{:.1f}", fps));
        row.push_back(fmt::format("{:.2f}", 1000 * fps / double(c->luts())));
        row.push_back(fmt::format("{:.2f}", fps / double(c->dsp)));
    } else {
        row.insert(row.end(), {"-", "-", "-", "-", fmt::format("{:.1f}", fps), "-", "-"});
    }
}
Table area_table(const Figures& figures, bool finished) {
    Table table({"structure", "LUTs", "FF", "multipliers", "block memories", "fps", "fps per 1,000 LUTs",
                 "fps per multiplier"});
    const std::vector<SceneCells> scenes = finished ? figures.large : triangle_scenes(figures);
    for (std::size_t i = 0; i < figures.large[0].cells.size(); ++i) {
        std::vector<std::string> row{figures.large[0].cells[i].structure};
        const Areas* areas = figures.areas ? &(*figures.areas)[i] : nullptr;
        add_area(row,
                 !areas     ? nullptr
                 : finished ? &areas->all
                            : &areas->hits,
                 mean_of(scenes, i, finished ? finished_fps_of : fps_of));
        table.add(row);
    }
    return table;
}

Table list_table(const std::vector<SceneCells>& scenes, const Limits& limits) {
    Table table({"scene", "primitives", "structure", "tests a ray", "cycles a ray", "tri busy"}, 3);
    for (const SceneCells& scene : scenes)
        for (const Cell& c : scene.cells) {
            if (!c.refused.empty()) continue;
            table.add({scene.name, grouped(scene.primitives), c.structure + mark_of(limits, c.camera),
                       per_ray(c.camera.run.triangle_tests, c.camera),
                       fmt::format("{:.2f}", c.camera.cycles_per_ray()),
                       fmt::format("{:.0f} %", 100 * c.camera.tri_busy)});
        }
    return table;
}

constexpr const char* intro = R"(# Structures on one machine

Made by `{}`. Configuration `{}`, {:g} MHz, one frame with cold caches. Camera rays: {}x{}
pixels, scenes in triangles unless a scene's heading says otherwise. Finished pictures (`--depth 4`): half as many
columns and rows, and true spheres where the scene has them. fps are frames a second of these pictures.

All structures give the same picture, bit for bit; the [documentation](../README.md) has a page for each. An octree
uses exactly the gates of kd ([configurations.md](../guide/configurations.md#structures)). "bvh, splits" is a bvh that may
cut primitives (`splits=on`). The `box_queue` of each structure is longer than the latency of its unit.

- **build**: processor time of scene compilation, all threads together. It is the only figure that depends on
  the host.
- **pays after rays**: the number of camera rays from which building the tree pays off. With fewer rays, a chip
  that tests a list of all primitives, one test a cycle, is done earlier than build and tree together.
  **Frames of the chip**: frames that the chip with the tree draws in the build time.
- A dagger (†) marks a picture beyond a limit ([report.md](../guide/report.md#limits)); the sentence below the table
  names the farthest.
- **bound, reached**: the largest of visits, tests (one a cycle each) and the transfers of the memory, and its
  share of the frame's cycles. **tri busy**: the share of cycles in which an intersection test begins.

)";

constexpr const char* area_words = R"(
Area: one pipeline, counted unit by unit as Yosys maps it to an ECP5 ([area.md](area.md)). The table above is for
camera rays: a pipeline that finds hits of triangles, and the geometric mean of fps over the scenes in triangles.
The table below is for finished pictures: a pipeline with every unit that they may need, and the mean over all
scenes.

)";

constexpr const char* around_words = R"(
The structure with the fewest cycles a camera ray, for other memories and cache sizes (KB of each cache). A cell
names the structure, its cycles, and how many times as many cycles the next structure needs. "bvh, splits" is left
out, since it is a way to build a bvh.

)";

constexpr const char* ratio_words = R"(
Camera rays, divided by the same figure of bvh:

)";

constexpr const char* list_words = R"(
## Against a list

These scenes are small enough for a list of all primitives, Whitted's baseline. With the list `tri` is almost
always busy. Trees avoid most of these tests. The textbook's octree (`straddlers=inner`) lies between trees and
list: every ray tests the primitives that straddle the root's planes.

)";

}   // namespace

const std::vector<std::string>& large_scenes() {
    static const std::vector<std::string> scenes{"gears:8", "balls:3", "balls:4",   "mount:8",
                                                 "rings:3", "tetra:8", "teapot:12", "tree:8"};
    return scenes;
}
const std::vector<std::string>& small_scenes() {
    static const std::vector<std::string> scenes{"gears:1", "tetra:4", "mount:3"};
    return scenes;
}

std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture) {
    std::string text = fmt::format(fmt::runtime(intro), command, study.base.name, default_khz / 1e3,
                                   study.size.width, study.size.height);
    text += "## In short\n\n" + area_table(figures, false).markdown() + area_words +
            area_table(figures, true).markdown();
    if (figures.areas) {
        const area::Count& list = figures.areas->back().hits;
        text += fmt::format("\nA pipeline that walks a list takes {} LUTs and {} multipliers.\n",
                            grouped(list.luts()), grouped(list.dsp));
        text += fmt::format("\n![Speed against area and memory]({}.svg)\n", picture);
    }
    text += around_words + best_table(figures.large, study.base);
    const auto& usual = large_scenes();   // other scenes may follow these
    const bool is_usual = study.base.name == "default" && study.scenes.size() >= usual.size() &&
                          std::equal(usual.begin(), usual.end(), study.scenes.begin());
    if (is_usual) text += "\n" + summary(figures) + "\n";
    for (const SceneCells& scene : figures.large) {
        text += fmt::format("\n## {}\n\n{} primitives{}.\n\n", printable(scene.name),
                            grouped(scene.primitives), scene.is_round ? ", true spheres" : "");
        text += tree_table(scene).markdown() + "\n" + frame_table(figures, scene, study.limits).markdown() +
                far_note(study.limits, pictures_of(scene));
        if (const std::string ratios = ratio_table(scene); !ratios.empty()) text += ratio_words + ratios;
        for (const Cell& c : scene.cells)
            if (!c.refused.empty()) text += fmt::format("\n{} is missing: {}.\n", c.structure, c.refused);
        if (const std::string why = cause(scene.name); is_usual && !why.empty()) text += "\n" + why + "\n";
    }
    std::vector<NamedError> small;
    for (const SceneCells& scene : figures.small)
        for (const NamedError& picture : pictures_of(scene))
            small.push_back({fmt::format("{}, {}", scene.name, picture.name), picture.error});
    return text + list_words + list_table(figures.small, study.limits).markdown() +
           far_note(study.limits, small);
}

plot::Drawing picture(const Figures& figures, const Study& study) {
    plot::Panel area{"speed against area", "LUTs of a pipeline", "cycles a ray", false, {}},
        memory{"speed against memory", "image, MB", "cycles a ray", false, {}};
    std::vector<sweep::Figures> by_area, by_memory;
    const std::vector<SceneCells> scenes = triangle_scenes(figures);
    for (std::size_t i = 0; i < figures.large[0].cells.size(); ++i) {
        const std::string& name = figures.large[0].cells[i].structure;
        const double cycles = mean_of(scenes, i, cycles_of), megabytes = mean_of(scenes, i, bytes_of) / 1e6;
        const double luts = figures.areas ? double((*figures.areas)[i].hits.luts()) : 0;
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
        fmt::format("geometric means over {} scenes; line: the panel's own front", scenes.size()),
        {area, memory});
}

}   // namespace rayclock::structures
