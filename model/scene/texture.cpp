// Mip levels, resampling, wrapping and filtering of textures in double precision.
#include "model/scene/texture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <tbb/parallel_for.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {
namespace {

using Texel = std::array<std::uint8_t, 4>;

double decoded(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

std::array<double, 256> all_codes() {
    std::array<double, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code) table[code] = decoded(double(code) / 255);
    return table;
}

/// Sums of weighted texels. If all texels are transparent, the plain mean replaces the mean weighted by
/// alpha.
struct TexelSum {
    glm::dvec3 plain{0}, by_alpha{0};
    double weight = 0, alpha = 0;

    void add(const glm::dvec3& colour, double texel_alpha, double texel_weight) {
        plain += texel_weight * colour;
        by_alpha += texel_weight * texel_alpha * colour;
        weight += texel_weight, alpha += texel_weight * texel_alpha;
    }
    void add(const TexelSum& other, double factor) {
        plain += factor * other.plain, by_alpha += factor * other.by_alpha;
        weight += factor * other.weight, alpha += factor * other.alpha;
    }
    Texel texel(bool alphas_differ) const {
        const glm::dvec3 colour = alphas_differ && alpha > 0 ? by_alpha / alpha : plain / weight;
        return {linear_to_srgb(colour.r), linear_to_srgb(colour.g), linear_to_srgb(colour.b),
                static_cast<std::uint8_t>(std::floor(alpha / weight + 0.5))};
    }
};

glm::dvec3 colour_of(const Texel& texel) {
    return {srgb_to_linear(texel[0]), srgb_to_linear(texel[1]), srgb_to_linear(texel[2])};
}

const Texel& texel_at(const TexelLevel& level, int x, int y) {
    return level.texels[std::size_t(y) * std::size_t(level.width) + std::size_t(x)];
}

TexelLevel halved(const TexelLevel& level) {
    TexelLevel out{std::max(level.width / 2, 1), std::max(level.height / 2, 1), {}};
    out.texels.reserve(std::size_t(out.width) * std::size_t(out.height));
    const int wide = level.width / out.width, high = level.height / out.height;
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            TexelSum sum;
            bool alphas_differ = false;
            const std::uint8_t first = texel_at(level, wide * x, high * y)[3];
            for (int j = 0; j < high; ++j)
                for (int i = 0; i < wide; ++i) {
                    const Texel& texel = texel_at(level, wide * x + i, high * y + j);
                    alphas_differ = alphas_differ || texel[3] != first;
                    sum.add(colour_of(texel), texel[3], 1);
                }
            out.texels.push_back(sum.texel(alphas_differ));
        }
    return out;
}

bool is_power_of_two(int side) { return side > 0 && (side & (side - 1)) == 0; }

/// Calls use(old texel, length of overlap) for each old texel that a new texel overlaps, along one side.
/// Lengths are in units of 1 / (old side * new side).
template <class Use> void each_overlap(int old_side, int new_side, int texel, const Use& use) {
    const std::int64_t begin = std::int64_t(texel) * old_side, end = begin + old_side;
    for (std::int64_t old = begin / new_side; old * new_side < end; ++old)
        use(int(old), double(std::min((old + 1) * new_side, end) - std::max(old * new_side, begin)));
}

/// Returns a row of the picture, resampled along s only.
std::vector<TexelSum> resampled_row(const TexelLevel& picture, int y, int width) {
    std::vector<TexelSum> row(std::size_t(width), TexelSum{});
    for (int x = 0; x < width; ++x)
        each_overlap(picture.width, width, x, [&](int old, double overlap) {
            const Texel& texel = texel_at(picture, old, y);
            row[std::size_t(x)].add(colour_of(texel), texel[3], overlap);
        });
    return row;
}

int wrapped(std::int64_t texel, int side, Wrap wrap) {
    const auto modulo = [](std::int64_t x, std::int64_t n) { return (x % n + n) % n; };
    switch (wrap) {
        case Wrap::repeat: return int(modulo(texel, side));
        case Wrap::mirror: {
            const std::int64_t in_period = modulo(texel, 2 * std::int64_t(side));
            return int(in_period < side ? in_period : 2 * std::int64_t(side) - 1 - in_period);
        }
        case Wrap::clamp: break;
    }
    return int(std::clamp<std::int64_t>(texel, 0, side - 1));
}

double area_of(const std::array<glm::dvec3, 3>& corners) {
    return glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
}

}   // namespace

