#pragma once
// Pictures on surfaces: the texels with all their mip levels, and the texture unit's rules in double
// precision. t increases downwards from the top row of the picture, as in glTF. Texel i of a level of width W
// covers s from i / W to (i + 1) / W.
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace rayclock {

struct Scene;
struct Plane;
struct Sphere;

/// The texel for a coordinate outside 0..1: the texel at s mod 1, the texel of the mirrored picture (period
/// 2), or the nearest texel at the edge.
enum class Wrap : std::uint8_t { repeat, mirror, clamp };

/// One level of a picture: texels row by row from the top. Red, green and blue are sRGB codes, alpha is
/// linear. The colours are not multiplied by alpha.
struct TexelLevel {
    int width = 0, height = 0;   ///< powers of two in a Pyramid
    std::vector<std::array<std::uint8_t, 4>> texels;
};

/// Level 0 is the picture. Each level halves the sides of the level before, down to 1x1; a side of 1 stays 1.
struct Pyramid {
    std::vector<TexelLevel> levels;
};

/// A picture and how to read it.
struct Texture {
    std::string name;   ///< for messages
    std::shared_ptr<const Pyramid> pyramid;
    Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
    bool nearest = false;   ///< true: the texel at the point; false: interpolates four texels
    bool mipmaps = true;    ///< without them only level 0 is used
};

/// The longest side of level 0.
constexpr int max_texture_side = 4096;
/// The largest |s| and |t| of a triangle's corner, after the shift by whole periods.
constexpr double max_coordinate = 64;

/// The largest |s| and |t| that a file may give, for triangles and planes. A 32-bit float of a larger number
/// has too few digits for a texel.
constexpr double max_given_coordinate = 1e6;

/// The coordinates (s, t) of a triangle's three corners.
using CornerCoordinates = std::array<glm::dvec2, 3>;

/// Returns the linear light of an sRGB code, 0..1 (IEC 61966-2-1).
double srgb_to_linear(std::uint8_t code);
/// Returns the nearest sRGB code of linear light, which is clamped to 0..1.
std::uint8_t linear_to_srgb(double linear);

/// Returns all levels of a picture whose sides are powers of two. A texel is the mean of 2x2, 2x1 or 1x2
/// texels of the level before, in linear light, rounded to the nearest code. If the alphas differ, they
/// weight the colours. Alpha is the plain mean, rounded half up.
Pyramid make_pyramid(TexelLevel level0);

/// Returns the power of two whose logarithm is nearest to the logarithm of a side, at most max_texture_side.
int texture_side(int side);
/// Returns the picture with sides of texture_side(). A new texel is the mean of the old picture over the new
/// texel's area, in linear light. Alpha weights the colours. If the sides already fit, the picture does not
/// change.
TexelLevel resampled(const TexelLevel& picture);

/// Returns the coordinates shifted by whole periods of the wrap modes. The middle of their range then lies in
/// the first period: 0..1 for `repeat`, 0..2 for `mirror`. `clamp` has no period.
CornerCoordinates near_zero(const Texture& texture, CornerCoordinates corners);

/// Returns the colour at a point in linear light: the nearest texel, or with wrapped neighbours the bilinear
/// mean at (s W - 1/2, t H - 1/2). The level is clamped to the pyramid; without mipmaps it is 0.
glm::dvec3 filtered(const Texture& texture, glm::dvec2 st, int level);
/// The same with alpha, 0..1, as the fourth component.
glm::dvec4 filtered_with_alpha(const Texture& texture, glm::dvec2 st, int level);
/// Returns the mean of all texels of level 0 in linear light.
glm::dvec3 average_of(const Texture& texture);

/// The share of the foreshortening, log2(1 / cosine), in the level of a slanted surface. 1 filters for the
/// long axis of a pixel's footprint, 0 for the short axis. Of 0, 0.5 and 1, 0.5 has the highest PSNR on the
/// scene `room` against 64 samples per pixel.
constexpr double foreshortening_share = 0.5;
/// The lower bound of the cosine; smaller cosines count as this one.
constexpr double least_cosine = 0x1p-16;

/// Returns log2 of the texels of level 0 per scene unit: log2 sqrt(area in texels / area in the scene).
/// Returns -infinity, which means level 0, if one of the areas is 0.
double texture_detail(const Texture& texture, const std::array<glm::dvec3, 3>& vertices,
                      const CornerCoordinates& corners);
/// Does the same for a triangle of a scene whose material has a texture.
double texture_detail(const Scene& scene, std::uint32_t triangle);

/// Return the same for a plane, and for a sphere with an octahedral picture. A sphere has one number for its
/// whole surface: log2 sqrt(texels / area). The true density lies between 0.37 below and 0.83 above this
/// number (docs/machine/shading.md).
double texture_detail(const Texture& texture, const Plane& plane);
double texture_detail(const Texture& texture, const Sphere& sphere);

/// Returns the place (s, t) of a direction from a sphere's centre in an octahedral picture. The octahedron
/// |x| + |y| + |z| = 1 is seen along y: its upper half fills the middle of the square, and its lower half is
/// folded outwards to the corners (Meyer et al. 2010, "On floating-point normal vectors").
glm::dvec2 octahedral_place(const glm::dvec3& direction);
/// Returns the unit vector for a place in an octahedral picture.
glm::dvec3 octahedral_direction(const glm::dvec2& st);
/// Returns the side of the octahedral picture for a picture of longitude and latitude: half the width of the
/// picture's level 0, or its height if that is more. Both are powers of two. With half the width, the equator
/// has as many texels as the picture's width.
int octahedral_side(const Texture& texture);
/// Turns a picture of longitude (s; the middle is +z, and s increases towards +x) and latitude (the top is
/// +y) into an octahedral picture. A texel is the mean of the picture at 4 x 4 places in the texel's area, in
/// linear light. `texture.nearest` selects the filter at these places. `turn`: Sphere::turn. The result
/// clamps at its edges.
Texture octahedral_picture(const Texture& texture, const glm::dmat3& turn);

/// Returns the level of detail, not yet rounded. `distance` is the length of the path from the eye in scene
/// units. `cosine`: the cosine of the angle between the ray and the shading normal; its sign does not matter.
double level_of_detail(double detail, double distance, double spread, double cosine);
/// Returns the level to draw: the existing level nearest to `lod`.
int level_of(const Texture& texture, double lod);

}   // namespace rayclock
