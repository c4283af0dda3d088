// Follows a hit to its texels in the scene's picture.
#include "sim/judge/paths/texture.hpp"

#include <cmath>

#include "model/compile/plane.hpp"
#include "sim/judge/paths/arithmetic.hpp"

namespace rayclock {

namespace {

constexpr double slack = 1e-6;

/// True if `number` is the nearest whole number to `value`, or one of two nearest.
bool is_nearest(std::int64_t number, double value, double error = 0) {
    return std::abs(double(number) - value) <= 0.5 + error + slack;
}

/// Returns log2(x) in 64ths, for the middle of x's part of 32 in its octave; 0 for 0.
std::int64_t log_in_64ths(std::uint64_t x) {
    if (x == 0) return 0;
    std::int64_t whole = 0;
    while (x >> whole > 1) ++whole;
    const double part = std::floor(std::ldexp(double(x), 5 - int(whole))) - 32;
    return 64 * whole + std::llround(64 * std::log2(1 + (part + 0.5) / 32));
}

/// Returns the intensity of a code, in units of 2^-12.
Int128 intensity(std::uint8_t code, std::uint32_t most) {
    // In a format with fewer bits: the nearest code, extended by repeating its upper bits.
    std::uint32_t shown = code;
    if (most != 255) {
        const auto few = std::uint32_t(std::lround(double(code) * most / 255));
        shown = most == 31 ? few * 8 + few / 4 : few * 4 + few / 16;
    }
    const double x = double(shown) / 255;
    const double light = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    return Int128(std::floor(light * std::exp2(share_bits) + 0.5));
}

/// A coordinate on a side of a level: two texels, and the weight of the second in 256ths.
struct TwoTexels {
    std::int64_t first = 0, second = 0;
    Int128 weight = 0;
};

/// `at`: the coordinate in units of 2^-20 pictures.
TwoTexels on_side(Int128 at, std::int64_t side, Wrap wrap, bool nearest) {
    const Int128 one = Int128(1) << 20;
    Int128 within = at;
    if (wrap == Wrap::repeat) {
        within = at - one * floor_of(at, one);
    } else if (wrap == Wrap::mirror) {
        within = at - 2 * one * floor_of(at, 2 * one);
        if (within >= one) within = 2 * one - 1 - within;
    } else {
        within = at < 0 ? Int128(0) : at >= one ? one - 1 : at;
    }
    Int128 place = floor_of(within * side * 256, one);
    if (nearest) return {std::int64_t(place / 256), std::int64_t(place / 256), 0};
    place -= 128;
    if (place < 0) place = wrap == Wrap::repeat ? place + side * 256 : Int128(0);
    const auto first = std::int64_t(place / 256);
    const std::int64_t next = first + 1 < side ? first + 1 : wrap == Wrap::repeat ? 0 : side - 1;
    return {first, next, place % 256};
}

/// Four texels and their weights.
struct Footprint {
    const TexelLevel& picture;
    TwoTexels x, y;
    bool is_short;   ///< rgb565