double srgb_to_linear(std::uint8_t code) {
    static const std::array<double, 256> table = all_codes();
    return table[code];
}

std::uint8_t linear_to_srgb(double linear) {
    const double clamped = linear > 0 ? std::min(linear, 1.0) : 0.0;   // the comparison is false for NaN
    const double srgb = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * srgb));
}

Pyramid make_pyramid(TexelLevel level0) {
    if (!is_power_of_two(level0.width) || !is_power_of_two(level0.height) ||
        level0.texels.size() != std::size_t(level0.width) * std::size_t(level0.height))
        throw std::logic_error("make_pyramid() needs sides that are powers of two");
    Pyramid pyramid;
    pyramid.levels.push_back(std::move(level0));
    while (pyramid.levels.back().width > 1 || pyramid.levels.back().height > 1)
        pyramid.levels.push_back(halved(pyramid.levels.back()));
    return pyramid;
}

int texture_side(int side) {
    std::int64_t power = 1;
    // n lies nearer to 2 p than to p if n / p > 2 p / n.
    while (power < max_texture_side && std::int64_t(side) * side > 2 * power * power) power *= 2;
    return int(power);
}

TexelLevel resampled(const TexelLevel& picture) {
    TexelLevel out{texture_side(picture.width), texture_side(picture.height), {}};
    if (out.width == picture.width && out.height == picture.height) return picture;
    out.texels.reserve(std::size_t(out.width) * std::size_t(out.height));
    std::vector<TexelSum> row;
    int row_number = -1;   // neighbouring rows share the old row between them
    for (int y = 0; y < out.height; ++y) {
        std::vector<TexelSum> sums(std::size_t(out.width), TexelSum{});
        each_overlap(picture.height, out.height, y, [&](int old, double overlap) {
            if (old != row_number) row = resampled_row(picture, row_number = old, out.width);
            for (std::size_t x = 0; x < sums.size(); ++x) sums[x].add(row[x], overlap);
        });
        for (const TexelSum& sum : sums) out.texels.push_back(sum.texel(true));
    }
    return out;
}

CornerCoordinates near_zero(const Texture& texture, CornerCoordinates corners) {
    for (int axis = 0; axis < 2; ++axis) {
        const Wrap wrap = axis == 0 ? texture.wrap_s : texture.wrap_t;
        if (wrap == Wrap::clamp) continue;
        const double least = std::min({corners[0][axis], corners[1][axis], corners[2][axis]}),
                     most = std::max({corners[0][axis], corners[1][axis], corners[2][axis]}),
                     period = wrap == Wrap::repeat ? 1 : 2,
                     shift = period * std::floor((least + (most - least) / 2) / period);
        for (glm::dvec2& corner : corners) corner[axis] -= shift;
    }
    return corners;
}

glm::dvec4 filtered_with_alpha(const Texture& texture, glm::dvec2 st, int level) {
    const std::vector<TexelLevel>& levels = texture.pyramid->levels;
    const TexelLevel& from =
        levels[texture.mipmaps ? std::size_t(std::clamp(level, 0, int(levels.size()) - 1)) : 0];
    const auto colour = [&](double x, double y) {
        const Texel& texel = texel_at(from, wrapped(std::int64_t(x), from.width, texture.wrap_s),
                                      wrapped(std::int64_t(y), from.height, texture.wrap_t));
        return glm::dvec4(colour_of(texel), texel[3] / 255.0);
    };
    const double x = st.x * from.width, y = st.y * from.height;
    if (texture.nearest) return colour(std::floor(x), std::floor(y));
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), across = x - 0.5 - left,
                 down = y - 0.5 - top;
    return (1 - down) * ((1 - across) * colour(left, top) + across * colour(left + 1, top)) +
           down * ((1 - across) * colour(left, top + 1) + across * colour(left + 1, top + 1));
}

glm::dvec3 filtered(const Texture& texture, glm::dvec2 st, int level) {
    return glm::dvec3(filtered_with_alpha(texture, st, level));
}

glm::dvec3 average_of(const Texture& texture) {
    const TexelLevel& picture = texture.pyramid->levels.front();
    glm::dvec3 sum(0);
    for (const Texel& texel : picture.texels) sum += colour_of(texel);
    return sum / double(picture.texels.size());
}

