#pragma once
// Judges the colour of a textured hit exactly, from the scene's picture and the hit's weights. The judge
// shares no arithmetic with the unit tex (model/unit/tex/texel.hpp), and reads no texel from memory.
#include "model/unit/tex/texel.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

/// A triangle with a texture, as the scene gives it.
struct TexturedTriangle {
    const Texture* texture = nullptr;
    CornerCoordinates coordinates{};
    std::array<glm::dvec3, 3> corners{};   ///< in lattice steps
    double cutoff = 0;
};
/// Returns a triangle of a scene, if it has a texture. `pitch`: scene units in a lattice step.
std::optional<TexturedTriangle> textured_triangle(const Scene& scene, const glm::dvec3& pitch,
                                                  std::size_t primitive);

/// Returns the length of a path after a ray, by the rule in docs/machine/shading.md.
std::uint32_t path_length(std::uint32_t before, const Vec3i& d, std::uint32_t t, const Config& config);

/// True if the register for the spread of samples holds the nearest number.
bool is_spread(const FrameInputs& inputs, int samples_per_side);

/// True if a hit holds the nearest number to the scale of an instance's map (`a` in memory).
bool is_scale(std::int32_t scale, const std::array<std::int64_t, 9>& a, const Config& config);

/// True if a triangle has a hole at a hit, at level 0. u and v: as in Closest.
bool is_hole(const FrameInputs& inputs, const TexturedTriangle& triangle, std::uint32_t u, std::uint32_t v);

/// Returns a fault, or null. Judges the texture record (each number must be the nearest one to the scene's
/// number), the level, and the colour, to the bit.
const char* judge_texture(const FrameInputs& inputs, const TexturedTriangle& triangle, const TexReq& hit,
                          const TexRecord& record, const TexelPlace& place, const TexRsp& answer);

}   // namespace rayclock
