#pragma once
// Texture records and texels that no scene produces.
#include <vector>

#include "model/layout/memory_image.hpp"
#include "sim/explore/torture/dice.hpp"
#include "sim/explore/torture/image.hpp"

namespace rayclock::torture {

/// The textures of a memory image: a few random records and random texels, which its surfaces share. If the
/// chip has no textures, the functions draw and change nothing.
class Textures {
public:
    /// Draws with its own dice, so that the rest of an image is the same with and without textures.
    Textures(const Config& config, const Dice& dice, SurfaceStyle style);

    /// Changes some triangles into cut-outs, or all triangles in the style `holes`.
    void make_cutouts(std::vector<PrimData>& prims);
    /// Returns the number of lines that append() writes.
    std::uint32_t lines() const;
    /// Appends the texels and then the records to an image. So no record lies in line 0.
    void append(std::vector<std::uint32_t>& words);
    /// Returns Surface::record for a primitive, or 0. 90 % of the cut-outs have a texture, and 25 % of the
    /// other triangles; the styles `textured` and `holes` have more. A texture on another triangle may also
    /// have holes. Light does not pass through these.
    std::uint32_t record_for(const PrimData& prim);

private:
    std::int32_t coordinate();
    std::array<std::int32_t, 3> corners();
    std::int32_t density(std::uint32_t last_level);
    TexRecord record(std::uint32_t first_texels, std::uint32_t number);
    Line texels();

    const Config& config_;
    Dice dice_;
    SurfaceStyle style_;
    std::uint32_t first_record_ = 0;
};

}   // namespace rayclock::torture
