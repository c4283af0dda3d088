// Paints patterns texel by texel.
#include "model/scene/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/common.hpp>

#include "model/base/rng.hpp"

namespace rayclock {
namespace {

double fraction_of(double x) { return x - std::floor(x); }

/// Interpolates linearly between colours at equal distances. x = 0 gives the first colour, x = 1 the last.
glm::dvec3 between(const std::vector<glm::dvec3>& colours, double x) {
    const double at = std::clamp(x, 0.0, 1.0) * double(colours.size() - 1);
    const auto first = std::min(std::size_t(at), colours.size() - 2);
    return glm::mix(colours[first], colours[first + 1], at - double(first));
}

glm::dvec3 checker_at(const Pattern& p, const glm::dvec2& st) {
    const auto number = std::size_t(st.x * p.columns) + std::size_t(st.y * p.rows);
    return p.colours[number % p.colours.size()];
}

glm::dvec3 brick_at(const Pattern& p, const glm::dvec2& st) {
    const int row = int(st.y * p.rows);
    const double up = fraction_of(st.y * p.rows),
                 along = fraction_of(st.x * p.columns + (row % 2 != 0 ? 0.5 : 0)) / p.columns;
    return p.colours[up < p.joint || along < p.joint / p.rows ? 1 : 0];
}

/// Random values at the corners of a grid, interpolated by Hermite's cubic. The grid closes on itself.
class NoiseOctave {
public:
    NoiseOctave(int columns, int rows, Rng& rng) : columns_(columns), rows_(rows) {
        values_.resize(std::size_t(columns) * std::size_t(rows));
        for (double& value : values_) value = std::ldexp(double(rng.next() >> 11), -53);
    }
    double operator()(const glm::dvec2& st) const {
        const double x = st.x * columns_, y = st.y * rows_;
        const int column = int(x), row = int(y);
        const double across = smooth(x - column), down = smooth(y - row);
        return glm::mix(glm::mix(at(column, row), at(column + 1, row), across),
                        glm::mix(at(column, row + 1), at(column + 1, row + 1), across), down);
    }

private:
    static double smooth(double x) { return x * x * (3 - 2 * x); }
    double at(int column, int row) const {
        return values_[std::size_t(row % rows_) * std::size_t(columns_) + std::size_t(column % columns_)];
    }
    int columns_, rows_;
    std::vector<double> values_;
};

/// The weighted mean of the octaves of a noise, within 0..1.
class Noise {
public:
    explicit Noise(const Pattern& p) {
        Rng rng(p.seed);
        for (int k = 0; k < p.octaves; ++k) octaves_.emplace_back(p.columns << k, p.rows << k, rng);
    }
    double operator()(const glm::dvec2& st) const {
        double sum = 0, most = 0, strength = 1;
        for (const NoiseOctave& octave : octaves_) {
            sum += strength * octave(st), most += strength;
            strength /= 2;
        }
        return sum / most;
    }

private:
    std::vector<NoiseOctave> octaves_;
};

TexelLevel painted(const Pattern& p, const std::function<glm::dvec3(const glm::dvec2&)>& colour_at) {
    TexelLevel out{p.width, p.height, {}};
    out.texels.reserve(std::size_t(p.width) * std::size_t(p.height));
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const glm::dvec3 colour = colour_at({(x + 0.5) / p.width, (y + 0.5) / p.height});
            out.texels.push_back(
                {linear_to_srgb(colour.r), linear_to_srgb(colour.g), linear_to_srgb(colour.b), 255});
        }
    return out;
}

}   // namespace

std::uint64_t painting_bytes(const Pattern& pattern) {
    const auto area = [](int a, int b) { return std::uint64_t(a) * std::uint64_t(b); };
    std::uint64_t bytes = 2 * sizeof(TexelLevel::texels[0]) * area(pattern.width, pattern.height);
    if (pattern.kind == Pattern::Kind::noise)
        for (int k = 0; k < pattern.octaves; ++k)
            bytes += sizeof(double) * area(pattern.columns << k, pattern.rows << k);
    return bytes;
}

TexelLevel texels_of(const Pattern& pattern) {
    switch (pattern.kind) {
        case Pattern::Kind::checker:
            return painted(pattern, [&](const glm::dvec2& st) { return checker_at(pattern, st); });
        case Pattern::Kind::bricks:
            return painted(pattern, [&](const glm::dvec2& st) { return brick_at(pattern, st); });
        case Pattern::Kind::gradient:
            return painted(pattern, [&](const glm::dvec2& st) { return between(pattern.colours, st.y); });
        case Pattern::Kind::noise: break;
    }
    const Noise noise(pattern);
    // The sums rarely reach 0 or 1. The range that they have in this picture is stretched to 0..1.
    double low = 1, high = 0;
    for (int y = 0; y < pattern.height; ++y)
        for (int x = 0; x < pattern.width; ++x) {
            const double value = noise({(x + 0.5) / pattern.width, (y + 0.5) / pattern.height});
            low = std::min(low, value), high = std::max(high, value);
        }
    const double range = high > low ? high - low : 1;
    return painted(pattern,
                   [&](const glm::dvec2& st) { return between(pattern.colours, (noise(st) - low) / range); });
}

Texture texture_of(const Pattern& pattern) {
    return {.name = "a pattern",
            .pyramid = std::make_shared<const Pyramid>(make_pyramid(texels_of(pattern)))};
}

}   // namespace rayclock
