#pragma once
// Why a finished picture is not the reference's, pixel by pixel.
//
// Every ray and every step of the pixel's path is judged first (sim/judge). If all is right, one of these
// findings holds:
//   the machine's rays met what the reference's did, in the same order: the colours differ by the chip's
//   arithmetic, and lie within its proven bounds: `shading`; they met what the reference's meet on the scene
//   as the machine has it, vertices, spheres, planes and lights on the lattice: `snapping`; they met what
//   neither does, each ray having been found to meet what it must, and to begin and to lead where it must but
//   for a rounding that is named and bounded: `ray_quantisation`.
// With two levels such a pixel is a `seam` if one of its rays is: if no single line gives what it met
// (seam.hpp), because each instance rounds the ray for itself.
// What is not found right in every step is a `bug`, whether or not it shows.
#include "model/reference/reference.hpp"
#include "sim/cause/cause.hpp"

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
