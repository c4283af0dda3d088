#pragma once
// Finds the cause of each pixel of a finished picture that differs from the reference's.
//
// Two readers check the machine's pixels. The judge (sim/judge) follows every ray of every pixel, in exact
// arithmetic and by the machine's rules. The reference tracer draws the pixels that differ once more in each
// of three stages, by its own rules. Its input changes from the scene as given to the machine's:
//
//   stage  the reference has                                                       cause
//   0      the scene as given                                                      shading
//   1      corners, spheres, planes, lights and eye on the lattice                 snapping
//   2      each ray as the machine sent it, if it lies within its stated bound;    ray_quantisation, seam,
//          colours and weights with the machine's bits                             horizon
//
// A pixel's cause is the first stage in which the reference's rays meet the same primitives as the machine's.
// In the last stage they must do so, and the colour must lie within the judge's bounds. Otherwise, or if the
// judge finds a fault, the pixel is a `bug`. guide.hpp lists the differences that the reference accepts in
// that stage, and how they are counted: ties, seams of two levels, planes beyond the horizon.
#include "sim/judge/cause/cause.hpp"
#include "sim/judge/reference/reference.hpp"

namespace rayclock {

/// The results of a frame: the reference's and the machine's.
struct FinishedAnswer {
    const WhittedFrame& reference;
    const Picture& picture;
    const MachineOutput& given;
};
/// Returns the cause of every pixel whose 8-bit sRGB colour differs, or whose first sample hit another
/// primitive (`hits`).
Judgement judge_finished(const FrameInputs& inputs, const MemoryImage& image, const Whitted& settings,
                         const FinishedAnswer& answered, const HitFrame& hits, int threads = 0,
                         const Progress& progress = {});

}   // namespace rayclock
