#pragma once
// Pictures that formulas make: squares, bricks, gradients and noise.
#include <cstdint>
#include <vector>

#include "model/scene/texture.hpp"

namespace rayclock {

/// A picture made by a formula. A texel has the colour of the formula at its middle. Noise repeats without a
/// seam. So do bricks with an even number of rows, and a checker if the number of colours divides both sides.
struct Pattern {
    enum class Kind : std::uint8_t {
        checker,    ///< columns x rows fields; field (i, j) has colour number (i + j) mod colours.size()
        bricks,     ///< columns x rows bricks of the first colour, and joints of the second
        gradient,   ///< all colours at equal distances, the first along the upper edge, the last along the
                    ///< lower
        noise       ///< value noise: the lowest value has the first colour, the highest value the last
    };
    Kind kind = Kind::checker;
    int width = 256, height = 256;                                       ///< texels: powers of two
    std::vector<glm::dvec3> colours{glm::dvec3(0.8), glm::dvec3(0.2)};   ///< linear light; two at least
    int columns = 2, rows = 2;
    /// For bricks: the width of a joint divided by the height of a row. Every second row is shifted by half a
    /// brick.
    double joint = 0.1;
    /// For noise: the number of octaves, and the seed of their random numbers. Octave k has columns 2^k x
    /// rows 2^k random values, with half the strength of octave k - 1.
    int octaves = 4;
    std::uint64_t seed = 0;
};
constexpr int max_octaves = 8;
/// The largest number of columns or rows. For noise: in its last octave.
constexpr int max_cells = max_texture_side;

/// Returns the memory in bytes that texture_of() takes: the texels of all levels, and the random values of
/// noise.
std::uint64_t painting_bytes(const Pattern& pattern);

/// Returns the texels of a pattern. All are opaque.
TexelLevel texels_of(const Pattern& pattern);

/// Returns a texture that shows the pattern.
Texture texture_of(const Pattern& pattern);

}   // namespace rayclock
