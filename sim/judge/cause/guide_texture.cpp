// Judges the textures that the machine draws on the guided path: coordinates, level, holes and colour.
#include "sim/judge/cause/guide.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "sim/judge/cause/level_error.hpp"
#include "sim/judge/cause/tie.hpp"
#include "sim/judge/paths/arithmetic.hpp"
#include "sim/judge/reference/geometry.hpp"
#include "sim/judge/reference/holes.hpp"

namespace rayclock {

namespace {

/// Returns the level of detail of a texture that is seen at this cosine. An error may make the cosine
/// negative.
double detail_at(const RefTexel& texel, double cosine) {
    return level_of_detail(texel.detail, texel.distance, texel.spread, std::max(cosine, 0.0));
}

/// Colours and alpha at several places of a texture: the least and the largest value of each channel.
struct TexelRange {
    glm::dvec3 low{2}, high{-1};
    double clear = 2, dense = -1;   ///< alpha
};
/// Returns the range over all places within `error` of `st`, on the machine's grid of 256ths of a texel.
TexelRange texel_range(const Texture& texture, int level, const glm::dvec2& st, const glm::dvec2& error) {
    const TexelLevel& picture =
        texture.pyramid->levels[std::min(std::size_t(level), texture.pyramid->levels.size() - 1)];
    const glm::dvec2 grid(256.0 * picture.width, 256.0 * picture.height),
        moved = error * grid, first = glm::floor(st * grid - moved),
        last = glm::floor(st * grid + moved) + 1.0;
    TexelRange range;
    for (double y = first.y; y <= last.y; ++y)
        for (double x = first.x; x <= last.x; ++x) {
            const glm::dvec4 found = filtered_with_alpha(texture, glm::dvec2(x, y) / grid, level);
            range.low = glm::min(range.low, glm::dvec3(found));
            range.high = glm::max(range.high, glm::dvec3(found));
            range.clear = std::min(range.clear, found.a), range.dense = std::max(range.dense, found.a);
        }
    return range;
}

}   // namespace

double stretch_error(const std::array<std::int64_t, 9>& a) {
    glm::dmat3 map;
    for (int i = 0; i < 9; ++i) map[i % 3][i / 3] = double(a[std::size_t(i)]);
    const glm::dmat3 square = glm::transpose(map) * map;
    const double size = (square[0][0] + square[1][1] + square[2][2]) / 3;
    double off = 0;   // deviation from a multiple of the identity
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) off = std::max(off, std::abs(square[i][k] - (i == k ? size : 0)));
    if (off <= 0x1p-10 * size) return 0x1p-8;
    // The map scales areas by a factor between the smallest and the largest product of two singular values.
    const double volume = std::abs(glm::determinant(map)), largest = std::sqrt(3 * size);
    const double least = volume / largest, most = largest * largest, mean = std::cbrt(volume * volume);
    return 0.5 * std::max(std::log2(most / mean), std::log2(mean / least));
}

/// A place in a texture that the machine reads.
struct Guide::TexturePlace {
    glm::dvec2 st{0};
    glm::dvec2 error{0x1p-19};   ///< in pictures
    double scale_error = 0;      ///< in levels, from an instance's map
    bool is_wrong = false;       ///< it does not belong to the point that was hit
    bool is_last = false;        ///< the machine draws the texture's last level at any distance
};

/// The machine rounds the weights of the corners and the coordinates.
Guide::TexturePlace Guide::place_on_triangle(const MachineVisit& at, const RefClosest& hit,
                                             const RefTexel& own) const {
    const auto& [a, b, c] = rules_.scene.coordinates[hit.primitive];
    const double fine = std::exp2(-rules_.inputs.config.bary_bits);
    double u = fine * at.hit.u, v = fine * at.hit.v;
    const std::uint32_t place =
        rules_.placed ? rules_.placed->place_of(at.hit.prim) : oracle::PlacedRay::nowhere;
    if (rules_.placed && rules_.placed->is_mirrored(place)) std::swap(u, v);
    TexturePlace found;
    found.st = (1 - u - v) * a + u * b + v * c;
    // With two levels the ray is rounded in the instance's space, so it may hit the triangle a few steps
    // away.
    double away = 0;
    if (rules_.placed && is_turned(at)) {
        const auto& vertex = rules_.scene.triangles[hit.primitive].vertex;
        const auto corner = [&](std::size_t k) { return rules_.scene.vertices[vertex[k]]; };
        const glm::dvec3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0);
        const double longest = glm::length(e1) + glm::length(e2), area = glm::length(glm::cross(e1, e2));
        const glm::dvec3& pitch = rules_.inputs.lattice.pitch;
        const double steps = 4 * std::max(pitch.x, std::max(pitch.y, pitch.z));
        away = steps * longest / area / std::max(own.cosine, 0x1p-8);
        found.scale_error = stretch_error(rules_.placed->solids().places()[place].a);
    }
    const glm::dvec2 edges = glm::abs(b - a) + glm::abs(c - a);
    found.is_wrong = !is_substituted_ && glm::any(glm::greaterThan(glm::abs(found.st - own.st),
                                                                   (4 * fine + away) * edges + 0x1p-18));
    return found;
}

