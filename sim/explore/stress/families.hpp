#pragma once
// The families of hard cases: a surface and its rays. docs/measured/hard-cases.md shows them.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/explore/stress/mesh.hpp"

namespace rayclock::stress {

/// A ray, and how many bodies contain its origin. The number is empty if the origin may lie on a surface.
struct Shot {
    Vec3i o{}, d{};
    std::optional<int> inside;
};

/// A surface of a family, and its rays.
struct Case {
    Mesh mesh;
    std::function<Shot(Rng&)> shoot;
};

/// A family of hard cases.
struct Family {
    const char* name;
    const char* what;   ///< one sentence for the page
    bool closed;        ///< the surface is closed: leaks and double hits count
    bool leaks;         ///< negative control: the surface must leak
    Case (*make)(int coord_bits, int dir_bits, Rng& rng);
};

const std::vector<Family>& families();
/// Returns the family of this name. Throws UserError.
const Family& family(const std::string& name);

}   // namespace rayclock::stress
