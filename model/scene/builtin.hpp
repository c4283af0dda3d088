#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "model/scene/scene.hpp"

namespace rayclock {

/// A scene that the program makes itself.
struct Builtin {
    std::string_view name;
    int default_size;                       ///< size factor when none is given
    int max_size;                           ///< largest accepted (keeps to about 10 million triangles)
    std::string_view purpose;               ///< one line for `rayclock scenes`
    std::uint64_t (*triangles)(int size);   ///< exact count, by formula
    Scene (*make)(int size);
};

/// All of them, in the order they are listed.
std::span<const Builtin> builtins();

/// `name` or `name:size`, for example "gears:8". Throws UserError for an unknown name (with the nearest known
/// one) and for a size that is not a number in 1..max_size.
Scene make_builtin(std::string_view spec);

/// True if `spec` up to a colon is the name of a built-in scene.
bool is_builtin(std::string_view spec);

} // namespace rayclock
