#pragma once
// What a configuration does to one scene and frame: measured with the model, against the reference on the
// scene as given.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/files/image/image.hpp"

namespace rayclock::fit {

/// One configuration's frame, or all frames of a film: sums, and the worst.
struct Outcome {
    std::string refused;   ///< why the scene cannot be compiled for it; nothing else is known then
    std::uint64_t pixels = 0;
    std::uint64_t other = 0;              ///< pixels that hold another primitive than the reference's
    double psnr_db = 0;                   ///< of the pictures; infinite if they are equal
    std::uint64_t work = 0;               ///< nodes visited and triangles tested
    std::int64_t direction_squares = 0;   ///< largest square of a direction's length
    CompileReport compile;

    double other_percent() const { return pixels ? 100.0 * double(other) / double(pixels) : 100; }
};

/// Measures configurations of one base; what was measured once is remembered. Images are kept, by what they
/// depend on.
class Measure {
public:
    /// `scene` must have a camera, and stay. The reference works at once.
    Measure(const Scene& scene, FrameSize size, int threads, const PictureChoice& choice = {});

    /// Throws std::runtime_error if interrupted().
    const Outcome& operator()(const Config& config);

    /// A sentence before each measurement that is not remembered, and how many there were.
    std::function<void(const Config& config, std::size_t done)> tell;
    std::size_t done() const { return done_.size(); }
    FrameSize size() const { return size_; }
    const Scene& scene() const { return scene_; }
    const PictureChoice& choice() const { return choice_; }
    /// One picture of what camera rays hit in triangles: the rest is done once more for each configuration.
    bool is_plain() const;

private:
    Outcome measure(const Config& config);
    void measure_plain(const Config& config, Outcome& outcome);
    void measure_film(const Config& config, Outcome& outcome);
    void expect_frames();
    const MemoryImage& image(const Config& config);

    const Scene& scene_;
    FrameSize size_;
    int threads_;
    PictureChoice choice_;
    std::vector<HitFrame> references_;   ///< of each frame
    std::vector<Picture> expected_;
    std::map<std::vector<int>, Outcome> done_;
    std::map<std::vector<int>, MemoryImage> images_;
};

}   // namespace rayclock::fit
