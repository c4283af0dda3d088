// Polygons: the cut equals the plain algorithm's, and 10,000 corners take less than a second.
#include <catch2/catch.hpp>

#include <cmath>
#include <ctime>
#include <random>

#include "sim/load/mesh/triangulate.hpp"

using namespace rayclock;

namespace {

using Polygon = std::vector<glm::dvec3>;
using Cut = std::vector<std::array<std::uint32_t, 3>>;

double turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Plain ear clipping: tries every corner and checks it against every other. Counter-clockwise in x and y.
Cut plain(const Polygon& p) {
    std::vector<std::uint32_t> ring(p.size());
    for (std::uint32_t i = 0; i < p.size(); ++i) ring[i] = i;
    std::vector<bool> is_reflex(p.size());
    const auto bend = [&](std::size_t k) {
        return turn(p[ring[(k + ring.size() - 1) % ring.size()]], p[ring[k]], p[ring[(k + 1) % ring.size()]]);
    };
    for (std::size_t k = 0; k < ring.size(); ++k) is_reflex[ring[k]] = bend(k) <= 0;
    Cut cut;
    std::size_t at = 1;
    while (ring.size() > 3) {
        const std::size_t n = ring.size();
        const auto is_ear = [&](std::size_t k) {
            const glm::dvec3 a = p[ring[(k + n - 1) % n]], b = p[ring[k]], c = p[ring[(k + 1) % n]];
            if (!(turn(a, b, c) > 0)) return false;
            for (const std::uint32_t r : ring) {
                const bool is_corner = p[r] == a || p[r] == b || p[r] == c;
                if (is_reflex[r] && !is_corner && turn(a, b, p[r]) >= 0 && turn(b, c, p[r]) >= 0 &&
                    turn(c, a, p[r]) >= 0)
                    return false;
            }
            return true;
        };
        std::size_t ear = at;
        for (std::size_t tried = 0; tried < n && !is_ear(ear); ++tried) ear = (ear + 1) % n;
        cut.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
        const std::uint32_t next = ring[(ear + 2) % n];
        const std::uint32_t before = ring[(ear + n - 1) % n], after = ring[(ear + 1) % n];
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
        for (std::size_t k = 0; k < ring.size(); ++k) {
            if ((ring[k] == before || ring[k] == after) && is_reflex[ring[k]])
                is_reflex[ring[k]] = bend(k) <= 0;
            if (ring[k] == next) at = k;
        }
    }
    const std::size_t n = ring.size();
    cut.push_back({ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]});
    return cut;
}

Cut cut_of(const Polygon& p) {
    Cut cut;
    triangulate(p, cut);
    return cut;
}

double area(const Polygon& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        sum += p[i].x * p[(i + 1) % p.size()].y - p[(i + 1) % p.size()].x * p[i].y;
    return sum / 2;
}

}   // namespace

TEST_CASE("polygons are cut as the plain algorithm cuts them") {
    const unsigned seed = 7;
    std::mt19937 random(seed);
    const auto number = [&](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    int compared = 0;
    for (int round = 0; round < 3000; ++round) {
        const int kind = round % 4, corners = 4 + static_cast<int>(random() % (round % 50 == 0 ? 300 : 40));
        Polygon p;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * 3.14159265358979 * i / corners, r = number(0.1, 1);
            if (kind == 0) p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);   // star-shaped
            if (kind == 1) p.emplace_back(number(-1, 1), number(-1, 1), 0);               // crosses itself
            if (kind == 2)
                p.emplace_back(std::floor(number(0, 6)), std::floor(number(0, 6)),
                               // Coincident corners, and straight ones.
                               0);
            if (kind == 3)
                p.emplace_back(i < corners / 2 ? i : corners - i, i < corners / 2 ? 0 : 1 + random() % 3,
                               // Many straight corners.
                               0);
        }
        if (!(area(p) > 0)) continue;   // has the opposite direction, and would be reversed
        // The plane is found in three dimensions. Here it must be that of x and y, moved to the first corner.
        for (std::size_t i = p.size(); i-- > 0;) p[i] -= p[0];
        INFO("seed " << seed << " round " << round);
        REQUIRE(cut_of(p) == plain(p));
        ++compared;
    }
    CHECK(compared > 1500);
}

TEST_CASE("a face of ten thousand corners is cut in less than a second") {
    constexpr int n = 10'000;
    std::mt19937 random(3);
    std::vector<Polygon> all(6);
    for (int i = 0; i < n; ++i) {
        const double a = 2 * 3.14159265358979 * i / n, along = i < n / 2 ? i : n - 1 - i,
                     radius = 0.01 * along + (i < n / 2 ? 1 : 0.7);
        all[0].emplace_back(radius * std::cos(0.01 * along), radius * std::sin(0.01 * along),
                            // A spiral.
                            0);
        all[1].emplace_back(static_cast<double>(random() % 100'000), static_cast<double>(random() % 100'000),
                            // Crosses itself.
                            0);
        all[2].emplace_back((i % 2 ? 1 : 3) * std::cos(a), (i % 2 ? 1 : 3) * std::sin(a), 0);   // a star
        all[3].emplace_back(i, i == n - 1 ? -1e6 : i % 2 ? 0 : 100 + i % 7, 0);                 // a comb
        all[4].emplace_back(i, 0, 0);                                                           // a line
        all[5].emplace_back(0, 0, 0);                                                           // a point
    }
    for (const Polygon& p : all) {
        timespec start{}, end{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &start);
        const Cut cut = cut_of(p);
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
        INFO("polygon " << &p - all.data());
        CHECK(cut.size() == n - 2);
#ifdef NDEBUG
        CHECK(double(end.tv_sec - start.tv_sec) + 1e-9 * double(end.tv_nsec - start.tv_nsec) < 1);
#endif
    }
    // The triangles of polygons with an inside cover it exactly once.
    for (const int simple : {0, 2}) {
        double sum = 0, least = 0;
        for (const auto& [a, b, c] : cut_of(all[static_cast<std::size_t>(simple)])) {
            const Polygon& p = all[static_cast<std::size_t>(simple)];
            const double part = turn(p[a], p[b], p[c]) / 2 * (area(p) > 0 ? 1 : -1);
            sum += part;
            least = std::min(least, part);
        }
        CHECK(sum == Approx(std::abs(area(all[static_cast<std::size_t>(simple)]))));
        CHECK(least > -1e-6);
    }
}
