#pragma once
// Memory images that no scene produces: primitives at the ends of the lattice, on top of each other, edge-on;
// surfaces with any mixture of reflection and refraction.
#include <vector>

#include "model/layout/memory_image.hpp"
#include "sim/explore/torture/dice.hpp"

namespace rayclock::torture {

/// Triangles of all sizes, needles, spheres that touch each other or fill the lattice, a floor and a slanted
/// plane. Primitives that the chip lacks are left out.
std::vector<PrimData> soup(const Config& config, Dice& dice, int count);

/// Planes that are nearly parallel to each other or to an axis.
std::vector<PrimData> walls(const Config& config);

/// Triangles between corners of the lattice.
std::vector<PrimData> spans(const Config& config, Dice& dice, int count);

/// A triangle at right angles to `normal`, with mirror_place(at) inside.
PrimData mirror(const Config& config, const Vec3i& normal, std::int32_t at);

/// Spheres that overlap or hide each other.
std::vector<PrimData> balls(const Config& config, Dice& dice, int count);

PrimData ball(const Config& config, const Vec3i& centre, std::int32_t radius);

/// Spheres with a radius of one to three steps, near the middle.
std::vector<PrimData> beads(const Config& config, Dice& dice, int count);

/// Triangles and spheres of a few lattice steps, all within 3 of the middle.
std::vector<PrimData> specks(const Config& config, Dice& dice, int count);

/// Two copies of a square mesh in the plane z = 0, numbered in opposite orders: every hit at a corner or an
/// edge ties with many others. The distance of corners is `step`, and each side has `side` squares.
std::vector<PrimData> mesh(std::int32_t step, int side);

/// Large half-transparent squares, one behind the other: at each of them one more ray waits.
std::vector<PrimData> panes(const Config& config, int count);

/// Surfaces of a chip that shades: any; half mirror and half glass; colours that are 0 or 1 without any
/// light; highlights of any sharpness without reflection; most triangles with a texture, sometimes larger
/// than the memory; all triangles as cut-outs, with nearly all texels transparent. In a chip with textures,
/// 44 % of the triangles have a texture in the styles `any`, `clear` and `shiny`, and none in the style
/// `bright`.
enum class SurfaceStyle { any, clear, bright, shiny, textured, holes };
/// Draws a surface without a texture.
Surface random_surface(const PrimData& prim, const Config& config, Dice& dice, SurfaceStyle style);
/// Appends a surface to the words of an image.
void append_line(const Surface& surface, const Config& config, std::vector<std::uint32_t>& words);

/// Returns the whole memory image. With two levels placed_image() makes it.
MemoryImage image_of(const std::vector<PrimData>& prims, const Config& config, Dice& dice, const char* name,
                     SurfaceStyle style = SurfaceStyle::any);
/// Changes every node of the tree of treelets or slants at line 0. Each node gets a box of a few steps near
/// the middle, and planes of any direction that cut the box. Rays then miss the scene, but model and RTL must
/// still agree.
void cut_anew(MemoryImage& image, const Config& config, Dice& dice);

/// Adds `root` to the addresses in nodes that were compiled for line 0 and now begin at line `root`. With two
/// levels these are the nodes of a mesh.
void move_nodes(std::vector<std::uint32_t>& words, std::uint32_t root, Structure engine,
                const Config& config);

/// Returns the image of a list or a tree that ends at the last address. It begins in line `root`, after its
/// surfaces. The `listed` of a list counts from line 0.
MemoryImage image_at_the_end(const std::vector<PrimData>& prims, const Config& config, Dice& dice,
                             const char* name, std::uint32_t& root);

/// Triangles whose edges are multiples of 1, 2, 4 ... 64 steps.
std::vector<PrimData> coarse(const Config& config, Dice& dice, int count);

}   // namespace rayclock::torture
