#pragma once
// Why a finished picture is not the reference's, pixel by pixel.
//
// A pixel has a tree of rays. If the machine's rays met what the reference's did, in the same order, the colours differ by the
// chip's arithmetic: `shading`. If not, the reference is asked again about the scene as the machine has it, vertices, spheres, planes
// and lights on the lattice. If its rays now meet what the machine's do, the cause is `snapping`; else the machine's rays, whose
// directions and origins are rounded, went another way: `ray_quantisation`.
//
// What the camera rays of a scene of triangles met is also judged by the oracle, if there is one sample in the middle of a pixel: a
// wrong answer is a `bug`. All other decisions are the business of the tests.
#include "model/reference/reference.hpp"
#include "sim/cause/cause.hpp"

namespace rayclock {

/// What came of a frame: by the reference, and as the machine gave it.
struct FinishedAnswer {
    const WhittedFrame& reference;
    const Picture& picture;
    const std::vector<Closest>& answers;            ///< of the machine's first samples
    const std::vector<std::uint64_t>& signatures;   ///< of the machine's pixels
};
/// The cause of every pixel whose 8-bit sRGB colour differs or whose first sample hit another primitive (`hits`).
Judgement judge_finished(const Asked& asked, const Whitted& settings, const FinishedAnswer& answered, const HitFrame& hits, int threads = 0,
                         const Progress& progress = {});

} // namespace rayclock
