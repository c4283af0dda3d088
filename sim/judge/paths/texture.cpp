// Follows a hit to its texels in the scene's picture.
#include "sim/judge/paths/texture.hpp"

#include <cmath>

#include "sim/judge/paths/steps.hpp"

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

/// `s`, `t`: the corners' coordinates in units of 2^-20 pictures.
Footprint footprint(const FrameInputs& inputs, const Texture& texture, std::size_t level,
                    const std::array<std::int32_t, 3>& s, const std::array<std::int32_t, 3>& t,
                    std::uint32_t u, std::uint32_t v) {
    const TexelLevel& picture = texture.pyramid->levels[level];
    const auto at = [&](const std::array<std::int32_t, 3>& c) {
        return c[0] + floor_of(Int128(u) * (Int128(c[1]) - c[0]) + Int128(v) * (Int128(c[2]) - c[0]),
                               Int128(1) << inputs.config.bary_bits);
    };
    return {picture, on_side(at(s), picture.width, texture.wrap_s, texture.nearest),
            on_side(at(t), picture.height, texture.wrap_t, texture.nearest),
            inputs.config.texels == TexelFormat::rgb565};
}

const char* judge_record(const FrameInputs& inputs, const TexturedTriangle& triangle,
                         const TexRecord& record) {
    const Texture& texture = *triangle.texture;
    const CornerCoordinates& corners = triangle.coordinates;
    for (std::size_t k = 0; k < 3; ++k)
        if (!is_nearest(record.s[k], std::ldexp(corners[k].x, 20)) ||
            !is_nearest(record.t[k], std::ldexp(corners[k].y, 20)))
            return "memory does not hold the texture coordinates of the triangle that was hit";
    const std::vector<TexelLevel>& levels = texture.pyramid->levels;
    const auto mode = [](Wrap wrap) { return std::uint32_t(wrap); };   // the same order: repeat, mirror,
                                                                       // clamp
    if (levels[0].width != 1 << record.log_width || levels[0].height != 1 << record.log_height ||
        record.wrap_s != mode(texture.wrap_s) || record.wrap_t != mode(texture.wrap_t) ||
        (record.nearest != 0) != texture.nearest ||
        record.last_level != (texture.mipmaps ? levels.size() - 1 : 0))
        return "memory does not hold the texture of the triangle that was hit";
    const double cutoff = triangle.cutoff;
    const bool holds_cutoff =
        cutoff > 0 ? record.cutoff > 0 && is_nearest(record.cutoff, std::max(255 * cutoff, 1.0))
                   : record.cutoff == 0;
    if (!holds_cutoff) return "memory does not hold the cut-off of the texture that was hit";
    // Half the logarithm of the quotient of two areas.
    const auto& [p, q, r] = triangle.corners;
    const double area = glm::length(glm::cross(q - p, r - p));
    const glm::dvec2 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
    const double texels = std::abs(e1.x * e2.y - e1.y * e2.x) * levels[0].width * levels[0].height;
    const double most = std::exp2(level_bits - 1) - 1;
    const double density = texels > 0 && area > 0
                               ? 32 * (std::log2(texels) - std::log2(area)) - 64 * inputs.config.t_frac_bits
                               : -most;
    // Corners of large triangles have moved by up to 2^-13 of an edge.
    if (!is_nearest(record.density, std::clamp(density, -most, most), 0.05))
        return "memory does not hold the density of the texture that was hit";
    return nullptr;
}

}   // namespace

std::optional<TexturedTriangle> textured_triangle(const Scene& scene, const glm::dvec3& pitch,
                                                  std::size_t primitive) {
    if (primitive >= scene.triangles.size() || scene.coordinates.empty()) return std::nullopt;
    const Triangle& triangle = scene.triangles[primitive];
    const Material& material = scene.materials[triangle.material];
    if (!material.texture) return std::nullopt;
    TexturedTriangle found{
        &scene.textures[*material.texture], scene.coordinates[primitive], {}, material.cutoff};
    for (std::size_t k = 0; k < 3; ++k) found.corners[k] = scene.vertices[triangle.vertex[k]] / pitch;
    return found;
}

