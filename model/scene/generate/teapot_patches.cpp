// The teapot's symmetry reduces 290 points to 35 rows of numbers. Body, lid and bottom are surfaces of
// revolution. The second half of handle and spout is the mirror image of the first. The patches have the
// published numbers to the bit.
#include "model/scene/generate/teapot_patches.hpp"

#include <cstddef>
#include <span>

namespace rayclock {
namespace {

/// A circle about the axis x = y = 0, made of four curves. A curve runs from one axis to the next. Its two
/// inner control points lie `radius` along the nearer axis and `bend` along the other.
struct ProfileRing {
    double radius, bend, z;
};
constexpr ProfileRing body[] = {{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125},
                                {1.5, 0.84, 2.4},  {1.75, 0.98, 1.875},      {2, 1.12, 1.35},
                                {2, 1.12, 0.9},    {2, 1.12, 0.45},          {1.5, 0.84, 0.225},
                                {1.5, 0.84, 0.15}};
constexpr ProfileRing lid[] = {{0, 0, 3.15},       {0.8, 0.45, 3.15},  {0, 0, 2.85},     {0.2, 0.112, 2.7},
                               {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}};
constexpr ProfileRing bottom[] = {{0, 0, 0}, {1.425, 0.798, 0}, {1.5, 0.84, 0.075}, {1.5, 0.84, 0.15}};

/// Half a cross-section of handle or spout: from one point of the plane y = 0 to another, with `width` to its
/// side.
struct Rib {
    double x, z, other_x, other_z, width;
};
constexpr Rib handle[] = {{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3},
                          {-2.7, 2.025, -3, 2.25, 0.3},   {-2.7, 1.8, -3, 1.8, 0.3},
                          {-2.7, 1.575, -3, 1.35, 0.3},   {-2.5, 1.125, -2.65, 0.9375, 0.3},
                          {-2, 0.9, -1.9, 0.6, 0.3}};
constexpr Rib spout[] = {{1.7, 1.425, 1.7, 0.6, 0.66},       {2.6, 1.425, 3.1, 0.825, 0.66},
                         {2.3, 2.1, 2.4, 2.025, 0.25},       {2.7, 2.4, 3.3, 2.4, 0.25},
                         {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
                         {2.8, 2.4, 3.2, 2.4, 0.15}};

/// Calls `add` with every four rows of control points. Every fourth row ends one patch and begins the next.
template <class Row, class Add> void each_four(std::span<const Row> rows, const Add& add) {
    for (std::size_t first = 0; first + 3 < rows.size(); first += 3) add(rows.subspan(first, 4));
}

/// Adds four quarters, the first from x to `side` times y.
void revolve(std::span<const ProfileRing> profile, double side, std::vector<TeapotPatch>& patches) {
    const glm::dvec3 axes[] = {{1, 0, 0}, {0, side, 0}, {-1, 0, 0}, {0, -side, 0}};
    each_four(profile, [&](std::span<const ProfileRing> rings) {
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const glm::dvec3 &from = axes[quarter], &to = axes[(quarter + 1) % 4];
            TeapotPatch& patch = patches.emplace_back();
            for (std::size_t r = 0; r < 4; ++r) {
                const auto [radius, bend, z] = rings[r];
                const double along[] = {radius, radius, bend, 0}, across[] = {0, bend, radius, radius};
                for (std::size_t c = 0; c < 4; ++c)
                    patch[4 * r + c] = along[c] * from + across[c] * to + glm::dvec3(0, 0, z);
            }
        }
    });
}

/// Adds the half at negative y, then the other half.
void mirror(std::span<const Rib> profile, std::vector<TeapotPatch>& patches) {
    each_four(profile, [&](std::span<const Rib> ribs) {
        TeapotPatch half, other;
        for (std::size_t r = 0; r < 4; ++r) {
            const auto [x, z, other_x, other_z, width] = ribs[r];
            const glm::dvec3 row[] = {
                {x, 0, z}, {x, -width, z}, {other_x, -width, other_z}, {other_x, 0, other_z}};
            for (std::size_t c = 0; c < 4; ++c) {
                half[4 * r + c] = row[c];
                other[4 * r + 3 - c] = {row[c].x, 0 - row[c].y, row[c].z};
            }
        }
        patches.insert(patches.end(), {half, other});
    });
}

}   // namespace

std::vector<TeapotPatch> teapot_patches() {
    std::vector<TeapotPatch> patches;
    revolve(body, -1, patches);
    mirror(handle, patches);
    mirror(spout, patches);
    revolve(lid, -1, patches);
    revolve(bottom, 1, patches);
    return patches;
}

}   // namespace rayclock
