// Puts infinite planes on the lattice.
#include "model/compile/plane.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rayclock {

namespace {

constexpr double longest_side = 1.0 / 16;    // as a share of the lattice's reach
constexpr int max_level = corner_bits - 1;   // a phase counts sides of two squares

/// Returns how often a square's side is halved; negative if it is doubled.
int level_of(double side, double reach) { return int(std::ceil(std::log2(side / (longest_side * reach)))); }

double phase_of(double at, int level) {
    const double pair = std::ldexp(1.0, level + 1);
    return level < 0 ? 0 : at - pair * std::floor(at / pair);
}

}   // namespace

glm::dvec3 nearest_point(const Plane& plane, const glm::dvec3& from) {
    const glm::dvec3 n = glm::cross(glm::normalize(plane.u), glm::normalize(plane.v)), size = glm::abs(n);
    return from - glm::sign(n) * (glm::dot(n, from - plane.point) / (size.x + size.y + size.z));
}

PlaneOnLattice plane_on_lattice(const Plane& plane, const Lattice& lattice) {
    const double reach = double((1 << (lattice.coord_bits - 1)) - 1) * lattice.pitch.x;
    const glm::dvec3 middle = nearest_point(plane, lattice.centre) - plane.point;
    PlaneOnLattice out;
    std::array<Vec3i, 2> side{};
    glm::dvec3 at = plane.point;
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3& whole = i == 0 ? plane.u : plane.v;
        out.level[i] = level_of(glm::length(whole), reach);
        const glm::dvec3 part = whole * std::ldexp(1.0, -out.level[i]);
        out.at[i] = std::round(glm::dot(middle, part) / glm::dot(part, part));
        at += out.at[i] * part;
        for (std::size_t k = 0; k < 3; ++k)
            side[i][k] = std::int32_t(std::lround(part[int(k)] / lattice.pitch[int(k)]));
    }
    out.a = out.b = out.c = lattice.snap(at);
    for (std::size_t k = 0; k < 3; ++k) out.b[k] += side[0][k], out.c[k] += side[1][k];
    return out;
}

std::optional<CornerCoordinates> plane_coordinates(const Plane& plane, const PlaneOnLattice& on,
                                                   const Texture& texture) {
    std::array<glm::dvec2, 2> step{};
    CornerCoordinates corners;
    corners[0] = plane.coordinates[0];
    for (std::size_t i = 0; i < 2; ++i) {
        step[i] = (plane.coordinates[i + 1] - plane.coordinates[0]) * std::ldexp(1.0, -on.level[i]);
        corners[0] += on.at[i] * step[i];
    }
    corners[1] = corners[0] + step[0], corners[2] = corners[0] + step[1];
    corners = near_zero(texture, corners);
    for (const glm::dvec2& corner : corners)
        if (!(std::abs(corner.x) <= max_coordinate && std::abs(corner.y) <= max_coordinate))
            return std::nullopt;
    return corners;
}

Plane snapped_plane(const Plane& plane, const Lattice& lattice) {
    const PlaneOnLattice on = plane_on_lattice(plane, lattice);
    const auto point = [](const Vec3i& p) { return glm::dvec3(p[0], p[1], p[2]); };
    const glm::dvec3 u = point(on.b) - point(on.a), v = point(on.c) - point(on.a);
    return {point(on.a) - on.at[0] * u - on.at[1] * v, u * std::ldexp(1.0, on.level[0]),
            v * std::ldexp(1.0, on.level[1]), plane.material, plane.coordinates};
}

void set_checkers(const PlaneOnLattice& plane, const Config& config, Surface& surface) {
    if (!surface.checkered) return;
    for (std::size_t i = 0; i < 2; ++i) {
        const int level = plane.level[i], bit = config.bary_bits + level;
        if (bit < 0) {   // squares finer than u and v
            for (std::size_t k = 0; k < 3; ++k)
                surface.colour[k] = surface.other[k] = (surface.colour[k] + surface.other[k]) >> 1;
        } else if (level > max_level) {   // one square around a covers the whole range
            if (std::fmod(std::floor(std::ldexp(plane.at[i], -level)), 2) != 0)
                std::swap(surface.colour, surface.other);
            surface.normal[2 + i] = -1;
        } else {
            const auto phase = std::int32_t(phase_of(plane.at[i], level));
            surface.normal[i] = phase < 1 << max_level ? phase : phase - (2 << max_level);
            surface.normal[2 + i] = bit;
        }
    }
}

double room_around_planes(const Scene& scene, const Config& config) {
    if (!config.planes) return 1;
    const double reach = std::ldexp(1.0, config.coord_bits - 1);
    const double step =
        std::ldexp(1.0, config.dir_bits - 2 + config.approach_shift() - config.origin_bits) / reach;
    const bool go_on = std::any_of(scene.planes.begin(), scene.planes.end(), [&](const Plane& plane) {
        if (plane.material >= scene.materials.size()) return false;
        const Material& m = scene.materials[plane.material];
        return m.transmit > 0 || m.mirror > 0;
    });
    const double room = config.shading && go_on && scene.planes.size() > 1 ? horizon_room : 1;
    return room / (1 - step - 4 / reach);   // and a few steps for rounding
}

}   // namespace rayclock
