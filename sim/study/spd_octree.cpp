// Compares octrees of Haines' scenes, and rays in them, with Havran's published figures.
#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include "sim/judge/reference/reference.hpp"
#include "sim/study/spd.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::spd {

namespace {

/// Inner nodes, leaves, empty leaves, references; then tests for each ray that hits something, and leaves and
/// empty leaves for each ray.
using Figures = std::array<double, 7>;
constexpr std::array<const char*, 7> figure_names{"inner_nodes",         "leaves",        "empty_leaves",
                                                  "references",          "tests_per_hit", "leaves_per_ray",
                                                  "empty_leaves_per_ray"};
constexpr std::size_t of_tree = 4;   // the first four do not depend on rays
constexpr struct { int first, last; } depths{4, 7};

struct PublishedOctree {
    const char* scene;
    int depth;
    Figures figures;
};
/// V. Havran, "Comparison of Octree Traversal Algorithms", 1999, "Octree84-C".
constexpr PublishedOctree published_octrees[] = {
    {"balls:4", 4, {57, 400, 300, 9171, 1787.00, 9.93, 3.67}},
    {"balls:4", 5, {117, 820, 570, 10946, 577.70, 15.39, 9.52}},
    {"balls:4", 6, {304, 2129, 1038, 15611, 209.60, 19.88, 12.54}},
    {"balls:4", 7, {1108, 7757, 2905, 27288, 94.75, 24.71, 16.12}},
    {"gears:4", 4, {265, 1856, 652, 39440, 157.50, 5.71, 2.07}},
    {"gears:4", 5, {1405, 9836, 4088, 85832, 71.38, 8.33, 4.64}},
    {"gears:4", 6, {5837, 40860, 10334, 235526, 44.22, 10.64, 5.66}},
    {"gears:4", 7, {28447, 199130, 28228, 879434, 39.13, 13.20, 6.27}},
    {"mount:6", 4, {232, 1625, 777, 18107, 42.53, 4.92, 1.82}},
    {"mount:6", 5, {1019, 7134, 3060, 34351, 23.72, 6.08, 2.33}},
    {"mount:6", 6, {4716, 33013, 11720, 90456, 18.30, 7.64, 2.83}},
    {"mount:6", 7, {22630, 158411, 45049, 324918, 18.52, 9.44, 3.31}},
    {"teapot:12", 4, {227, 1590, 777, 18845, 184.00, 7.61, 5.14}},
    {"teapot:12", 5, {1001, 7008, 3450, 34072, 78.30, 9.73, 7.07}},
    {"teapot:12", 6, {4100, 28701, 12327, 83551, 45.63, 11.69, 8.61}},
    {"teapot:12", 7, {18066, 126463, 38316, 295865, 40.02, 13.75, 9.53}},
};

/// From the same source: eye rays that hit, and all rays.
constexpr struct PublishedRays {
    const char* scene;
    HavranRays rays;
} ray_table[] = {
    {"balls:4", {263169, 1402297}},
    {"gears:4", {245332, 2845519}},
    {"mount:6", {173685, 1334642}},
    {"teapot:12", {161546, 895744}},
};

constexpr const char* octree_intro = R"(

## Octrees by published rules

V. Havran published the composition of octrees over these scenes, and the work of rays in them ("Comparison
of Octree Traversal Algorithms", 1999, with Ray Tracing News 12(2)). This page builds trees by his rules over
the scenes as given, in double precision (`sim/judge/reference/octree.hpp`), and sends the reference's rays
through them. The model is not involved. `=` after a figure means that it equals his; otherwise its
deviation follows in brackets. His scenes are spheres, cones and polygons. Here cones and cylinders are cut
into triangles, so rings and tree cannot be compared. This page has no published figures for tetra.

His text leaves rules open. They were found from his counts:

- **Boxes.** The box of a polygon is widened by 0.02 on both sides of an axis on which it is thinner than
  0.02. The root is 0.001 larger than the scene on all sides.
- **Camera.** The scene's angle spans 512 spacings between rays, not 511 as in Haines' counts. Then the eye
  rays that hit agree.
- **Lights.** A transmitting surface is lit from its outside only. Its normal is not turned to the side of
  the incoming ray, as it is in Haines' counts and in our pictures.
- **Shadow rays** end at the first test that finds a blocker, wherever it lies in the leaf. They **pass
  through transmitting surfaces**.
- **Tests** are divided by the rays *that hit something*, blocked shadow rays included.

With these rules, the largest deviations over all depths are:

)";

constexpr const char* deviations = R"(
- **mount:** the cause of the differences is unknown. Rounding the coordinates to single precision or to six
  digits does not change them.
- **teapot:** the plane in the middle of the root passes through the centres of lid and bottom. Many
  triangles meet at a point exactly on this plane, which gives too many references. If the point moves off
  the plane, there are too few. His rounded coordinates probably lie on both sides.
- **gears:** tests a hit and the number of rays differ, and the cause is unknown. No common number of hits
  explains the tests of all depths.

)";

