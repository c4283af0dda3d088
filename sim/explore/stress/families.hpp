#pragma once
// The families of hard cases: which surface, and which rays. docs/hard-cases.md shows them.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/explore/stress/mesh.hpp"

namespace rayclock::stress {

/// A ray, and how often the bodies around its origin hold it; nothing if the origin may lie on a surface.
struct Shot {
    Vec3i o{}, d{};
    std::optional<int> inside;
};

/// One surface of a family, and its rays.
struct Case {
    Mesh mesh;
    std::function<Shot(Rng&)> shoot;
};

struct Family {
    const char* name;
    const char* what;   ///< one sentence for the page
    bool closed;        ///< leaks and double hits are counted
    bool leaks;         ///< negative control: it must leak
    Case (*make)(int coord_bits, int dir_bits, Rng& rng);
};

const std::vector<Family>& families();
/// Throws UserError.
const Family& family(const std::string& name);

}   // namespace rayclock::stress