/// The machine projects the unit normal that it found. The normal follows from the hit's point, which
/// move_ray_origin() judges. Rounding lowers each quotient by less than 2^(1 - bary_bits), and the 1 in the
/// divisor lowers it by at most 2^-16. An error e of both quotients is at most (e, 2 e, e) on the octahedron.
/// The octahedron lies at least 1 / sqrt(3) from its middle, so this is at most sqrt(18) e on the sphere.
Guide::TexturePlace Guide::place_on_sphere(const MachineVisit& at, const RefClosest& hit) const {
    const double fine = std::exp2(-rules_.inputs.config.bary_bits);
    const Sphere& sphere = rules_.scene.spheres[hit.primitive - rules_.scene.triangles.size()];
    const glm::dvec3 out = glm::normalize(point(at.state.o, rules_.inputs.config.origin_frac()) -
                                          rules_.reference.geometry().space()(sphere.centre));
    TexturePlace found;
    found.st = fine * glm::dvec2(at.texture->u, at.texture->v);
    found.is_wrong = glm::length(octahedral_direction(found.st) - out) >
                     vector_error + 4.25 * (2 * fine + 0x1p-16) + tie_size;
    return found;
}

/// The machine counts sides of the plane from a point a (plane.hpp). This function computes the coordinates
/// at the same point from the plane's own point and squares. move_ray_origin() judges the point. The
/// machine's coordinates at a, b and c have 20 fraction bits. If their differences are not multiples of
/// 2^-20, the error grows with the number of sides.
Guide::TexturePlace Guide::place_on_plane(const MachineVisit& at, const RefClosest& hit,
                                          const Texture& texture) const {
    const Config& config = rules_.inputs.config;
    const Lattice& lattice = rules_.inputs.lattice;
    const Plane& plane =
        rules_.scene.planes[hit.primitive - rules_.scene.triangles.size() - rules_.scene.spheres.size()];
    const glm::dvec3 n = glm::cross(plane.u, plane.v);
    const auto coordinates_along = [&](const glm::dvec3& way) {
        const double u = glm::dot(glm::cross(way, plane.v), n) / glm::dot(n, n),
                     v = glm::dot(glm::cross(plane.u, way), n) / glm::dot(n, n);
        return u * (plane.coordinates[1] - plane.coordinates[0]) +
               v * (plane.coordinates[2] - plane.coordinates[0]);
    };
    const auto of = [&](const Vec3i& p) { return lattice.pitch * glm::dvec3(p[0], p[1], p[2]); };
    const glm::dvec3 a = of(at.surface.a);
    TexturePlace found;
    found.st = plane.coordinates[0] + coordinates_along(lattice.centre + a - plane.point);
    const glm::dvec2 at_a = found.st;
    const double end = std::exp2(config.uv_bits() - 1);
    for (std::size_t i = 0; i < 2; ++i) {
        const double field = i == 0 ? at.hit.u : at.hit.v, whole = field >= end ? field - 2 * end : field,
                     sides = std::ldexp(whole, -config.bary_bits);
        const glm::dvec2 step = coordinates_along(of(i == 0 ? at.surface.b : at.surface.c) - a);
        found.st += sides * step;
        found.is_last = found.is_last || whole == end - 1 || whole == -end;
        for (int axis = 0; axis < 2; ++axis) {
            const double units = std::ldexp(step[axis], coordinate_frac);
            if (std::abs(units - std::round(units)) > 0x1p-12)
                found.error[axis] += std::ldexp(std::abs(sides), -coordinate_frac);
            // These coordinates may not fit into a record. b and c may lie on opposite sides of a.
            const bool clamps = (axis == 0 ? texture.wrap_s : texture.wrap_t) == Wrap::clamp;
            found.is_last = found.is_last || std::abs(step[axis]) > max_coordinate - 2 ||
                            (clamps && std::abs(at_a[axis]) + std::abs(step[axis]) > max_coordinate - 1);
        }
    }
    return found;
}

