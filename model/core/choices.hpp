#pragma once
// Parameters that are one of several named values. A row defines the enum, and the names in files and in
// --set.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/split.hpp"

namespace rayclock {

/// The names of an enum of this file, in the order of its values.
template <class Choice> const std::vector<std::string>& names_of();

/// The name of a value.
template <class Choice> const std::string& name_of(Choice value) {
    return names_of<Choice>()[std::size_t(value)];
}

/// The value of that name; it must exist.
template <class Choice> Choice choice_named(std::string_view name) {
    const std::vector<std::string>& names = names_of<Choice>();
    return Choice(std::find(names.begin(), names.end(), name) - names.begin());
}

/// "a, b, c" as its words.
inline std::vector<std::string> words_of(std::string_view list) {
    std::vector<std::string> words = split(list, ',');
    for (std::string& word : words) word.erase(0, word.find_first_not_of(' '));
    return words;
}

#define RAYCLOCK_CHOICE(Type, ...) RAYCLOCK_CHOICE_OF(Type, __VA_ARGS__)
#define RAYCLOCK_CHOICE_OF(Type, ...)                                         \
    enum class Type { __VA_ARGS__ };                                          \
    template <> inline const std::vector<std::string>& names_of<Type>() {     \
        static const std::vector<std::string> names = words_of(#__VA_ARGS__); \
        return names;                                                         \
    }

/// Ray-triangle tests: model/unit/tri/tri_test.hpp.
RAYCLOCK_CHOICE(PrimitiveTest, exact, sheared, unit24, moller, woop, truncated)

// Structures of nodes: boxes (engine/bvh), space cut by axis-parallel planes (engine/kd), cells cut in the
// middle of all axes (engine/octree; the engine of kd walks them), bounding spheres (engine/spheres), space
// cut by planes in any direction (engine/bsp), pairs of planes across an axis (engine/bih).
#define RAYCLOCK_TREES bvh, kd, octree, spheres, bsp, bih

/// Acceleration structures. none is a list of all primitives (engine/none).
RAYCLOCK_CHOICE(Structure, RAYCLOCK_TREES, none)

/// Returns the acceleration structures that have nodes.
inline std::vector<Structure> tree_structures() {
    std::vector<Structure> all;
    for (int s = 0; s < int(names_of<Structure>().size()); ++s)
        if (Structure(s) != Structure::none) all.push_back(Structure(s));
    return all;
}

/// Acceleration structures of meshes, with two levels; same: the structure of the scene.
RAYCLOCK_CHOICE(MeshStructure, same, RAYCLOCK_TREES)

/// Where a primitive goes that lies on both sides of a plane, in an octree and in bsp: into every leaf that
/// it reaches into, into the inner node (octree), or the plane is not used (bsp).
RAYCLOCK_CHOICE(Straddlers, leaves, inner, stop)

/// Whether the builder of boxes may cut primitives.
RAYCLOCK_CHOICE(Splits, off, on)

/// The source of rays: the camera and shade, or records in memory (docs/guide/streams.md).
RAYCLOCK_CHOICE(RaySource, camera, stream)

/// Formats of texels, both sRGB (model/unit/tex/texel.hpp): 8 bits a channel with 8 bits of alpha, or 5, 6
/// and 5 bits with one bit of alpha.
RAYCLOCK_CHOICE(TexelFormat, rgb888, rgb565)

/// The length of paths in the RTL: model/core/stages.hpp.
RAYCLOCK_CHOICE(Timing, relaxed, fast)

/// Memories outside the chip: model/core/dram_presets.hpp. board is the SDRAM of rtl/board with its
/// controller.
RAYCLOCK_CHOICE(DramName, ideal, sdr, ddr3, rpu, sdr_half, ddr4, lpddr4, hbm2, board)

#undef RAYCLOCK_CHOICE
#undef RAYCLOCK_CHOICE_OF

}   // namespace rayclock
