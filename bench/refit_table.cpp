// Measures how long a host takes to refit and to rebuild a tree, and how refits degrade it: the tables of
// docs/machine/motion.md, Trees that follow.
//
// rc_refit prints them. Times are the least of several runs on one thread.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <glm/vec3.hpp>

#include "model/base/stopwatch.hpp"
#include "model/compile/frame.hpp"
#include "model/compile/lattice.hpp"
#include "model/compile/refit/refit.hpp"
#include "model/compile/surfaces.hpp"
#include "model/trace/record.hpp"
#include "model/trace/trace.hpp"

using namespace rayclock;

namespace {

/// Returns a waving tube of n by n squares about the z axis, twisted by `degrees` from end to end.
Scene tube(int n, double degrees) {
    Scene scene;
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k < n; ++k) {
            const double along = 2.0 * i / n - 1,
                         angle = (360.0 * k / n + degrees * along) * std::numbers::pi / 180,
                         far = 0.4 + 0.3 * std::cos(2 * (360.0 * k / n) * std::numbers::pi / 180);
            scene.vertices.emplace_back(far * std::cos(angle) + 0.0005 * degrees * along * along,
                                        far * std::sin(angle), along);
        }
    const auto at = [n](int i, int k) { return std::uint32_t(i * n + k % n); };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            scene.triangles.push_back({{at(i, k), at(i, k + 1), at(i + 1, k + 1)}, 0});
            scene.triangles.push_back({{at(i, k), at(i + 1, k + 1), at(i + 1, k)}, 0});
        }
    return scene;
}

std::vector<PrimData> prims_of(const Scene& scene, const Lattice& lattice) {
    std::vector<PrimData> prims;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        prims.push_back(snap_primitive(scene, lattice, i));
    return prims;
}

const Camera camera{{2.5, 1.5, 1}, {0, 0, 0}, {0, 0, 1}, 45};

Lattice lattice_of(const Scene& scene, const Config& config) {
    Scene room = scene;
    room.vertices.push_back({1.5, 1.5, 1});
    room.vertices.push_back({-1.5, -1.5, -1});
    const auto last = std::uint32_t(room.vertices.size() - 1);
    room.triangles.push_back({{last - 1, last, last}, 0});
    return fit_lattice(room, camera.eye, config.coord_bits);
}

struct Walk {
    std::uint64_t visits = 0, tests = 0;
};
Walk walk_of(const Refit& tree, const Lattice& lattice, const Config& config) {
    MemoryImage image;
    image.lattice = lattice;
    image.words.resize(tree.report().bytes / 4);
    tree.write(0, false, image.words.data(), image.lines());
    const Trace trace = record_trace(image, make_frame(camera, {256, 192}, image, config), config);
    return {trace.visits, trace.triangle_tests};
}

void times(const Config& config) {
    fmt::print("| triangles | rebuilt, ms | refitted, ms | ratio |\n|---|---|---|---|\n");
    for (const int n : {24, 75, 240, 480}) {
        const Scene rest = tube(n, 0);
        const Lattice lattice = lattice_of(rest, config);
        const std::vector<PrimData> before = prims_of(rest, lattice), after = prims_of(tube(n, 9), lattice);
        std::vector<std::uint32_t> words(16 * Refit::max_lines(before.size()));
        double least[2] = {1e9, 1e9};
        for (int run = 0; run < (n < 200 ? 9 : 3); ++run)
            for (const bool is_built : {true, false}) {
                Refit tree(config, "tube");
                tree.follow(before, 0);
                std::vector<PrimData> prims = after;
                const Stopwatch watch;
                tree.follow(std::move(prims), is_built ? 0 : 1e9);
                tree.write(0, false, words.data(), std::uint32_t(tree.report().bytes / 64));
                double& own = least[is_built ? 0 : 1];
                own = std::min(own, watch.seconds());
            }
        fmt::print("| {} | {:.2f} | {:.2f} | {:.1f} |\n", before.size(), 1e3 * least[0], 1e3 * least[1],
                   least[0] / least[1]);
    }
}

void spoiling(const Config& config) {
    fmt::print(
        "\n| twist, degrees | cost relative to the built tree | visits, refitted over rebuilt | tests "
        "|\n|---|---|---|---|\n");
    constexpr int n = 75;
    const Lattice lattice = lattice_of(tube(n, 0), config);
    for (const double degrees : {0., 15., 30., 45., 60., 90., 135., 180.}) {
        Refit tree(config, "tube"), anew(config, "tube");
        tree.follow(prims_of(tube(n, 0), lattice), 0);
        tree.follow(prims_of(tube(n, degrees), lattice), 1e9);
        anew.follow(prims_of(tube(n, degrees), lattice), 0);
        const Walk own = walk_of(tree, lattice, config), other = walk_of(anew, lattice, config);
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} |\n", degrees, tree.ratio(),
                   double(own.visits) / double(other.visits), double(own.tests) / double(other.tests));
    }
}

}   // namespace

int main() {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Config config = named_config("default");
    times(config);
    spoiling(config);
}
