#pragma once
// A machine's frame beside the reference's: what simulate and explain need.
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/view/report/json.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

/// What a machine gave for a frame.
struct MachineFrame {
    const Frame& frame;
    const Camera& camera;
    const std::vector<Closest>& answers;
    const Colours& colours;
    const std::vector<std::uint64_t>& signatures;
};

struct Compared {
    FrameError error;
    std::optional<Judgement> judgement;
    Picture picture, reference;       ///< the machine's, the reference's
    HitFrame hits, reference_hits;    ///< likewise
    std::vector<PixelStage> stages;   ///< of the pixel that was asked for, if the chip does not shade
};
/// `pixel`: whose stages are wanted, or none. The judge is asked if `judged`.
Compared compare(const Request& request, const Job& job, const MachineFrame& made, bool judged, int threads,
                 const Progress& progress, std::optional<std::size_t> pixel = std::nullopt);

}   // namespace rayclock
