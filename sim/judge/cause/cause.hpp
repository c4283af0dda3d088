#pragma once
// Finds the cause of each pixel that differs between machine and reference, and judges every answer.
//
// From the reference to the machine a pixel passes through these stages. Each stage makes one change:
//   0  reference: double precision, scene as given, the camera's ray
//   1  double precision, vertices on the lattice          snapping
//   2  the integer direction                              ray_quantisation
//   3  exact, as every instance sees that direction       seam, or ray_quantisation
//   4  t, u and v rounded as promised                     t_rounding
//   5  the machine's answer                               primitive_test
//   6  the colours of its hits                            shading
// With one level, stages 2 and 3 are the same, and exact. With two levels, stages 1 and 2 are in double
// precision, with corners where lattices and maps in memory put them. A change by stage 3 is a seam if
// seam.hpp finds one. It is ray_quantisation if a single line gives the answer: this line is the direction
// rounded once more. Otherwise the pixel is a bug. If the primitive differs at the end, the cause is the
// first stage that changed it. Otherwise it is the stage that changed the colour most. With the exact
// primitive test, stage 5 must equal stage 4 to the bit. If not, the pixel is a bug, visible or not.
//
// The stages share rules with the machine: the camera's registers, the lattice, the meaning of t, u and v,
// and shade(). So the reference then checks each pixel that differs by its own rules
// (camera_stage_check.hpp). Any fault that it finds is a bug.
#include <array>
#include <span>

#include "model/base/progress.hpp"
#include "model/scene/hit_shading.hpp"
#include "sim/judge/paths/judge_picture.hpp"

namespace rayclock {

enum class PixelCause : std::uint8_t {
    snapping,
    ray_quantisation,
    seam,
    t_rounding,
    primitive_test,
    shading,
    texture,
    horizon,
    bug,
    none
};
constexpr std::size_t pixel_causes = 9;   ///< without `none`

/// A cause's key in reports and its colour in the difference picture, sRGB.
struct PixelCauseInfo {
    const char* key;
    std::array<std::uint8_t, 3> colour;
};
const PixelCauseInfo& cause_info(PixelCause cause);

using PixelCauses = std::array<std::uint64_t, pixel_causes>;   ///< pixels by cause

struct Judgement {
    std::vector<PixelCause> pixels;   ///< `none` where the pixel equals the reference's
    std::vector<bool> other;          ///< holds another primitive
    PixelCauses causes{};
    PixelCauses causes_other{};   ///< of the pixels that hold another primitive
    std::uint64_t wrong = 0;      ///< pixels with a fault
    RayCounts rays;               ///< judged rays, by purpose
    std::uint64_t colours = 0;    ///< judged colours
    double widest = 0;   ///< half of the widest range in which a colour must lie, in 1/65536; 0: no colours
    std::vector<PictureFault> faults;   ///< the first fault of each of the first wrong pixels
    /// Pixels with another primitive whose ray meets an edge in the reference, to 2^-22 of the triangle. No
    /// precision decides which side such a ray takes.
    std::uint64_t on_edge = 0;
    /// Steps that doubles or a stated bound leave open, in which the reference followed the machine
    /// (sim/judge/cause/guide.hpp).
    std::uint64_t ties = 0;
    double seams_apart = 0;   ///< largest distance of the lines of a seam, relative to its bound
    double seconds = 0;       ///< host time
    /// Returns the pixels that must be 0. With an inexact primitive test, wrong answers have a separate cause
    /// and are allowed.
    std::uint64_t wrong_for(const Config& config) const {
        return config.test() == PrimitiveTest::exact ? wrong : bugs();
    }
    std::uint64_t bugs() const { return causes[std::size_t(PixelCause::bug)]; }
};

/// The results of a frame, one entry for each pixel: the reference's and the machine's.
struct FrameAnswers {
    const HitFrame& reference;
    const std::vector<Closest>& answers;
    const Picture& picture;   ///< made from the machine's answers
};
/// Judges every pixel on `threads` cores (0: all). `image`: the machine's memory.
Judgement judge(const FrameInputs& inputs, const MemoryImage& image, const FrameAnswers& answered,
                int threads = 0, const Progress& progress = {});

/// A pixel's hit and colour after the stage `name`, one of those above.
struct PixelStage {
    const char* name;
    Hit hit;
    glm::vec3 colour{0};
};
std::vector<PixelStage> stages_of(const FrameInputs& inputs, const MemoryImage& image,
                                  const FrameAnswers& answered, std::size_t pixel);

/// Returns a dim grey copy of the reference's picture, in which each pixel that differs has the colour of its
/// cause: in full light if it holds another primitive or is a bug, at a third of the light if only its colour
/// differs.
Picture cause_picture(const Picture& reference, const Judgement& judgement);

}   // namespace rayclock