Guide::TexturePlace Guide::texture_place(const MachineVisit& at, const RefClosest& hit,
                                         const Texture& texture, const RefTexel& own) const {
    switch (at.surface.kind) {
        case PrimKind::sphere: return place_on_sphere(at, hit);
        case PrimKind::plane: return place_on_plane(at, hit, texture);
        default: return place_on_triangle(at, hit, own);
    }
}

/// Returns the amount, in scene units, by which the machine's path to a plane's hit is longer than the
/// reference's. A bounce from beyond the lattice stores its origin divided by 2^far_drop. Where t is
/// saturated, the machine measures the path from this stored point.
double Guide::extra_distance(const MachineVisit& at, const RefClosest& hit) const {
    const Config& config = rules_.inputs.config;
    if (at.surface.kind != PrimKind::plane || at.ray.is_partial == 0 ||
        at.hit.t != (1u << config.t_bits()) - 1)
        return 0;
    const Vec3i& o = at.ray.o;
    const glm::dvec3 from = point({o[0], o[1], o[2]}, config.origin_frac());
    return (glm::distance(point(at.state.o, config.origin_frac()), from) - hit.depth) /
           rules_.reference.geometry().space().scale;
}

/// Judges the level that the machine draws. The machine finds it from logarithms of 6 fraction bits. Its
/// length of a path errs by 0.098 of a level, and by another 0.023 because |d| has 7 fraction bits. The
/// logarithm of the path adds 0.031. The logarithm of the cosine adds half of 0.031 and 1/128. The two
/// registers add 1/128 each.
void Guide::judge_level(int level, const TexturePlace& place, const Texture& texture, const RefTexel& own) {
    const double level_error = error_of_level + place.scale_error;
    constexpr double cosine_error_of_level = 0x1p-12;
    const double least = detail_at(own, own.cosine + cosine_error_of_level),
                 most = detail_at(own, own.cosine - cosine_error_of_level);
    const bool is_last = place.is_last && level == int(texture.pyramid->levels.size()) - 1;
    if (!is_last && level > level_of(texture, least) && level > std::floor(most + 0.5 + level_error))
        fail("a texture is drawn at a level that is too coarse");
    if (level < level_of(texture, most) && level < std::ceil(least - 0.5 - level_error))
        fail("a texture is drawn at a level that is too fine");
}

/// The machine rounds the weights of the corners, the coordinates, and the place in texels down.
void Guide::texel(const RefClosest& hit, const RefSurface& surface, RefTexel& own) {
    const MachineVisit* at = visit();
    if (!at || !at->hit.found || at->hit.prim != hit.primitive) return;
    if (!at->texture) return fail("a surface is drawn without its texture");
    const Texture& texture = rules_.scene.textures[*surface.material->texture];
    const TexturePlace place = texture_place(*at, hit, texture, own);
    if (place.is_wrong) fail("the coordinates of a texture do not belong to the point that was hit");
    own.distance += extra_distance(*at, hit);
    const auto level = int(at->texture->level);
    judge_level(level, place, texture, own);
    const TexelRange range = texel_range(texture, level, place.st, place.error);

    // The cut-off is rounded to a code.
    if (const bool is_hole = at->texture->is_hole; is_hole != own.is_hole) {
        const double cutoff = surface.material->cutoff, half = 0.5 / 255;
        if (is_hole ? range.clear < cutoff + half : range.dense >= cutoff - half)
            tie();
        else
            fail("a texture has a hole where its picture has none, or none where it has one");
        own.is_hole = is_hole;
    }

    const double unit = std::exp2(-share_bits);
    glm::dvec3 seen(0);
    for (int k = 0; k < 3; ++k) {
        const double albedo = std::ldexp(double(at->state.albedo[std::size_t(k)]), -share_bits),
                     material = surface.colour[k];
        if (albedo < material * range.low[k] - 2 * unit || albedo > material * range.high[k] + 2 * unit)
            fail("a texture gives another colour than its picture");
        seen[k] = material > 0 ? albedo / material : own.colour[k];
    }
    own.colour = seen;
    const Texture& whole = rules_.inputs.scene.textures[*surface.material->texture];
    const glm::dvec3 exact = filtered(whole, own.st, level_of(whole, detail_at(own, own.cosine)));
    finding_.has_texture |=
        glm::any(glm::greaterThan(glm::abs(seen - exact) * surface.colour, glm::dvec3(2 * unit)));
}

}   // namespace rayclock
