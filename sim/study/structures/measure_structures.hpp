#pragma once
// Measures every structure on every scene: the compiled image, the work of rays, and the time of the chip.
#include <optional>
#include <string>
#include <vector>

#include "sim/run/frame/frame.hpp"
#include "sim/silicon/area/synthesise_units.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock::structures {

/// The input of the page.
struct Study {
    Config base;
    FrameSize size{256, 192};
    std::vector<std::string> scenes;
    std::vector<std::string> round;   ///< scenes whose camera rays also meet true spheres
    int threads = 0;
    Limits limits{};   ///< a picture beyond these gets a mark
    bool is_round(const std::string& scene) const;
};

/// A structure, with its name on the page.
struct NamedStructure {
    std::string name;
    Config config;
};
/// Return the trees in the order of the page, a list, and an octree by the textbook's rule.
std::vector<NamedStructure> trees(const Config& base);
NamedStructure list(const Config& base);
NamedStructure inner_octree(const Config& base);

/// A frame and its bound.
struct Frame {
    FrameResult run;
    Bound bound;
    double tri_busy = 0;   ///< share of cycles in which tri starts a test
    FrameError error{};    ///< error of its picture against the reference
    double rays() const { return rays_of(run); }
    double cycles_per_ray() const { return double(run.cycles) / rays(); }
    double fps() const { return per_second(run, default_khz); }
};

/// The results of one structure on one scene.
struct Cell {
    std::string structure;
    std::string refused;   ///< the compiler's error message; the figures below are then missing
    CompileReport report;
    double build = 0;   ///< processor time in seconds, summed over threads
    Frame camera;
    std::optional<Frame> finished;
    std::vector<double> elsewhere;   ///< cycles per camera ray in each of surroundings()
};

/// Caches and memories that the page compares with the configuration's own.
struct Surroundings {
    const char* dram;
    int sets;   ///< sets of both caches
};
const std::vector<Surroundings>& surroundings();

/// The results of all structures on one scene.
struct SceneCells {
    std::string name;
    bool is_round = false;   ///< camera rays meet true spheres
    std::uint64_t primitives = 0;
    std::vector<Cell> cells;
};

/// The area of one pipeline with a structure.
struct Areas {
    area::Count hits;   ///< a pipeline that finds hits of triangles
    area::Count all;    ///< a pipeline with every unit of finished pictures
};

/// Measures camera rays of the scene. The scene has triangles or, if it is in study.round, true spheres and
/// no light. `finished` adds its picture at depth 4 and half the size with true spheres. Throws Interrupted
/// after Ctrl-C.
SceneCells measure(const std::string& scene, const std::vector<NamedStructure>& candidates,
                   const Study& study, bool finished, const Progress& progress);

}   // namespace rayclock::structures