double texture_detail(const Texture& texture, const std::array<glm::dvec3, 3>& vertices,
                      const CornerCoordinates& corners) {
    const TexelLevel& picture = texture.pyramid->levels.front();
    const glm::dvec2 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const double in_texels = std::abs(a.x * b.y - a.y * b.x) / 2 * picture.width * picture.height,
                 in_scene = area_of(vertices);
    if (!(in_texels > 0 && in_scene > 0)) return -std::numeric_limits<double>::infinity();
    return (std::log2(in_texels) - std::log2(in_scene)) / 2;
}

double texture_detail(const Scene& scene, std::uint32_t triangle) {
    const Triangle& t = scene.triangles[triangle];
    return texture_detail(
        scene.textures[*scene.materials[t.material].texture],
        {scene.vertices[t.vertex[0]], scene.vertices[t.vertex[1]], scene.vertices[t.vertex[2]]},
        scene.coordinates[triangle]);
}

double texture_detail(const Texture& texture, const Plane& plane) {
    return texture_detail(texture, {plane.point, plane.point + plane.u, plane.point + plane.v},
                          plane.coordinates);
}

double texture_detail(const Texture& texture, const Sphere& sphere) {
    const TexelLevel& picture = texture.pyramid->levels.front();
    constexpr double log2_of_4_pi = 3.6514961294723187;
    return (std::log2(double(picture.width) * picture.height) - log2_of_4_pi) / 2 - std::log2(sphere.radius);
}

glm::dvec2 octahedral_place(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    glm::dvec2 away = glm::dvec2(size.x, size.z) / (size.x + size.y + size.z);
    if (direction.y < 0) away = {1 - away.y, 1 - away.x};
    return {(1 + (direction.x < 0 ? -away.x : away.x)) / 2, (1 + (direction.z < 0 ? -away.y : away.y)) / 2};
}

glm::dvec3 octahedral_direction(const glm::dvec2& st) {
    const glm::dvec2 from_middle = 2.0 * st - 1.0, away = glm::abs(from_middle);
    const double y = 1 - away.x - away.y;
    const glm::dvec2 size = y < 0 ? glm::dvec2(1 - away.y, 1 - away.x) : away;
    return glm::normalize(
        glm::dvec3(from_middle.x < 0 ? -size.x : size.x, y, from_middle.y < 0 ? -size.y : size.y));
}

int octahedral_side(const Texture& texture) {
    const TexelLevel& picture = texture.pyramid->levels.front();
    return std::max(picture.width / 2, picture.height);
}

Texture octahedral_picture(const Texture& texture, const glm::dmat3& turn) {
    constexpr int places = 4;
    constexpr double pi = 3.14159265358979323846;
    Texture around = texture;   // a picture of longitude and latitude
    around.wrap_s = Wrap::repeat, around.wrap_t = Wrap::clamp;
    const int side = octahedral_side(texture);
    TexelLevel out{side, side, {}};
    out.texels.resize(std::size_t(side) * std::size_t(side));
    const glm::dmat3 back = glm::transpose(turn);
    tbb::parallel_for(0, side, [&](int row) {
        for (int column = 0; column < side; ++column) {
            TexelSum sum;
            for (int i = 0; i < places * places; ++i) {
                const glm::dvec2 place(column + (i % places + 0.5) / places,
                                       row + (i / places + 0.5) / places);
                const glm::dvec3 d = back * octahedral_direction(place / double(side));
                const glm::dvec2 st(0.5 + std::atan2(d.x, d.z) / (2 * pi),
                                    std::acos(std::clamp(d.y, -1.0, 1.0)) / pi);
                const glm::dvec4 found = filtered_with_alpha(around, st, 0);
                sum.add(glm::dvec3(found), 255 * found.a, 1);
            }
            out.texels[std::size_t(row) * std::size_t(side) + std::size_t(column)] = sum.texel(true);
        }
    });
    around.wrap_s = Wrap::clamp;
    around.pyramid = std::make_shared<const Pyramid>(make_pyramid(std::move(out)));
    return around;
}

double level_of_detail(double detail, double distance, double spread, double cosine) {
    const double foreshortening = -std::log2(std::clamp(std::abs(cosine), least_cosine, 1.0));
    return std::log2(distance * spread) + detail + foreshortening_share * foreshortening;
}

int level_of(const Texture& texture, double lod) {
    const double last = texture.mipmaps ? double(texture.pyramid->levels.size()) - 1 : 0;
    const double level = std::floor(lod + 0.5);
    return level > 0 ? int(std::min(level, last)) : 0;   // the comparison is false for NaN
}

}   // namespace rayclock
