// Octrees of Haines' scenes beside those that Havran published.
#include <algorithm>

#include <fmt/format.h>

#include "sim/pages/spd.hpp"
#include "sim/report/text.hpp"

namespace rayclock::spd {

namespace {

/// Inner nodes, leaves, empty ones, references; tests for each ray that hits something, leaves and empty
/// leaves a ray.
using Figures = std::array<double, 7>;
constexpr std::array<const char*, 7> figure_names{"inner_nodes",         "leaves",        "empty_leaves",
                                                  "references",          "tests_per_hit", "leaves_per_ray",
                                                  "empty_leaves_per_ray"};
constexpr std::size_t of_tree = 4;   // the first of them do not depend on rays

struct Published {
    const char* scene;
    int depth;
    Figures figures;
};
/// V. Havran, "Comparison of Octree Traversal Algorithms", 1999, "Octree84-C".
constexpr Published table[] = {
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

const Figures* published(const std::string& scene, int depth) {
    for (const Published& p : table)
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

}   // namespace

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
                if (his)
                    cell += mine[i] == (*his)[i]
                                ? " (=)"
                                : fmt::format(" ({:+.2f} %)", 100 * (mine[i] / (*his)[i] - 1));
                row.push_back(cell);
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
