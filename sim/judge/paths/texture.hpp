#pragma once
// Judges the colour of a textured hit exactly, from the scene's picture and the hit's weights. The judge
// shares no arithmetic with the unit tex (model/unit/tex/texel.hpp), and reads no texel from memory.
#include "model/unit/tex/texel.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

/// A surface with a texture, as the scene gives it.
struct TexturedSurface {
    const Texture* texture = nullptr;
    PrimKind kind = PrimKind::triangle;
    /// At the corners in memory, in pictures. For a plane they may differ from memory by whole periods.
    CornerCoordinates coordinates{};
    /// log2 of the number of texels of level 0 per lattice step.
    double detail = 0;
    double cutoff = 0;
    bool is_average = false;   ///< a plane whose coordinates do not fit into a record: it shows the last
                               ///< level
};
/// Returns a primitive of a scene, if it shows a texture.
std::optional<TexturedSurface> textured_surface(const Scene& scene, const Lattice& lattice,
                                                std::size_t primitive);

/// True if a primitive is a triangle whose texture may have holes.
bool may_have_holes(const Scene& scene, std::size_t primitive);

/// True if a request to tex has the place of a sphere's normal in the octahedral picture. `outwards`: the
/// unit normal that the chip found, 16 fraction bits.
bool is_octahedral(const TexReq& hit, const Vec3i& outwards, const Config& config);

/// Returns the length of a path after a ray, by the rule in docs/machine/shading.md. `far_way`: for a hit on
/// a plane with a saturated t, the vector from the ray's origin to the hit, in units of 2^-B.
std::uint32_t path_length(std::uint32_t before, const Vec3i& d, std::uint32_t t,
                          const std::optional<Vec3l>& far_way, const Config& config);

/// True if the register for the spread of samples holds the nearest number.
bool is_spread(const FrameInputs& inputs, int samples_per_side);

/// True if a hit holds the nearest number to the scale of an instance's map (`a` in memory).
bool is_scale(std::int32_t scale, const std::array<std::int64_t, 9>& a, const Config& config);

/// Returns a fault, or null. Judges the texture record (each number must be the nearest one to the scene's
/// number), the level, and the colour, to the bit.
const char* judge_texture(const FrameInputs& inputs, const TexturedSurface& surface, const TexReq& hit,
                          const TexRecord& record, const TexelPlace& place, const TexRsp& answer);

}   // namespace rayclock
