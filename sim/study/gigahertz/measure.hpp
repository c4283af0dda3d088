#pragma once
// One machine at the clocks of processors: what it does on each memory, with more and more pipelines.
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sim/run/engine/engine.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock::gigahertz {

/// A memory as the page calls it.
struct MemoryChoice {
    std::string name, dram;
    int channels;
};
const std::vector<MemoryChoice>& memories();
const std::vector<int>& clocks();      ///< MHz, from slow to fast
const std::vector<int>& pipelines();   ///< from few to many

/// What the page is made of.
struct Study {
    Config base;
    std::string scene, finished_scene;
    FrameSize size;   ///< of camera rays; a finished picture has half as many columns and rows
    int threads = 0;
};

/// A frame, and what its memory did.
struct Frame {
    std::uint64_t cycles = 0;
    double rays = 0, fps = 0, bytes = 0;
    Bound bound;
    double busy = 0, waits = 0;   ///< shares of cycles: data on the memory's bus; requests wait
    double rays_per_second() const { return fps * rays; }
};

/// Changes to the machine that may move the wall, as the page calls them.
enum class Cure { none, contexts, cache };
constexpr int cures = 3;

/// Which frame: index of the memory, MHz, pipelines, cure.
using Point = std::tuple<std::size_t, int, int, Cure>;

struct Figures {
    std::map<Point, Frame> camera;     ///< clocks x memories with the fewest and the most pipelines; at the
                                       ///< last clock with any number of them; cures at the last of both
    std::map<Point, Frame> finished;   ///< first and last clock, first and last number of pipelines
    std::size_t triangles = 0;
    double finished_rays_per_pixel = 0;

    const Frame& at(std::size_t memory, int mhz, int pipelines, Cure cure = Cure::none) const {
        return camera.at({memory, mhz, pipelines, cure});
    }
};

/// The machine with the memory, pipelines and cure of a point.
Config config_of(const Config& base, const Point& point);

/// Throws UserError if interrupted.
Figures measure(const Study& study, const Progress& progress);

}   // namespace rayclock::gigahertz
