#pragma once
// A finished picture, judged: every ray of it, every step between two rays, every colour.
#include <array>
#include <span>

#include "model/base/progress.hpp"
#include "model/scene/whitted.hpp"
#include "sim/judge/world.hpp"

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

/// Walks every pixel's rays again as the model does, and judges what it sees. `image` is the memory that the
/// machine had.
PictureJudgement judge_picture(const Asked& asked, const MemoryImage& image, const Whitted& settings,
                               const Given& given, int threads = 0, const Progress& progress = {});

}   // namespace rayclock
