#pragma once
// Judges the colour that a texture gives to a hit: exactly, from the scene's picture and the hit's weights.
// The judge shares no arithmetic with the unit tex (model/unit/tex/texel.hpp), and reads no texel from
// memory.
#include "model/unit/tex/texel.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

/// Returns the texture of a primitive, if it has one.
const Texture* texture_of(const Scene& scene, std::size_t primitive);

/// Returns the length of a path after a ray, by the rule in docs/machine/shading.md.
std::uint32_t path_length(std::uint32_t before, const Vec3i& d, std::uint32_t t, const Config& config);

/// True if the register for the spread of samples holds the nearest number.
bool is_spread(const FrameInputs& inputs, int samples_per_side);

/// Returns a fault, or null. It judges the numbers of the texture record, each the nearest one to the
/// scene's; the level; and the colour, to the bit.
const char* judge_texture(const FrameInputs& inputs, std::size_t triangle, const TexReq& hit,
                          const TexRecord& record, const TexelPlace& place, const TexRsp& answer);

}   // namespace rayclock
