#pragma once
// Measures the errors and the work of a configuration on one scene and frame, with the model. The reference
// renders the scene as given.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "sim/files/image/image.hpp"
#include "sim/run/film/choice.hpp"

namespace rayclock::fit {

/// The errors and the work of one configuration's frame, or of all frames of a film: sums, and the worst
/// value.
struct Measurement {
    std::string refused;   ///< why the scene cannot be compiled; the other members are then unset
    std::uint64_t pixels = 0;
    std::uint64_t other = 0;              ///< pixels that hold another primitive than the reference's
    double psnr_db = 0;                   ///< infinite if the pictures are equal
    std::uint64_t work = 0;               ///< nodes visited and triangles tested
    std::int64_t direction_squares = 0;   ///< largest square of a direction's length
    CompileReport compile;

    double other_percent() const { return pixels ? 100.0 * double(other) / double(pixels) : 100; }
};

/// Measures configurations that share one base. Results and memory images are cached by the parameters that
/// affect them.
class Measurer {
public:
    /// Runs the reference. `scene` must have a camera, and outlive the object.
    Measurer(const Scene& scene, FrameSize size, int threads, const PictureChoice& choice = {});

    /// Throws std::runtime_error if interrupted().
    const Measurement& operator()(const Config& config);

    /// Called before each measurement that is not cached, with the number of earlier ones.
    std::function<void(const Config& config, std::size_t done)> on_measured;
    std::size_t done() const { return done_.size(); }
    FrameSize size() const { return size_; }
    const Scene& scene() const { return scene_; }
    const PictureChoice& choice() const { return choice_; }
    /// True if camera rays draw triangles alone, in one picture. Any other picture is rendered completely for
    /// each configuration.
    bool is_plain() const;

private:
    Measurement measure(const Config& config);
    void measure_plain(const Config& config, Measurement& outcome);
    void measure_film(const Config& config, Measurement& outcome);
    void expect_frames();
    const MemoryImage& image(const Config& config);

    const Scene& scene_;
    FrameSize size_;
    int threads_;
    PictureChoice choice_;
    std::vector<HitFrame> references_;   ///< one for each frame
    std::vector<Picture> expected_;
    std::map<std::vector<int>, Measurement> done_;
    std::map<std::vector<int>, MemoryImage> images_;
};

}   // namespace rayclock::fit
