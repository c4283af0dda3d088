#pragma once
// Every structure on every scene: what the compiler made, what rays did in it, what the chip took.
#include <optional>
#include <string>
#include <vector>

#include "sim/engine/engine.hpp"
#include "sim/report/accounts.hpp"

namespace rayclock::structures {

/// What the page is made of.
struct Study {
    Config base;
    FrameSize size{256, 192};
    std::vector<std::string> scenes;
    int threads = 0;
};

/// A structure as the page calls it.
struct Kind {
    std::string name;
    Config config;
};
/// The trees in the order of the page, a list, and an octree by the rule of the textbook.
std::vector<Kind> trees(const Config& base);
Kind list(const Config& base);
Kind inner_octree(const Config& base);

/// A frame, and what bounds it.
struct Frame {
    FrameRun run;
    Bound bound;
    double tri_busy = 0;   ///< share of cycles in which tri begins a test
    double rays() const { return rays_of(run); }
    double cycles_per_ray() const { return double(run.cycles) / rays(); }
    double fps() const { return per_second(run, default_khz); }
};

struct Cell {
    std::string structure;
    std::string refused;   ///< the compiler's sentence; then there is nothing else
    CompileReport report;
    double build = 0;   ///< seconds of processor time, all threads together
    Frame camera;
    std::optional<Frame> finished;
    std::vector<double> cached;   ///< cycles a camera ray with caches of cache_sets()
};

/// Sets of both caches that the page compares, beside the configuration's own.
const std::vector<int>& cache_sets();

struct SceneCells {
    std::string name;
    std::uint64_t primitives = 0;
    std::vector<Cell> cells;
};

/// Camera rays of the scene, in triangles; with `finished` also its picture at depth 4 and half the size,
/// true spheres. Throws UserError if interrupted.
SceneCells measure(const std::string& scene, const std::vector<Kind>& kinds, const Study& study,
                   bool finished, const Progress& progress);

}   // namespace rayclock::structures