/// Returns true if a primitive transmits light.
bool transmits(const Scene& scene, std::uint32_t primitive) {
    const std::size_t triangles = scene.triangles.size(), round = triangles + scene.spheres.size();
    const std::uint32_t material = primitive < triangles ? scene.triangles[primitive].material
                                   : primitive < round   ? scene.spheres[primitive - triangles].material
                                                         : scene.planes[primitive - round].material;
    return scene.materials[material].transmit > 0;
}

/// Appends the deviation from the published value to a count.
std::string with_deviation(const std::string& shown, double mine, double his) {
    return shown + (mine == his ? " (=)" : fmt::format(" ({:+.2f} %)", 100 * (mine / his - 1)));
}

const Figures* published(const std::string& scene, int depth) {
    for (const PublishedOctree& p : published_octrees)
        if (scene == p.scene && depth == p.depth) return &p.figures;
    return nullptr;
}

Figures figures_of(const Octree& tree) {
    const OctreeSize& s = tree.size;
    const OctreeWork& w = tree.work;
    const auto at_least_one = [](std::uint64_t n) { return double(std::max<std::uint64_t>(1, n)); };
    const double rays = at_least_one(w.rays), hits = at_least_one(w.hits);
    return {double(s.inner),        double(s.leaves),        double(s.empty),       double(s.references),
            double(w.tests) / hits, double(w.leaves) / rays, double(w.empty) / rays};
}

/// Returns for each published scene the equal counts of its trees, and the largest deviations from the
/// published figures.
Table deviation_table(const std::vector<Counted>& all) {
    Table table({"scene", "equal counts of trees", "counts of trees", "tests a hit", "leaves a ray",
                 "empty leaves a ray"});
    for (const Counted& c : all) {
        std::size_t equal = 0, compared = 0;
        std::array<double, 4> largest{};   // of trees; then tests, leaves, empty leaves
        for (const Octree& tree : c.octrees) {
            const Figures* his = published(c.scene, tree.depth);
            if (!his) continue;
            const Figures mine = figures_of(tree);
            for (std::size_t i = 0; i < mine.size(); ++i) {
                const double off = mine[i] / (*his)[i] - 1;
                double& most = largest[i < of_tree ? 0 : i - of_tree + 1];
                if (std::abs(off) > std::abs(most)) most = off;
                if (i < of_tree) ++compared, equal += mine[i] == (*his)[i];
            }
        }
        if (compared == 0) continue;
        std::vector<std::string> row{c.scene, fmt::format("{} of {}", equal, compared)};
        for (const double off : largest) row.push_back(fmt::format("{:+.2f} %", 100 * off));
        table.add(row);
    }
    return table;
}

}   // namespace

