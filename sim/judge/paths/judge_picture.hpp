#pragma once
// A finished picture, judged: every ray of it, every step between two rays, every colour.
#include <array>
#include <memory>

#include "model/base/progress.hpp"
#include "model/scene/whitted.hpp"
#include "model/trace/record_shaded.hpp"
#include "sim/judge/paths/path.hpp"

namespace rayclock {

/// The machine's output, one entry per pixel.
struct MachineOutput {
    const std::vector<Closest>& answers;   ///< to the first camera ray of each pixel
    const std::vector<std::array<std::uint32_t, 3>>& colours;
    const std::vector<std::uint64_t>& signatures;   ///< PathSignature, from the model only
};

struct PictureFault {
    std::uint32_t x = 0, y = 0;
    int ray = 0;   ///< number within the pixel
    std::string what;
};

/// The result of judging a picture.
struct PictureJudgement {
    RayCounts rays;                     ///< judged rays by purpose; a total reflection sends no refracted ray
    std::uint64_t colours = 0;          ///< judged pixels
    std::uint64_t wrong = 0;            ///< pixels with a fault, and wrong registers of the frame
    std::vector<bool> pixels;           ///< the pixels with a fault
    std::vector<PictureFault> faults;   ///< the first faults of some pixels, in the order of pixels
    double widest = 0;                  ///< half the widest range of a colour, in 1/65536
    double seconds = 0;                 ///< the host's time
};

/// Judges the pictures of a frame against the scene on the lattice and the rules of the requested picture.
class PictureJudge {
public:
    /// `image` is the machine's memory. All arguments must outlive the judge.
    PictureJudge(const FrameInputs& inputs, const MemoryImage& image, const Whitted& settings);
    ~PictureJudge();
    PictureJudge(const PictureJudge&) = delete;

    /// Traces every pixel's rays again as the model does, and judges each step.
    PictureJudgement judge(const MachineOutput& given, int threads = 0, const Progress& progress = {}) const;

    const PathRules& rules() const;
    const PlacedWorld* placed() const;   ///< null with one level
    /// Returns a recorder that traces a pixel's rays again; each thread needs its own.
    ShadedRecorder recorder() const;

private:
    struct World;
    std::unique_ptr<World> world_;
};

/// The same in one call.
PictureJudgement judge_picture(const FrameInputs& inputs, const MemoryImage& image, const Whitted& settings,
                               const MachineOutput& given, int threads = 0, const Progress& progress = {});

}   // namespace rayclock