    /// Returns the weighted sum of a channel, 3 for alpha, times 65536.
    Int128 sum(std::size_t channel) const {
        const auto value = [&](std::int64_t column, std::int64_t row) {
            const std::uint8_t code = picture.texels[std::size_t(row * picture.width + column)][channel];
            if (channel == 3) return is_short ? Int128(code >= 128 ? 255 : 0) : Int128(code);
            return intensity(code, !is_short ? 255 : channel == 1 ? 63 : 31);
        };
        const auto along = [&](std::int64_t row) {
            return value(x.first, row) * (256 - x.weight) + value(x.second, row) * x.weight;
        };
        return along(y.first) * (256 - y.weight) + along(y.second) * y.weight;
    }
};

/// `s`, `t`: the corners' coordinates in units of 2^-20 pictures. `u`, `v`: whole numbers of 2^-bary_bits.
Footprint footprint(const FrameInputs& inputs, const Texture& texture, std::size_t level,
                    const std::array<std::int32_t, 3>& s, const std::array<std::int32_t, 3>& t, Int128 u,
                    Int128 v) {
    const TexelLevel& picture = texture.pyramid->levels[level];
    const auto at = [&](const std::array<std::int32_t, 3>& c) {
        return c[0] + floor_of(u * (Int128(c[1]) - c[0]) + v * (Int128(c[2]) - c[0]),
                               Int128(1) << inputs.config.bary_bits);
    };
    return {picture, on_side(at(s), picture.width, texture.wrap_s, texture.nearest),
            on_side(at(t), picture.height, texture.wrap_t, texture.nearest),
            inputs.config.texels == TexelFormat::rgb565};
}

/// True if memory holds the nearest numbers to the coordinates of three corners on one axis. For a plane all
/// three may differ by the same number of periods.
bool holds_axis(const std::array<std::int32_t, 3>& held, const CornerCoordinates& corners, int axis,
                Wrap wrap, PrimKind kind) {
    const double period = std::ldexp(wrap == Wrap::repeat ? 1.0 : 2.0, 20);
    const bool moves = kind == PrimKind::plane && wrap != Wrap::clamp;
    const double shift =
        moves ? period * std::round((std::ldexp(corners[0][axis], 20) - held[0]) / period) : 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double value = std::ldexp(corners[k][axis], 20);
        // If a plane's own point is far away, the coordinates are large, and a double rounds them.
        const double error = kind == PrimKind::plane ? 0x1p-50 * std::abs(value) : 0;
        if (!is_nearest(held[k], value - shift, error)) return false;
    }
    return true;
}

const char* judge_record(const FrameInputs& inputs, const TexturedSurface& surface, const TexRecord& record) {
    const Texture& texture = *surface.texture;
    const CornerCoordinates& corners = surface.coordinates;
    const bool holds_none =
        surface.is_average && record.s == std::array<std::int32_t, 3>{} && record.t == record.s;
    if (!holds_none &&
        (surface.is_average || !holds_axis(record.s, corners, 0, texture.wrap_s, surface.kind) ||
         !holds_axis(record.t, corners, 1, texture.wrap_t, surface.kind)))
        return "memory does not hold the texture coordinates of the surface that was hit";
    const std::vector<TexelLevel>& levels = texture.pyramid->levels;
    const auto mode = [](Wrap wrap) { return WrapMode(wrap); };   // the same order: repeat, mirror, clamp
    if (levels[0].width != 1 << record.log_width || levels[0].height != 1 << record.log_height ||
        record.wrap_s != mode(texture.wrap_s) || record.wrap_t != mode(texture.wrap_t) ||
        (record.nearest != 0) != texture.nearest ||
        record.last_level != (texture.mipmaps || surface.is_average ? levels.size() - 1 : 0))
        return "memory does not hold the texture of the surface that was hit";
    const double cutoff = surface.cutoff;
    const bool holds_cutoff =
        cutoff > 0 ? record.cutoff > 0 && is_nearest(record.cutoff, std::max(255 * cutoff, 1.0))
                   : record.cutoff == 0;
    if (!holds_cutoff) return "memory does not hold the cut-off of the texture that was hit";
    const double most = std::exp2(level_bits - 1) - 1;
    const double density = surface.is_average ? most : 64 * (surface.detail - inputs.config.t_frac_bits);
    // Corners of large triangles have moved by up to 2^-13 of an edge.
    const double error = surface.kind == PrimKind::triangle ? 0.05 : 0;
    if (!is_nearest(record.density, std::clamp(density, -most, most), error))
        return "memory does not hold the density of the texture that was hit";
    return nullptr;
}

/// Returns log2 of the texels per unit of length: half the logarithm of a quotient of areas. `normal`: the
/// cross product of the sides from the first corner to the other two.
double detail_of(const Texture& texture, const CornerCoordinates& corners, const glm::dvec3& normal) {
    const TexelLevel& level = texture.pyramid->levels[0];
    const glm::dvec2 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
    const double texels = std::abs(e1.x * e2.y - e1.y * e2.x) * level.width * level.height,
                 area = glm::length(normal);
    return texels > 0 && area > 0 ? 0.5 * (std::log2(texels) - std::log2(area)) : -HUGE_VAL;
}

/// Sets the coordinates at the corners that a plane has in memory, from the coordinates of its squares.
void set_plane(const Plane& plane, const PlaneOnLattice& on, TexturedSurface& out) {
    const glm::dvec2 along_u = plane.coordinates[1] - plane.coordinates[0],
                     along_v = plane.coordinates[2] - plane.coordinates[0];
    const auto at = [&](double sides_u, double sides_v) {
        return plane.coordinates[0] + std::exp2(-on.level[0]) * sides_u * along_u +
               std::exp2(-on.level[1]) * sides_v * along_v;
    };
    out.coordinates = {at(on.at[0], on.at[1]), at(on.at[0] + 1, on.at[1]), at(on.at[0], on.at[1] + 1)};
    for (int axis = 0; axis < 2; ++axis) {
        const auto& c = out.coordinates;
        double low = std::min({c[0][axis], c[1][axis], c[2][axis]}),
               high = std::max({c[0][axis], c[1][axis], c[2][axis]});
        // Whole periods are subtracted, so that the middle lies in the first period.
        const Wrap wrap = axis == 0 ? out.texture->wrap_s : out.texture->wrap_t;
        if (wrap != Wrap::clamp) {
            const double period = wrap == Wrap::repeat ? 1 : 2,
                         shift = period * std::floor((low + high) / 2 / period);
            low -= shift, high -= shift;
        }
        out.is_average |= !(low >= -max_coordinate && high <= max_coordinate);
    }
}

}   // namespace

