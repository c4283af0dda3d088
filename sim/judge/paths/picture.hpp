#pragma once
// A finished picture, judged: every ray of it, every step between two rays, every colour.
#include <array>
#include <memory>

#include "model/base/progress.hpp"
#include "model/scene/whitted.hpp"
#include "model/trace/record_shaded.hpp"
#include "sim/judge/paths/path.hpp"

namespace rayclock {

/// What a machine gave, one entry a pixel.
struct Given {
    const std::vector<Closest>& answers;   ///< of the pixels' first camera rays
    const std::vector<std::array<std::uint32_t, 3>>& colours;
    const std::vector<std::uint64_t>& signatures;   ///< PathSignature; of the model
};

struct PictureFault {
    std::uint32_t x = 0, y = 0;
    int ray = 0;   ///< of its pixel
    std::string what;
};

/// Judged so far and found wrong.
struct PictureJudgement {
    RayCounts rays;              ///< judged, by what they are for; a total reflection sends no refracted ray
    std::uint64_t colours = 0;   ///< pixels
    std::uint64_t wrong = 0;     ///< pixels in which something is wrong, and registers of the frame
    std::vector<bool> pixels;    ///< those
    std::vector<PictureFault> faults;   ///< the first of some of them, in the order of pixels
    double widest = 0;                  ///< half of the widest range in which a colour must lie, in 1/65536
    double seconds = 0;                 ///< of the host
};

/// What a frame is judged by: the scene as the machine must have it, and the rules of the asked picture.
class PictureJudge {
public:
    /// `image` is the memory that the machine had. All arguments must stay.
    PictureJudge(const Asked& asked, const MemoryImage& image, const Whitted& settings);
    ~PictureJudge();
    PictureJudge(const PictureJudge&) = delete;

    /// Walks every pixel's rays again as the model does, and judges what it sees.
    PictureJudgement judge(const Given& given, int threads = 0, const Progress& progress = {}) const;

    const PathRules& rules() const;
    const PlacedWorld* placed() const;   ///< of two levels
    /// What follows a pixel's rays again; one for each thread.
    ShadedRecorder recorder() const;

private:
    struct World;
    std::unique_ptr<World> world_;
};

/// The same in one call.
PictureJudgement judge_picture(const Asked& asked, const MemoryImage& image, const Whitted& settings,
                               const Given& given, int threads = 0, const Progress& progress = {});

}   // namespace rayclock
