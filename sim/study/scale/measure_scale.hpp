#pragma once
// The host's cost of drawing and judging a frame, against the size of the scene and of the picture.
#include <array>
#include <string>
#include <vector>

#include "sim/run/request/request.hpp"

namespace rayclock::scale {

/// The kinds of work on a frame, in the order in which they run.
enum class Work { load, compile, record, replay, reference, judge };
constexpr std::array<const char*, 6> work_names{"load", "compile", "record", "replay", "reference", "judge"};
constexpr std::size_t works = work_names.size();

/// The input of the study: series of scenes and of picture sizes.
struct Study {
    ConfigChoice config;
    std::vector<std::string> scenes;   ///< with more and more triangles, each drawn at `size`
    std::vector<std::string> placed;   ///< the same for scenes of instances
    FrameSize size;
    /// Larger and larger pictures of the first of `scenes`. The last of `scenes` has the last size as well.
    std::vector<FrameSize> sizes;
    int threads = 0;
};

/// The cost of one frame.
struct Row {
    std::string scene;
    FrameSize size;
    std::uint64_t triangles = 0, image_bytes = 0, cycles = 0, judged = 0, wrong = 0;
    std::array<double, works> seconds{};   ///< [Work], wall time
    /// The most memory that the process uses from the loading of the scene until the frame is judged.
    std::uint64_t peak_bytes = 0;
    std::uint64_t pixels() const { return std::uint64_t(size.width) * std::uint64_t(size.height); }
};

/// All results of the study.
struct Figures {
    std::vector<Row> scenes, placed, pictures;
    Row largest;
};

/// Runs the study. Throws Interrupted after Ctrl-C.
Figures measure(const Study& study, const Progress& progress);

/// Fits seconds = c x^p to the rows, by least squares of the logarithms, and returns the exponent p. `x`
/// returns the size of a row. Returns NaN with fewer than two positive times, or if all sizes are equal.
double exponent(const std::vector<Row>& rows, Work work, std::uint64_t (*x)(const Row&));

}   // namespace rayclock::scale
