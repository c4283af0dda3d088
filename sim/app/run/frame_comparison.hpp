#pragma once
// Compares a machine's frame with the reference, for simulate and explain.
#include "sim/judge/cause/finished.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/request/request.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

/// A frame as a machine rendered it.
struct MachineFrame {
    const Frame& frame;
    const Camera& camera;
    const std::vector<Closest>& answers;
    const Colours& colours;
    const std::vector<std::uint64_t>& signatures;
};

/// The machine's frame and the reference's, with all differences.
struct FrameComparison {
    FrameError error;
    std::optional<Judgement> judgement;
    Picture picture, reference;       ///< the machine's picture and the reference's
    HitFrame hits, reference_hits;    ///< the hits of both
    std::vector<PixelStage> stages;   ///< stages of the requested pixel, if the chip does not shade
};
/// Compares a frame. `judged` runs the judge; `pixel` selects a pixel whose stages are recorded.
FrameComparison compare(const Request& request, const Job& job, const MachineFrame& made, bool judged,
                        int threads, const Progress& progress,
                        std::optional<std::size_t> pixel = std::nullopt);

}   // namespace rayclock