void count_octrees(Counted& c, const Scene& scene, const Camera& camera, FrameSize size,
                   const Whitted& settings, int threads, const Progress& progress) {
    std::vector<RefOctree> trees;
    for (int depth = depths.first; depth <= depths.last; ++depth) trees.emplace_back(scene, depth);
    std::vector<OctreeWork> work(trees.size());
    std::mutex adding;
    const auto into_trees = [&](const WatchedRay& ray) {
        std::vector<std::uint32_t> blockers = ray.blockers;
        std::erase_if(blockers, [&](std::uint32_t primitive) { return transmits(scene, primitive); });
        std::array<OctreeWork, depths.last - depths.first + 1> own;
        for (std::size_t i = 0; i < trees.size(); ++i) {
            trees[i].walk(ray.from, ray.direction, ray.reach, own[i], blockers);
            own[i].hits = ray.hits;
        }
        const std::lock_guard lock(adding);
        for (std::size_t i = 0; i < trees.size(); ++i) work[i] += own[i];
    };
    const RayCounts rays = Reference(scene)
                               .whitted(camera, size, settings, threads, progress,
                                        {.see = into_trees, .lights_outside_of_glass = true})
                               .rays;
    c.havran = {rays.primary_hits, rays.all()};
    for (std::size_t i = 0; i < trees.size(); ++i)
        c.octrees.push_back({depths.first + int(i), trees[i].size(), work[i]});
    c.objects = trees[0].objects();
}

Table havran_table(const std::vector<Counted>& all) {
    Table table({"scene", "eye rays that hit", "rays in all"});
    for (const Counted& c : all) {
        std::vector<std::string> row{c.scene, grouped(c.havran.primary_hits), grouped(c.havran.all)};
        for (const PublishedRays& p : ray_table)
            if (c.published && c.scene == p.scene) {
                row[1] = with_deviation(row[1], double(c.havran.primary_hits), double(p.rays.primary_hits));
                row[2] = with_deviation(row[2], double(c.havran.all), double(p.rays.all));
            }
        table.add(row);
    }
    return table;
}

std::string octree_page(const std::vector<Counted>& all) {
    return octree_intro + deviation_table(all).markdown() + deviations + havran_table(all).markdown() + "\n" +
           octree_table(all).markdown();
}

Table octree_table(const std::vector<Counted>& all) {
    Table table({"scene", "objects", "depth", "inner nodes", "leaves", "empty leaves", "references",
                 "tests a hit", "leaves a ray", "empty leaves a ray"});
    for (const Counted& c : all)
        for (const Octree& tree : c.octrees) {
            std::vector<std::string> row{c.scene, grouped(c.objects), std::to_string(tree.depth)};
            const Figures mine = figures_of(tree);
            const Figures* his = published(c.scene, tree.depth);
            for (std::size_t i = 0; i < mine.size(); ++i) {
                std::string cell =
                    i < of_tree ? grouped(std::uint64_t(mine[i])) : fmt::format("{:.2f}", mine[i]);
                row.push_back(his ? with_deviation(cell, mine[i], (*his)[i]) : cell);
            }
            table.add(row);
        }
    return table;
}

nlohmann::ordered_json octree_json(const Counted& c) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Octree& tree : c.octrees) {
        const auto named = [](const Figures& figures) {
            nlohmann::ordered_json json;
            for (std::size_t i = 0; i < figures.size(); ++i) json[figure_names[i]] = figures[i];
            return json;
        };
        const Figures* his = published(c.scene, tree.depth);
        list.push_back({{"depth", tree.depth}, {"objects", c.objects}});
        list.back().update(named(figures_of(tree)));
        list.back()["tests_per_ray"] =
            double(tree.work.tests) / double(std::max<std::uint64_t>(1, tree.work.rays));
        list.back()["published"] = his ? named(*his) : nlohmann::ordered_json(nullptr);
    }
    return list;
}

}   // namespace rayclock::spd
