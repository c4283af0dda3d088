#pragma once
// Memory images that no scene gives: primitives at the ends of the lattice, on top of each other, edge on;
// surfaces of any share.
#include "model/layout/memory_image.hpp"
#include "sim/explore/torture/dice.hpp"

namespace rayclock::torture {

/// Triangles of all sizes, needles, spheres that touch each other or fill the lattice, a floor and a slanted
/// plane: what of these the chip has.
std::vector<PrimData> soup(const Config& config, Dice& dice, int count);

/// Planes that are all but parallel to each other or to an axis.
std::vector<PrimData> walls(const Config& config);

/// Triangles between corners of the lattice.
std::vector<PrimData> spans(const Config& config, Dice& dice, int count);

/// A triangle across the `normal`, with mirror_place(at) inside.
PrimData mirror(const Config& config, const Vec3i& normal, std::int32_t at);

/// Spheres in each other's way.
std::vector<PrimData> balls(const Config& config, Dice& dice, int count);

PrimData ball(const Config& config, const Vec3i& centre, std::int32_t radius);

/// Spheres of a radius of one to three steps, near the middle.
std::vector<PrimData> beads(const Config& config, Dice& dice, int count);

/// Triangles and spheres of a few lattice steps, all within 3 of the middle.
std::vector<PrimData> specks(const Config& config, Dice& dice, int count);

/// A square mesh in the plane z = 0, twice, numbered against each other: every hit at a corner or an edge has
/// many that tie. `step` from corner to corner, `side` squares a side.
std::vector<PrimData> mesh(std::int32_t step, int side);

/// Large half-transparent squares, one behind the other: every ray leaves one ray waiting at each.
std::vector<PrimData> panes(const Config& config, int count);

/// Surfaces, if the chip shades: of any share; half mirror and half glass; of colours that are 0 or 1 without
/// any light; or with highlights of any sharpness and no mirror.
enum class Look { any, clear, bright, shiny };
Surface random_surface(const PrimData& prim, const Config& config, Dice& dice, Look look);

/// All that a chip's memory holds; with two levels placed_image().
MemoryImage image_of(const std::vector<PrimData>& prims, const Config& config, Dice& dice, const char* name,
                     Look look = Look::any);
/// Gives every node of the tree at line 0, of treelets or of slants, a box of a few steps near the middle,
/// and planes of any direction that cut it. Rays no longer hit what the scene holds, but model and RTL must
/// still do the same.
void cut_anew(MemoryImage& image, const Config& config, Dice& dice);

/// Adds `root` to the addresses in nodes that were compiled from line 0 on and now begin there. With two
/// levels they are a mesh's.
void move_nodes(std::vector<std::uint32_t>& words, std::uint32_t root, Structure engine,
                const Config& config);

/// The image of a list or a tree that begins in line `root`, behind its surfaces, and ends with the last
/// lines that can be addressed. The `listed` of a list counts from line 0 on.
MemoryImage image_at_the_end(const std::vector<PrimData>& prims, const Config& config, Dice& dice,
                             const char* name, std::uint32_t& root);

/// Triangles whose edges are multiples of 1, 2, 4 ... 64 steps.
std::vector<PrimData> coarse(const Config& config, Dice& dice, int count);

}   // namespace rayclock::torture
