#pragma once
// One machine at the clocks of processors, on several memories and with growing numbers of pipelines.
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sim/run/frame/frame.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock::gigahertz {

/// A memory, with its name on the page.
struct MemoryChoice {
    std::string name, dram;
    int channels;
};
const std::vector<MemoryChoice>& memories();
const std::vector<int>& clocks();      ///< in MHz, in ascending order
const std::vector<int>& pipelines();   ///< in ascending order

/// The input of the page.
struct Study {
    Config base;
    std::string scene, finished_scene;
    FrameSize size;   ///< size of pictures from camera rays; a finished picture has half the columns and rows
    int threads = 0;
};

/// The figures of a frame and of its memory.
struct Frame {
    std::uint64_t cycles = 0;
    double rays = 0, fps = 0, bytes = 0;
    Bound bound;
    double busy = 0, waits = 0;   ///< shares of cycles: data on the memory's bus; requests waiting
    double rays_per_second() const { return fps * rays; }
};

/// Changes to the machine that may remove the limit, by their names on the page.
enum class Remedy { none, contexts, cache };
constexpr int remedies = 3;

/// Identifies a frame: index of the memory, MHz, pipelines, remedy.
using Point = std::tuple<std::size_t, int, int, Remedy>;

/// All results of the study.
struct Figures {
    /// Clocks x memories with the fewest and the most pipelines; the last clock with every number of
    /// pipelines; remedies at the last clock and number.
    std::map<Point, Frame> camera;
    std::map<Point, Frame> finished;   ///< first and last clock with the first and last number of pipelines
    std::size_t triangles = 0;
    double finished_rays_per_pixel = 0;

    const Frame& at(std::size_t memory, int mhz, int pipelines, Remedy remedy = Remedy::none) const {
        return camera.at({memory, mhz, pipelines, remedy});
    }
};

/// Returns the machine with the memory, the pipelines and the remedy of a point.
Config config_of(const Config& base, const Point& point);

/// Runs the study. Throws Interrupted after Ctrl-C.
Figures measure(const Study& study, const Progress& progress);

}   // namespace rayclock::gigahertz