bool is_scale(std::int32_t scale, const std::array<std::int64_t, 9>& a, const Config& config) {
    glm::dmat3 map;
    for (int i = 0; i < 9; ++i) map[i % 3][i / 3] = double(a[std::size_t(i)]);
    const double volume = std::abs(glm::determinant(map));
    return is_nearest(scale, 64 * (std::log2(volume) / 3 - config.map_frac()));
}

std::uint32_t path_length(std::uint32_t before, const Vec3i& d, std::uint32_t t, const Config& config) {
    std::array<Int128, 3> size{};
    for (std::size_t k = 0; k < 3; ++k) size[k] = d[k] < 0 ? -Int128(d[k]) : Int128(d[k]);
    std::sort(size.begin(), size.end());
    const Int128 length = floor_of(
        size[2] + floor_of(size[1], 4) + floor_of(size[1], 8) + floor_of(size[0], 4) + floor_of(size[0], 16),
        Int128(1) << (config.dir_bits - 8));
    const Int128 path = before + floor_of(length * t, 128), most = (Int128(1) << config.t_bits()) - 1;
    return std::uint32_t(path < most ? path : most);
}

bool is_spread(const FrameInputs& inputs, int samples_per_side) {
    constexpr double half_degree = 3.14159265358979323846 / 360;
    const double width = 2 * std::tan(inputs.camera.fov_degrees * half_degree) / inputs.frame.height;
    return is_nearest(inputs.frame.shade.spread, 64 * (std::log2(width / samples_per_side) - 0.057));
}

bool is_hole(const FrameInputs& inputs, const TexturedTriangle& triangle, std::uint32_t u, std::uint32_t v) {
    if (triangle.cutoff <= 0) return false;
    std::array<std::int32_t, 3> s{}, t{};
    for (std::size_t k = 0; k < 3; ++k) {
        s[k] = std::int32_t(std::llround(std::ldexp(triangle.coordinates[k].x, 20)));
        t[k] = std::int32_t(std::llround(std::ldexp(triangle.coordinates[k].y, 20)));
    }
    const std::int64_t cutoff = std::max<std::int64_t>(std::llround(255 * triangle.cutoff), 1);
    return footprint(inputs, *triangle.texture, 0, s, t, u, v).sum(3) < Int128(cutoff) * 65536;
}

const char* judge_texture(const FrameInputs& inputs, const TexturedTriangle& triangle, const TexReq& hit,
                          const TexRecord& record, const TexelPlace& place, const TexRsp& answer) {
    const Texture* const texture = triangle.texture;
    if (const char* wrong = judge_record(inputs, triangle, record)) return wrong;

    const std::int64_t slant = std::max<std::int64_t>(64 * unit_bits - log_in_64ths(hit.cosine), 0) / 2;
    const std::int64_t detail =
        record.density + hit.scale + inputs.frame.shade.spread + log_in_64ths(hit.path) + slant;
    const Int128 level = hit.path == 0
                             ? Int128(0)
                             : std::clamp<Int128>(floor_of(detail + 32, 64), 0, Int128(record.last_level));
    if (Int128(place.level) != level) return "a texture's level does not follow from the hit's distance";

    const Footprint texels =
        footprint(inputs, *texture, std::size_t(level), record.s, record.t, hit.u, hit.v);
    if ((answer.hole != 0) != (texels.sum(3) < Int128(record.cutoff) * 65536))
        return "a texture has a hole where its picture has none, or none where it has one";
    for (std::size_t k = 0; k < 3; ++k)
        if (answer.colour[k] != nearest_of_power(texels.sum(k), 16))
            return "a texture's colour differs from its picture at the hit";
    return nullptr;
}

}   // namespace rayclock