std::optional<TexturedSurface> textured_surface(const Scene& scene, const Lattice& lattice,
                                                std::size_t primitive) {
    const std::size_t triangles = scene.triangles.size(), planes = triangles + scene.spheres.size();
    const Material& material = material_of(scene, primitive);
    if (!material.texture || (primitive < triangles && scene.coordinates.empty())) return std::nullopt;
    TexturedSurface found;
    found.texture = &scene.textures[*material.texture];
    if (primitive < triangles) {
        const auto& vertex = scene.triangles[primitive].vertex;
        found.coordinates = scene.coordinates[primitive], found.cutoff = material.cutoff;
        const auto corner = [&](std::size_t k) { return scene.vertices[vertex[k]] / lattice.pitch; };
        found.detail = detail_of(*found.texture, found.coordinates,
                                 glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    } else if (primitive < planes) {
        const double radius = scene.spheres[primitive - triangles].radius / lattice.pitch.x;
        found.kind = PrimKind::sphere;
        found.coordinates = {{{0, 0}, {1, 0}, {0, 1}}};
        const TexelLevel& level = found.texture->pyramid->levels[0];
        found.detail = 0.5 * std::log2(double(level.width) * level.height /
                                       (4 * 3.14159265358979323846 * radius * radius));
    } else {
        const Plane& plane = scene.planes[primitive - planes];
        found.kind = PrimKind::plane;
        found.detail = detail_of(*found.texture, plane.coordinates,
                                 glm::cross(plane.u / lattice.pitch, plane.v / lattice.pitch));
        set_plane(plane, plane_on_lattice(plane, lattice), found);
    }
    return found;
}

bool may_have_holes(const Scene& scene, std::size_t primitive) {
    if (primitive >= scene.triangles.size() || scene.coordinates.empty()) return false;
    const Material& material = material_of(scene, primitive);
    return material.texture && material.cutoff > 0;
}

bool is_octahedral(const TexReq& hit, const Vec3i& outwards, const Config& config) {
    const auto size = [&](std::size_t k) { return Int128(outwards[k] < 0 ? -outwards[k] : outwards[k]); };
    const Int128 whole = size(0) + size(1) + size(2) + 1, half = Int128(1) << (config.bary_bits - 1);
    const std::array<Int128, 2> middle{floor_of(half * size(0), whole), floor_of(half * size(2), whole)};
    for (std::size_t i = 0; i < 2; ++i) {
        // The lower half of the sphere is folded outwards: each axis gets 1 minus the other one.
        const Int128 away = outwards[1] < 0 ? half - middle[1 - i] : middle[i];
        if (Int128(i == 0 ? hit.u : hit.v) != (outwards[2 * i] < 0 ? half - away : half + away)) return false;
    }
    return true;
}

bool is_scale(std::int32_t scale, const std::array<std::int64_t, 9>& a, const Config& config) {
    glm::dmat3 map;
    for (int i = 0; i < 9; ++i) map[i % 3][i / 3] = double(a[std::size_t(i)]);
    const double volume = std::abs(glm::determinant(map));
    return is_nearest(scale, 64 * (std::log2(volume) / 3 - config.map_frac()));
}

std::uint32_t path_length(std::uint32_t before, const Vec3i& d, std::uint32_t t,
                          const std::optional<Vec3l>& far_way, const Config& config) {
    const auto length_of = [](const auto& v) {
        std::array<Int128, 3> size{};
        for (std::size_t k = 0; k < 3; ++k) size[k] = v[k] < 0 ? -Int128(v[k]) : Int128(v[k]);
        std::sort(size.begin(), size.end());
        return size[2] + floor_of(size[1], 4) + floor_of(size[1], 8) + floor_of(size[0], 4) +
               floor_of(size[0], 16);
    };
    const Int128 added = far_way
                             ? floor_of(length_of(*far_way) * (Int128(1) << config.t_frac_bits),
                                        Int128(1) << config.origin_bits)
                             : floor_of(floor_of(length_of(d), Int128(1) << (config.dir_bits - 8)) * t, 128);
    const Int128 path = before + added, most = (Int128(1) << (config.t_bits() + (config.planes ? 6 : 0))) - 1,
                 widest = (Int128(1) << 32) - 1;
    return std::uint32_t(std::min({path, most, widest}));
}

bool is_spread(const FrameInputs& inputs, int samples_per_side) {
    constexpr double half_degree = 3.14159265358979323846 / 360;
    const std::optional<PictureWindow>& window = inputs.camera.window;
    const double height = window ? window->whole_height : int(inputs.frame.height),
                 width = 2 * std::tan(inputs.camera.fov_degrees * half_degree) / height;
    return is_nearest(inputs.frame.shade.spread, 64 * (std::log2(width / samples_per_side) - 0.057));
}

const char* judge_texture(const FrameInputs& inputs, const TexturedSurface& surface, const TexReq& hit,
                          const TexRecord& record, const TexelPlace& place, const TexRsp& answer) {
    const Texture* const texture = surface.texture;
    if (const char* wrong = judge_record(inputs, surface, record)) return wrong;

    // A plane's u and v are signed. At the ends of their range the texture's last level is drawn.
    const Int128 end = (Int128(1) << (inputs.config.uv_bits() - 1)) - 1;
    const auto weight = [&](std::uint32_t x) {
        return surface.kind == PrimKind::plane && Int128(x) > end ? Int128(x) - 2 * end - 2 : Int128(x);
    };
    const Int128 u = weight(hit.u), v = weight(hit.v);
    const bool ends =
        surface.kind == PrimKind::plane && (u == end || v == end || u == -end - 1 || v == -end - 1);

    const std::int64_t slant = std::max<std::int64_t>(64 * unit_bits - log_in_64ths(hit.cosine), 0) / 2;
    const std::int64_t detail =
        record.density + hit.scale + inputs.frame.shade.spread + log_in_64ths(hit.path) + slant;
    const Int128 level = hit.path == 0 ? Int128(0)
                         : ends        ? Int128(record.last_level)
                                : std::clamp<Int128>(floor_of(detail + 32, 64), 0, Int128(record.last_level));
    if (Int128(place.level) != level) return "a texture's level does not follow from the hit's distance";

    const Footprint texels = footprint(inputs, *texture, std::size_t(level), record.s, record.t, u, v);
    if ((answer.hole != 0) != (texels.sum(3) < Int128(record.cutoff) * 65536))
        return "a texture has a hole where its picture has none, or none where it has one";
    for (std::size_t k = 0; k < 3; ++k)
        if (answer.colour[k] != nearest_of_power(texels.sum(k), 16))
            return "a texture's colour differs from its picture at the hit";
    return nullptr;
}

}   // namespace rayclock
