#pragma once
// Lines that are uniformly distributed in place and direction, and the counts of what they meet.
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include "model/unit/raygen/raygen.hpp"
#include "tests/support/cases/draw.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test {

constexpr double ball_radius = 60000;   // a ball that contains everything; every line meets it

/// Returns triangles around points of a cube, all in the ball.
inline std::vector<PrimData> triangles(std::uint32_t count, int reach, int size) {
    Draw draw{9};
    std::vector<PrimData> prims;
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec3i middle{}, corner[3];
        for (int& x : middle) x = draw.between(-reach, reach);
        for (Vec3i& c : corner)
            for (std::size_t k = 0; k < 3; ++k) c[k] = middle[k] + draw.between(-size, size);
        prims.push_back({corner[0], corner[1], corner[2], i});
    }
    return prims;
}

/// Lines through the ball: a direction, and a point of the disc perpendicular to it.
class Lines {
public:
    explicit Lines(const Config& config) : config_(config) {}
    Ray next() {
        const auto d = unit();
        auto side = unit();   // made perpendicular
        const double along = d[0] * side[0] + d[1] * side[1] + d[2] * side[2];
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k) side[k] -= along * d[k], length += side[k] * side[k];
        const double off = ball_radius * std::sqrt(even_(rng_)) / std::sqrt(length);
        Vec3i o{}, direction{};
        for (std::size_t k = 0; k < 3; ++k) {
            o[k] = int(std::lround(off * side[k] - ball_radius * d[k]));
            direction[k] = int(std::lround(d[k] * ((1 << (config_.dir_bits - 1)) - 1)));
        }
        return make_ray(o, direction, config_);
    }

private:
    std::array<double, 3> unit() {
        const double z = 2 * even_(rng_) - 1, turn = 2 * std::numbers::pi * even_(rng_),
                     r = std::sqrt(1 - z * z);
        return {r * std::cos(turn), r * std::sin(turn), z};
    }
    Config config_;
    std::mt19937_64 rng_{5};
    std::uniform_real_distribution<double> even_{0, 1};
};

/// The mean of a count over lines.
class Mean {
public:
    void add(double n) { sum_ += n, squares_ += n * n, ++lines_; }
    /// Requires that the mean lies within four standard errors of the bounds. It may exceed the upper bound
    /// by at most 2 %, the cost of conservative tests.
    void check(double least, double most) const {
        const double mean = sum_ / lines_, error = std::sqrt((squares_ / lines_ - mean * mean) / lines_);
        CAPTURE(mean, error, least, most, mean / least, mean / most);
        CHECK(mean >= least - 4 * error);
        CHECK(mean <= most * 1.02 + 4 * error);
    }

private:
    double sum_ = 0, squares_ = 0, lines_ = 0;
};

}   // namespace rayclock::test
