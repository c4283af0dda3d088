// The design of a sample: slots, parts, strata, and the estimator on a population of numbers.
#include <cmath>
#include <set>

#include <boost/math/distributions/students_t.hpp>
#include <catch2/catch.hpp>

#include "sim/run/sample/estimate.hpp"

using namespace rayclock;
using namespace rayclock::sample;

namespace {

Frame frame_of(std::uint32_t width, std::uint32_t height) {
    Frame frame;
    frame.width = width, frame.height = height;
    return frame;
}

/// A population of parts: work x, and a figure y that is only roughly in proportion.
struct Population {
    std::vector<std::uint64_t> x;
    std::vector<double> y;
};
Population population(std::uint64_t seed) {
    Rng rng(seed);
    Population p;
    for (int i = 0; i < 400; ++i) {
        const std::uint64_t heavy = i % 3 == 0 ? 0 : below(rng, 9000);   // a third is background
        p.x.push_back(1000 + heavy);
        p.y.push_back(double(p.x.back()) * (0.9 + 0.2 * double(below(rng, 1000)) / 1000) + 50);
    }
    return p;
}

double total_of(const Population& p) {
    double sum = 0;
    for (const double y : p.y) sum += y;
    return sum;
}

Estimate sample_of(const Population& p, std::uint64_t seed) {
    Rng rng(seed);
    const std::vector<Stratum> strata = draw(p.x, 12, rng);
    PartValues y{p.y.front() + p.y.back(), {}};
    Auxiliary x;
    x.parts.certain = double(p.x.front() + p.x.back());
    for (std::size_t i = 1; i + 1 < p.x.size(); ++i) x.total += double(p.x[i]);
    for (const Stratum& stratum : strata) {
        y.pairs.emplace_back(p.y[stratum.chosen[0]], p.y[stratum.chosen[1]]);
        x.parts.pairs.emplace_back(double(p.x[stratum.chosen[0]]), double(p.x[stratum.chosen[1]]));
    }
    return total(strata, y, x);
}

/// Returns the share of intervals that hold the total, with half-widths times `factor`.
double coverage(const Population& p, int samples, double factor) {
    const double truth = total_of(p);
    int covered = 0;
    for (int s = 0; s < samples; ++s) {
        const Estimate e = sample_of(p, std::uint64_t(s) + 1);
        covered += std::fabs(e.value - truth) <= factor * e.half_width;
    }
    return double(covered) / samples;
}

}   // namespace

TEST_CASE("the slots of a frame hold every pixel once, in tiles") {
    const int tile_bits = GENERATE(0, 2, 4);
    const SlotOrder order(frame_of(50, 37), tile_bits);
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (std::uint64_t slot = 0; slot < order.slots(); ++slot) {
        if (slot % order.tile_slots() == 0)
            REQUIRE(order.pixels_before(std::uint32_t(slot / order.tile_slots())) == seen.size());
        const SlotOrder::Pixel p = order.pixel(slot);
        if (order.is_inside(p)) REQUIRE(seen.emplace(p.x, p.y).second);
    }
    REQUIRE(seen.size() == 50 * 37);
}

TEST_CASE("parts cover all tiles of a frame") {
    const Parts parts = parts_of(frame_of(512, 390), named_config("default"));
    std::uint32_t tile = 0;
    for (std::uint32_t part = 0; part < parts.count; ++part) {
        REQUIRE(parts.first_tile(part) == tile);
        tile = parts.end_tile(part);
    }
    REQUIRE(tile == parts.order.tiles());
}

TEST_CASE("strata partition the parts between the first and the last, and have two different ones each") {
    const Population p = population(7);
    Rng rng(3);
    std::uint32_t sum = 0;
    std::set<std::uint32_t> chosen;
    for (const Stratum& s : draw(p.x, 20, rng)) {
        REQUIRE(s.size >= 3);
        sum += s.size;
        for (const std::uint32_t part : s.chosen) {
            REQUIRE((part > 0 && part < 399));
            REQUIRE(chosen.insert(part).second);
        }
    }
    REQUIRE(sum == 398);
}

TEST_CASE("each part of a stratum is chosen equally often") {
    const std::vector<std::uint64_t> work(17, 100);   // five strata of three parts each
    std::vector<int> times(work.size());
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        Rng rng(seed);
        for (const Stratum& s : draw(work, 5, rng))
            for (const std::uint32_t part : s.chosen) ++times[part];
    }
    for (std::size_t part = 1; part + 1 < work.size(); ++part) REQUIRE(std::abs(times[part] - 2000) < 150);
}

TEST_CASE("quantiles of Student's t are those of Boost") {
    for (const double degrees : {1.0, 1.5, 2.0, 2.5, 3.0, 4.2, 5.0, 7.9, 10.0, 25.0, 100.0, 1e6, 1e9, 2e14}) {
        const double quantile = boost::math::quantile(boost::math::students_t(degrees), 0.975);
        INFO(degrees << " degrees");
        REQUIRE(student_975(degrees) == Approx(quantile).epsilon(degrees < 3   ? 0.04
                                                                 : degrees < 5 ? 0.005
                                                                               : 0.0005));
    }
}

TEST_CASE("95 % intervals hold the total of a population in 93 to 97 % of the samples") {
    double mean = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) mean += coverage(population(seed), 400, 1) / 10;
    CHECK(mean > 0.93);
    CHECK(mean < 0.97);
}

TEST_CASE("intervals of half the width hold far less, so this test can fail") {
    REQUIRE(coverage(population(1), 400, 0.5) < 0.8);
}

TEST_CASE("95 % intervals of a mean hold the mean of five populations in 93 to 97 % of the samples") {
    std::vector<Population> populations;
    double truth = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        populations.push_back(population(seed));
        truth += total_of(populations.back()) / 5;
    }
    constexpr int samples = 1000;
    int covered = 0;
    for (int s = 0; s < samples; ++s) {
        std::vector<Estimate> estimates;
        for (std::size_t i = 0; i < 5; ++i)
            estimates.push_back(sample_of(populations[i], std::uint64_t(5 * s) + i + 1));
        const Estimate e = mean(estimates);
        covered += std::fabs(e.value - truth) <= e.half_width;
    }
    CHECK(covered > 0.93 * samples);
    CHECK(covered < 0.97 * samples);
}
