#pragma once
// Why a finished picture is not the reference's, pixel by pixel.
//
// Two readers look at the machine's pixels. The judge (sim/judge) follows every ray of every pixel, by exact
// arithmetic and by the machine's rules. The ladder follows the pixels that differ, in the reference tracer
// and by the reference's rules, while one thing after the other is changed from the scene as given to the
// machine:
//
//   rung  the reference has                                                        cause
//   0     the scene as given                                                       shading
//   1     corners, spheres, planes, lights and eye on the lattice                  snapping
//   2     each ray as the machine sent it, once it is found within the bound that  ray_quantisation, seam,
//         is stated for it; colours and weights with the machine's bits            horizon
//
// A pixel's cause is the lowest rung at which the reference's rays meet what the machine's met. At the last
// rung they must in any case, and the colour must lie within the judge's bounds: else the pixel is a `bug`,
// as it is if the judge finds a fault. guide.hpp says what the reference lets pass at that rung, and how it
// is counted: ties, seams of two levels, planes beyond the horizon.
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/cause.hpp"

namespace rayclock {

/// What came of a frame: by the reference, and as the machine gave it.
struct FinishedAnswer {
    const WhittedFrame& reference;
    const Picture& picture;
    const Given& given;
};
/// The cause of every pixel whose 8-bit sRGB colour differs or whose first sample hit another primitive
/// (`hits`).
Judgement judge_finished(const Asked& asked, const MemoryImage& image, const Whitted& settings,
                         const FinishedAnswer& answered, const HitFrame& hits, int threads = 0,
                         const Progress& progress = {});

}   // namespace rayclock
