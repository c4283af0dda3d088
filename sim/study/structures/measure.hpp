#pragma once
// Every structure on every scene: what the compiler made, what rays did in it, what the chip took.
#include <optional>
#include <string>
#include <vector>

#include "sim/silicon/area/run.hpp"
#include "sim/run/engine/engine.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock::structures {

/// What the page is made of.
struct Study {
    Config base;
    FrameSize size{256, 192};
    std::vector<std::string> scenes;
    std::vector<std::string> round;   ///< of these, those whose camera rays meet true spheres as well
    int threads = 0;
    Limits limits{};   ///< beyond which a picture gets a mark
    bool is_round(const std::string& scene) const;
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
    FrameError error{};    ///< of its picture, beside the reference's
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
    std::vector<double> elsewhere;   ///< cycles a camera ray in each of surroundings()
};

/// Caches and memories that the page compares, beside the configuration's own.
struct Surroundings {
    const char* dram;
    int sets;   ///< of both caches
};
const std::vector<Surroundings>& surroundings();

struct SceneCells {
    std::string name;
    bool is_round = false;   ///< camera rays meet true spheres
    std::uint64_t primitives = 0;
    std::vector<Cell> cells;
};

/// One pipeline of a structure's machine.
struct Areas {
    area::Count hits;   ///< that finds hits of triangles
    area::Count all;    ///< with every unit of finished pictures
};

/// Camera rays of the scene, in triangles or, if it is one of study.round, in true spheres and without a
/// light; with `finished` also its picture at depth 4 and half the size, true spheres. Throws UserError if
/// interrupted.
SceneCells measure(const std::string& scene, const std::vector<Kind>& kinds, const Study& study,
                   bool finished, const Progress& progress);

}   // namespace rayclock::structures
