#pragma once
// Why a machine's picture is not the reference's: every pixel that differs gets a cause, and every answer a
// judge.
//
// From the reference to the machine a pixel goes through these stages; each changes one thing:
//   0  reference: double precision, scene as given, the camera's ray
//   1  double precision, vertices on the lattice          snapping
//   2  the integer direction                              ray_quantisation
//   3  exact, as every instance sees that direction       seam, or ray_quantisation
//   4  t, u and v rounded as promised                     t_rounding
//   5  the machine's answer                               primitive_test
//   6  the colours that its hits were given               shading
// Of one level stages 2 and 3 are the same, and exact. Of two levels stages 1 and 2 are in double precision,
// on the corners where lattices and maps in memory put them; what stage 3 changes is a seam if seam.hpp
// finds one, and is ray_quantisation if a single line gives the answer, for that is the direction rounded
// once more. If it finds neither, the pixel is a bug. If the primitive differs in the end, the cause is the
// first stage that changed it; otherwise the one that changed the colour most. With the exact primitive test
// stage 4 is stage 3 to the bit, or the pixel is a bug, whether or not it shows.
//
// The stages share rules with the machine: the camera's registers, the lattice, what t, u and v mean, and
// shade(). So whatever the cause, the reference decides each pixel that differs once more by rules of its own
// (camera_rung.hpp), and what it finds wrong is a bug.
#include <array>
#include <span>

#include "model/base/progress.hpp"
#include "model/scene/hit_shading.hpp"
#include "sim/judge/paths/picture.hpp"

namespace rayclock {

enum class PixelCause : std::uint8_t {
    snapping,
    ray_quantisation,
    seam,
    t_rounding,
    primitive_test,
    shading,
    horizon,
    bug,
    none
};
constexpr std::size_t pixel_causes = 8;   ///< without `none`

/// A cause's key in reports and its colour in the difference picture, sRGB.
struct PixelCauseInfo {
    const char* key;
    std::array<std::uint8_t, 3> colour;
};
const PixelCauseInfo& cause_info(PixelCause cause);

using PixelCauses = std::array<std::uint64_t, pixel_causes>;   ///< pixels by cause

struct Judgement {
    std::vector<PixelCause> pixels;   ///< `none` where the pixel is as the reference has it
    std::vector<bool> other;          ///< holds another primitive
    PixelCauses causes{};
    PixelCauses causes_other{};   ///< of the pixels that hold another primitive
    std::uint64_t wrong = 0;      ///< pixels in which something is not as it must be
    RayCounts rays;               ///< judged, by what they are for
    std::uint64_t colours = 0;    ///< judged
    double widest = 0;   ///< half of the widest range in which a colour must lie, in 1/65536; 0: no colours
    std::vector<PictureFault> faults;   ///< the first of some wrong pixels
    /// Pixels with another primitive whose ray in the reference meets an edge, to 2^-22 of the triangle: no
    /// precision decides there.
    std::uint64_t on_edge = 0;
    /// Steps that doubles or a stated bound leave open, in which the reference followed the machine
    /// (sim/judge/cause/guide.hpp).
    std::uint64_t ties = 0;
    double seams_apart = 0;   ///< of lines that make a seam: how far, at most, as a part of the bound
    double seconds = 0;       ///< of the host
    /// What must not be there: of another primitive test than the exact one wrong answers are a cause of
    /// their own.
    std::uint64_t wrong_for(const Config& config) const {
        return config.test() == PrimitiveTest::exact ? wrong : bugs();
    }
    std::uint64_t bugs() const { return causes[std::size_t(PixelCause::bug)]; }
};

/// What came of it, one entry a pixel: by the reference, and as a machine gave it.
struct Answered {
    const HitFrame& reference;
    const std::vector<Closest>& answers;
    const Picture& picture;   ///< of the machine's answers
};
/// Judges every pixel on all cores, or as many as `threads` says. `image`: the memory that the machine had.
Judgement judge(const Asked& asked, const MemoryImage& image, const Answered& answered, int threads = 0,
                const Progress& progress = {});

/// One pixel on its way from the reference to the machine, in the order of the stages above: what it hits,
/// and its colour, after the step that is named.
struct PixelStage {
    const char* step;
    Hit hit;
    glm::vec3 colour{0};
};
std::vector<PixelStage> stages_of(const Asked& asked, const MemoryImage& image, const Answered& answered,
                                  std::size_t pixel);

/// Grey copy of the reference's picture, dimmed, with every pixel that has a cause in the cause's colour: in
/// full if it holds another primitive or is a bug, at a third of the light if only its colour differs.
Picture cause_picture(const Picture& reference, const Judgement& judgement);

}   // namespace rayclock
