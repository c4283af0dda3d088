#pragma once
// The built-in scenes: their list, their counts and their generation.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "model/scene/scene.hpp"

namespace rayclock {

/// The form of round shapes: cut into triangles, or native spheres. Cones and cylinders are always cut, and
/// so is everything else except spheres. The newer scenes (spheres, plane, mirrors, square) have only one
/// form, which is native.
enum class Primitives { triangles, native };

struct PrimitiveCounts {
    std::uint64_t triangles = 0, spheres = 0, planes = 0;
    friend bool operator==(const PrimitiveCounts&, const PrimitiveCounts&) = default;
};

/// A scene that the program makes itself.
struct Builtin {
    std::string_view name;
    int default_size;           ///< size factor if none is given
    int max_size;               ///< largest accepted size (at most about 10 million triangles)
    std::string_view purpose;   ///< one line for `rayclock scenes`
    PrimitiveCounts (*counts)(int size, Primitives primitives);   ///< exact, by formula
    Scene (*generate)(int size, Primitives primitives);

    std::uint64_t triangles(int size) const { return counts(size, Primitives::triangles).triangles; }
    Scene make(int size, Primitives primitives = Primitives::triangles) const {
        return generate(size, primitives);
    }
};

/// Returns all built-in scenes, in the order of their listing.
std::span<const Builtin> builtins();

/// Makes the scene of a spec `name` or `name:size`, for example "gears:8"; some scenes take
/// `name:size:sides`. Throws UserError for an unknown name (with the nearest known one) and for a size that
/// is not a number in 1..max_size.
Scene make_builtin(std::string_view spec, Primitives primitives = Primitives::triangles);

/// Returns the counts of make_builtin() without making the scene. Throws as make_builtin() does.
PrimitiveCounts builtin_counts(std::string_view spec, Primitives primitives);

/// True if `spec` up to a colon is the name of a built-in scene.
bool is_builtin(std::string_view spec);

}   // namespace rayclock
