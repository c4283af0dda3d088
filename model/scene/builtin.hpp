#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "model/scene/scene.hpp"

namespace rayclock {

/// How round things are made: cut into triangles, or spheres as spheres. Cones and cylinders are always cut;
/// so is all that a scene has beside spheres. The newer scenes (spheres, plane, mirrors, square) have only
/// one form, which is native.
enum class Primitives { triangles, native };

struct PrimitiveCounts {
    std::uint64_t triangles = 0, spheres = 0, planes = 0;
    friend bool operator==(const PrimitiveCounts&, const PrimitiveCounts&) = default;
};

/// A scene that the program makes itself.
struct Builtin {
    std::string_view name;
    int default_size;           ///< size factor when none is given
    int max_size;               ///< largest accepted (keeps to about 10 million triangles)
    std::string_view purpose;   ///< one line for `rayclock scenes`
    PrimitiveCounts (*counts)(int size, Primitives primitives);   ///< exact, by formula
    Scene (*generate)(int size, Primitives primitives);

    std::uint64_t triangles(int size) const { return counts(size, Primitives::triangles).triangles; }
    Scene make(int size, Primitives primitives = Primitives::triangles) const {
        return generate(size, primitives);
    }
};

/// All of them, in the order they are listed.
std::span<const Builtin> builtins();

/// `name` or `name:size`, for example "gears:8". Throws UserError for an unknown name (with the nearest known
/// one) and for a size that is not a number in 1..max_size.
Scene make_builtin(std::string_view spec, Primitives primitives = Primitives::triangles);

/// What make_builtin() would make of it, without making it. Throws as it does.
PrimitiveCounts builtin_counts(std::string_view spec, Primitives primitives);

/// True if `spec` up to a colon is the name of a built-in scene.
bool is_builtin(std::string_view spec);

}   // namespace rayclock
